/* Applies a mapping to a file of measurements, row by row: finds the columns
 * that the rules name, selects rows, converts numbers, and averages. A number
 * that is not converted stays the text that the file has. */
#include "readings/mapped.h"

#include "base/file.h"
#include "base/log.h"
#include "base/number.h"
#include "base/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A limit against hostile files, of a few seconds: how often a cell of the file
 * may be compared or converted. A year of measurements, one every ten minutes,
 * takes 2e6 for the values at twenty wavelengths. */
#define LOOKS_MAX 10000000

/* The mean of the rows of an averaged entry so far. */
typedef struct average {
    size_t rows;
    size_t reading;              /* index of the reading in the table */
    double mean, sum_of_squares; /* of the values: mean, and sum of squared
                                  * deviations from it */
    double error;                /* mean of the standard errors */
} average;

typedef struct maker {
    murk_mapped_file *out;
    const murk_table *source;
    size_t capacity;  /* readings that the table has memory for */
    size_t max;       /* readings that there may be */
    average *average; /* [mapping.n] */
    long *column;     /* [mapping.n][MURK_READING_COLUMNS]; source columns of
                       * the rules, -1: none */
    long *selected; /* [1 + mapping.n][MURK_MAPPING_SELECT_MAX]; source columns
                     * of the selection of all entries, then of each entry */
    size_t looks;   /* at cells of the file so far, as LOOKS_MAX bounds them */
    size_t left_out, first_left_out; /* readings; line of the first */
    murk_error *err;
} maker;

static murk_status no_memory(const maker *m)
{
    return murk_no_memory(m->err, m->source->path, "for its readings");
}

/* Fails at a cell of the file. */
static murk_status fail_cell(const maker *m, size_t row, long column,
                             const char *what)
{
    char where[320], name[64], found[48];
    murk_words_show(name, sizeof name, m->source->name[column]);
    murk_words_show(found, sizeof found,
                    m->source->cell[row * m->source->columns + (size_t)column]);
    snprintf(where, sizeof where, "%.220s:%d: %s", m->source->path,
             m->source->line[row], name);
    return murk_fail(m->err, MURK_BAD_VALUE, where, "%s, %s", found, what);
}

/* ---- columns ---- */

/* Finds a column by the name that a node of the mapping gives. */
static murk_status find_column(const maker *m, const murk_yaml *node,
                               const char *name, long *out)
{
    const murk_table *source = m->source;
    *out = murk_table_column(source, name);
    if (*out >= 0) {
        return MURK_OK;
    }
    char where[320], shown[64];
    murk_words_show(shown, sizeof shown, name);
    murk_yaml_place(node, where, sizeof where);
    return murk_fail(m->err, MURK_BAD_VALUE, where,
                     "%s is no column of %.100s%s", shown, source->path,
                     murk_words_suggest(name, (const char *const *)source->name,
                                        source->columns)
                         .text);
}

/* Checks the units that the file states for a column. */
static murk_status check_units(const maker *m, const murk_mapping_rule *rule,
                               long column)
{
    const murk_field_file *file = &m->out->file;
    char where[320], found[48];
    if (!rule->unit) {
        return MURK_OK;
    }
    murk_yaml_place(rule->node, where, sizeof where);
    if (!file->unit) {
        return murk_fail(m->err, MURK_BAD_VALUE, where,
                         "units cannot be checked, because %.100s states none",
                         m->source->path);
    }
    murk_words_show(found, sizeof found, file->unit[column]);
    return strcmp(rule->unit, file->unit[column]) == 0
               ? MURK_OK
               : murk_fail(m->err, MURK_BAD_VALUE, where,
                           "units %.40s, but line %d of %.100s states %s",
                           rule->unit, file->unit_line, m->source->path, found);
}

static murk_status find_selected(const maker *m,
                                 const murk_mapping_selection *select,
                                 long *column)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < select->n && !status; ++i) {
        const murk_mapping_select *item = &select->item[i];
        status = find_column(m, item->node, item->column, &column[i]);
    }
    return status;
}

