/* Prints the rows of a study as a table on the terminal, as many columns and
 * rows as there is room for. */
#include "results/study_print.h"

#include "results/summary.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CELL_SIZE   40 /* a value with its error, or a name */
#define TABLE_WIDTH 80 /* of a terminal */
#define NUMBER      5  /* columns of a row's number */
#define ROWS_MAX    24 /* about a screen */

typedef char cell[CELL_SIZE];

typedef struct table {
    const murk_sweep *sweep;
    size_t rows, columns;
    const char **value; /* [columns] names of values; NULL: an axis */
    cell *title;        /* [columns] */
    cell *cells;        /* [rows * columns] */
    size_t *width;      /* [columns] */
} table;

/* "density_475nm" is of a band. */
static bool is_of_band(const char *name)
{
    const char *last = strrchr(name, '_');
    const size_t n = last ? strlen(last) : 0;
    return n > 3 && strcmp(last + n - 2, "nm") == 0 &&
           isdigit((unsigned char)last[1]);
}

/* "media.fog.visibility_m" is told by its last part. */
static const char *last_part(const char *path)
{
    const char *dot = strrchr(path, '.');
    return dot ? dot + 1 : path;
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

/* The first row that has values says which there are. */
static const murk_study_row *first_done(const murk_sweep *sweep)
{
    for (size_t i = 0; i < sweep->desc.study->rows; ++i) {
        if (sweep->row[i].found.values > 0) {
            return &sweep->row[i].found;
        }
    }
    return NULL;
}

static void name_columns(table *t)
{
    const murk_study_file *study = t->sweep->desc.study;
    const murk_study_row *one = first_done(t->sweep);
    for (size_t a = 0; a < study->axes; ++a) {
        snprintf(t->title[t->columns++], CELL_SIZE, "%s",
                 last_part(study->axis[a].name));
    }
    for (size_t i = 0; one && i < one->values; ++i) {
        const murk_study_value *v = &one->value[i];
        if (!is_of_band(v->name)) {
            t->value[t->columns] = v->name;
            snprintf(t->title[t->columns++], CELL_SIZE, "%.24s%s%.12s", v->name,
                     v->unit[0] ? " " : "", v->unit);
        }
    }
}

static void fill(table *t)
{
    const murk_study_file *study = t->sweep->desc.study;
    for (size_t i = 0; i < t->rows; ++i) {
        size_t index[MURK_STUDY_AXES_MAX];
        murk_study_row_indices(study, i, index);
        for (size_t c = 0; c < t->columns; ++c) {
            char *out = t->cells[i * t->columns + c];
            if (c < study->axes) {
                snprintf(out, CELL_SIZE, "%s", study->axis[c].text[index[c]]);
            } else {
                show_value(out, murk_study_row_get(&t->sweep->row[i].found,
                                                   t->value[c]));
            }
        }
    }
    for (size_t c = 0; c < t->columns; ++c) {
        t->width[c] = strlen(t->title[c]);
        for (size_t i = 0; i < t->rows; ++i) {
            const size_t n = strlen(t->cells[i * t->columns + c]);
            t->width[c] = n > t->width[c] ? n : t->width[c];
        }
    }
}

static void print_line(const table *t, cell *cells, const char *number,
                       size_t shown)
{
    murk_print("%-*s", NUMBER, number);
    for (size_t c = 0; c < shown; ++c) {
        murk_print("  %-*s", c + 1 < shown ? (int)t->width[c] : 0, cells[c]);
    }
    murk_print("\n");
}

static void print_table(const table *t, const char *folder)
{
    const size_t axes = t->sweep->desc.study->axes;
    const size_t all = t->sweep->desc.study->rows;
    size_t shown = 0, width = NUMBER;
    while (shown < t->columns &&
           (shown < axes || width + 2 + t->width[shown] <= TABLE_WIDTH)) {
        width += 2 + t->width[shown++];
    }
    print_line(t, t->title, "row", shown);
    for (size_t i = 0; i < t->rows; ++i) {
        const char *failed = t->sweep->row[i].found.failed;
        char number[24];
        snprintf(number, sizeof number, "%zu", i + 1);
        print_line(t, t->cells + i * t->columns, number,
                   failed[0] ? axes : shown);
        if (failed[0]) {
            murk_print("            failed: %s\n", failed);
        }
    }
    const size_t rows = all - t->rows, columns = t->columns - shown;
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

void murk_print_study_rows(const murk_sweep *sweep, const char *folder)
{
    const size_t all = sweep->desc.study->rows;
    const murk_study_row *one = first_done(sweep);
    const size_t max = sweep->desc.study->axes + (one ? one->values : 0) + 1;
    table t = {.sweep = sweep, .rows = all < ROWS_MAX ? all : ROWS_MAX};
    t.value = calloc(max, sizeof *t.value);
    t.title = calloc(max, sizeof *t.title);
    t.width = calloc(max, sizeof *t.width);
    t.cells = calloc(t.rows * max, sizeof *t.cells);
    if (t.value && t.title && t.width && t.cells) {
        name_columns(&t);
        fill(&t);
        print_table(&t, folder);
    }
    free(t.value);
    free(t.title);
    free(t.width);
    free(t.cells);
}
