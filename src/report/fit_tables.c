#include "report/fit.h"
#include "report/html.h"

#include <math.h>
#include <string.h>

#define HEADS_MAX (KEYS_MAX + 5) /* and the columns that all have */

/* Keys that have a column; more are told by fit.json alone. */
#define KEYS_MAX 24

/* The keys as heads from heads[1] on; their number, 0 where they are too many
 * for a table. */
static size_t name_keys(const char *heads[HEADS_MAX], const murk_yaml *fit)
{
    const size_t n = murk_result_count(fit, "parameters");
    const murk_yaml *list = murk_result_at(fit, "parameters");
    for (size_t i = 0; i < n && i < KEYS_MAX; ++i) {
        const char *key = murk_result_text(list->child[i], "key");
        heads[i + 1] = key ? key : "";
    }
    return n <= KEYS_MAX ? n : 0;
}

void murk_report_fit_value(FILE *to, const murk_yaml *parameter)
{
    const double value = murk_result_number(parameter, "value");
    if (murk_result_is(parameter, "status", "determined") || !isfinite(value)) {
        murk_page_estimate(to, value,
                           murk_result_number(parameter, "standard_error"));
        return;
    }
    murk_page_power(to, value, 2);
    fputs(" (", to);
    murk_page_text(to, murk_result_text(parameter, "status"));
    fputs(")", to);
}

