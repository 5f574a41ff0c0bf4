/* Makes a sparse matrix from entries in any order: a sort by row, unless
 * the file is sorted, then a distribution to columns. Weights become whole
 * numbers. */
#include "sparse/builder.h"

#include "base/sort.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Limit on the sum of whole weights: src/placement allows sums below 2^47, and
 * rounding may add a little. */
#define WHOLE_SUM_MAX 0x1p46

static murk_status no_memory(const murk_sparse_builder *b, murk_error *err)
{
    return murk_no_memory(err, b->path, "for the matrix");
}

murk_status murk_sparse_builder_put(murk_sparse_builder *b, size_t row,
                                    size_t column, size_t line, double clarity,
                                    murk_error *err)
{
    const uint16_t whole = (uint16_t)lrint(clarity * MURK_CLEAR);
    if (whole == 0) {
        return MURK_OK;
    }
    if (b->entries == b->capacity) {
        const size_t capacity = b->capacity ? 2 * b->capacity : 1024;
        murk_sparse_entry *entry = realloc(b->entry, capacity * sizeof *entry);
        if (!entry) {
            return no_memory(b, err);
        }
        b->entry = entry;
        b->capacity = capacity;
    }
    b->entry[b->entries++] = (murk_sparse_entry){
        (uint32_t)row, (uint32_t)column, (uint32_t)line, whole};
    return MURK_OK;
}

/* By row, then by line of the file, then by column. */
static int by_row(const void *a, const void *b)
{
    const murk_sparse_entry *x = a, *y = b;
    const int row = MURK_ORDER(x->row, y->row);
    const int line = MURK_ORDER(x->line, y->line);
    return row ? row : line ? line : MURK_ORDER(x->column, y->column);
}

/* Sorts by row, unless the entries are sorted already. */
static void sort_by_row(murk_sparse_builder *b)
{
    for (size_t k = 1; k < b->entries; ++k) {
        if (b->entry[k - 1].row > b->entry[k].row) {
            qsort(b->entry, b->entries, sizeof *b->entry, by_row);
            return;
        }
    }
}

/* Distributes the entries, which are sorted by row, to columns. Two entries of
 * the same row and column are then neighbours in the column, and the second one
 * makes the function fail with MURK_BAD_FILE. */
static murk_status fill_columns(murk_sparse_matrix *m,
                                const murk_sparse_builder *b, murk_error *err)
{
    m->is_clear = true;
    /* Count the entries of each column, then fill the columns. */
    for (size_t k = 0; k < b->entries; ++k) {
        ++m->begin[b->entry[k].column + 1];
    }
    for (size_t j = 0; j < m->columns; ++j) {
        m->begin[j + 1] += m->begin[j];
    }
    size_t *at = malloc(m->columns * sizeof *at);
    if (!at) {
        return no_memory(b, err);
    }
    memcpy(at, m->begin, m->columns * sizeof *at);
    murk_status status = MURK_OK;
    for (size_t k = 0; k < b->entries && !status; ++k) {
        const murk_sparse_entry *e = &b->entry[k];
        const size_t to = at[e->column]++;
        if (to > m->begin[e->column] && m->row[to - 1] == e->row) {
            char where[320];
            snprintf(where, sizeof where, "%.290s:%lu", b->path,
                     (unsigned long)e->line);
            status = murk_fail(
                err, MURK_BAD_FILE, where, "column %lu covers row %lu twice",
                (unsigned long)e->column + 1, (unsigned long)e->row + 1);
        }
        m->row[to] = e->row;
        m->clarity[to] = e->clarity;
        m->is_clear = m->is_clear && e->clarity == MURK_CLEAR;
    }
    free(at);
    return status;
}

static bool are_whole(const double *weight, size_t n, double unit)
{
    for (size_t i = 0; i < n; ++i) {
        const double x = weight[i] * unit;
        /* A decimal such as 0.1 is rounded to a double, and the product x is
         * rounded again. Both relative errors, 2^-53 at most each, are allowed.
         */
        if (fabs(x - rint(x)) > 2 * 0x1p-53 * x) {
            return false;
        }
    }
    return true;
}

/* Makes whole weights. The unit is the smallest power of ten, from 1 on, that
 * makes all given weights whole; or, if this power exceeds the largest unit
 * that 32 bits and WHOLE_SUM_MAX allow, that largest unit. Without given
 * weights all weights are 1. */
static murk_status weigh(murk_sparse_matrix *m, const murk_sparse_builder *b,
                         murk_error *err)
{
    m->unit = 1;
    if (!b->weight) {
        for (size_t i = 0; i < m->rows; ++i) {
            m->weight[i] = 1;
        }
        return MURK_OK;
    }
    double sum = 0, max = 0;
    for (size_t i = 0; i < m->rows; ++i) {
        sum += b->weight[i];
        max = fmax(max, b->weight[i]);
    }
    if (!(sum > 0 && isfinite(sum))) {
        return murk_fail(err, MURK_BAD_FILE, b->path,
                         "the weights add up to %g, must be more than 0", sum);
    }
    /* The unit, then the weights. */
    const double finest = fmin(UINT32_MAX / max, WHOLE_SUM_MAX / sum);
    while (m->unit <= finest && !are_whole(b->weight, m->rows, m->unit)) {
        m->unit *= 10;
    }
    if (!(m->unit <= finest)) {
        m->unit = finest;
    }
    for (size_t i = 0; i < m->rows; ++i) {
        m->weight[i] = (uint32_t)fmin(rint(b->weight[i] * m->unit), UINT32_MAX);
    }
    return MURK_OK;
}

static murk_status finish(murk_sparse_matrix **out, murk_sparse_builder *b,
                          murk_error *err)
{
    if (b->rows < 1 || b->columns < 1 || b->entries < 1) {
        return murk_fail(err, MURK_BAD_FILE, b->path,
                         "%zu rows, %zu columns and %zu entries above 0, must "
                         "be 1 or more of each",
                         b->rows, b->columns, b->entries);
    }
    /* Sort, convert the weights, and fill the columns. */
    murk_sparse_matrix *m = calloc(1, sizeof *m);
    if (!m) {
        return no_memory(b, err);
    }
    sort_by_row(b);
    *m = (murk_sparse_matrix){.format = b->format,
                              .rows = b->rows,
                              .columns = b->columns,
                              .weight = malloc(b->rows * sizeof *m->weight),
                              .begin = calloc(b->columns + 1, sizeof *m->begin),
                              .row = malloc(b->entries * sizeof *m->row),
                              .clarity =
                                  malloc(b->entries * sizeof *m->clarity)};
    murk_status status = m->weight && m->begin && m->row && m->clarity
                             ? weigh(m, b, err)
                             : no_memory(b, err);
    if (!status) {
        status = fill_columns(m, b, err);
    }
    if (status) {
        murk_sparse_matrix_destroy(m);
        return status;
    }
    m->cost = b->cost;
    m->name = b->name;
    b->cost = NULL;
    b->name = NULL;
    *out = m;
    return MURK_OK;
}

murk_status murk_sparse_builder_finish(murk_sparse_matrix **out,
                                       murk_sparse_builder *b, murk_error *err)
{
    const murk_status status = finish(out, b, err);
    murk_sparse_builder_release(b);
    return status;
}

void murk_sparse_builder_release(murk_sparse_builder *b)
{
    for (size_t j = 0; b->name && j < b->columns; ++j) {
        free(b->name[j]);
    }
    free(b->name);
    free(b->cost);
    free(b->weight);
    free(b->entry);
    *b = (murk_sparse_builder){.path = b->path};
}