/* Finds the columns of all selections and rules. */
static murk_status find_columns(maker *m)
{
    const murk_mapping *mapping = &m->out->mapping;
    murk_status status = find_selected(m, &mapping->select, m->selected);
    for (size_t e = 0; e < mapping->n && !status; ++e) {
        const murk_mapping_entry *entry = &mapping->entry[e];
        status = find_selected(m, &entry->select,
                               m->selected + (1 + e) * MURK_MAPPING_SELECT_MAX);
        for (size_t c = 0; c < MURK_READING_COLUMNS && !status; ++c) {
            const murk_mapping_rule *rule = &entry->rule[c];
            long *column = &m->column[e * MURK_READING_COLUMNS + c];
            *column = -1;
            if (rule->column) {
                status = find_column(m, rule->node, rule->column, column);
                status = status ? status : check_units(m, rule, *column);
            }
        }
    }
    return status;
}

/* ---- cells ---- */

static const char *cell_at(const maker *m, size_t row, long column)
{
    return m->source->cell[row * m->source->columns + (size_t)column];
}

/* True if a cell holds no measurement, by the format or by the mapping. */
static bool is_missing(const maker *m, const char *cell)
{
    const murk_yaml *list = m->out->mapping.missing;
    bool is_it = murk_field_is_missing(&m->out->file, cell);
    for (size_t i = 0; list && i < list->n && !is_it; ++i) {
        double a, b;
        const char *text = list->child[i]->text;
        is_it =
            strcmp(cell, text) == 0 || (murk_number_parse(cell, &a) &&
                                        murk_number_parse(text, &b) && a == b);
    }
    return is_it;
}

/* True if a row is one of a selection. A cell that is no number is in no range.
 * column: of the items. */
static bool is_selected(const maker *m, const murk_mapping_selection *select,
                        const long *column, size_t row)
{
    bool is_in = true;
    for (size_t i = 0; i < select->n && is_in; ++i) {
        const murk_mapping_select *item = &select->item[i];
        const char *cell = cell_at(m, row, column[i]);
        double a, b;
        const bool is_number = murk_number_parse(cell, &a);
        if (item->text) {
            is_in = strcmp(cell, item->text) == 0 ||
                    (is_number && murk_number_parse(item->text, &b) && a == b);
        } else {
            is_in = is_number && !is_missing(m, cell) && a >= item->low &&
                    a <= item->high;
        }
    }
    return is_in;
}

/* Prints a number into `text`; NULL: into memory that lives as long as the
 * table. */
static char *print(maker *m, char *text, double number)
{
    text = text ? text : murk_arena_array(&m->out->arena, MURK_NUMBER_SIZE, 1);
    if (text) {
        murk_number_print(text, number);
    }
    return text;
}

/* The number of a rule: a constant, or a column after conversion. */
static murk_status number_of(const maker *m, const murk_mapping_rule *rule,
                             size_t row, long column, double *out)
{
    const char *cell =
        rule->constant ? rule->constant : cell_at(m, row, column);
    if (!murk_number_parse(cell, out)) {
        return rule->constant
                   ? murk_fail(m->err, MURK_BAD_VALUE, m->source->path,
                               "%.40s, must be a "
                               "number",
                               cell)
                   : fail_cell(m, row, column, "must be a number");
    }
    if (!rule->constant) {
        *out = *out * rule->factor + rule->offset;
    }
    return MURK_OK;
}

/* Fails at a rule whose number is not 0 or more: at the cell of the file, or at
 * the constant of the mapping. */
static murk_status fail_negative(const maker *m, const murk_mapping_rule *rule,
                                 size_t row, long column)
{
    static const char what[] = "a standard error must be 0 or more";
    char where[320];
    if (!rule->constant) {
        return fail_cell(m, row, column, what);
    }
    murk_yaml_place(rule->node, where, sizeof where);
    return murk_fail(m->err, MURK_BAD_VALUE, where, "%.40s, %s", rule->constant,
                     what);
}

/* The standard error: of the column, and a share of the value, combined; but
 * not below at_least. A negative one is refused here, as neither the root of
 * squares nor the maximum would show its sign. */
