/* A placement, as sections of the report. */
#include "app/chart.h"
#include "app/page.h"
#include "app/report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define CELL 48

/* What a list of maps holds under a key: values[n] for free(); NULL when out
 * of memory. */
static double *column_of(const murk_yaml *list, size_t n, const char *key)
{
    double *values = malloc((n + 1) * sizeof *values);
    for (size_t i = 0; values && i < n; ++i) {
        values[i] = murk_result_number(list->child[i], key);
    }
    return values;
}

/* ---- the plan in a sentence and a table ---- */

static void write_sentence(FILE *to, const murk_yaml *plan)
{
    const size_t n = murk_result_count(plan, "sensors");
    const double held_out = murk_result_number(plan, "coverage.held_out");
    const double upper = murk_result_number(plan, "bound.upper");
    fprintf(to, "<p class=\"lead\">%zu sensor%s see%s <strong>", n,
            n == 1 ? "" : "s", n == 1 ? "s" : "");
    if (isfinite(held_out)) {
        murk_page_share(
            to, held_out,
            murk_result_number(plan, "coverage.held_out_standard_error"));
        fputs("</strong> of the light of a second, independent map.", to);
    } else {
        double error =
            murk_result_number(plan, "coverage.in_sample_standard_error");
        if (!isfinite(error)) {
            error = murk_result_number(plan, "coverage.standard_error");
        }
        murk_page_share(to, murk_result_number(plan, "coverage.in_sample"),
                        error);
        fputs("</strong> of the light of this run's map.", to);
    }
    if (isfinite(upper)) {
        fputs(" On the map that it was chosen by, no plan of this kind sees "
              "more than <strong>",
              to);
        murk_page_share(to, upper, NAN);
        fputs("</strong>.", to);
    }
    fputs("</p>\n", to);
}

static void write_summary(FILE *to, const murk_yaml *plan)
{
    murk_page_table_begin(to, "The placement in numbers", NULL, 0);
    murk_page_fact_share(
        to, "in sample: the map that it was chosen by",
        murk_result_number(plan, "coverage.in_sample"),
        murk_result_number(plan, "coverage.in_sample_standard_error"));
    murk_page_fact_share(
        to, "held out: an independent map",
        murk_result_number(plan, "coverage.held_out"),
        murk_result_number(plan, "coverage.held_out_standard_error"));
    murk_page_fact_share(to, "of light on surfaces",
                         murk_result_number(plan, "coverage.surface"), NAN);
    murk_page_fact_share(to, "of light scattered in media",
                         murk_result_number(plan, "coverage.volume"), NAN);
    murk_page_fact_share(to, "ceiling: all candidates at once",
                         murk_result_number(plan, "coverage.ceiling"), NAN);
    murk_page_fact_share(to, "upper bound",
                         murk_result_number(plan, "bound.upper"), NAN);
    murk_page_fact_share(to, "gap to the bound",
                         murk_result_number(plan, "bound.gap"), NAN);
    murk_page_fact(to, "proven optimal",
                   murk_result_text(plan, "bound.proven_optimal"));
    murk_page_fact(to, "method", murk_result_text(plan, "placement.method"));
    murk_page_fact_number(to, "candidates that were usable",
                          murk_result_number(plan, "candidates.usable"), "");
    murk_page_fact_number(to, "photons emitted",
                          murk_result_number(plan, "photons.emitted"), "");
    murk_page_fact_number(to, "photons stored on surfaces",
                          murk_result_number(plan, "photons.surface"), "");
    murk_page_fact_number(to, "photons stored in media",
                          murk_result_number(plan, "photons.volume"), "");
    murk_page_table_end(to);
}

/* ---- curve ---- */

static void write_curve_rows(FILE *to, const double *count,
                             const double *coverage, const double *upper,
                             size_t n)
{
    static const char *const heads[] = {"sensors", "coverage", "upper bound"};
    fputs("<details><summary>The curve as a table</summary>\n", to);
    murk_page_table_begin(to, "Coverage by number of sensors", heads, 3);
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        char name[CELL];
        snprintf(name, sizeof name, "%.0f", count[i]);
        murk_page_row_begin(to, name);
        murk_page_cell_share(to, coverage[i], NAN);
        murk_page_cell_share(to, upper[i], NAN);
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
    murk_page_more(to, n, "plan.json");
    fputs("</details>\n", to);
}

