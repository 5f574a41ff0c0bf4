/* Builds the coverage matrix: asks the problem for every row, over all threads,
 * and stores each in a compact format (placement/row.h), in memory or in a
 * scratch file (placement/row_space.h). A sample of the rows is computed first
 * and gives an estimate of the size, so that a matrix that does not fit on the
 * disk is refused before all rows are computed. At the end photons with equal
 * columns are merged, if the caller allows it and the rows become so much
 * shorter that merging pays (placement/merge.h). */
#include "placement/matrix.h"

#include "base/arena.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/machine.h"
#include "base/pool.h"
#include "base/progress.h"
#include "base/ranks.h"
#include "base/tally.h"
#include "placement/merge.h"
#include "placement/row_exchange.h"
#include "placement/work_count.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* With fewer photons murk_matrix_create() merges nothing: the rows are so short
 * that calling the kernels takes longer than the loops over words that merging
 * would shorten (a choice). */
#define PHOTONS_WORTH_MERGING 16384

/* Rows of the sample. A rough estimate suffices, as rows that do not fit on the
 * disk are refused when they are stored, too. */
#define SAMPLE_ROWS 32

typedef struct fill_task {
    const murk_problem *problem;
    murk_matrix *matrix;
    murk_row_patching *patching; /* [threads]; NULL: no row is patched */
    const uint64_t *is_gone;     /* [words] slots of photons that are gone, or
                                  * that no photon had */
    _Atomic uint64_t
        *hash;       /* [photons] hashes of the columns; NULL: not computed */
    murk_tally rows; /* that are stored */
    murk_tally out_of_memory; /* rows that could not be allocated */
    murk_tally refused;       /* rows that the scratch file could not take */
} fill_task;

static double gigabytes(double bytes)
{
    return bytes * 1e-9;
}

/* The most rows that a rank stores: the same number in all ranks, so that all
 * make a forecast or none. */
static size_t share_max(const murk_matrix *matrix)
{
    const size_t ranks = matrix->is_distributed ? murk_ranks_count() : 1;
    return (matrix->candidates + ranks - 1) / ranks;
}

/* What the candidates of a message are. */
static const char *of_rank(const murk_matrix *matrix)
{
    return matrix->is_distributed ? " of a rank" : "";
}

/* Upper bound on the bytes of the rows, for any entries. */
static uint64_t max_possible(const murk_layout *layout, size_t candidates)
{
    return (uint64_t)candidates * murk_row_bytes_max(layout);
}

/* Adds a row to the hashes, or the difference from the earlier row. */
static void hash_row(fill_task *f, unsigned worker, size_t candidate,
                     const murk_sparse_row *entries)
{
    const murk_problem *problem = f->problem;
    if (!problem->earlier_hash) {
        murk_merge_hash(f->hash, candidate, entries);
        return;
    }
    murk_sparse_row gone, come;
    problem->get_differences(problem->context, worker, &gone, &come);
    murk_merge_unhash(f->hash, candidate, &gone);
    murk_merge_hash(f->hash, candidate, &come);
}

/* Turns the patch of a row, by photons, into one by slots. */
static void patch_slots(const fill_task *f, unsigned worker,
                        const murk_row_patch *by_photon)
{
    const murk_layout *layout = &f->matrix->layout;
    murk_row_patching *p = &f->patching[worker];
    memcpy(p->clear, f->is_gone, layout->words * sizeof *p->clear);
    memset(p->set, 0, layout->words * sizeof *p->set);
    for (size_t w = 0; w < (layout->photons + 63) / 64; ++w) {
        for (uint64_t left = by_photon->again[w]; left; left &= left - 1) {
            const size_t slot = murk_layout_slot(
                layout, (uint32_t)(64 * w) + (uint32_t)__builtin_ctzll(left));
            p->clear[slot / 64] |= UINT64_C(1) << (slot % 64);
        }
    }
    const murk_sparse_row *come = &by_photon->come;
    for (size_t k = 0; k < come->seen; ++k) {
        const size_t slot = murk_layout_slot(layout, come->photon[k]);
        p->set[slot / 64] |= UINT64_C(1) << (slot % 64);
        p->come[slot] = come->clarity ? come->clarity[k] : MURK_CLEAR;
    }
}

