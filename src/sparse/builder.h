/* A sparse matrix under construction: entries in any order, weights as given in
 * the file. */
#ifndef MURK_SPARSE_BUILDER_H
#define MURK_SPARSE_BUILDER_H

#include "sparse/matrix.h"

typedef struct murk_sparse_entry {
    uint32_t row, column; /* from 0 */
    uint32_t line;        /* line of the file, from 1, for messages */
    uint16_t clarity;
} murk_sparse_entry;

typedef struct murk_sparse_builder {
    const char *path;
    murk_matrix_format format;
    size_t rows, columns;
    murk_sparse_entry *entry; /* [entries] */
    size_t entries, capacity;
    double *weight; /* [rows] >= 0; NULL: all 1 */
    double *cost;   /* [columns]; NULL: none */
    char **name;    /* [columns]; NULL: none */
} murk_sparse_builder;

/* Adds an entry at a row and a column, both from 0. A clarity (0..1) that
 * rounds to 0 of MURK_CLEAR (placement/problem.h) is not stored. `line` is the
 * line of the file, from 1. Fails with MURK_NO_MEMORY. */
murk_status murk_sparse_builder_put(murk_sparse_builder *builder, size_t row,
                                    size_t column, size_t line, double clarity,
                                    murk_error *err);

/* Sorts the entries and makes the matrix. Fails with MURK_BAD_FILE if a row and
 * column have two entries, if there are no rows, no columns or no entries, or
 * if the weights add up to 0; or with MURK_NO_MEMORY. After success and after a
 * failure the builder is empty except for the path. */
murk_status murk_sparse_builder_finish(murk_sparse_matrix **out,
                                       murk_sparse_builder *builder,
                                       murk_error *err);
void murk_sparse_builder_release(murk_sparse_builder *builder);

#endif
