/* How a plan fares when a sensor is lost or not quite in place, and how far
 * radio has to reach, in the report. */
#include "report/chart.h"
#include "report/chart_bars.h"
#include "report/html.h"
#include "report/plan.h"

#include <math.h>
#include <stdlib.h>

#define CELL 48

/* ---- a sensor lost ---- */

static bool draw_losses(FILE *to, const murk_yaml *plan, const murk_yaml *list,
                        size_t n)
{
    const size_t rows = n < MURK_BARS_MAX ? n : MURK_BARS_MAX;
    const double held_out = murk_result_number(plan, "coverage.held_out");
    const bool has_held_out = isfinite(held_out);
    const double whole = has_held_out
                             ? held_out
                             : murk_result_number(plan, "coverage.in_sample");
    double *loss = malloc((rows + 1) * sizeof *loss);
    char(*text)[CELL] = malloc((rows + 1) * sizeof *text);
    const char **name = malloc((rows + 1) * sizeof *name);
    const bool is_whole = loss && text && name;
    for (size_t i = 0; is_whole && i < rows; ++i) {
        const murk_yaml *one = list->child[i];
        snprintf(text[i], CELL, "without %.0f",
                 murk_result_number(one, "sensor"));
        name[i] = text[i];
        loss[i] = whole - murk_result_number(one, has_held_out ? "held_out"
                                                               : "in_sample");
    }
    const murk_bars bars = {
        .title = has_held_out
                     ? "Coverage lost where one sensor fails, held out"
                     : "Coverage lost where one sensor fails, in sample",
        .axis_title = "coverage lost",
        .rows = rows,
        .parts = 1,
        .name = name,
        .value = loss,
        .scale = MURK_SCALE_SHARE};
    if (is_whole) {
        murk_bars_draw(to, &bars);
    }
    free(loss);
    free(text);
    free(name);
    return is_whole;
}

/* ---- not quite in place ---- */

static void draw_jitter(FILE *to, const murk_yaml *jitter)
{
    static const char *const names[] = {"as planned", "mean",
                                        "worst twentieth begins"};
    static const double at[] = {0, 1, 2};
    const double mean = murk_result_number(jitter, "mean");
    const double error = murk_result_number(jitter, "mean_standard_error");
    const double value[] = {murk_result_number(jitter, "as_planned"), mean,
                            murk_result_number(jitter, "quantile_5")};
    const double low[] = {NAN, mean - 1.96 * error,
                          murk_result_number(jitter, "quantile_5_lower")};
    const double high[] = {NAN, mean + 1.96 * error,
                           murk_result_number(jitter, "quantile_5_upper")};
    char title[200];
    snprintf(title, sizeof title,
             "Coverage where sensors stand up to %.4g m and %.4g° off, by %.0f "
             "draws, with 95 %% intervals",
             murk_result_number(jitter, "jitter_m"),
             murk_result_number(jitter, "jitter_deg"),
             murk_result_number(jitter, "draws"));
    const murk_chart_series series = {.name = "coverage",
                                      .n = 3,
                                      .x = at,
                                      .y = value,
                                      .low = low,
                                      .high = high};
    const murk_chart chart = {.title = title,
                              .x_title = "",
                              .y_title = "coverage",
                              .x_name = names,
                              .x_names = 3,
                              .y = MURK_SCALE_SHARE};
    murk_chart_draw(to, &chart, &series, 1);
}

static void write_jitter(FILE *to, const murk_yaml *jitter)
{
    murk_page_table_begin(to, "Not quite in place", NULL, 0);
    murk_page_fact_number(to, "off by at most",
                          murk_result_number(jitter, "jitter_m"), "m");
    murk_page_fact_number(to, "turned by at most",
                          murk_result_number(jitter, "jitter_deg"), "°");
    murk_page_fact_number(to, "draws", murk_result_number(jitter, "draws"), "");
    murk_page_fact_share(to, "as planned",
                         murk_result_number(jitter, "as_planned"), NAN);
    murk_page_fact_share(to, "mean", murk_result_number(jitter, "mean"),
                         murk_result_number(jitter, "mean_standard_error"));
    murk_page_fact_share(to, "in 19 of 20 draws at least",
                         murk_result_number(jitter, "quantile_5"), NAN);
    murk_page_fact_share(to, "which is surely (95 %) at least",
                         murk_result_number(jitter, "quantile_5_lower"), NAN);
    murk_page_fact_share(to, "and at most",
                         murk_result_number(jitter, "quantile_5_upper"), NAN);
    murk_page_fact_number(to, "draws of a place that stayed",
                          murk_result_number(jitter, "unmoved"), "");
    murk_page_table_end(to);
}

/* ---- links ---- */

static void write_links(FILE *to, const murk_yaml *robust)
{
    static const char *const heads[] = {"from sensor", "to sensor", "m"};
    const size_t n = murk_result_count(robust, "links");
    const murk_yaml *list = murk_result_at(robust, "links");
    const double range = murk_result_number(robust, "link_range_m");
    const double groups = murk_result_number(robust, "link_groups");
    const double plain = murk_result_number(robust, "plain_link_range_m");
    if (!isfinite(groups)) {
        return;
    }
    fputs("<h4>Links between sensors</h4>\n<p>", to);
    if (isfinite(range)) {
        fputs("All sensors are joined by open ways when each link may be ", to);
        murk_page_number(to, range);
        fputs(" m long.", to);
    } else {
        fputs("Open ways join the sensors to ", to);
        murk_page_count(to, groups, "group", "groups");
        fputs(" only, however long the links.", to);
    }
    if (isfinite(plain)) {
        fputs(" Were all ways open, ", to);
        murk_page_number(to, plain);
        fputs(" m would do.", to);
    }
    fputs("</p>\n", to);
    if (n == 0) {
        return;
    }
    murk_page_table_begin(to, "The links that join them", heads, 3);
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        char name[CELL];
        snprintf(name, sizeof name, "%.0f",
                 murk_result_number(list->child[i], "from"));
        murk_page_row_begin(to, name);
        murk_page_cell_number(to, murk_result_number(list->child[i], "to"));
        murk_page_cell_number(to,
                              murk_result_number(list->child[i], "length_m"));
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
    murk_page_more(to, n, "plan.json");
}

bool murk_report_robust(FILE *to, const murk_yaml *plan)
{
    const murk_yaml *robust = murk_result_at(plan, "robustness");
    const murk_yaml *jitter = murk_result_at(robust, "jitter");
    const murk_yaml *list = murk_result_at(robust, "drop_one.without");
    const size_t n = murk_result_count(robust, "drop_one.without");
    const bool has_jitter = isfinite(murk_result_number(jitter, "mean"));
    bool is_whole = true;
    if (!robust || robust->kind != MURK_YAML_MAP) {
        return true;
    }
    fputs("<h3>When something goes wrong</h3>\n<div class=\"plans\">\n", to);
    if (n > 1) {
        is_whole = draw_losses(to, plan, list, n);
    }
    if (has_jitter) {
        draw_jitter(to, jitter);
    }
    fputs("</div>\n", to);
    if (has_jitter) {
        write_jitter(to, jitter);
    }
    write_links(to, robust);
    return is_whole;
}