static murk_status error_of(const maker *m, const murk_mapping_rule *rule,
                            size_t row, long column, double value, double *out)
{
    double stated = 0;
    const murk_status status = rule->constant || column >= 0
                                   ? number_of(m, rule, row, column, &stated)
                                   : MURK_OK;
    if (!status && !(stated >= 0)) {
        return fail_negative(m, rule, row, column);
    }
    const double share = rule->relative * fabs(value);
    *out = share > 0 ? hypot(stated, share) : stated;
    *out = fmax(*out, rule->at_least);
    return status;
}

/* Fills one cell of a reading, other than the standard error. text: memory for
 * a number that is converted; NULL: memory that lives as long as the table. */
static murk_status fill_cell(maker *m, const murk_mapping_rule *rule,
                             murk_reading_column to, size_t row, long column,
                             char *text, char **out)
{
    double number;
    /* Constants and texts stay as they are. */
    if (!rule->node) {
        *out = "";
        return MURK_OK;
    }
    if (rule->constant || murk_reading_column_is_text(to)) {
        *out =
            (char *)(rule->constant ? rule->constant : cell_at(m, row, column));
        return MURK_OK;
    }
    const murk_status status = number_of(m, rule, row, column, &number);
    if (status) {
        return status;
    }
    const bool is_same = rule->factor == 1 && rule->offset == 0;
    *out = is_same ? (char *)cell_at(m, row, column) : print(m, text, number);
    return *out ? MURK_OK : no_memory(m);
}

/* ---- readings ---- */

/* Makes memory for one more reading. */
static murk_status reserve(maker *m)
{
    murk_table *table = &m->out->table;
    if (table->rows == m->max) {
        return murk_fail(m->err, MURK_BAD_FILE, m->source->path,
                         "more than %zu readings", m->max);
    }
    if (table->rows < m->capacity) {
        return MURK_OK;
    }
    const size_t more = m->capacity ? 2 * m->capacity : 256;
    char **cell = realloc(table->cell, more * table->columns * sizeof *cell);
    if (!cell) {
        return no_memory(m);
    }
    table->cell = cell;
    int *line = realloc(table->line, more * sizeof *line);
    if (!line) {
        return no_memory(m);
    }
    table->line = line;
    m->capacity = more;
    return MURK_OK;
}

/* True if a cell that the entry takes from the file holds no measurement. */
static bool lacks(const maker *m, size_t e, size_t row)
{
    const long *column = m->column + e * MURK_READING_COLUMNS;
    bool is_it = false;
    for (size_t c = 0; c < MURK_READING_COLUMNS; ++c) {
        is_it = is_it ||
                (column[c] >= 0 && is_missing(m, cell_at(m, row, column[c])));
    }
    return is_it;
}

/* Adds a row to the average of an entry, in the reading of the first row. All
 * other cells must be those of the first row. */
static murk_status add_to_average(maker *m, size_t e, size_t row, char **cell,
                                  double value, double error)
{
    murk_table *table = &m->out->table;
    average *a = &m->average[e];
    char **first = table->cell + a->reading * table->columns;
    for (int c = 0; c < MURK_READING_COLUMNS; ++c) {
        if (c != MURK_COLUMN_VALUE && c != MURK_COLUMN_ERROR &&
            strcmp(cell[c], first[c]) != 0) {
            char where[320];
            snprintf(where, sizeof where, "%.240s:%d: %s", m->source->path,
                     m->source->line[row],
                     murk_reading_column_name((murk_reading_column)c));
            return murk_fail(m->err, MURK_BAD_VALUE, where,
                             "%.40s, but %.40s in line %d, must be the same in "
                             "all rows of an average",
                             cell[c], first[c], table->line[a->reading]);
        }
    }
    /* Mean and squares by Welford (1962), doi:10.1080/00401706.1962.10490022.
     */
    const double n = (double)++a->rows, off = value - a->mean;
    a->mean += off / n;
    a->sum_of_squares += off * (value - a->mean);
    a->error += (error - a->error) / n;
    return MURK_OK;
}

/* Adds what an entry makes of a row: a reading of its own, or the first or a
 * further row of an average. */
