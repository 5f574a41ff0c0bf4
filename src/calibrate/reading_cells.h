/* The columns of a file of readings, and the cells of one of its rows. Private
 * to measurements. */
#ifndef MURK_CALIBRATE_READING_CELLS_H
#define MURK_CALIBRATE_READING_CELLS_H

#include "calibrate/measurements.h"
#include "scene/table.h"

#define MURK_READING_NAME_SIZE 64 /* of groups and gains */

typedef enum murk_reading_column {
    MURK_COLUMN_KIND,
    MURK_COLUMN_CONDITION,
    MURK_COLUMN_X,                                /* then y, z */
    MURK_COLUMN_X2 = MURK_COLUMN_X + 3,           /* likewise */
    MURK_COLUMN_DIRECTION_X = MURK_COLUMN_X2 + 3, /* likewise */
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

#define MURK_READING_KINDS 4

/* "coverage" .. by murk_reading_kind. */
extern const char *const murk_reading_kinds[MURK_READING_KINDS];

typedef struct murk_reading_source {
    const murk_table *table;
    long column[MURK_READING_COLUMNS]; /* -1: not there */
    const murk_scene_desc *scene;
    const murk_domain *domain;
} murk_reading_source;

typedef struct murk_reading_row {
    const murk_reading_source *source;
    size_t row; /* of the table */
    murk_error *err;
} murk_reading_row;

/* Finds the columns; refuses those that are none of a reading's, and a table
 * without kind, value or standard_error. */
murk_status murk_reading_columns(murk_reading_source *source, murk_error *err);

/* "field.csv:7: group": the place of a cell. */
void murk_reading_where(char out[320], const murk_table *table, int line,
                        murk_reading_column column);

/* Empty where the column is missing. */
const char *murk_reading_cell(const murk_reading_row *at,
                              murk_reading_column column);

murk_status murk_reading_fail(const murk_reading_row *at,
                              murk_reading_column column, const char *text);

murk_status murk_reading_number(const murk_reading_row *at,
                                murk_reading_column column, double *out);

/* Of three columns that follow each other. */
murk_status murk_reading_vector(const murk_reading_row *at,
                                murk_reading_column first, murk_vec3 *out);

/* Which of known[n] it is. */
murk_status murk_reading_word(const murk_reading_row *at,
                              murk_reading_column column,
                              const char *const *known, size_t n, size_t *out);

/* A text of at most MURK_READING_NAME_SIZE - 1 bytes; may be empty. */
murk_status murk_reading_name(const murk_reading_row *at,
                              murk_reading_column column, const char **out);

#endif
