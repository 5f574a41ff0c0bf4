/* What each sensor sees, and how many see the same, in the report. */
#include "report/answers.h"
#include "report/chart_bars.h"
#include "report/html.h"
#include "report/plan.h"

#include <math.h>
#include <stdlib.h>

#define CELL 64

/* ---- bars ---- */

/* Of each what others see, too, and what only it does. */
static bool draw_shares(FILE *to, const murk_yaml *list, size_t n,
                        const char *axis_title)
{
    static const char *const parts[] = {"only it covers",
                                        "it covers, and others do, too"};
    const size_t rows = n < MURK_BARS_MAX ? n : MURK_BARS_MAX;
    double *value = malloc(2 * (rows + 1) * sizeof *value);
    char(*text)[CELL] = malloc((rows + 1) * sizeof *text);
    const char **name = malloc((rows + 1) * sizeof *name);
    const bool is_whole = value && text && name;
    for (size_t i = 0; is_whole && i < rows; ++i) {
        const murk_yaml *sensor = list->child[i];
        const char *type = murk_result_text(sensor, "type");
        type = type ? type : murk_result_text(sensor, "name");
        const double only = murk_result_number(sensor, "only_it_covers");
        const double covers = murk_result_number(sensor, "covers");
        snprintf(text[i], CELL, "%zu%s%.40s", i + 1, type ? " " : "",
                 type ? type : "");
        name[i] = text[i];
        value[2 * i] = fmax(only, 0);
        value[2 * i + 1] = fmax(covers - fmax(only, 0), 0);
    }
    const murk_bars bars = {
        .title = n > rows ? "What each sensor covers (the first of them)"
                          : "What each sensor covers",
        .axis_title = axis_title,
        .rows = rows,
        .parts = 2,
        .name = name,
        .part = parts,
        .value = value,
        .scale = MURK_SCALE_SHARE};
    if (is_whole) {
        murk_bars_draw(to, &bars);
    }
    free(value);
    free(text);
    free(name);
    return is_whole;
}

static bool draw_seen(FILE *to, const murk_yaml *list, size_t n,
                      const char *axis_title)
{
    const size_t rows = n < MURK_BARS_MAX ? n : MURK_BARS_MAX;
    double *value = malloc((rows + 1) * sizeof *value);
    char(*text)[CELL] = malloc((rows + 1) * sizeof *text);
    const char **name = malloc((rows + 1) * sizeof *name);
    const bool is_whole = value && text && name;
    for (size_t i = 0; is_whole && i < rows; ++i) {
        snprintf(text[i], CELL, i + 1 < n ? "%zu or more" : "all %zu", i + 1);
        name[i] = text[i];
        value[i] = murk_result_number(list->child[i], "");
    }
    const murk_bars bars = {.title = "What so many sensors see at once, by "
                                     "weight, however dimly it is seen",
                            .axis_title = axis_title,
                            .rows = rows,
                            .parts = 1,
                            .name = name,
                            .value = value,
                            .scale = MURK_SCALE_SHARE};
    if (is_whole) {
        murk_bars_draw(to, &bars);
    }
    free(value);
    free(text);
    free(name);
    return is_whole;
}

/* ---- tables ---- */

static void write_place(FILE *to, const murk_yaml *sensor)
{
    const murk_yaml *place = murk_result_at(sensor, "position_m");
    for (size_t k = 0; k < 3; ++k) {
        const bool has = place && place->kind == MURK_YAML_LIST && k < place->n;
        murk_page_cell_number(to, has ? murk_result_number(place->child[k], "")
                                      : NAN);
    }
    murk_page_cell_number(to, murk_result_number(sensor, "heading_deg"));
    murk_page_cell_number(to, murk_result_number(sensor, "tilt_deg"));
}

static void write_column(FILE *to, const murk_yaml *sensor)
{
    murk_page_cell_number(to, murk_result_number(sensor, "column"));
    murk_page_cell_text(to, murk_result_text(sensor, "name"));
    murk_page_cell_number(to, murk_result_number(sensor, "cost"));
}

