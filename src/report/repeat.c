/* The same job with several seeds, in the report: repeat.csv. */
#include "base/number.h"
#include "report/chart.h"
#include "report/html.h"
#include "report/plan.h"

#include <math.h>
#include <stdlib.h>

static double number(const murk_table *t, size_t row, const char *column)
{
    const long c = murk_table_column(t, column);
    double value = NAN;
    return c >= 0 && murk_number_parse(t->cell[row * t->columns + (size_t)c],
                                       &value)
               ? value
               : NAN;
}

/* Each run's values beside each other, about its seed. */
static bool draw(FILE *to, const murk_table *t)
{
    static const char *const column[][3] = {
        {"held_out", "held out", "held_out_standard_error"},
        {"in_sample", "in sample", ""},
        {"plan", "the plan, on this run's map", "plan_standard_error"},
        {"upper", "upper bound", ""}};
    enum { SERIES = 4 };
    const size_t n = t->rows;
    double *room = malloc((SERIES * 4 * n + 1) * sizeof *room);
    murk_chart_series series[SERIES];
    if (!room) {
        return false;
    }
    for (size_t k = 0; k < SERIES; ++k) {
        double *x = room + 4 * n * k, *y = x + n, *low = y + n, *high = low + n;
        for (size_t i = 0; i < n; ++i) {
            const double error = number(t, i, column[k][2]);
            x[i] = number(t, i, "seed") + 0.08 * ((double)k - 1.5);
            y[i] = number(t, i, column[k][0]);
            low[i] = y[i] - 1.96 * error;
            high[i] = y[i] + 1.96 * error;
        }
        series[k] = (murk_chart_series){.name = column[k][1],
                                        .n = n,
                                        .x = x,
                                        .y = y,
                                        .low = low,
                                        .high = high};
    }
    const murk_chart chart = {
        .title = "The whole job with other seeds; where errors are known, with "
                 "95 % intervals",
        .x_title = "seed",
        .y_title = "coverage",
        .x = MURK_SCALE_WHOLE,
        .y = MURK_SCALE_SHARE};
    murk_chart_draw(to, &chart, series, SERIES);
    free(room);
    return true;
}

static void write_spread(FILE *to, const murk_yaml *repeat, const char *name,
                         const char *key, bool is_share)
{
    static const char *const parts[] = {"median", "minimum", "maximum"};
    const murk_yaml *spread = murk_result_at(repeat, key);
    murk_page_row_begin(to, name);
    for (size_t k = 0; k < 3; ++k) {
        const double value = murk_result_number(spread, parts[k]);
        if (is_share) {
            murk_page_cell_share(to, value, NAN);
        } else {
            murk_page_cell_number(to, value);
        }
    }
    murk_page_row_end(to);
}

static void write_spreads(FILE *to, const murk_yaml *repeat)
{
    static const char *const heads[] = {"", "median", "least", "most"};
    murk_page_table_begin(to, "Over all seeds", heads, 4);
    write_spread(to, repeat, "held out", "held_out", true);
    write_spread(to, repeat, "in sample", "in_sample", true);
    write_spread(to, repeat, "upper bound", "upper", true);
    write_spread(to, repeat, "sensors", "sensors", false);
    murk_page_table_end(to);
}

static void write_gap(FILE *to, const murk_yaml *repeat)
{
    const double lower = murk_result_number(repeat, "gap.lower");
    fputs("<p>", to);
    murk_page_number(to, murk_result_number(repeat, "runs"));
    fputs(" of ", to);
    murk_page_number(to, murk_result_number(repeat, "asked"));
    fputs(" runs were done; the plan is the first one's. On maps that did not "
          "choose it it covers ",
          to);
    murk_page_share(to, murk_result_number(repeat, "plan.coverage"),
                    murk_result_number(repeat, "plan.standard_error"));
    fputc('.', to);
    if (isfinite(lower)) {
        fputs(" The best plan there is covers more than it by ", to);
        murk_page_share(to, murk_result_number(repeat, "gap.value"), NAN);
        fputs(" at most, by the mean of the bounds (95 %: ", to);
        murk_page_share(to, lower, NAN);
        fputs(" to ", to);
        murk_page_share(to, murk_result_number(repeat, "gap.upper"), NAN);
        fputs(").", to);
    }
    fputs("</p>\n", to);
}

murk_status murk_report_repeat(FILE *to, const murk_results_in *results,
                               const murk_yaml *plan, murk_error *err)
{
    const murk_yaml *repeat = murk_result_at(plan, "repeat");
    murk_table *table = NULL;
    if (!isfinite(murk_result_number(repeat, "runs"))) {
        return MURK_OK;
    }
    murk_status status =
        murk_results_table(&table, results->folder, "repeat.csv", err);
    if (status) {
        return status;
    }
    fputs("<h3>With other seeds</h3>\n", to);
    write_gap(to, repeat);
    fputs("<div class=\"beside\">\n", to);
    write_spreads(to, repeat);
    if (table && !draw(to, table)) {
        status = murk_fail(err, MURK_NO_MEMORY, "", "no memory for the plots");
    }
    fputs("</div>\n", to);
    murk_table_destroy(table);
    return status;
}
