/* A calibration, as a section of the report. */
#include "report/fit.h"
#include "base/number.h"
#include "report/chart.h"
#include "report/html.h"
#include "report/sections.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Values, and units of readings, that are drawn. */
#define INTERVALS_MAX 40
#define UNITS_MAX     6

/* From this ratio on, readings are drawn by logarithms. */
#define LOG_RATIO 50

/* Half a 95 % interval, in standard errors. */
#define HALF_INTERVAL 1.96

static void write_facts(FILE *to, const murk_yaml *fit)
{
    murk_page_table_begin(to, "The fit in numbers", NULL, 0);
    murk_page_fact_number(to, "chi²", murk_result_number(fit, "chi2"), "");
    murk_page_fact_number(to, "degrees of freedom",
                          murk_result_number(fit, "degrees_of_freedom"), "");
    murk_page_fact_number(to, "chance of so large a chi² or a larger one",
                          murk_result_number(fit, "p_value"), "");
    murk_page_fact(to, "accepted (chance of at least 1e-4)",
                   murk_result_text(fit, "accepted"));
    murk_page_fact(to, "converged", murk_result_text(fit, "converged"));
    murk_page_fact(to, "why it ended", murk_result_text(fit, "why"));
    murk_page_fact_number(to, "times that light was traced",
                          murk_result_number(fit, "traces"), "");
    murk_page_fact_number(to, "iterations",
                          murk_result_number(fit, "iterations"), "");
    murk_page_fact_number(to, "evaluations",
                          murk_result_number(fit, "evaluations"), "");
    murk_page_fact_number(to, "rows held out",
                          murk_result_number(fit, "hold_out.rows"), "");
    murk_page_fact_number(
        to, "their root mean square residual",
        murk_result_number(fit, "hold_out.rms_in_standard_errors"),
        "standard errors");
    murk_page_fact(to, "data", murk_result_text(fit, "data.file"));
    murk_page_table_end(to);
}

static void write_parameters(FILE *to, const murk_yaml *fit)
{
    static const char *const heads[] = {"key",       "value", "from (95 %)",
                                        "to (95 %)", "start", "<known"};
    const size_t n = murk_result_count(fit, "parameters");
    const murk_yaml *list = murk_result_at(fit, "parameters");
    murk_page_table_begin(to, "What was found", heads, 6);
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        const murk_yaml *p = list->child[i];
        murk_page_row_begin(to, murk_result_text(p, "key"));
        fputs("<td>", to);
        murk_report_fit_value(to, p);
        fputs("</td>", to);
        murk_page_cell_number(to, murk_result_number(p, "lower"));
        murk_page_cell_number(to, murk_result_number(p, "upper"));
        murk_page_cell_number(to, murk_result_number(p, "start"));
        murk_page_cell_text(to, murk_result_text(p, "status"));
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
    murk_page_more(to, n, "fit.json");
}

/* Each value's 95 % interval, as shares of the value. */
static bool draw_intervals(FILE *to, const murk_yaml *fit)
{
    const size_t all = murk_result_count(fit, "parameters");
    const murk_yaml *list = murk_result_at(fit, "parameters");
    const size_t n = all < INTERVALS_MAX ? all : INTERVALS_MAX;
    double *room = malloc((4 * n + 1) * sizeof *room);
    const char **name = malloc((n + 1) * sizeof *name);
    const bool is_whole = room && name;
    if (is_whole) {
        double *x = room, *y = x + n, *low = y + n, *high = low + n;
        for (size_t i = 0; i < n; ++i) {
            const murk_yaml *p = list->child[i];
            const char *key = murk_result_text(p, "key");
            const double value = murk_result_number(p, "value");
            const double a = murk_result_number(p, "lower") / value - 1;
            const double b = murk_result_number(p, "upper") / value - 1;
            name[i] = key ? key : "";
            x[i] = (double)i;
            low[i] = fmin(a, b);
            high[i] = fmax(a, b);
            y[i] = isfinite(a) && isfinite(b) ? 0 : NAN;
        }
        const murk_chart_series series = {
            .name = "found", .n = n, .x = x, .y = y, .low = low, .high = high};
        const murk_chart chart = {
            .title = "How well each value is known: its 95 % interval, in per "
                     "cent of the value",
            .x_title = "",
            .y_title = "off the value",
            .x_name = name,
            .x_names = n,
            .y = MURK_SCALE_SHARE};
        murk_chart_draw(to, &chart, &series, 1);
    }
    free(room);
    free(name);
    return is_whole;
}