/* Stores a row in memory: that of the earlier matrix with a patch, or a row of
 * which all entries are asked for. False when out of memory. */
static bool make_row(fill_task *f, unsigned worker, size_t candidate,
                     murk_row *row)
{
    const murk_problem *problem = f->problem;
    murk_matrix *before = problem->patches.matrix;
    murk_row_patch patch;
    if (f->patching &&
        problem->patches.get(problem->context, worker, candidate, &patch)) {
        patch_slots(f, worker, &patch);
        const bool is_stored = murk_row_store_patched(
            row, &f->matrix->layout, murk_matrix_row(before, patch.candidate),
            &before->layout, &f->patching[worker]);
        if (patch.is_last) {
            murk_matrix_drop(before, patch.candidate);
        }
        return is_stored;
    }
    murk_sparse_row entries;
    problem->get_row(problem->context, worker, candidate, &entries);
    if (f->hash && murk_row_is_own(candidate)) {
        hash_row(f, worker, candidate, &entries);
    }
    return murk_row_store(row, &f->matrix->layout, &entries);
}

static void fill_row(void *context, unsigned worker, uint64_t batch)
{
    fill_task *f = context;
    murk_row *row = &f->matrix->row[batch];
    if (row->memory || murk_tally_read(&f->out_of_memory) > 0 ||
        murk_tally_read(&f->refused) > 0) {
        return;
    }
    if (!make_row(f, worker, (size_t)batch, row)) {
        murk_tally_add(&f->out_of_memory, 1);
    } else if (!murk_row_space_keep(f->matrix->space, row)) {
        murk_tally_add(&f->refused, 1);
    } else {
        murk_tally_add(&f->rows, 1);
    }
    murk_progress_add(1);
}

/* Fills row k of this rank. */
static void fill_own(void *context, unsigned worker, uint64_t k)
{
    fill_row(context, worker, murk_ranks_item(k));
}

/* Fills row k of the sample. Multiples of the golden ratio spread the sample
 * evenly and do not align with the steps of a grid. */
static void fill_sample(void *context, unsigned worker, uint64_t k)
{
    fill_task *f = context;
    const double turn = (double)k * 0.6180339887498949;
    const double share = turn - (double)(size_t)turn;
    fill_row(f, worker, (uint64_t)(share * (double)f->matrix->candidates));
}

/* A distributed matrix has no sampled rows but those of its own candidates. */
static void drop_others(fill_task *f)
{
    murk_matrix *matrix = f->matrix;
    for (size_t j = 0; j < matrix->candidates; ++j) {
        if (!murk_matrix_has(matrix, j)) {
            murk_row_space_drop(matrix->space, &matrix->row[j]);
        }
    }
}

/* Refuses a matrix, of estimated size, that memory and scratch file do not
 * hold. */
static murk_status check_size(const fill_task *f, double bytes, murk_error *err)
{
    const murk_row_space *space = f->matrix->space;
    const double memory = (double)space->memory_max;
    if (!space->file) {
        return murk_fail(err, space->error.code, space->error.where, "%s",
                         space->error.text);
    }
    /* The sample is in the file already. */
    const double left = murk_scratch_file_left(space->file) +
                        (double)murk_tally_read(&space->in_file);
    return bytes - memory <= left
               ? MURK_OK
               : murk_fail(err, MURK_RUN_FAILED, murk_scratch_folder(),
                           "the coverage matrix of %zu candidates%s and %zu "
                           "photons takes about %.3g GB: %.3g GB in memory, "
                           "and the rest in a scratch file in this folder, "
                           "which can take %.3g GB; TMPDIR may name another "
                           "folder, and fewer candidates or photons, or "
                           "`knowledge: unknown`, need less",
                           share_max(f->matrix), of_rank(f->matrix),
                           f->problem->photons, gigabytes(bytes),
                           gigabytes(memory), gigabytes(left));
}

/* Computes a sample of the rows, and estimates the matrix. If memory cannot
 * hold the matrix, prints the sizes and the time, or fails if the scratch file
 * cannot take the rest. */