static void write_table(FILE *to, const murk_yaml *list, size_t n,
                        bool is_matrix, const char *file)
{
    static const char *const places[] = {
        "sensor",    "<type",  "x m",       "y m",           "z m",
        "heading °", "tilt °", "it covers", "only it covers"};
    static const char *const columns[] = {
        "chosen", "column", "<name", "cost", "it covers", "only it covers"};
    if (is_matrix) {
        murk_page_table_begin(to, "The columns", columns, 6);
    } else {
        murk_page_table_begin(to, "The sensors", places, 9);
    }
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        const murk_yaml *sensor = list->child[i];
        char name[CELL];
        snprintf(name, sizeof name, "%zu", i + 1);
        murk_page_row_begin(to, name);
        if (is_matrix) {
            write_column(to, sensor);
        } else {
            murk_page_cell_text(to, murk_result_text(sensor, "type"));
            write_place(to, sensor);
        }
        murk_page_cell_share(to, murk_result_number(sensor, "covers"), NAN);
        murk_page_cell_share(to, murk_result_number(sensor, "only_it_covers"),
                             NAN);
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
    murk_page_more(to, n, file);
}

static void write_seen(FILE *to, const murk_yaml *list, size_t n)
{
    static const char *const heads[] = {"sensors", "see together"};
    fputs("<details><summary>The same as a table</summary>\n", to);
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
    murk_page_more(to, n, "seen_by_at_least of the JSON");
    fputs("</details>\n", to);
}

/* Of at least one region. */
static void write_regions(FILE *to, const murk_yaml *list, size_t n)
{
    const bool of_targets =
        isfinite(murk_result_number(list->child[0], "targets"));
    const char *const heads[] = {"name", "weight",
                                 of_targets ? "targets" : "stored photons",
                                 "in sample", "held out"};
    murk_page_table_begin(to, "Coverage of regions of interest", heads, 5);
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        const murk_yaml *row = list->child[i];
        murk_page_row_begin(to, murk_result_text(row, "name"));
        murk_page_cell_number(to, murk_result_number(row, "weight"));
        murk_page_cell_number(
            to,
            murk_result_number(row, of_targets ? "targets" : "stored_photons"));
        murk_page_cell_share(to, murk_result_number(row, "coverage"),
                             murk_result_number(row, "standard_error"));
        murk_page_cell_share(
            to, murk_result_number(row, "held_out"),
            murk_result_number(row, "held_out_standard_error"));
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
    murk_page_more(to, n, "the JSON");
}

bool murk_report_sensors(FILE *to, const murk_results_in *results,
                         const murk_yaml *plan)
{
    const murk_yaml *list = murk_result_at(plan, "sensors");
    const murk_yaml *seen = murk_result_at(plan, "seen_by_at_least");
    const size_t n = murk_result_count(plan, "sensors");
    const size_t n_seen = murk_result_count(plan, "seen_by_at_least");
    const size_t regions = murk_result_count(plan, "regions_of_interest");
    const bool is_matrix = murk_result_text(plan, "matrix.file") != NULL;
    const bool is_made = results->json[MURK_RESULT_PLAN] != NULL;
    const char *share = is_matrix                       ? "share of the rows"
                        : murk_answer_has_targets(plan) ? "share of the targets"
                                                        : "share of the light";
    bool is_whole = true;
    if (n > 0) {
        fprintf(to, "<h3>%s</h3>\n", is_matrix ? "Columns" : "Sensors");
        write_table(to, list, n, is_matrix,
                    is_made ? "plan.json" : "coverage.json");
        fputs("<div class=\"plans\">\n", to);
        is_whole = draw_shares(to, list, n, share) &&
                   (n_seen == 0 || draw_seen(to, seen, n_seen, share));
        fputs("</div>\n", to);
    }
    if (n_seen > 0) {
        write_seen(to, seen, n_seen);
    }
    if (regions > 0) {
        write_regions(to, murk_result_at(plan, "regions_of_interest"), regions);
    }
    return is_whole;
}