static bool write_curve(FILE *to, const murk_yaml *plan)
{
    const size_t n = murk_result_count(plan, "curve");
    if (n == 0) {
        return true;
    }
    const murk_yaml *curve = murk_result_at(plan, "curve");
    double *count = column_of(curve, n, "count");
    double *coverage = column_of(curve, n, "coverage");
    double *upper = column_of(curve, n, "upper");
    const bool is_whole = count && coverage && upper;
    if (is_whole) {
        const murk_chart_series series[] = {{.name = "coverage",
                                             .n = n,
                                             .x = count,
                                             .y = coverage,
                                             .low = coverage,
                                             .high = upper,
                                             .is_line = true},
                                            {.name = "no plan sees more",
                                             .n = n,
                                             .x = count,
                                             .y = upper,
                                             .is_line = true}};
        const murk_chart chart = {
            .title = "Coverage by number of sensors, and how much more could "
                     "be had at most (on the map that was chosen by)",
            .x_title = "sensors",
            .y_title = "coverage",
            .x = MURK_SCALE_WHOLE,
            .y = MURK_SCALE_SHARE};
        fputs("<h3>Coverage curve</h3>\n", to);
        murk_chart_draw(to, &chart, series, 2);
        write_curve_rows(to, count, coverage, upper, n);
    }
    free(count);
    free(coverage);
    free(upper);
    return is_whole;
}

/* ---- in sample against held out ---- */

static bool write_samples(FILE *to, const murk_yaml *plan)
{
    const char *list_path = "robustness.drop_one.without";
    const size_t n = murk_result_count(plan, list_path) + 1;
    if (!isfinite(murk_result_number(plan, "coverage.held_out"))) {
        return true;
    }
    const murk_yaml *list = murk_result_at(plan, list_path);
    double *at = malloc(2 * n * sizeof *at);
    double *in = malloc(n * sizeof *in), *out = malloc(n * sizeof *out);
    double *low = malloc(2 * n * sizeof *low);
    double *high = malloc(2 * n * sizeof *high);
    char(*text)[CELL] = calloc(n, sizeof *text);
    const char **name = malloc(n * sizeof *name);
    const bool is_whole = at && in && out && low && high && text && name;
    if (is_whole) {
        const double in_error =
            murk_result_number(plan, "coverage.in_sample_standard_error");
        const double out_error =
            murk_result_number(plan, "coverage.held_out_standard_error");
        for (size_t i = 0; i < n; ++i) {
            const murk_yaml *row = i == 0 ? NULL : list->child[i - 1];
            const double sensor = murk_result_number(row, "sensor");
            snprintf(text[i], CELL, i == 0 ? "all" : "no %.0f", sensor);
            name[i] = text[i];
            at[i] = (double)i - 0.08;
            at[n + i] = (double)i + 0.08;
            in[i] = i == 0 ? murk_result_number(plan, "coverage.in_sample")
                           : murk_result_number(row, "in_sample");
            out[i] = i == 0 ? murk_result_number(plan, "coverage.held_out")
                            : murk_result_number(row, "held_out");
            /* the errors are those of the whole plan */
            low[i] = in[i] - (i == 0 ? 1.96 * in_error : NAN);
            high[i] = in[i] + (i == 0 ? 1.96 * in_error : NAN);
            low[n + i] = out[i] - (i == 0 ? 1.96 * out_error : NAN);
            high[n + i] = out[i] + (i == 0 ? 1.96 * out_error : NAN);
        }
        const murk_chart_series series[] = {{.name = "in sample",
                                             .n = n,
                                             .x = at,
                                             .y = in,
                                             .low = low,
                                             .high = high},
                                            {.name = "held out",
                                             .n = n,
                                             .x = at + n,
                                             .y = out,
                                             .low = low + n,
                                             .high = high + n}};
        const murk_chart chart = {
            .title = "In sample against held out: the plan (with its 95 % "
                     "interval), and without each of its sensors",
            .x_title = "sensors left",
            .y_title = "coverage",
            .x_name = name,
            .x_names = n,
            .y = MURK_SCALE_SHARE};
        fputs("<h3>In sample against held out</h3>\n", to);
        murk_page_paragraph(
            to, "A plan is chosen to suit one sample of photons, so it looks "
                "better on that than it is. The held-out value is the one to "
                "quote.");
        murk_chart_draw(to, &chart, series, 2);
    }
    free(at);
    free(in);
    free(out);
    free(low);
    free(high);
    free(text);
    free(name);
    return is_whole;
}