static murk_status forecast(fill_task *f, murk_error *err)
{
    const murk_problem *problem = f->problem;
    const murk_row_space *space = f->matrix->space;
    const double begun_s = murk_clock_s();
    for (size_t k = 0; k < SAMPLE_ROWS && !murk_interrupted(); ++k) {
        fill_sample(f, 0, k);
    }
    /* Scale the sample to all candidates. */
    const double rows = fmax((double)murk_tally_read(&f->rows), 1);
    const double here = (double)share_max(f->matrix);
    const double of_all = here / rows;
    const double elapsed_s = (murk_clock_s() - begun_s) / problem->threads;
    const double bytes = of_all * (double)murk_row_space_bytes(space);
    drop_others(f);
    if (bytes <= (double)space->memory_max) {
        return MURK_OK;
    }
    const murk_status status = check_size(f, bytes, err);
    if (!status) {
        murk_note("coverage matrix",
                  "%.0f candidates%s and %zu photons take about %.3g GB and "
                  "%.2g s to compute: %.3g GB in memory, the rest in a scratch "
                  "file in %s, which can take %.3g GB",
                  here, of_rank(f->matrix), problem->photons, gigabytes(bytes),
                  elapsed_s * of_all, gigabytes((double)space->memory_max),
                  murk_scratch_folder(),
                  gigabytes(murk_scratch_file_left(space->file)));
    }
    return status;
}

/* Fails if not all rows are stored. */
static murk_status check_rows(const fill_task *f, murk_error *err)
{
    if (murk_tally_read(&f->out_of_memory) > 0) {
        return murk_no_memory(
            err, "",
            "for the coverage matrix of %zu candidates and %zu photons",
            f->problem->candidates, f->problem->photons);
    }
    return murk_row_space_check(f->matrix->space, err);
}

/* Gives all ranks the rows, unless the matrix is distributed, and the hashes of
 * the columns that the others have computed. */
static murk_status exchange(fill_task *f, murk_status status, murk_error *err)
{
    murk_matrix *matrix = f->matrix;
    uint64_t *sum = NULL;
    const size_t photons = f->hash ? f->problem->photons : 0;
    if (!matrix->is_distributed) {
        status =
            murk_row_exchange(matrix->row, matrix->candidates, matrix->space,
                              murk_row_bytes_max(&matrix->layout), status, err);
    }
    if (photons > 0 && !status) {
        sum = malloc(photons * sizeof *sum);
        status = sum ? MURK_OK : murk_no_memory(err, "", "to merge photons");
    }
    for (size_t i = 0; i < photons && !status; ++i) {
        sum[i] = f->hash[i];
    }
    status = murk_ranks_sum(sum, photons, false, status, err);
    for (size_t i = 0; i < photons && !status; ++i) {
        f->hash[i] = sum[i];
    }
    free(sum);
    return status;
}

/* Allocates what patches need. */
static murk_status prepare_patches(fill_task *f, murk_arena *arena,
                                   murk_error *err)
{
    const murk_problem *problem = f->problem;
    const murk_layout *layout = &f->matrix->layout;
    const size_t words = layout->words, slots = layout->slots;
    uint64_t *is_gone = murk_arena_array(arena, words, sizeof *is_gone);
    f->patching =
        murk_arena_array(arena, problem->threads, sizeof *f->patching);
    for (unsigned i = 0; f->patching && i < problem->threads; ++i) {
        murk_row_patching *p = &f->patching[i];
        p->clear = murk_arena_array(arena, words, sizeof *p->clear);
        p->set = murk_arena_array(arena, words, sizeof *p->set);
        p->bits = murk_arena_array(arena, words, sizeof *p->bits);
        p->come = murk_arena_array(arena, slots, sizeof *p->come);
        p->slot = murk_arena_array(arena, slots, sizeof *p->slot);
        p->clarity = murk_arena_array(arena, slots, sizeof *p->clarity);
    }
    if (arena->is_short) {
        return murk_no_memory(err, "", "to change %zu rows",
                              problem->candidates);
    }
    /* Slots of photons that stay are not gone. */
    memset(is_gone, 0xff, words * sizeof *is_gone);
    for (uint32_t i = 0; i < problem->photons; ++i) {
        if (problem->patches.photon[i] != MURK_NO_PHOTON) {
            const size_t slot = murk_layout_slot(layout, i);
            is_gone[slot / 64] &= ~(UINT64_C(1) << (slot % 64));
        }
    }
    f->is_gone = is_gone;
    return MURK_OK;
}

