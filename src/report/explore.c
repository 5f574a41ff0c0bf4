/* Who has to explore: what is covered along the way, in the report. */
#include "report/chart.h"
#include "report/html.h"
#include "report/plan.h"

#include <math.h>
#include <stdlib.h>

#define CELL 32

static void draw_against(FILE *to, const double *x, const double *coverage,
                         size_t n, bool by_path)
{
    const murk_chart_series series = {
        .name = "coverage", .n = n, .x = x, .y = coverage, .is_line = true};
    const murk_chart chart = {
        .title = by_path ? "Coverage along the way that was gone"
                         : "Coverage by sensors set up on the way",
        .x_title = by_path ? "way gone, m" : "step",
        .y_title = "coverage, in sample",
        .x = by_path ? MURK_SCALE_EVEN : MURK_SCALE_WHOLE,
        .y = MURK_SCALE_SHARE};
    murk_chart_draw(to, &chart, &series, 1);
}

/* Both begin with nothing. */
static bool draw(FILE *to, const murk_yaml *steps, size_t n)
{
    double *room = malloc(3 * (n + 1) * sizeof *room);
    if (!room) {
        return false;
    }
    double *coverage = room, *path = room + n + 1, *step = path + n + 1;
    coverage[0] = path[0] = step[0] = 0;
    for (size_t i = 0; i < n; ++i) {
        coverage[i + 1] = murk_result_number(steps->child[i], "coverage");
        path[i + 1] = murk_result_number(steps->child[i], "path_m");
        step[i + 1] = (double)(i + 1);
    }
    fputs("<div class=\"plans\">\n", to);
    draw_against(to, step, coverage, n + 1, false);
    draw_against(to, path, coverage, n + 1, true);
    fputs("</div>\n", to);
    free(room);
    return true;
}

static void write_steps(FILE *to, const murk_yaml *steps, size_t n)
{
    static const char *const heads[] = {"step",     "sensor",     "gain",
                                        "coverage", "way gone m", "places seen",
                                        "queries",  "shadow rays"};
    murk_page_table_begin(to, "Step by step", heads, 8);
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        const murk_yaml *step = steps->child[i];
        char name[CELL];
        snprintf(name, sizeof name, "%zu", i + 1);
        murk_page_row_begin(to, name);
        murk_page_cell_number(to, murk_result_number(step, "sensor"));
        murk_page_cell_share(to, murk_result_number(step, "gain"), NAN);
        murk_page_cell_share(to, murk_result_number(step, "coverage"), NAN);
        murk_page_cell_number(to, murk_result_number(step, "path_m"));
        murk_page_cell_number(to, murk_result_number(step, "places_seen"));
        murk_page_cell_number(to, murk_result_number(step, "queries"));
        murk_page_cell_number(to, murk_result_number(step, "shadow_rays"));
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
    murk_page_more(to, n, "explore.csv");
}

bool murk_report_explore(FILE *to, const murk_yaml *plan)
{
    const murk_yaml *explore = murk_result_at(plan, "explore");
    const murk_yaml *steps = murk_result_at(explore, "steps");
    const size_t n = murk_result_count(explore, "steps");
    if (n == 0) {
        return true;
    }
    fputs("<h3>Exploring</h3>\n<p>", to);
    murk_page_number(to, murk_result_number(explore, "path_m"));
    fputs(" m were gone, and ", to);
    murk_page_number(to, murk_result_number(explore, "places_seen"));
    fputs(" of ", to);
    murk_page_number(to, murk_result_number(explore, "places"));
    fputs(" places seen on the way. What ended it: ", to);
    murk_page_text(to, murk_result_text(explore, "ended_by"));
    fputs(".</p>\n", to);
    const bool is_whole = draw(to, steps, n);
    write_steps(to, steps, n);
    return is_whole;
}
