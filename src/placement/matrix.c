/* Builds the coverage matrix: asks the problem for every row, over all threads,
 * and stores each in a compact format (placement/row.h). If the matrix could
 * exceed the memory limit, a pilot sample of rows estimates the size first, so
 * that a matrix that does not fit is refused before all rows are computed. At
 * the end photons with equal columns are merged, if the caller allows it and
 * the rows become so much shorter that merging pays (placement/merge.h). */
#include "placement/matrix.h"

#include "base/interrupt.h"
#include "base/machine.h"
#include "base/pool.h"
#include "base/progress.h"
#include "base/tally.h"
#include "placement/merge.h"

#include <assert.h>
#include <stdlib.h>

/* With fewer photons murk_matrix_create() merges nothing: the rows are so short
 * that calling the kernels takes longer than the loops over words that merging
 * would shorten (a choice). */
#define PHOTONS_WORTH_MERGING 16384

/* Rows of the pilot sample. A rough estimate suffices, as the limit
 * itself is checked while the matrix is filled. */
#define PILOT_ROWS 32

typedef struct fill_task {
    const murk_problem *problem;
    murk_matrix *matrix;
    uint64_t max_bytes;
    _Atomic uint64_t
        *hash; /* [photons] hashes of the columns; NULL: not computed */
    murk_tally bytes;
    murk_tally out_of_memory; /* rows that could not be allocated */
} fill_task;

static double gigabytes(uint64_t bytes)
{
    return (double)bytes * 1e-9;
}

static murk_status too_big(murk_error *err, const murk_problem *problem,
                           const char *about, double gb, uint64_t max_bytes)
{
    return murk_fail(err, MURK_RUN_FAILED, "",
                     "the coverage matrix of %zu candidates and %zu photons "
                     "takes %s %.3g GB, more than the %.3g GB it may; fewer "
                     "candidates or photons, or `knowledge: unknown`, need "
                     "less",
                     problem->candidates, problem->photons, about, gb,
                     gigabytes(max_bytes));
}

/* Upper bound on the memory of the rows, for any entries. */
static uint64_t max_possible(const murk_layout *layout, size_t candidates)
{
    return (uint64_t)candidates *
           (sizeof(murk_row) + 64 + layout->slots * sizeof(uint16_t));
}

/* Candidate k of the pilot sample. Multiples of the golden ratio spread the
 * sample evenly and do not align with the steps of a grid. */
static size_t pilot_candidate(size_t k, size_t candidates)
{
    const double turn = (double)k * 0.6180339887498949;
    return (size_t)((turn - (double)(size_t)turn) * (double)candidates);
}

static murk_status pilot(const murk_problem *problem, const murk_layout *layout,
                         uint64_t max_bytes, murk_error *err)
{
    double bytes = 0;
    for (size_t k = 0; k < PILOT_ROWS && !murk_interrupted(); ++k) {
        murk_sparse_row entries;
        problem->get_row(problem->context, 0,
                         pilot_candidate(k, problem->candidates), &entries);
        bytes += (double)murk_row_bytes(layout, &entries) / PILOT_ROWS;
    }
    bytes = (bytes + sizeof(murk_row)) * (double)problem->candidates;
    if (bytes > (double)max_bytes) {
        return too_big(err, problem, "about", bytes * 1e-9, max_bytes);
    }
    return MURK_OK;
}

static void fill_row(void *context, unsigned worker, uint64_t batch)
{
    fill_task *f = context;
    if ((uint64_t)murk_tally_read(&f->bytes) > f->max_bytes ||
        murk_tally_read(&f->out_of_memory) > 0) {
        return;
    }
    murk_sparse_row entries;
    f->problem->get_row(f->problem->context, worker, (size_t)batch, &entries);
    if (f->hash) {
        murk_merge_hash(f->hash, (size_t)batch, &entries);
    }
    murk_row *row = &f->matrix->row[batch];
    if (murk_row_store(row, &f->matrix->layout, &entries)) {
        murk_tally_add(&f->bytes, (int64_t)(row->memory_bytes + sizeof *row));
    } else {
        murk_tally_add(&f->out_of_memory, 1);
    }
    murk_progress_add(1);
}

