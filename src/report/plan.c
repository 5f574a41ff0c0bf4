/* A placement, as sections of the report. */
#include "report/plan.h"
#include "report/answers.h"
#include "report/chart.h"
#include "report/html.h"
#include "report/sections.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define CELL        48
#define SAMPLES_MAX 40 /* conditions that are drawn */

/* Half a 95 % interval, in standard errors. */
#define HALF_INTERVAL 1.96

/* ---- numbers ---- */

/* Rows of what there is. */
static void fact_share(FILE *to, const murk_yaml *plan, const char *name,
                       const char *key, const char *error_key)
{
    const double share = murk_result_number(plan, key);
    if (isfinite(share)) {
        murk_page_fact_share(to, name, share,
                             murk_result_number(plan, error_key));
    }
}

static void fact_count(FILE *to, const murk_yaml *plan, const char *name,
                       const char *key)
{
    const double count = murk_result_number(plan, key);
    if (isfinite(count)) {
        murk_page_fact_number(to, name, count, "");
    }
}

static void fact_text(FILE *to, const murk_yaml *plan, const char *name,
                      const char *key)
{
    const char *text = murk_result_text(plan, key);
    if (text) {
        murk_page_fact(to, name, text);
    }
}

static void write_numbers(FILE *to, const murk_yaml *plan, bool is_made)
{
    murk_page_table_begin(to, "The placement in numbers", NULL, 0);
    fact_share(to, plan,
               is_made ? "in sample: the sample that it was chosen by"
                       : "coverage",
               "coverage.in_sample",
               is_made ? "coverage.in_sample_standard_error"
                       : "coverage.standard_error");
    fact_share(to, plan, "held out: an independent sample", "coverage.held_out",
               "coverage.held_out_standard_error");
    const bool of_targets = murk_answer_has_targets(plan);
    fact_share(to, plan,
               of_targets ? "of targets on surfaces" : "of light on surfaces",
               "coverage.surface", "coverage.surface_standard_error");
    fact_share(to, plan,
               of_targets ? "of targets in the volume"
                          : "of light scattered in media",
               "coverage.volume", "coverage.volume_standard_error");
    fact_share(to, plan, "ceiling: all candidates at once", "coverage.ceiling",
               "");
    fact_share(to, plan, "upper bound", "bound.upper", "");
    fact_share(to, plan, "gap to the bound", "bound.gap", "");
    fact_text(to, plan, "proven optimal", "bound.proven_optimal");
    fact_text(to, plan, "what the method guarantees", "bound.guarantee");
    fact_text(to, plan, "method", "placement.method");
    fact_text(to, plan, "detection", "placement.detection");
    fact_text(to, plan, "knowledge", "placement.knowledge");
    fact_count(to, plan,
               of_targets ? "views of a target that count"
                          : "views of a photon that count",
               "placement.redundancy");
    fact_count(to, plan, "candidates asked for", "candidates.asked");
    fact_count(to, plan, "candidates that were usable", "candidates.usable");
    fact_count(to, plan, "plans weighed", "placement.evaluations");
    fact_count(to, plan, "shadow rays", "placement.shadow_rays");
    fact_share(to, plan, "what surfaces have in the coverage",
               "weights_used.surface", "");
    fact_share(to, plan, "what media have in the coverage",
               "weights_used.volume", "");
    if (murk_answer_has_targets(plan)) {
        fact_count(to, plan, "targets", "targets.points");
        fact_count(to, plan, "targets on sides of surfaces", "targets.surface");
        fact_count(to, plan, "targets in the volume", "targets.volume");
    } else {
        fact_count(to, plan, "photons emitted", "photons.emitted");
        fact_count(to, plan, "photons stored on surfaces", "photons.surface");
        fact_count(to, plan, "photons stored in media", "photons.volume");
    }
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
    double *count = murk_result_column(curve, n, "count");
    double *coverage = murk_result_column(curve, n, "coverage");
    double *upper = murk_result_column(curve, n, "upper");
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
        fputs("<div>\n<h3>Coverage curve</h3>\n", to);
        murk_chart_draw(to, &chart, series, 2);
        write_curve_rows(to, count, coverage, upper, n);
        fputs("</div>\n", to);
    }
    free(count);
    free(coverage);
    free(upper);
    return is_whole;
}