/* ---- residuals ---- */

typedef struct columns {
    const murk_table *table;
    long use, residual, value, error, predicted, kind, unit;
} columns;

static const char *cell(const columns *c, size_t row, long column)
{
    return column < 0
               ? ""
               : c->table->cell[row * c->table->columns + (size_t)column];
}

static double number(const columns *c, size_t row, long column)
{
    double value = NAN;
    return murk_number_parse(cell(c, row, column), &value) ? value : NAN;
}

static bool draw_residuals(FILE *to, const columns *c)
{
    static const char *const uses[] = {"fit", "hold_out"};
    static const char *const names[] = {"fitted", "held out"};
    static const double lines[] = {-HALF_INTERVAL, 0, HALF_INTERVAL};
    const size_t rows = c->table->rows;
    double *room = malloc((8 * rows + 1) * sizeof *room);
    murk_chart_series series[2];
    size_t n_series = 0;
    if (!room) {
        return false;
    }
    for (size_t u = 0; u < 2; ++u) {
        double *x = room + 4 * rows * u, *y = x + rows;
        double *low = y + rows, *high = low + rows;
        size_t n = 0;
        for (size_t i = 0; i < rows; ++i) {
            const double residual = number(c, i, c->residual);
            if (strcmp(cell(c, i, c->use), uses[u]) != 0 ||
                !isfinite(residual)) {
                continue;
            }
            x[n] = (double)(i + 1);
            y[n] = residual;
            low[n] = residual - HALF_INTERVAL;
            high[n] = residual + HALF_INTERVAL;
            ++n;
        }
        if (n > 0) {
            series[n_series++] = (murk_chart_series){.name = names[u],
                                                     .n = n,
                                                     .x = x,
                                                     .y = y,
                                                     .low = low,
                                                     .high = high};
        }
    }
    const murk_chart chart = {
        .title = "Residuals (measured less predicted) in standard errors, "
                 "each with its 95 % interval; one in twenty may leave the "
                 "dashed lines by chance",
        .x_title = "row of the data",
        .x = MURK_SCALE_WHOLE,
        .y_title = "residual / standard error",
        .y_line = lines,
        .y_lines = 3};
    murk_chart_draw(to, &chart, series, n_series);
    free(room);
    return true;
}

/* Measured against predicted, of the readings of one unit: on the line they
 * agree. */
static bool draw_agreement(FILE *to, const columns *c, const char *unit)
{
    const size_t rows = c->table->rows;
    double *room = malloc((4 * rows + 4) * sizeof *room);
    double min = INFINITY, max = -INFINITY;
    if (!room) {
        return false;
    }
    double *x = room, *y = x + rows, *low = y + rows, *high = low + rows;
    double *end = high + rows;
    for (size_t i = 0; i < rows; ++i) {
        const bool is_of = strcmp(cell(c, i, c->unit), unit) == 0;
        const double error = number(c, i, c->error);
        x[i] = is_of ? number(c, i, c->predicted) : NAN;
        y[i] = is_of ? number(c, i, c->value) : NAN;
        low[i] = y[i] - HALF_INTERVAL * error;
        high[i] = y[i] + HALF_INTERVAL * error;
        if (isfinite(x[i]) && isfinite(y[i])) {
            min = fmin(min, fmin(x[i], y[i]));
            max = fmax(max, fmax(x[i], y[i]));
        }
    }
    end[0] = min;
    end[1] = max;
    const murk_axis_scale scale =
        min > 0 && max > LOG_RATIO * min ? MURK_SCALE_LOG : MURK_SCALE_EVEN;
    const murk_chart_series series[] = {{.name = "readings, 95 % intervals",
                                         .n = rows,
                                         .x = x,
                                         .y = y,
                                         .low = low,
                                         .high = high},
                                        {.name = "where both are the same",
                                         .n = 2,
                                         .x = end,
                                         .y = end,
                                         .is_line = true}};
    char x_title[80], y_title[80];
    snprintf(x_title, sizeof x_title, "predicted, %.60s", unit);
    snprintf(y_title, sizeof y_title, "measured, %.60s", unit);
    const murk_chart chart = {.title = "Measured against predicted",
                              .x_title = x_title,
                              .y_title = y_title,
                              .x = scale,
                              .y = scale};
    if (max > -INFINITY) {
        murk_chart_draw(to, &chart, series, 2);
    }
    free(room);
    return true;
}

