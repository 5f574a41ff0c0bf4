/* CSV files with a header row: named columns, strict numbers, messages with
 * line and column name. Comment lines begin with #. */
#ifndef MURK_SCENE_TABLE_H
#define MURK_SCENE_TABLE_H

#include "base/status.h"

#include <stddef.h>

typedef struct murk_table {
    char *path;
    size_t rows, columns;
    char **name; /* [columns] */
    int header_line;
    char **cell; /* [rows * columns], row by row */
    int *line;   /* [rows]: of the file */
    char *text;  /* the bytes that names and cells point into */
} murk_table;

/* At most 256 MB, 1e7 rows and 2e7 cells; every row has the header's number of
 * cells. Cells may be quoted with ". *out is the caller's. */
murk_status murk_table_read(murk_table **out, const char *path,
                            murk_error *err);
/* The same from memory: takes the text, which has a '\0' behind its bytes, also
 * where it fails; `path` is its name in messages. */
murk_status murk_table_parse(murk_table **out, const char *path, char *text,
                             size_t size, murk_error *err);
void murk_table_destroy(murk_table *table); /* NULL is fine */

/* The column of that name, or -1. */
long murk_table_column(const murk_table *table, const char *name);

/* A finite number, or MURK_BAD_VALUE with line and column name. An empty cell
 * (or column -1) gives *out = missing when that is not NaN, else fails. */
murk_status murk_table_number(const murk_table *table, size_t row, long column,
                              double missing, double *out, murk_error *err);

#endif
