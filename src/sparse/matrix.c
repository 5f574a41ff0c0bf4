/* A coverage matrix as a placement problem, and the reverse: the collection of
 * the entries of all candidates of a problem into a matrix, in which each
 * candidate is a column. (In a problem the entries of a candidate are called a
 * row.) Collecting works in blocks: the entries of each block of candidates are
 * computed over all threads and then appended in order, so memory beyond the
 * result stays small. Also sorts the entries of a matrix by row. */
#include "sparse/matrix.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "placement/layout.h"

#include <stdlib.h>
#include <string.h>

static void get_row(void *context, unsigned worker, size_t candidate,
                    murk_sparse_row *out)
{
    const murk_sparse_matrix *m = context;
    (void)worker;
    const size_t from = m->begin[candidate];
    *out = (murk_sparse_row){.seen = m->begin[candidate + 1] - from,
                             .photon = m->row + from,
                             .clarity = m->is_clear ? NULL : m->clarity + from};
}

murk_problem murk_sparse_matrix_problem(murk_sparse_matrix *matrix,
                                        unsigned threads)
{
    return (murk_problem){.photons = matrix->rows,
                          .candidates = matrix->columns,
                          .weight = matrix->weight,
                          .get_row = get_row,
                          .context = matrix,
                          .threads = threads};
}

bool murk_sparse_matrix_by_rows(murk_sparse_rows *out,
                                const murk_sparse_matrix *m,
                                const bool *is_wanted, murk_arena *arena)
{
    const size_t entries = murk_sparse_matrix_entries(m);
    out->begin = murk_arena_array(arena, m->rows + 2, sizeof *out->begin);
    out->column = murk_arena_array(arena, entries, sizeof *out->column);
    out->clarity = murk_arena_array(arena, entries, sizeof *out->clarity);
    if (arena->is_short) {
        return false;
    }
    /* First begin[i + 2] counts the entries of row i. After the summation,
     * begin[i + 1] is the place of the next entry of row i, and at the end the
     * end of row i. */
    for (size_t e = 0; e < entries; ++e) {
        out->begin[m->row[e] + 2] += !is_wanted || is_wanted[m->row[e]];
    }
    for (size_t i = 0; i < m->rows; ++i) {
        out->begin[i + 2] += out->begin[i + 1];
    }
    for (size_t j = 0; j < m->columns; ++j) {
        for (size_t e = m->begin[j]; e < m->begin[j + 1]; ++e) {
            if (!is_wanted || is_wanted[m->row[e]]) {
                const size_t to = out->begin[m->row[e] + 1]++;
                out->column[to] = (uint32_t)j;
                out->clarity[to] = m->clarity[e];
            }
        }
    }
    return true;
}

/* Candidates of a block for each thread: enough that threads seldom wait for
 * the slowest candidate (a choice). */
#define BLOCK_EACH 8

typedef struct stored_row {
    size_t seen;
    uint32_t *photon;
    uint16_t *clarity;
    bool has_failed;
} stored_row;

typedef struct collection {
    const murk_problem *problem;
    murk_sparse_matrix *matrix;
    size_t capacity, max;
    size_t first; /* candidate of block[0] */
    stored_row *block;
} collection;

static void get_one_row(void *context, unsigned worker, uint64_t batch)
{
    const collection *c = context;
    stored_row *stored = &c->block[batch];
    murk_sparse_row seen;
    c->problem->get_row(c->problem->context, worker, c->first + batch, &seen);
    *stored = (stored_row){
        .seen = seen.seen,
        .photon = malloc((seen.seen + 1) * sizeof *stored->photon),
        .clarity = malloc((seen.seen + 1) * sizeof *stored->clarity)};
    stored->has_failed = !stored->photon || !stored->clarity;
    for (size_t k = 0; k < seen.seen && !stored->has_failed; ++k) {
        stored->photon[k] = seen.photon[k];
        stored->clarity[k] = seen.clarity ? seen.clarity[k] : MURK_CLEAR;
    }
}

/* Makes space for `more` entries behind the first `have`. */
static bool make_space(collection *c, size_t have, size_t more)
{
    murk_sparse_matrix *m = c->matrix;
    if (have + more <= c->capacity) {
        return true;
    }
    size_t wanted = 2 * c->capacity;
    wanted = wanted > have + more ? wanted : have + more;
    uint32_t *row = realloc(m->row, wanted * sizeof *row);
    if (!row) {
        return false;
    }
    m->row = row;
    uint16_t *clarity = realloc(m->clarity, wanted * sizeof *clarity);
    if (!clarity) {
        return false;
    }
    m->clarity = clarity;
    c->capacity = wanted;
    return true;
}

