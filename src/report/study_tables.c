#include "report/study.h"

#include "base/number.h"
#include "report/html.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ERRORS "_standard_error"

#define OUTPUTS_MAX 4 /* of one table */

bool murk_study_is_output(const murk_table *t, size_t column)
{
    const size_t length = strlen(t->name[column]);
    return column + 1 < t->columns &&
           strncmp(t->name[column + 1], t->name[column], length) == 0 &&
           strcmp(t->name[column + 1] + length, ERRORS) == 0;
}

bool murk_study_is_of_band(const char *output)
{
    const char *last = strrchr(output, '_');
    const size_t digits = last ? strspn(last + 1, "0123456789.") : 0;
    return digits > 0 && strcmp(last + 1 + digits, "nm") == 0;
}

bool murk_study_is_share(const char *output)
{
    return strncmp(output, "coverage", 8) == 0;
}

static double number(const murk_table *t, size_t row, size_t column)
{
    double value = NAN;
    return murk_number_parse(t->cell[row * t->columns + column], &value) ? value
                                                                         : NAN;
}

static void write_row(FILE *to, const murk_table *t, size_t row, size_t axes,
                      const size_t *output, size_t outputs)
{
    char name[32];
    snprintf(name, sizeof name, "%zu", row + 1);
    murk_page_row_begin(to, name);
    for (size_t c = 0; c < axes; ++c) {
        fputs("<td>", to);
        murk_page_text(to, t->cell[row * t->columns + c]);
        fputs("</td>", to);
    }
    for (size_t k = 0; k < outputs; ++k) {
        const double value = number(t, row, output[k]);
        const double error = number(t, row, output[k] + 1);
        if (murk_study_is_share(t->name[output[k]])) {
            murk_page_cell_share(to, value, error);
        } else {
            murk_page_cell_estimate(to, value, error);
        }
    }
    murk_page_row_end(to);
}

static void write_block(FILE *to, const murk_table *t, size_t axes,
                        const size_t *output, size_t outputs,
                        const char **heads)
{
    size_t n = 0;
    heads[n++] = "row";
    for (size_t c = 0; c < axes; ++c) {
        heads[n++] = t->name[c];
    }
    for (size_t k = 0; k < outputs; ++k) {
        heads[n++] = t->name[output[k]];
    }
    murk_page_table_begin(to, "The rows of the study", heads, n);
    for (size_t i = 0; i < t->rows && i < MURK_PAGE_ROWS_MAX; ++i) {
        write_row(to, t, i, axes, output, outputs);
    }
    murk_page_table_end(to);
    murk_page_more(to, t->rows, "table.csv");
}

bool murk_report_study_rows(FILE *to, const murk_table *t, size_t axes,
                            bool of_bands)
{
    const char **heads = calloc(axes + OUTPUTS_MAX + 1, sizeof *heads);
    size_t output[OUTPUTS_MAX], outputs = 0;
    for (size_t c = axes; heads && c < t->columns; ++c) {
        if (!murk_study_is_output(t, c)) {
            continue;
        }
        if (murk_study_is_of_band(t->name[c]) == of_bands) {
            output[outputs++] = c;
        }
        ++c;
        if (outputs == OUTPUTS_MAX) {
            write_block(to, t, axes, output, outputs, heads);
            outputs = 0;
        }
    }
    if (outputs > 0) {
        write_block(to, t, axes, output, outputs, heads);
    }
    free(heads);
    return heads != NULL;
}

/* The rows that failed, and why. */
void murk_report_study_failed(FILE *to, const murk_yaml *study)
{
    static const char *const heads[] = {"row", "<why"};
    const size_t n = murk_result_count(study, "rows");
    const murk_yaml *list = murk_result_at(study, "rows");
    size_t failed = 0;
    for (size_t i = 0; i < n; ++i) {
        const char *why = murk_result_text(list->child[i], "failed");
        if (!why || failed == MURK_PAGE_ROWS_MAX) {
            continue;
        }
        if (failed++ == 0) {
            murk_page_table_begin(to, "Rows that failed", heads, 2);
        }
        char name[32];
        snprintf(name, sizeof name, "%zu", i + 1);
        murk_page_row_begin(to, name);
        murk_page_cell_text(to, why);
        murk_page_row_end(to);
    }
    if (failed > 0) {
        murk_page_table_end(to);
    }
}

void murk_report_study_plans(FILE *to, const murk_yaml *study)
{
    static const char *const heads[] = {
        "one plan for", "sensors", "mean", "least", "in row", "upper bound"};
    static const char *const which[] = {"mean", "worst"};
    if (!murk_result_at(study, "plans.mean") &&
        !murk_result_at(study, "plans.worst")) {
        return;
    }
    murk_page_table_begin(to, "One plan for all rows", heads, 6);
    for (size_t k = 0; k < 2; ++k) {
        const murk_yaml *plans = murk_result_at(study, "plans");
        const murk_yaml *plan = murk_result_at(plans, which[k]);
        if (!plan) {
            continue;
        }
        murk_page_row_begin(to, k == 0 ? "the mean" : "the worst row");
        murk_page_cell_number(to, (double)murk_result_count(plan, "sensors"));
        murk_page_cell_share(to, murk_result_number(plan, "mean.value"),
                             murk_result_number(plan, "mean.standard_error"));
        murk_page_cell_share(to, murk_result_number(plan, "worst.value"),
                             murk_result_number(plan, "worst.standard_error"));
        murk_page_cell_number(to, murk_result_number(plan, "worst_row"));
        murk_page_cell_share(to, murk_result_number(plan, "upper_bound"), NAN);
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
}