void murk_report_correlations(FILE *to, const murk_yaml *fit)
{
    const char *heads[HEADS_MAX] = {"key"};
    const size_t n = name_keys(heads, fit);
    const murk_yaml *matrix = murk_result_at(fit, "correlation");
    if (n < 2 || murk_result_count(fit, "correlation") != n) {
        return;
    }
    fputs("<h3>Correlations</h3>\n", to);
    murk_page_paragraph(to, "From -1 to 1; the deeper the shade, the more the "
                            "readings tell of both together only.");
    murk_page_table_begin(to, "Correlations of the values", heads, n + 1);
    for (size_t i = 0; i < n; ++i) {
        const murk_yaml *row = matrix->child[i];
        murk_page_row_begin(to, heads[i + 1]);
        for (size_t k = 0; k < n; ++k) {
            const bool has = row->kind == MURK_YAML_LIST && k < row->n;
            const double value =
                has ? murk_result_number(row->child[k], "") : NAN;
            murk_page_shaded_begin(to, i == k ? 0 : value);
            if (isfinite(value) && fabs(value) <= 1) {
                fprintf(to, "%.3f", value);
            } else {
                murk_page_number(to, value);
            }
            murk_page_shaded_end(to);
        }
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
}

/* What a map by keys holds, in the order of the heads. */
static void write_by_key(FILE *to, const murk_yaml *map,
                         const char *const *heads, size_t n, bool is_shaded)
{
    for (size_t k = 0; k < n; ++k) {
        const murk_yaml *one = map && map->kind == MURK_YAML_MAP
                                   ? murk_yaml_get(map, heads[k + 1])
                                   : NULL;
        const double value = murk_result_number(one, "");
        murk_page_shaded_begin(to, is_shaded ? value : 0);
        murk_page_number(to, value);
        murk_page_shaded_end(to);
    }
}

void murk_report_directions(FILE *to, const murk_yaml *fit)
{
    const char *heads[HEADS_MAX] = {"direction"};
    const size_t n = name_keys(heads, fit);
    const murk_yaml *list = murk_result_at(fit, "identifiability.directions");
    const size_t rows = murk_result_count(fit, "identifiability.directions");
    if (n < 2 || rows == 0) {
        return;
    }
    heads[n + 1] = "standard error";
    heads[n + 2] = "<determined";
    fputs("<h3>What the readings tell</h3>\n", to);
    murk_page_paragraph(
        to, "Combinations of the values (of their logarithms, where they are "
            "positive), from the best known to the worst: how much of each "
            "value is in it, and how well it is known.");
    murk_page_table_begin(to, "Directions", heads, n + 3);
    for (size_t i = 0; i < rows && i < MURK_PAGE_ROWS_MAX; ++i) {
        const murk_yaml *one = list->child[i];
        char name[32];
        snprintf(name, sizeof name, "%zu", i + 1);
        murk_page_row_begin(to, name);
        write_by_key(to, murk_result_at(one, "direction"), heads, n, true);
        murk_page_cell_number(to, murk_result_number(one, "standard_error"));
        murk_page_cell_text(to, murk_result_text(one, "determined"));
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
}

void murk_report_starts(FILE *to, const murk_yaml *fit)
{
    const char *heads[HEADS_MAX] = {"start"};
    const size_t n = name_keys(heads, fit);
    const murk_yaml *list = murk_result_at(fit, "starts");
    const size_t rows = murk_result_count(fit, "starts");
    if (n == 0 || rows == 0) {
        return;
    }
    heads[n + 1] = "chi²";
    heads[n + 2] = "light traced";
    heads[n + 3] = "<converged";
    heads[n + 4] = "<why it ended";
    fputs("<h3>The search</h3>\n", to);
    murk_page_table_begin(to, "Where each search began and ended", heads,
                          n + 5);
    for (size_t i = 0; i < rows && i < MURK_PAGE_ROWS_MAX; ++i) {
        const murk_yaml *one = list->child[i];
        char name[32];
        snprintf(name, sizeof name, "%zu from", i + 1);
        murk_page_row_begin(to, name);
        write_by_key(to, murk_result_at(one, "from"), heads, n, false);
        fputs("<td></td><td></td><td></td><td></td>", to);
        murk_page_row_end(to);
        snprintf(name, sizeof name, "%zu to", i + 1);
        murk_page_row_begin(to, name);
        write_by_key(to, murk_result_at(one, "to"), heads, n, false);
        murk_page_cell_number(to, murk_result_number(one, "chi2"));
        murk_page_cell_number(to, murk_result_number(one, "traces"));
        murk_page_cell_text(to, murk_result_text(one, "converged"));
        murk_page_cell_text(to, murk_result_text(one, "why"));
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
    murk_page_more(to, rows, "fit.json");
}

void murk_report_next(FILE *to, const murk_yaml *fit)
{
    static const char *const heads[] = {
        "place", "x m", "y m", "z m", "gain", "predicted", "standard error"};
    const murk_yaml *next = murk_result_at(fit, "next");
    const murk_yaml *list = murk_result_at(next, "places");
    const size_t n = murk_result_count(next, "places");
    if (n == 0) {
        return;
    }
    fputs("<h3>What to measure next</h3>\n<p>Readings of ", to);
    murk_page_text(to, murk_result_text(next, "kind"));
    fputs(" that would tell most of what is not known yet, in ", to);
    murk_page_text(to, murk_result_text(next, "unit"));
    fputs("; the gain is of information, in units of the natural "
          "logarithm.</p>\n",
          to);
    murk_page_table_begin(to, "Proposed places", heads, 7);
    for (size_t i = 0; i < n && i < MURK_PAGE_ROWS_MAX; ++i) {
        const murk_yaml *one = list->child[i];
        const murk_yaml *place = murk_result_at(one, "position_m");
        char name[32];
        snprintf(name, sizeof name, "%zu", i + 1);
        murk_page_row_begin(to, name);
        for (size_t k = 0; k < 3; ++k) {
            const bool has =
                place && place->kind == MURK_YAML_LIST && k < place->n;
            murk_page_cell_number(
                to, has ? murk_result_number(place->child[k], "") : NAN);
        }
        murk_page_cell_number(to, murk_result_number(one, "gain"));
        murk_page_cell_number(to, murk_result_number(one, "predicted"));
        murk_page_cell_number(to, murk_result_number(one, "standard_error"));
        murk_page_row_end(to);
    }
    murk_page_table_end(to);
}