/* ---- in sample against held out ---- */

/* Of the plan, and of each condition: two of each, beside each other. */
typedef struct samples {
    size_t n;
    double *room; /* [8 * n]: of in sample, then held out: x, y, low, high */
    const char **name;
} samples;

static void put_sample(const samples *s, size_t i, const char *name,
                       const murk_yaml *root)
{
    static const char *const key[][2] = {
        {"in_sample", "in_sample_standard_error"},
        {"held_out", "held_out_standard_error"}};
    s->name[i] = name ? name : "";
    for (size_t k = 0; k < 2; ++k) {
        double *x = s->room + 4 * s->n * k, *y = x + s->n;
        double *low = y + s->n, *high = low + s->n;
        const double error = murk_result_number(root, key[k][1]);
        x[i] = (double)i + (k == 0 ? -0.08 : 0.08);
        y[i] = murk_result_number(root, key[k][0]);
        low[i] = y[i] - HALF_INTERVAL * error;
        high[i] = y[i] + HALF_INTERVAL * error;
    }
}

static void draw_samples(FILE *to, const samples *s, bool has_conditions)
{
    const double *r = s->room;
    const size_t n = s->n;
    const murk_chart_series series[] = {{.name = "in sample",
                                         .n = n,
                                         .x = r,
                                         .y = r + n,
                                         .low = r + 2 * n,
                                         .high = r + 3 * n},
                                        {.name = "held out",
                                         .n = n,
                                         .x = r + 4 * n,
                                         .y = r + 5 * n,
                                         .low = r + 6 * n,
                                         .high = r + 7 * n}};
    const murk_chart chart = {.title = "In sample against held out, each with "
                                       "its 95 % interval",
                              .x_title = has_conditions ? "measured in" : "",
                              .y_title = "coverage",
                              .x_name = s->name,
                              .x_names = n,
                              .y = MURK_SCALE_SHARE};
    murk_chart_draw(to, &chart, series, 2);
}

static bool write_samples(FILE *to, const murk_yaml *plan)
{
    const size_t conditions = murk_result_count(plan, "conditions");
    const murk_yaml *list = murk_result_at(plan, "conditions");
    if (!isfinite(murk_result_number(plan, "coverage.held_out"))) {
        return true;
    }
    samples s = {.n =
                     1 + (conditions < SAMPLES_MAX ? conditions : SAMPLES_MAX)};
    s.room = malloc(8 * s.n * sizeof *s.room);
    s.name = malloc(s.n * sizeof *s.name);
    const bool is_whole = s.room && s.name;
    if (is_whole) {
        put_sample(&s, 0, "the plan", murk_result_at(plan, "coverage"));
        for (size_t i = 1; i < s.n; ++i) {
            const murk_yaml *one = list->child[i - 1];
            put_sample(&s, i, murk_result_text(one, "name"), one);
        }
        fputs("<div>\n<h3>In sample against held out</h3>\n", to);
        murk_page_paragraph(
            to, "A plan is chosen to suit one sample, so it looks better on "
                "that than it is. The held-out value is the one to quote.");
        draw_samples(to, &s, conditions > 0);
        fputs("</div>\n", to);
    }
    free(s.room);
    free(s.name);
    return is_whole;
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
    fputs("<div class=\"beside\">\n", to);
    write_numbers(to, plan, is_made);
    bool is_whole = write_curve(to, plan) && write_samples(to, plan);
    fputs("</div>\n", to);
    is_whole = is_whole && murk_report_sensors(to, results, plan);
    is_whole = is_whole && murk_report_over(to, plan) &&
               murk_report_robust(to, plan) && murk_report_explore(to, plan);
    murk_status status = is_whole ? MURK_OK
                                  : murk_fail(err, MURK_NO_MEMORY, "",
                                              "no memory for the plots");
    if (!status) {
        status = murk_report_repeat(to, results, plan, err);
    }
    murk_page_section_end(to);
    return status;
}