static murk_status fill(murk_matrix *matrix, const murk_problem *problem,
                        uint64_t max_bytes, _Atomic uint64_t *hash,
                        murk_error *err)
{
    fill_task f = {.problem = problem,
                   .matrix = matrix,
                   .hash = hash,
                   .max_bytes = max_bytes};
    /* Ask for all rows. */
    murk_progress_begin("sense", problem->candidates, "candidates");
    murk_pool_run_workers(problem->threads, problem->candidates, fill_row, &f);
    murk_progress_end();
    if (problem->rest) {
        problem->rest(problem->context);
    }
    /* Refuse an incomplete matrix. */
    if (murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    if (murk_tally_read(&f.out_of_memory) > 0) {
        return murk_no_memory(
            err, "",
            "for the coverage matrix of %zu candidates and %zu photons",
            problem->candidates, problem->photons);
    }
    if ((uint64_t)murk_tally_read(&f.bytes) > max_bytes) {
        return too_big(err, problem, "more than", gigabytes(max_bytes),
                       max_bytes);
    }
    /* Sum up the rows. */
    matrix->is_binary = true;
    matrix->memory_bytes = sizeof *matrix + (size_t)murk_tally_read(&f.bytes);
    for (size_t j = 0; j < matrix->candidates; ++j) {
        const murk_row *row = &matrix->row[j];
        matrix->pairs += row->seen;
        matrix->is_binary =
            matrix->is_binary &&
            (row->kind == MURK_ROW_BITS || row->kind == MURK_ROW_CLEAR_LIST);
    }
    if (matrix->is_binary) { /* detection with probability 1 needs no doses */
        free(matrix->layout.doses);
        matrix->layout.doses = NULL;
    }
    return MURK_OK;
}

murk_status murk_matrix_create(murk_matrix **out, const murk_problem *problem,
                               uint64_t max_bytes, murk_error *err)
{
    const bool is_worth =
        problem->photons >= PHOTONS_WORTH_MERGING && !problem->is_reweighed;
    return murk_matrix_make(
        out, problem, max_bytes,
        is_worth ? MURK_MERGE_WHERE_IT_PAYS : MURK_MERGE_NEVER, err);
}

murk_status murk_matrix_make(murk_matrix **out, const murk_problem *problem,
                             uint64_t max_bytes, murk_merging merging,
                             murk_error *err)
{
    assert(out && problem && problem->threads > 0);
    murk_status status = MURK_OK;
    /* hashes of the columns; without them nothing is merged */
    _Atomic uint64_t *hash = merging == MURK_MERGE_NEVER
                                 ? NULL
                                 : calloc(problem->photons + 1, sizeof *hash);
    murk_matrix *matrix = calloc(1, sizeof *matrix);
    if (matrix) {
        matrix->candidates = problem->candidates;
        matrix->row = calloc(problem->candidates + 1, sizeof *matrix->row);
    }
    if (!matrix || !matrix->row) {
        status = murk_no_memory(err, "", "for a matrix of %zu candidates",
                                problem->candidates);
        goto done;
    }
    /* Check the size with a pilot sample, fill, and merge. */
    status = murk_layout_init(&matrix->layout, problem, true, err);
    if (!status && problem->candidates > 0 &&
        max_possible(&matrix->layout, problem->candidates) > max_bytes) {
        status = pilot(problem, &matrix->layout, max_bytes, err);
    }
    if (!status) {
        status = fill(matrix, problem, max_bytes, hash, err);
    }
    if (!status && hash) {
        uint64_t row_bytes = matrix->memory_bytes - sizeof *matrix;
        status = murk_merge(&matrix->layout, matrix->row, problem, hash,
                            merging == MURK_MERGE_ALWAYS, &row_bytes, err);
        hash = NULL; /* murk_merge() has freed it */
        murk_machine_trim();
        matrix->memory_bytes = sizeof *matrix + (size_t)row_bytes;
    }
    if (status) {
        goto done;
    }
    *out = matrix;
    matrix = NULL;
done:
    free(hash);
    murk_matrix_destroy(matrix);
    return status;
}

murk_status murk_matrix_reweigh(murk_matrix **out, const murk_matrix *from,
                                const uint32_t *weight, murk_error *err)
{
    murk_matrix *matrix = malloc(sizeof *matrix);
    if (!matrix) {
        return murk_no_memory(err, "", "for a matrix");
    }
    *matrix = *from;
    matrix->borrows_rows = true;
    matrix->layout = (murk_layout){0};
    const murk_status status =
        murk_layout_reweigh(&matrix->layout, &from->layout, weight, err);
    if (status) {
        free(matrix);
        return status;
    }
    *out = matrix;
    return MURK_OK;
}

void murk_matrix_destroy(murk_matrix *matrix)
{
    if (matrix) {
        for (size_t j = 0;
             matrix->row && !matrix->borrows_rows && j < matrix->candidates;
             ++j) {
            free(matrix->row[j].memory);
        }
        if (!matrix->borrows_rows) {
            free(matrix->row);
        }
        murk_layout_release(&matrix->layout);
        free(matrix);
    }
}

uint64_t murk_matrix_pairs(const murk_matrix *matrix)
{
    return matrix->pairs;
}

size_t murk_matrix_memory_bytes(const murk_matrix *matrix)
{
    return matrix->memory_bytes;
}