static murk_status add_reading(maker *m, size_t e, size_t row)
{
    const murk_mapping_entry *entry = &m->out->mapping.entry[e];
    const long *column = m->column + e * MURK_READING_COLUMNS;
    murk_table *table = &m->out->table;
    average *a = &m->average[e];
    const bool is_new = a->rows == 0;
    char text[MURK_READING_COLUMNS][MURK_NUMBER_SIZE];
    char *cell[MURK_READING_COLUMNS];
    double value = 0, error = 0;
    murk_status status = is_new ? reserve(m) : MURK_OK;
    /* Only the sums of further rows stay, so their numbers need no memory. The
     * value of an average is written at the end. */
    cell[MURK_COLUMN_VALUE] = "";
    for (int c = 0; c < MURK_READING_COLUMNS && !status; ++c) {
        if (c != MURK_COLUMN_ERROR &&
            !(c == MURK_COLUMN_VALUE && entry->is_averaged)) {
            status = fill_cell(m, &entry->rule[c], (murk_reading_column)c, row,
                               column[c], is_new ? NULL : text[c], &cell[c]);
        }
    }
    status = status ? status
                    : number_of(m, &entry->rule[MURK_COLUMN_VALUE], row,
                                column[MURK_COLUMN_VALUE], &value);
    status = status ? status
                    : error_of(m, &entry->rule[MURK_COLUMN_ERROR], row,
                               column[MURK_COLUMN_ERROR], value, &error);
    if (status) {
        return status;
    }
    if (is_new) {
        cell[MURK_COLUMN_ERROR] = print(m, NULL, error);
        if (!cell[MURK_COLUMN_ERROR]) {
            return no_memory(m);
        }
        memcpy(table->cell + table->rows * table->columns, cell, sizeof cell);
        a->reading = table->rows;
        table->line[table->rows++] = m->source->line[row];
    }
    return entry->is_averaged ? add_to_average(m, e, row, cell, value, error)
                              : MURK_OK;
}

/* Writes the averages. Errors of one instrument are the same in all rows, so
 * the mean of the stated errors stays; the scatter of the rows adds the
 * standard error of their mean. */
static murk_status write_averages(maker *m)
{
    murk_table *table = &m->out->table;
    for (size_t e = 0; e < m->out->mapping.n; ++e) {
        const average *a = &m->average[e];
        if (!m->out->mapping.entry[e].is_averaged || a->rows == 0) {
            continue;
        }
        const double n = (double)a->rows;
        const double scatter =
            a->rows > 1 ? sqrt(a->sum_of_squares / (n - 1) / n) : 0;
        char **cell = table->cell + a->reading * table->columns;
        cell[MURK_COLUMN_VALUE] = print(m, NULL, a->mean);
        cell[MURK_COLUMN_ERROR] = print(m, NULL, hypot(a->error, scatter));
        if (!cell[MURK_COLUMN_VALUE] || !cell[MURK_COLUMN_ERROR]) {
            return no_memory(m);
        }
    }
    return MURK_OK;
}

/* Counts the looks at cells of a row that a selection and rules take: for each
 * column, one at the cell and one for each item of `missing`. */
static murk_status count_looks(maker *m, const murk_mapping_selection *select,
                               const long *column, size_t columns)
{
    const murk_yaml *missing = m->out->mapping.missing;
    size_t cells = 1 + select->n;
    for (size_t c = 0; c < columns; ++c) {
        cells += column[c] >= 0;
    }
    m->looks += cells * (1 + (missing ? missing->n : 0));
    return m->looks <= LOOKS_MAX
               ? MURK_OK
               : murk_fail(m->err, MURK_BAD_FILE, m->source->path,
                           "too many rows for the entries of the mapping: "
                           "more than %d looks at cells, make several files "
                           "of it",
                           LOOKS_MAX);
}

