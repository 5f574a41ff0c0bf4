/* Prints the rows of a study as a table on the terminal: the first ROWS_MAX
 * rows, with all axes and as many values as fit the width. */
#include "results/study_print.h"

#include "results/summary.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define CELL_SIZE   40 /* of a value with its error, or of a name */
#define TABLE_WIDTH 80 /* of a terminal */
#define NUMBER      5  /* width of the number of a row */
#define ROWS_MAX    24 /* about a screen */

typedef char cell[CELL_SIZE];

typedef struct table {
    const murk_sweep *sweep;
    const murk_study_row *one; /* the row whose values are the columns; NULL: no
                                  row has values */
    size_t rows, axes, columns; /* rows: number shown; columns: axes, then
                                   values */
} table;

#define HEADING SIZE_MAX /* in place of the number of a row */

/* True if a name ends like "density_475nm", so that the value is of a single
 * band. */
static bool is_of_band(const char *name)
{
    const char *last = strrchr(name, '_');
    const size_t n = last ? strlen(last) : 0;
    return n > 3 && strcmp(last + n - 2, "nm") == 0 &&
           isdigit((unsigned char)last[1]);
}

/* Value k, from 0, among the values of a row that are not of a single band;
 * NULL if there are not so many. */
static const murk_study_value *value_at(const murk_study_row *one, size_t k)
{
    for (size_t i = 0; one && i < one->values; ++i) {
        if (!is_of_band(one->value[i].name) && k-- == 0) {
            return &one->value[i];
        }
    }
    return NULL;
}

static void show_value(cell out, const murk_study_value *v)
{
    if (!v || !isfinite(v->of.value)) {
        snprintf(out, CELL_SIZE, "none");
    } else if (isfinite(v->of.standard_error)) {
        snprintf(out, CELL_SIZE, "%.4g +- %.1g", v->of.value,
                 v->of.standard_error);
    } else {
        snprintf(out, CELL_SIZE, "%.6g", v->of.value);
    }
}

/* The text of one cell. The heading of an axis is the last part of the key:
 * "visibility_m" for "media.fog.visibility_m". */
static void show_cell(cell out, const table *t, size_t row, size_t column)
{
    const murk_study_file *study = t->sweep->desc.study;
    if (column >= t->axes) {
        const murk_study_value *v = value_at(t->one, column - t->axes);
        if (row != HEADING) {
            show_value(out,
                       murk_study_row_get(&t->sweep->row[row].found, v->name));
        } else {
            snprintf(out, CELL_SIZE, "%.24s%s%.12s", v->name,
                     v->unit[0] ? " " : "", v->unit);
        }
    } else if (row != HEADING) {
        size_t index[MURK_STUDY_AXES_MAX];
        murk_study_row_indices(study, row, index);
        snprintf(out, CELL_SIZE, "%s", study->axis[column].text[index[column]]);
    } else {
        const char *name = study->axis[column].name;
        const char *dot = strrchr(name, '.');
        snprintf(out, CELL_SIZE, "%s", dot ? dot + 1 : name);
    }
}

static size_t width_of(const table *t, size_t column)
{
    cell text;
    show_cell(text, t, HEADING, column);
    size_t width = strlen(text);
    for (size_t i = 0; i < t->rows; ++i) {
        show_cell(text, t, i, column);
        width = strlen(text) > width ? strlen(text) : width;
    }
    return width;
}

static void print_line(const table *t, size_t row, const char *number,
                       size_t columns)
{
    murk_print("%-*s", NUMBER, number);
    for (size_t c = 0; c < columns; ++c) {
        cell text;
        show_cell(text, t, row, c);
        murk_print("  %-*s", c + 1 < columns ? (int)width_of(t, c) : 0, text);
    }
    murk_print("\n");
}

