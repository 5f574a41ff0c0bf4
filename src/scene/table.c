/* Reads tables from CSV text: a header of column names, and rows of as many
 * cells. base/csv.h cuts the text into cells (RFC 4180), and passes over blank
 * lines and lines that begin with #. A byte order mark at the beginning is
 * passed over. */
#include "scene/table.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/csv.h"
#include "base/file.h"
#include "base/number.h"
#include "base/words.h"

/* Limits against hostile files; scene/table.h states them. 1e7 positions of
 * sensors or points are more than any run can use. */
#define MAX_BYTES   256000000
#define MAX_ROWS    10000000
#define MAX_CELLS   20000000
#define MAX_COLUMNS 1000

typedef struct cursor {
    const char *path;
    murk_csv csv;
    bool may_repeat; /* columns may have the same name */
    murk_error *err;
} cursor;

static murk_status fail_at(const cursor *at, size_t line, const char *format,
                           ...) __attribute__((format(printf, 3, 4)));

static murk_status fail_at(const cursor *at, size_t line, const char *format,
                           ...)
{
    char where[320], text[256];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    snprintf(where, sizeof where, "%.290s:%zu", at->path, line);
    return murk_fail(at->err, MURK_BAD_FILE, where, "%s", text);
}

static murk_status no_memory(const char *path, murk_error *err)
{
    return murk_no_memory(err, path, "for the table");
}

static murk_status read_cell(cursor *at, char **cell, bool *is_last)
{
    const char *fault = murk_csv_read_cell(&at->csv, cell, is_last);
    return fault ? fail_at(at, at->csv.line, "%s", fault) : MURK_OK;
}

static murk_status read_header(murk_table *table, cursor *at)
{
    const size_t line = at->csv.line;
    bool is_last = false;
    table->header_line = (int)line;
    while (!is_last) {
        if (table->columns == MAX_COLUMNS) {
            return fail_at(at, line, "more than 1000 columns");
        }
        /* Read a name; it must be unique and not empty. */
        char **name = realloc(table->name, (table->columns + 1) * sizeof *name);
        if (!name) {
            return no_memory(at->path, at->err);
        }
        table->name = name;
        char *cell;
        const murk_status status = read_cell(at, &cell, &is_last);
        if (status) {
            return status;
        }
        char shown[48];
        if (!at->may_repeat && murk_table_column(table, cell) >= 0) {
            murk_words_show(shown, sizeof shown, cell);
            return fail_at(at, line, "column %s is there twice", shown);
        }
        if (cell[0] == '\0') {
            return fail_at(at, line, "column %zu has no name",
                           table->columns + 1);
        }
        table->name[table->columns++] = cell;
    }
    return MURK_OK;
}

/* Reserves memory for as many rows as the rest of the text has lines, within
 * the limits. This suffices, because a row takes at least one line. */
static murk_status reserve(murk_table *table, size_t *capacity,
                           const cursor *at)
{
    size_t lines = 1;
    for (const char *p = at->csv.next; p < at->csv.end; ++p) {
        lines += *p == '\n';
    }
    *capacity = MAX_CELLS / table->columns;
    *capacity = *capacity < MAX_ROWS ? *capacity : MAX_ROWS;
    *capacity = *capacity < lines ? *capacity : lines;
    table->cell = malloc(*capacity * table->columns * sizeof *table->cell);
    table->line = malloc(*capacity * sizeof *table->line);
    return table->cell && table->line ? MURK_OK : no_memory(at->path, at->err);
}

static murk_status read_row(murk_table *table, size_t capacity, cursor *at)
{
    const size_t line = at->csv.line;
    if (table->rows == capacity) {
        return fail_at(at, line,
                       "too large, must be at most 1e7 rows and 2e7 cells");
    }
    char **row = table->cell + table->rows * table->columns;
    size_t n = 0;
    bool is_last = false;
    /* Count all cells, but store no more than the header has. */
    while (!is_last) {
        char *cell;
        const murk_status status = read_cell(at, &cell, &is_last);
        if (status) {
            return status;
        }
        if (n < table->columns) {
            row[n] = cell;
        }
        ++n;
    }
    if (n != table->columns) {
        return fail_at(
            at, line,
            "%zu cells, must be %zu: one for each column of the header", n,
            table->columns);
    }
    table->line[table->rows++] = (int)line;
    return MURK_OK;
}