/* Adds what all entries make of a row. */
static murk_status add_row(maker *m, size_t row)
{
    const murk_mapping *mapping = &m->out->mapping;
    murk_status status = MURK_OK;
    for (size_t e = 0; e < mapping->n && !status; ++e) {
        const murk_mapping_selection *select = &mapping->entry[e].select;
        status = count_looks(m, select, m->column + e * MURK_READING_COLUMNS,
                             MURK_READING_COLUMNS);
        if (status ||
            !is_selected(m, select,
                         m->selected + (1 + e) * MURK_MAPPING_SELECT_MAX,
                         row)) {
            continue;
        }
        if (lacks(m, e, row)) {
            m->first_left_out = m->left_out++ ? m->first_left_out
                                              : (size_t)m->source->line[row];
        } else {
            status = add_reading(m, e, row);
        }
    }
    return status;
}

static murk_status make_readings(maker *m)
{
    const murk_mapping_selection *select = &m->out->mapping.select;
    murk_status status = find_columns(m);
    for (size_t row = 0; row < m->source->rows && !status; ++row) {
        status = count_looks(m, select, NULL, 0);
        if (!status && is_selected(m, select, m->selected, row)) {
            status = add_row(m, row);
        }
    }
    return status ? status : write_averages(m);
}

/* ---- all ---- */

/* Fills the table from the file that was read. */
static murk_status fill(murk_mapped_file *out, size_t max, murk_error *err)
{
    murk_table *table = &out->table;
    maker m = {.out = out, .source = out->file.table, .max = max, .err = err};
    murk_arena *arena = &out->arena;
    /* The table has the columns of readings, and no rows yet. */
    table->path = out->file.table->path;
    table->columns = MURK_READING_COLUMNS;
    table->header_line = out->file.table->header_line;
    table->name =
        murk_arena_array(arena, MURK_READING_COLUMNS, sizeof *table->name);
    m.average = murk_arena_array(arena, out->mapping.n, sizeof *m.average);
    m.column = murk_arena_array(arena, out->mapping.n * MURK_READING_COLUMNS,
                                sizeof *m.column);
    m.selected =
        murk_arena_array(arena, (1 + out->mapping.n) * MURK_MAPPING_SELECT_MAX,
                         sizeof *m.selected);
    if (arena->is_short) {
        return no_memory(&m);
    }
    for (int c = 0; c < MURK_READING_COLUMNS; ++c) {
        table->name[c] =
            (char *)murk_reading_column_name((murk_reading_column)c);
    }
    /* Fill it, and tell of missing cells. */
    const murk_status status = make_readings(&m);
    if (!status && m.left_out > 0) {
        murk_note(table->path,
                  "%zu reading%s left out: a cell is missing, first in line "
                  "%zu",
                  m.left_out, m.left_out > 1 ? "s are" : " is",
                  m.first_left_out);
    }
    if (!status && table->rows == 0) {
        return murk_fail(err, MURK_BAD_FILE, table->path,
                         "the mapping makes no reading of its %zu rows, %zu "
                         "are left out because a cell is missing",
                         out->file.table->rows, m.left_out);
    }
    return status;
}

murk_status murk_mapped_file_read(murk_mapped_file *out, const char *path,
                                  size_t max_bytes, size_t max_readings,
                                  murk_error *err)
{
    char *text = NULL, checksums[129];
    size_t size = 0;
    *out = (murk_mapped_file){0};
    /* The mapping. */
    murk_status status = murk_file_read(&text, &size, path, max_bytes, err);
    if (!status) {
        murk_sha256_hex(text, size, checksums);
        status = murk_mapping_parse(&out->mapping, path, text, size, err);
    }
    free(text);
    /* The file of measurements. */
    if (!status) {
        status =
            murk_file_read(&text, &size, out->mapping.file, max_bytes, err);
    }
    if (!status) {
        murk_sha256_hex(text, size, checksums + 64);
        murk_sha256_hex(checksums, 128, out->sha256);
        status = murk_field_file_read(&out->file, out->mapping.format,
                                      out->mapping.file, text, size, err);
    }
    return status ? status : fill(out, max_readings, err);
}

void murk_mapped_file_release(murk_mapped_file *mapped)
{
    free(mapped->table.cell);
    free(mapped->table.line);
    murk_field_file_release(&mapped->file);
    murk_mapping_release(&mapped->mapping);
    murk_arena_release(&mapped->arena);
    *mapped = (murk_mapped_file){0};
}