/* A plot for each unit, in the order of the rows. */
static bool draw_agreements(FILE *to, const columns *c)
{
    const char *unit[UNITS_MAX];
    size_t units = 0;
    bool is_whole = true;
    for (size_t i = 0; i < c->table->rows && is_whole; ++i) {
        size_t k = 0;
        while (k < units && strcmp(unit[k], cell(c, i, c->unit)) != 0) {
            ++k;
        }
        if (k == units && units < UNITS_MAX) {
            unit[units++] = cell(c, i, c->unit);
            is_whole = draw_agreement(to, c, unit[k]);
        }
    }
    return is_whole;
}

static void write_rows(FILE *to, const columns *c)
{
    static const char *const heads[] = {
        "row", "<kind", "<use", "measured", "predicted", "<unit", "residual σ"};
    murk_page_table_begin(to, "Measured and predicted", heads, 7);
    for (size_t i = 0; i < c->table->rows && i < MURK_PAGE_ROWS_MAX; ++i) {
        char name[32];
        snprintf(name, sizeof name, "%zu", i + 1);
        murk_page_row_begin(to, name);
        murk_page_cell_text(to, cell(c, i, c->kind));
        murk_page_cell_text(to, cell(c, i, c->use));
        murk_page_cell_estimate(to, number(c, i, c->value),
                                number(c, i, c->error));
        murk_page_cell_number(to, number(c, i, c->predicted));
        murk_page_cell_text(to, cell(c, i, c->unit));
        murk_page_cell_number(to, number(c, i, c->residual));
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
    murk_page_more(to, c->table->rows, "fit.csv");
}

murk_status murk_report_fit(FILE *to, const murk_results_in *results,
                            murk_error *err)
{
    const murk_yaml *fit = results->json[MURK_RESULT_FIT];
    murk_table *table = NULL;
    if (!fit) {
        return MURK_OK;
    }
    murk_status status =
        murk_results_table(&table, results->folder, "fit.csv", err);
    if (status) {
        return status;
    }
    murk_page_section_begin(to, "calibration", "The calibration");
    fputs("<div class=\"beside\">\n", to);
    write_parameters(to, fit);
    if (!draw_intervals(to, fit)) {
        status = murk_fail(err, MURK_NO_MEMORY, "", "no memory for the plots");
    }
    fputs("</div>\n", to);
    if (table) {
        const columns c = {
            .table = table,
            .use = murk_table_column(table, "use"),
            .residual = murk_table_column(table, "residual_in_standard_errors"),
            .value = murk_table_column(table, "value"),
            .error = murk_table_column(table, "standard_error"),
            .predicted = murk_table_column(table, "predicted"),
            .kind = murk_table_column(table, "kind"),
            .unit = murk_table_column(table, "unit")};
        fputs("<h3>Residuals</h3>\n<div class=\"plans\">\n", to);
        if (!draw_residuals(to, &c) || !draw_agreements(to, &c)) {
            status =
                murk_fail(err, MURK_NO_MEMORY, "", "no memory for the plots");
        }
        fputs("</div>\n", to);
        write_rows(to, &c);
    } else {
        murk_page_paragraph(to, "There is no fit.csv beside fit.json.");
    }
    murk_report_correlations(to, fit);
    murk_report_directions(to, fit);
    murk_report_next(to, fit);
    murk_report_starts(to, fit);
    write_facts(to, fit);
    murk_page_section_end(to);
    murk_table_destroy(table);
    return status;
}