static murk_status append(collection *c, size_t candidate,
                          const stored_row *seen, murk_error *err)
{
    murk_sparse_matrix *m = c->matrix;
    const size_t have = m->begin[candidate];
    if (have + seen->seen > c->max) {
        return murk_fail(err, MURK_RUN_FAILED, "",
                         "the first %zu of %zu candidates see %zu photons, a "
                         "matrix may have %zu entries",
                         candidate + 1, m->columns, have + seen->seen, c->max);
    }
    if (seen->has_failed || !make_space(c, have, seen->seen)) {
        return murk_no_memory(err, "", "for the matrix");
    }
    memcpy(m->row + have, seen->photon, seen->seen * sizeof *m->row);
    memcpy(m->clarity + have, seen->clarity, seen->seen * sizeof *m->clarity);
    for (size_t k = 0; k < seen->seen; ++k) {
        m->is_clear = m->is_clear && seen->clarity[k] == MURK_CLEAR;
    }
    m->begin[candidate + 1] = have + seen->seen;
    return MURK_OK;
}

static murk_status get_rows(collection *c, murk_error *err)
{
    const size_t capacity = (size_t)BLOCK_EACH * c->problem->threads;
    murk_status status = MURK_OK;
    c->block = calloc(capacity, sizeof *c->block);
    if (!c->block) {
        return murk_no_memory(err, "", "for the matrix");
    }
    /* One block after the other. */
    for (; c->first < c->matrix->columns && !status; c->first += capacity) {
        const size_t left = c->matrix->columns - c->first;
        const size_t n = left < capacity ? left : capacity;
        murk_pool_run_workers(c->problem->threads, n, get_one_row, c);
        status = murk_interrupt_check(err);
        for (size_t i = 0; i < n; ++i) {
            if (!status) {
                status = append(c, c->first + i, &c->block[i], err);
            }
            free(c->block[i].photon);
            free(c->block[i].clarity);
            c->block[i] = (stored_row){0};
        }
    }
    free(c->block);
    return status;
}

/* Divides the weights by their greatest common divisor. */
static void reduce_weights(murk_sparse_matrix *m)
{
    const uint32_t common = murk_common_divisor(m->weight, m->rows);
    for (size_t i = 0; i < m->rows; ++i) {
        m->weight[i] /= common;
    }
}

murk_status murk_sparse_matrix_collect(murk_sparse_matrix **out,
                                       const murk_problem *problem,
                                       size_t max_entries, murk_error *err)
{
    murk_status status = MURK_NO_MEMORY;
    murk_sparse_matrix *m = calloc(1, sizeof *m);
    if (m) {
        *m = (murk_sparse_matrix){
            .format = MURK_MATRIX_SPARSE_CSV,
            .rows = problem->photons,
            .columns = problem->candidates,
            .unit = 1,
            .is_clear = true,
            .weight = malloc((problem->photons + 1) * sizeof *m->weight),
            .begin = calloc(problem->candidates + 1, sizeof *m->begin)};
        status = m->weight && m->begin ? MURK_OK : status;
    }
    if (status) {
        murk_sparse_matrix_destroy(m);
        return murk_fail(err, status, "", "no memory for the matrix");
    }
    /* Reduce the weights, then collect the entries of all candidates. */
    memcpy(m->weight, problem->weight, problem->photons * sizeof *m->weight);
    reduce_weights(m);
    collection c = {.problem = problem, .matrix = m, .max = max_entries};
    status = make_space(&c, 0, 1) ? get_rows(&c, err)
                                  : murk_no_memory(err, "", "for the matrix");
    if (status) {
        murk_sparse_matrix_destroy(m);
        return status;
    }
    *out = m;
    return MURK_OK;
}

void murk_sparse_matrix_destroy(murk_sparse_matrix *matrix)
{
    if (!matrix) {
        return;
    }
    for (size_t j = 0; matrix->name && j < matrix->columns; ++j) {
        free(matrix->name[j]);
    }
    free(matrix->name);
    free(matrix->cost);
    free(matrix->weight);
    free(matrix->begin);
    free(matrix->row);
    free(matrix->clarity);
    free(matrix);
}