/* ---- tables ---- */

static void write_sensors(FILE *to, const murk_yaml *plan, const char *file)
{
    static const char *const heads[] = {
        "sensor",    "<type",  "x m",       "y m",           "z m",
        "heading °", "tilt °", "it covers", "only it covers"};
    const size_t n = murk_result_count(plan, "sensors");
    const murk_yaml *list = murk_result_at(plan, "sensors");
    if (n == 0) {
        return;
    }
    murk_page_table_begin(to, "The sensors", heads, 9);
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        const murk_yaml *sensor = list->child[i];
        const murk_yaml *place = murk_result_at(sensor, "position_m");
        const char *type = murk_result_text(sensor, "type");
        char name[CELL];
        snprintf(name, sizeof name, "%zu", i + 1);
        murk_page_row_begin(to, name);
        murk_page_cell_text(to, type ? type : murk_result_text(sensor, "name"));
        for (size_t k = 0; k < 3; ++k) {
            const bool has =
                place && place->kind == MURK_YAML_LIST && k < place->n;
            murk_page_cell_number(
                to, has ? murk_result_number(place->child[k], "") : NAN);
        }
        murk_page_cell_number(to, murk_result_number(sensor, "heading_deg"));
        murk_page_cell_number(to, murk_result_number(sensor, "tilt_deg"));
        murk_page_cell_share(to, murk_result_number(sensor, "covers"), NAN);
        murk_page_cell_share(to, murk_result_number(sensor, "only_it_covers"),
                             NAN);
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
    murk_page_more(to, n, file);
}

static void write_seen(FILE *to, const murk_yaml *plan)
{
    static const char *const heads[] = {"sensors", "see together"};
    const size_t n = murk_result_count(plan, "seen_by_at_least");
    const murk_yaml *list = murk_result_at(plan, "seen_by_at_least");
    if (n == 0) {
        return;
    }
    murk_page_table_begin(to, "Light seen by at least so many sensors", heads,
                          2);
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        char name[CELL];
        snprintf(name, sizeof name, "%zu or more", i + 1);
        murk_page_row_begin(to, name);
        murk_page_cell_share(to, murk_result_number(list->child[i], ""), NAN);
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
}

/* Regions of interest and conditions: named shares with errors. */
static void write_named(FILE *to, const murk_yaml *plan, const char *path,
                        const char *caption, const char *in_sample)
{
    const char *const heads[] = {"name", "weight", "in sample", "held out"};
    const size_t n = murk_result_count(plan, path);
    const murk_yaml *list = murk_result_at(plan, path);
    if (n == 0) {
        return;
    }
    murk_page_table_begin(to, caption, heads, 4);
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        const murk_yaml *row = list->child[i];
        murk_page_row_begin(to, murk_result_text(row, "name"));
        murk_page_cell_number(to, murk_result_number(row, "weight"));
        murk_page_cell_share(to, murk_result_number(row, in_sample), NAN);
        murk_page_cell_share(
            to, murk_result_number(row, "held_out"),
            murk_result_number(row, "held_out_standard_error"));
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
}

murk_status murk_report_plan(FILE *to, const murk_results_in *results,
                             murk_error *err)
{
    const bool is_made = results->json[MURK_RESULT_PLAN] != NULL;
    const murk_yaml *plan = is_made ? results->json[MURK_RESULT_PLAN]
                                    : results->json[MURK_RESULT_COVERAGE];
    if (!plan) {
        return MURK_OK;
    }
    murk_page_section_begin(to, "placement",
                            is_made ? "The placement" : "What the sensors see");
    write_sentence(to, plan);
    write_summary(to, plan);
    if (!write_curve(to, plan) || !write_samples(to, plan)) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the plots");
    }
    fputs("<h3>Sensors</h3>\n", to);
    write_sensors(to, plan, is_made ? "plan.json" : "coverage.json");
    write_seen(to, plan);
    write_named(to, plan, "regions_of_interest", "Regions of interest",
                "coverage");
    write_named(to, plan, "conditions", "Conditions", "in_sample");
    murk_page_section_end(to);
    return MURK_OK;
}
