/* CSV files with a header row: named columns, strict numbers, messages with
 * line and column name. Blank lines and lines that begin with # are passed
 * over. */
#ifndef MURK_SCENE_TABLE_H
#define MURK_SCENE_TABLE_H

#include "base/status.h"

#include <stddef.h>

typedef struct murk_table {
    char *path;
    size_t rows, columns;
    char **name; /* [columns] */
    int header_line;
    char **cell; /* cells row by row: [rows * columns] */
    int *line;   /* [rows]: line of each row in the file */
    char *text;  /* the text that names and cells point into */
} murk_table;

/* Reads a table of at most 256 MB, 1000 columns, 1e7 rows and 2e7 cells. Every
 * row must have as many cells as the header, and the names of columns must
 * differ and not be empty. Cells may be in double quotes. Fails with
 * MURK_BAD_FILE or MURK_NO_MEMORY. The caller owns *out and releases it with
 * murk_table_destroy(). */
murk_status murk_table_read(murk_table **out, const char *path,
                            murk_error *err);
/* Parses a table from text. Takes ownership of the text, also on failure;
 * the text must have a '\0' behind its `size` bytes. `path` is the name in
 * messages. */
murk_status murk_table_parse(murk_table **out, const char *path, char *text,
                             size_t size, murk_error *err);
/* The same for text whose header is in line `header_line`, from 1: the lines
 * before the header are passed over, and several columns may have the same
 * name, of which murk_table_column() finds the first. */
murk_status murk_table_parse_from(murk_table **out, const char *path,
                                  char *text, size_t size, size_t header_line,
                                  murk_error *err);
void murk_table_destroy(murk_table *table); /* NULL is fine */

/* Reads the numbers of a column into (*out)[rows], which the caller frees, also
 * after a failure. needs: the columns that the table must have, for the message
 * "misses column NAME, must have ...". Fails with MURK_BAD_FILE, as
 * murk_table_number(), or with MURK_NO_MEMORY. */
murk_status murk_table_read_column(const murk_table *table, const char *name,
                                   const char *needs, double **out,
                                   murk_error *err);

/* The index of the column with a name, from 0, or -1. */
long murk_table_column(const murk_table *table, const char *name);

/* Reads a finite number from a cell; otherwise fails with MURK_BAD_VALUE,
 * line and column name. An empty cell (or column -1) gives *out = missing,
 * or fails if missing is NaN. */
murk_status murk_table_number(const murk_table *table, size_t row, long column,
                              double missing, double *out, murk_error *err);

#endif
