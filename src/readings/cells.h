/* The columns of a file of readings, and the cells of one line. For
 * use inside src/readings only. */
#ifndef MURK_READINGS_CELLS_H
#define MURK_READINGS_CELLS_H

#include "readings/units.h"
#include "scene/table.h"

#define MURK_READING_NAME_SIZE 64 /* size of names of groups and factors */

typedef enum murk_reading_column {
    MURK_COLUMN_KIND,
    MURK_COLUMN_CONDITION,
    MURK_COLUMN_X,                                /* followed by y, z */
    MURK_COLUMN_X2 = MURK_COLUMN_X + 3,           /* followed by y, z */
    MURK_COLUMN_DIRECTION_X = MURK_COLUMN_X2 + 3, /* followed by y, z */
    MURK_COLUMN_RADIUS = MURK_COLUMN_DIRECTION_X + 3,
    MURK_COLUMN_ACCEPTANCE,
    MURK_COLUMN_BAND,
    MURK_COLUMN_SENSOR,
    MURK_COLUMN_HEADING,
    MURK_COLUMN_TILT,
    MURK_COLUMN_GROUP,
    MURK_COLUMN_GAIN,
    MURK_COLUMN_UNIT,
    MURK_COLUMN_VALUE,
    MURK_COLUMN_ERROR,
    MURK_COLUMN_USE,
    MURK_READING_COLUMNS
} murk_reading_column;

/* The name of a column, and the column of a name; MURK_READING_COLUMNS: none.
 */
const char *murk_reading_column_name(murk_reading_column column);
murk_reading_column murk_reading_column_find(const char *name);

/* True if cells of the column are words or names; else they are numbers. */
bool murk_reading_column_is_text(murk_reading_column column);

/* The file, and the scene that the readings belong to. */
typedef struct murk_reading_source {
    const murk_table *table;
    long column[MURK_READING_COLUMNS]; /* -1: the file does not have the column
                                        */
    const murk_scene_desc *scene;
    const murk_domain *domain;
} murk_reading_source;

/* One line of the file. */
typedef struct murk_reading_line {
    const murk_reading_source *source;
    size_t row; /* row of the table */
    murk_error *err;
} murk_reading_line;

/* Finds the columns. Fails with MURK_BAD_FILE for unknown columns, and if kind,
 * value or standard_error are missing. */
murk_status murk_reading_columns(murk_reading_source *source, murk_error *err);

/* Fails with MURK_BAD_VALUE if a cell is empty that a reading of this kind
 * needs, or if a cell is not empty that such a reading does not have. */
murk_status murk_reading_check_cells(const murk_reading_line *at,
                                     murk_reading_kind kind);

/* The place of a cell for messages: "field.csv:7: group". */
typedef struct murk_reading_where {
    char text[320];
} murk_reading_where;
murk_reading_where murk_reading_where_at(const murk_table *table, int line,
                                         murk_reading_column column);
murk_reading_where murk_reading_where_of(const murk_reading_line *at,
                                         murk_reading_column column);

/* Fails with MURK_BAD_VALUE at a cell. */
murk_status murk_reading_fail(const murk_reading_line *at,
                              murk_reading_column column, const char *format,
                              ...) __attribute__((format(printf, 3, 4)));

/* The text of a cell; empty if the column is missing. */
const char *murk_reading_cell(const murk_reading_line *at,
                              murk_reading_column column);
bool murk_reading_is_empty(const murk_reading_line *at,
                           murk_reading_column column);

/* Reads a finite number from a cell; fails with MURK_BAD_VALUE for an empty
 * cell or other text. */
murk_status murk_reading_number(const murk_reading_line *at,
                                murk_reading_column column, double *out);

/* Reads a vector from column `first` and the two columns that follow it in
 * murk_reading_column. */
murk_status murk_reading_vector(const murk_reading_line *at,
                                murk_reading_column first, murk_vec3 *out);

/* Reads a word; *out is the index of the word in known[n]. Fails with
 * MURK_BAD_VALUE if known[] does not contain it. */
murk_status murk_reading_word(const murk_reading_line *at,
                              murk_reading_column column,
                              const char *const *known, size_t n, size_t *out);

/* Reads a name of at most MURK_READING_NAME_SIZE - 1 bytes without control
 * characters, which may be empty; otherwise fails with MURK_BAD_VALUE. *out
 * points into the table. */
murk_status murk_reading_name(const murk_reading_line *at,
                              murk_reading_column column, const char **out);

#endif