static void print_rest(size_t rows, size_t columns, const char *folder)
{
    char more[96] = ""; /* two numbers of up to 20 digits and their words */
    if (rows > 0 && columns > 0) {
        snprintf(more, sizeof more, "%zu more rows, %zu more columns", rows,
                 columns);
    } else if (rows + columns > 0) {
        snprintf(more, sizeof more, "%zu more %s", rows + columns,
                 rows > 0 ? "rows" : "columns");
    }
    if (more[0]) {
        murk_print("            ... and %s%s%s%s\n", more,
                   folder ? " in " : "; -o DIR writes all to table.csv",
                   folder ? folder : "", folder ? "/table.csv" : "");
    }
}

static void print_rows(const murk_sweep *sweep, const char *folder)
{
    const size_t all = sweep->desc.study->rows;
    table t = {.sweep = sweep,
               .rows = all < ROWS_MAX ? all : ROWS_MAX,
               .axes = sweep->desc.study->axes};
    /* The first row that has values decides about the columns. */
    for (size_t i = 0; i < all && !t.one; ++i) {
        t.one = sweep->row[i].found.values ? &sweep->row[i].found : NULL;
    }
    for (t.columns = t.axes; value_at(t.one, t.columns - t.axes);) {
        ++t.columns;
    }
    /* All axes are shown, and as many values as there is room for. */
    size_t shown = 0;
    for (size_t width = NUMBER; shown < t.columns; ++shown) {
        width += 2 + width_of(&t, shown);
        if (shown >= t.axes && width > TABLE_WIDTH) {
            break;
        }
    }
    print_line(&t, HEADING, "row", shown);
    for (size_t i = 0; i < t.rows; ++i) {
        const char *failed = sweep->row[i].found.failed;
        const bool has_values = sweep->row[i].is_done && !failed[0];
        char number[24];
        snprintf(number, sizeof number, "%zu", i + 1);
        print_line(&t, i, number, has_values ? shown : t.axes);
        if (failed[0]) {
            murk_print("            failed: %s\n", failed);
        }
    }
    print_rest(all - t.rows, t.columns - shown, folder);
}

static void print_plan(const murk_sweep *sweep, int p)
{
    static const char *const names[] = {
        [MURK_SWEEP_MEAN] = "mean", [MURK_SWEEP_WORST] = "worst"};
    const murk_sweep_plan *plan = &sweep->plan[p];
    if (!plan->is_wanted) {
        return;
    }
    murk_print("one plan    for the %s of all rows: ", names[p]);
    if (plan->found.failed[0]) {
        murk_print("none: %s\n", plan->found.failed);
    } else if (!isfinite(plan->mean.value)) {
        murk_print("none: there is nothing to see in any row\n");
    } else {
        murk_print("%zu sensors, mean %.4g +- %.1g, least %.4g +- %.1g in row "
                   "%zu\n",
                   plan->found.sensors, plan->mean.value,
                   plan->mean.standard_error, plan->worst.value,
                   plan->worst.standard_error, plan->worst_row + 1);
    }
}

void murk_print_study(const void *of)
{
    const murk_study_results *results = of;
    const murk_sweep *sweep = results->sweep;
    const size_t rows = sweep->desc.study->rows;
    size_t traced = 0, reused = 0;
    for (size_t g = 0; g < sweep->groups; ++g) {
        traced += sweep->group[g].was_traced;
    }
    for (size_t i = 0; i < rows; ++i) {
        reused += sweep->row[i].is_reused;
    }
    /* The rows, the plans for all rows, and counts. */
    print_rows(sweep, results->folder);
    for (int p = 0; p < MURK_SWEEP_PLANS && !results->is_interrupted; ++p) {
        print_plan(sweep, p);
    }
    murk_print("rows        %zu, of which %zu kept from before and %zu failed; "
               "light traced for %zu groups of rows\n",
               rows, reused, murk_sweep_failed(sweep), traced);
    if (results->is_interrupted) {
        murk_print("            interrupted: %zu of the rows are done\n",
                   murk_sweep_done(sweep));
    }
}