static murk_status find_nul(const cursor *at)
{
    const char *nul =
        memchr(at->csv.next, '\0', (size_t)(at->csv.end - at->csv.next));
    if (!nul) {
        return MURK_OK;
    }
    size_t line = 1;
    for (const char *p = at->csv.next; p < nul; ++p) {
        line += *p == '\n';
    }
    return fail_at(at, line, "a NUL byte, must be text");
}

/* Parses text whose header is in line header_line; 0: in the first line that
 * has cells. */
static murk_status parse(murk_table **out, const char *path, char *text,
                         size_t size, size_t header_line, murk_error *err)
{
    size_t capacity = 0;
    murk_table *table = calloc(1, sizeof *table);
    if (!table || !(table->path = strdup(path))) {
        free(table);
        free(text);
        return no_memory(path, err);
    }
    table->text = text;
    cursor at = {path,
                 {table->text, table->text + size, 1, false},
                 header_line > 0,
                 err};
    murk_status status = find_nul(&at);
    if (size >= 3 && memcmp(at.csv.next, "\xEF\xBB\xBF", 3) == 0) {
        at.csv.next += 3; /* byte order mark */
    }
    while (!status && at.csv.line < header_line && at.csv.next < at.csv.end) {
        at.csv.line += *at.csv.next++ == '\n';
    }
    if (!status && !murk_csv_find_line(&at.csv)) {
        status = murk_fail(err, MURK_BAD_FILE, path,
                           "empty, must begin with a row of column names");
    }
    if (!status) {
        status = read_header(table, &at);
    }
    if (!status) {
        status = reserve(table, &capacity, &at);
    }
    while (!status && murk_csv_find_line(&at.csv)) {
        status = read_row(table, capacity, &at);
    }
    if (!status) {
        *out = table;
        table = NULL;
    }
    murk_table_destroy(table);
    return status;
}

murk_status murk_table_parse(murk_table **out, const char *path, char *text,
                             size_t size, murk_error *err)
{
    return parse(out, path, text, size, 0, err);
}

murk_status murk_table_parse_from(murk_table **out, const char *path,
                                  char *text, size_t size, size_t header_line,
                                  murk_error *err)
{
    return parse(out, path, text, size, header_line, err);
}

murk_status murk_table_read(murk_table **out, const char *path, murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    const murk_status status =
        murk_file_read(&text, &size, path, MAX_BYTES, err);
    return status ? status : murk_table_parse(out, path, text, size, err);
}

void murk_table_destroy(murk_table *table)
{
    if (table) {
        free(table->path);
        free(table->name);
        free(table->cell);
        free(table->line);
        free(table->text);
        free(table);
    }
}

long murk_table_column(const murk_table *table, const char *name)
{
    for (size_t i = 0; i < table->columns; ++i) {
        if (strcmp(table->name[i], name) == 0) {
            return (long)i;
        }
    }
    return -1;
}

murk_status murk_table_read_column(const murk_table *table, const char *name,
                                   const char *needs, double **out,
                                   murk_error *err)
{
    const long column = murk_table_column(table, name);
    *out = NULL;
    if (column < 0) {
        return murk_fail(err, MURK_BAD_FILE, table->path,
                         "misses column %s, must have %s", name, needs);
    }
    *out = malloc((table->rows + 1) * sizeof **out);
    murk_status status = *out ? MURK_OK : no_memory(table->path, err);
    for (size_t i = 0; i < table->rows && !status; ++i) {
        status = murk_table_number(table, i, column, NAN, &(*out)[i], err);
    }
    return status;
}

murk_status murk_table_number(const murk_table *table, size_t row, long column,
                              double missing, double *out, murk_error *err)
{
    const char *cell =
        column < 0 ? "" : table->cell[row * table->columns + (size_t)column];
    if (cell[0] == '\0' && !isnan(missing)) {
        *out = missing;
        return MURK_OK;
    }
    if (murk_number_parse(cell, out)) {
        return MURK_OK;
    }
    char where[320], name[64], found[48];
    murk_words_show(name, sizeof name,
                    column < 0 ? "a column" : table->name[column]);
    murk_words_show(found, sizeof found, cell);
    snprintf(where, sizeof where, "%.220s:%d: %s", table->path,
             table->line[row], name);
    return murk_fail(err, MURK_BAD_VALUE, where, "%s, must be a number",
                     found[0] ? found : "an empty cell");
}
