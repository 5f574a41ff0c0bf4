#include "study/sparse_matrix.h"

#include <stdlib.h>
#include <string.h>

static void look(void *context, unsigned worker, size_t candidate,
                 murk_look *out)
{
    const murk_sparse_matrix *m = context;
    (void)worker;
    const size_t from = m->begin[candidate];
    *out = (murk_look){.seen = m->begin[candidate + 1] - from,
                       .photon = m->row + from,
                       .clarity = m->is_clear ? NULL : m->clarity + from};
}

murk_problem murk_sparse_matrix_problem(murk_sparse_matrix *matrix,
                                        unsigned threads)
{
    return (murk_problem){.photons = matrix->rows,
                          .candidates = matrix->columns,
                          .weight = matrix->weight,
                          .look = look,
                          .context = matrix,
                          .threads = threads};
}

/* Room for `more` entries behind the first `have`. */
static bool make_room(murk_sparse_matrix *m, size_t *room, size_t have,
                      size_t more)
{
    if (have + more <= *room) {
        return true;
    }
    size_t wanted = 2 * *room;
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
    *room = wanted;
    return true;
}

static void append(murk_sparse_matrix *m, size_t at, const murk_look *seen)
{
    if (seen->seen) {
        memcpy(m->row + at, seen->photon, seen->seen * sizeof *m->row);
    }
    for (size_t k = 0; k < seen->seen; ++k) {
        const uint16_t clarity = seen->clarity ? seen->clarity[k] : MURK_CLEAR;
        m->clarity[at + k] = clarity;
        m->is_clear = m->is_clear && clarity == MURK_CLEAR;
    }
}

/* Weights in the smallest whole numbers of the same ratios: a sum is then
 * what it was, divided by their greatest common divisor. */
static void reduce_weights(murk_sparse_matrix *m)
{
    uint32_t common = 0;
    for (size_t i = 0; i < m->rows; ++i) {
        uint32_t a = common, b = m->weight[i];
        while (b) {
            const uint32_t rest = a % b;
            a = b;
            b = rest;
        }
        common = a;
    }
    for (size_t i = 0; i < m->rows && common > 1; ++i) {
        m->weight[i] /= common;
    }
}

murk_status murk_sparse_matrix_collect(murk_sparse_matrix **out,
                                       const murk_problem *problem,
                                       size_t most_entries, murk_error *err)
{
    murk_status status = MURK_NO_MEMORY;
    size_t room = 1024, have = 0;
    murk_sparse_matrix *m = calloc(1, sizeof *m);
    if (!m) {
        goto done;
    }
    *m = (murk_sparse_matrix){
        .format = MURK_MATRIX_SPARSE_CSV,
        .rows = problem->photons,
        .columns = problem->candidates,
        .unit = 1,
        .is_clear = true,
        .weight = malloc((problem->photons + 1) * sizeof *m->weight),
        .begin = calloc(problem->candidates + 1, sizeof *m->begin),
        .row = malloc(room * sizeof *m->row),
        .clarity = malloc(room * sizeof *m->clarity)};
    if (!m->weight || !m->begin || !m->row || !m->clarity) {
        goto done;
    }
    memcpy(m->weight, problem->weight, problem->photons * sizeof *m->weight);
    for (size_t j = 0; j < problem->candidates; ++j) {
        murk_look seen;
        problem->look(problem->context, 0, j, &seen);
        if (have + seen.seen > most_entries) {
            status =
                murk_fail(err, MURK_RUN_FAILED, "",
                          "the first %zu of %zu candidates see %zu "
                          "photons, a matrix may have %zu entries",
                          j + 1, m->columns, have + seen.seen, most_entries);
            goto done;
        }
        if (!make_room(m, &room, have, seen.seen)) {
            goto done;
        }
        append(m, have, &seen);
        have += seen.seen;
        m->begin[j + 1] = have;
    }
    reduce_weights(m);
    *out = m;
    m = NULL;
    status = MURK_OK;
done:
    murk_sparse_matrix_destroy(m);
    return status == MURK_NO_MEMORY
               ? murk_fail(err, status, "", "no memory for the matrix")
               : status;
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