/* Asks for all rows. */
static murk_status fill(murk_matrix *matrix, const murk_problem *problem,
                        bool may_exceed, _Atomic uint64_t *hash,
                        murk_error *err)
{
    fill_task f = {.problem = problem, .matrix = matrix, .hash = hash};
    murk_arena arena = {0};
    murk_status status =
        problem->patches.matrix ? prepare_patches(&f, &arena, err) : MURK_OK;
    murk_progress_begin("sense", problem->candidates, "candidates");
    if (!status && may_exceed && problem->candidates > 0) {
        status = forecast(&f, err);
    }
    const murk_work_count work = murk_work_count_begin(problem);
    if (!status) {
        murk_pool_run_workers(problem->threads,
                              murk_ranks_share(problem->candidates), fill_own,
                              &f);
    }
    murk_progress_end();
    murk_arena_release(&arena);
    if (problem->rest) {
        problem->rest(problem->context);
    }
    status = status ? status : murk_interrupt_check(err);
    status = status ? status : check_rows(&f, err);
    if (murk_ranks_count() > 1) {
        status = murk_work_count_add(&work, status, err);
        status = exchange(&f, status, err);
    }
    if (status) {
        return status;
    }
    /* Sum up the rows. */
    uint64_t pairs_and_attenuated[2] = {0};
    for (size_t j = 0; j < matrix->candidates; ++j) {
        const murk_row *row = &matrix->row[j];
        if (murk_matrix_has(matrix, j)) {
            pairs_and_attenuated[0] += row->seen;
            pairs_and_attenuated[1] +=
                row->kind != MURK_ROW_BITS && row->kind != MURK_ROW_CLEAR_LIST;
        }
    }
    if (matrix->is_distributed) {
        status = murk_ranks_sum(pairs_and_attenuated, 2, false, status, err);
    }
    matrix->pairs = pairs_and_attenuated[0];
    matrix->is_binary = pairs_and_attenuated[1] == 0;
    if (matrix->is_binary) { /* detection with probability 1 needs no doses */
        free(matrix->layout.doses);
        matrix->layout.doses = NULL;
    }
    return status;
}

static bool is_distributed(const murk_problem *problem)
{
    const unsigned ranks = murk_ranks_count();
    return murk_matrix_spreads((double)problem->candidates,
                               (double)problem->photons, ranks) ||
           (ranks > 1 && problem->is_distributed);
}

murk_status murk_matrix_create(murk_matrix **out, const murk_problem *problem,
                               uint64_t memory_bytes, murk_error *err)
{
    const bool is_worth = problem->photons >= PHOTONS_WORTH_MERGING &&
                          !problem->is_reweighed && !problem->is_unmerged;
    return murk_matrix_make(
        out, problem, memory_bytes,
        is_worth ? MURK_MERGE_WHERE_IT_PAYS : MURK_MERGE_NEVER, err);
}

murk_status murk_matrix_make(murk_matrix **out, const murk_problem *problem,
                             uint64_t memory_bytes, murk_merging merging,
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
        matrix->space = calloc(1, sizeof *matrix->space);
    }
    for (size_t i = 0; hash && problem->earlier_hash && i < problem->photons;
         ++i) {
        hash[i] = problem->earlier_hash[i];
    }
    /* All ranks exchange hashes, or none does. */
    const bool lacks_hash =
        murk_ranks_count() > 1 && merging != MURK_MERGE_NEVER && !hash;
    if (!matrix || !matrix->row || !matrix->space || lacks_hash) {
        status = murk_no_memory(err, "", "for a matrix of %zu candidates",
                                problem->candidates);
        goto done;
    }
    /* Fill, and merge. */
    status = problem->patches.matrix
                 ? murk_layout_patch(&matrix->layout, problem,
                                     &problem->patches.matrix->layout,
                                     problem->patches.photon, err)
                 : murk_layout_init(&matrix->layout, problem, true, err);
    if (!status) {
        matrix->is_distributed = is_distributed(problem);
        const uint64_t bytes_max =
            max_possible(&matrix->layout, share_max(matrix));
        murk_row_space_init(matrix->space, bytes_max, memory_bytes);
        status = fill(matrix, problem, bytes_max > memory_bytes, hash, err);
    }
    if (!status && hash) {
        status = murk_merge(
            &matrix->layout, matrix->row, matrix->space, matrix->is_distributed,
            problem, hash, problem->has_columns, merging == MURK_MERGE_ALWAYS,
            problem->has_columns ? &matrix->representative : NULL, err);
        hash =
            problem->has_columns ? hash : NULL; /* murk_merge() has freed it */
        if (matrix->representative) {
            matrix->hash = hash;
            hash = NULL;
        }
        murk_machine_trim();
    }
    if (!status) {
        matrix->bytes = murk_row_space_bytes(matrix->space);
    }
    if (matrix->is_distributed) {
        status = murk_ranks_sum(&matrix->bytes, 1, false, status, err);
    }
    if (matrix->is_distributed) {
        status = murk_fetched_rows_create(&matrix->fetched, matrix->row,
                                          matrix->candidates, status, err);
    }
    if (!status) {
        *out = matrix;
        matrix = NULL;
    }
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
    if (!matrix) {
        return;
    }
    if (!matrix->borrows_rows) {
        for (size_t j = 0;
             matrix->row && matrix->space && j < matrix->candidates; ++j) {
            if (!matrix->row[j].is_in_file) { /* the file goes as a whole */
                murk_row_space_drop(matrix->space, &matrix->row[j]);
            }
        }
        if (matrix->space) {
            murk_row_space_release(matrix->space);
        }
        free(matrix->space);
        free(matrix->row);
        free(matrix->representative);
        free(matrix->hash);
        murk_fetched_rows_destroy(matrix->fetched);
    }
    murk_layout_release(&matrix->layout);
    free(matrix);
}

uint64_t murk_matrix_pairs(const murk_matrix *matrix)
{
    return matrix->pairs;
}

size_t murk_matrix_bytes(const murk_matrix *matrix)
{
    return sizeof *matrix + matrix->candidates * sizeof *matrix->row +
           (size_t)murk_row_space_bytes(matrix->space);
}

uint64_t murk_matrix_memory(const murk_matrix *matrix)
{
    return (uint64_t)murk_tally_read(&matrix->space->memory);
}

size_t murk_matrix_slots(const murk_matrix *matrix)
{
    return matrix->layout.slots;
}

size_t murk_matrix_slot(const murk_matrix *matrix, uint32_t photon)
{
    return murk_layout_slot(
        &matrix->layout,
        matrix->representative ? matrix->representative[photon] : photon);
}

bool murk_matrix_list(uint32_t *slot, uint16_t *clarity, size_t *n,
                      const murk_matrix *matrix, size_t candidate)
{
    *n = 0;
    if (!murk_matrix_has(matrix, candidate)) {
        return false;
    }
    const murk_row *row = murk_matrix_row(matrix, candidate);
    size_t at;
    for (murk_row_walk walk = murk_row_begin(&matrix->layout, row);
         murk_row_next(&walk, &at, &clarity[*n]);) {
        slot[*n] = (uint32_t)at;
        *n += clarity[*n] > 0;
    }
    return true;
}

void murk_matrix_drop(murk_matrix *matrix, size_t candidate)
{
    murk_row_space_drop(matrix->space, &matrix->row[candidate]);
}

/* Photons that were added share words with photons of other places, which makes
 * rows longer: if more than this share was added, the photons are put in order
 * anew. */
#define ADDED_SHARE_MAX 0.25

bool murk_matrix_can_be_patched(const murk_matrix *matrix, size_t photons,
                                size_t added, size_t gone)
{
    const double all = (double)(matrix->layout.added + added);
    return matrix->layout.photons == photons - added + gone &&
           !matrix->representative && !matrix->hash && !matrix->borrows_rows &&
           murk_ranks_count() == 1 && all <= ADDED_SHARE_MAX * (double)photons;
}

const _Atomic uint64_t *murk_matrix_hashes(const murk_matrix *matrix)
{
    return matrix->hash;
}
