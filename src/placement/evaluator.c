/* Gains of candidates over a cover, single-threaded or spread over threads, and
 * the ranking of the candidates at the start of a placement: the value of each
 * candidate alone, the ceiling (the value of all candidates together), and the
 * dominated candidates (placement/presolve.h). Results never depend on the
 * number of threads. The caller owns the cover and must not change the cover
 * during a call. */
#include "placement/evaluator.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "base/ranks.h"
#include "base/sort.h"
#include "placement/presolve.h"
#include "placement/row_exchange.h"
#include "placement/work_count.h"

#include <stdlib.h>
#include <string.h>

/* Starting threads costs some 50 us. A scan over so many bytes takes 200 us and
 * more, so threads pay. */
#define BYTES_WORTH_THREADS 2097152

/* Candidates in one batch of a thread: evaluating 16 rows takes longer than
 * fetching the next batch. If the problem is asked for rows, each row is a
 * batch by itself, because computing a row always takes longer than that. */
#define ROWS_AT_ONCE 16

/* Candidates whose rows are computed before it is decided which of them are
 * cached, in an unknown environment. Enough for all threads, and the memory
 * of so many rows is needed besides that of the cached ones (a choice). */
#define ROWS_OFFERED 256

/* So many rows in a scratch file are evaluated in the order in which they lie
 * there; fewer are read too far apart (a choice). */
#define ORDERED_MIN 1024

/* A task for the thread pool: gains of n candidates. */
typedef struct evaluation {
    const murk_evaluator *evaluator;
    const murk_cover *cover;
    const uint32_t *candidate; /* NULL: candidate k is k */
    const uint64_t *order;     /* [n] the order of evaluation: k in the low half
                                  of each; NULL: k = 0, 1, ... */
    uint64_t *gain;
    murk_cover *seen;  /* [threads] covers, each of which receives the rows that
                          the thread evaluates; or NULL */
    uint64_t *slack;   /* receives the rounding slacks, or NULL */
    murk_row *offered; /* [n] receive the rows that may be cached, or NULL */
    bool *is_clear;    /* [n] receive whether all entries are MURK_CLEAR */
    const murk_row_need *need; /* NULL: all gains are exact */
    size_t n, at_once;
    bool is_max;     /* upper bounds instead of gains */
    bool is_divided; /* unknown environment: ranks divide the candidates */
} evaluation;

/* The row of a candidate if it is stored. */
static const murk_row *stored_row(const murk_evaluator *evaluator,
                                  uint32_t candidate)
{
    const murk_row *row = evaluator->row;
    return evaluator->matrix ? murk_matrix_row(evaluator->matrix, candidate)
           : evaluator->has_all_rows || (row && row[candidate].memory)
               ? &row[candidate]
               : NULL;
}

bool murk_evaluator_own_row(murk_row *out, const murk_evaluator *evaluator,
                            unsigned worker, uint32_t candidate)
{
    if (evaluator->matrix && !murk_matrix_has(evaluator->matrix, candidate)) {
        return false;
    }
    const murk_row *row = stored_row(evaluator, candidate);
    murk_sparse_row entries;
    if (!row) {
        evaluator->problem->get_row(evaluator->problem->context, worker,
                                    candidate, &entries);
    }
    *out = row ? *row : murk_row_borrow(&entries);
    return true;
}

murk_row murk_evaluator_row(const murk_evaluator *evaluator, unsigned worker,
                            uint32_t candidate)
{
    murk_row row;
    if (murk_evaluator_is_distributed(evaluator)) {
        return murk_matrix_fetch(evaluator->matrix, candidate);
    }
    (void)murk_evaluator_own_row(&row, evaluator, worker, candidate);
    return row;
}

void murk_evaluator_complete(const murk_evaluator *evaluator, uint64_t *word,
                             size_t n)
{
    murk_error err = {0};
    if (murk_evaluator_is_distributed(evaluator)) {
        (void)murk_ranks_complete(word, n * sizeof *word,
                                  murk_interrupt_check(&err), &err);
    }
}

/* The row of a candidate as far as it is needed; false if the row was given up,
 * or if another rank has it. */
static bool get_part(murk_row *out, const murk_evaluator *evaluator,
                     unsigned worker, uint32_t candidate,
                     const murk_row_need *need)
{
    const murk_problem *problem = evaluator->problem;
    if (!need || !problem->get_part || stored_row(evaluator, candidate)) {
        return murk_evaluator_own_row(out, evaluator, worker, candidate);
    }
    murk_sparse_row entries;
    if (!problem->get_part(problem->context, worker, candidate, need,
                           &entries)) {
        return false;
    }
    *out = murk_row_borrow(&entries);
    return true;
}

murk_row murk_evaluator_part(const murk_evaluator *evaluator, unsigned worker,
                             uint32_t candidate, const murk_row_need *need)
{
    murk_row row = {0};
    if (murk_evaluator_is_distributed(evaluator)) {
        return murk_evaluator_row(evaluator, worker, candidate);
    }
    (void)get_part(&row, evaluator, worker, candidate, need);
    return row;
}

void murk_evaluator_bound_entries(const murk_evaluator *evaluator,
                                  const murk_cover *cover, uint64_t *entry_max)
{
    const murk_layout *layout = evaluator->layout;
    for (size_t i = 0; i < layout->slots; ++i) {
        const unsigned lowest = !cover->full ? cover->best[i]
                                : cover->full[i / 64] >> (i % 64) & 1
                                    ? MURK_CLEAR
                                    : 0;
        entry_max[i] = (uint64_t)layout->weight[i] * (MURK_CLEAR - lowest);
    }
}

static uint32_t candidate_of(const evaluation *w, size_t k)
{
    return w->candidate ? w->candidate[k] : (uint32_t)k;
}

/* The first evaluation of a candidate, over an empty cover: also adds the row
 * to the cover of all rows, and stores a row that may be cached. */
static void evaluate_first(const evaluation *w, unsigned worker, size_t batch)
{
    const murk_evaluator *o = w->evaluator;
    const murk_layout *layout = o->layout;
    const uint32_t candidate = candidate_of(w, batch);
    murk_sparse_row entries;
    murk_row row;
    murk_progress_add(1);
    if ((o->matrix && !murk_matrix_has(o->matrix, candidate)) ||
        (w->is_divided && !murk_row_is_own(batch))) {
        return;
    }
    /* Evaluate the row. */
    if (o->matrix) {
        row = *murk_matrix_row(o->matrix, candidate);
    } else {
        o->problem->get_row(o->problem->context, worker, candidate, &entries);
        row = murk_row_borrow(&entries);
    }
    w->gain[batch] = murk_row_gain(layout, &row, w->cover);
    murk_cover_add(&w->seen[worker], layout, &row);
    if (w->slack) {
        w->slack[batch] = MURK_WORTH_SLACK * murk_row_weight(layout, &row);
    }
    /* Store the row if it may be cached. */
    if (w->offered) {
        const murk_ranked ranked = {
            w->gain[batch] + (w->slack ? w->slack[batch] : 0), candidate};
        w->is_clear[batch] = murk_row_is_clear(&entries);
        if (murk_ranked_rows_wants(&o->cached, ranked) &&
            !murk_row_store(&w->offered[batch], layout, &entries)) {
            w->offered[batch] = (murk_row){0};
        }
    }
}

/* True if no row is needed, because the upper bound on the gain is too small.
 */
static bool is_hopeless(const evaluation *w, uint32_t candidate)
{
    return w->need && murk_evaluator_gain_bound(w->evaluator, candidate) <
                          w->need->gain_min;
}

static void evaluate(const evaluation *w, unsigned worker, size_t batch)
{
    const murk_evaluator *o = w->evaluator;
    const uint32_t candidate = candidate_of(w, batch);
    murk_row row;
    if (w->seen) {
        evaluate_first(w, worker, batch);
        return;
    }
    if (w->is_divided && !murk_row_is_own(batch)) {
        w->gain[batch] = 0;
        return;
    }
    /* An upper bound, or the gain. */
    if (w->is_max) {
        w->gain[batch] = !murk_evaluator_own_row(&row, o, worker, candidate)
                             ? 0
                             : murk_row_gain_bound(o->layout, &row, w->cover) +
                                   MURK_GAIN_BOUND_SLACK / MURK_WORTH_SLACK *
                                       o->slack[candidate];
        return;
    }
    w->gain[batch] = !is_hopeless(w, candidate) &&
                             get_part(&row, o, worker, candidate, w->need)
                         ? murk_row_gain(o->layout, &row, w->cover)
                         : 0;
}

/* The place in candidate[] and gain[] of the k-th evaluation. */
static size_t place_of(const evaluation *w, size_t k)
{
    return w->order ? (uint32_t)w->order[k] : k;
}

/* Prefetches the next row if all are stored, as rows lie in separate blocks of
 * memory. */
static void prefetch_next(const evaluation *w, size_t k, size_t end)
{
    if (w->evaluator->has_all_rows && k + 1 < end) {
        const murk_row *row = w->evaluator->row;
        const size_t after = k + 2 < end ? k + 2 : k + 1;
        const char *next = row[candidate_of(w, place_of(w, k + 1))].memory;
        __builtin_prefetch(next);
        __builtin_prefetch(next + 64);
        __builtin_prefetch(&row[candidate_of(w, place_of(w, after))]);
    }
}

static void evaluate_range(const evaluation *w, unsigned worker, size_t begin,
                           size_t end)
{
    for (size_t k = begin; k < end; ++k) {
        prefetch_next(w, k, end);
        evaluate(w, worker, place_of(w, k));
    }
}

static void evaluate_batch(void *context, unsigned worker, uint64_t batch)
{
    const evaluation *w = context;
    const size_t past = ((size_t)batch + 1) * w->at_once;
    evaluate_range(w, worker, (size_t)batch * w->at_once,
                   past < w->n ? past : w->n);
}

static void evaluate_in_batches(evaluation *w, unsigned threads)
{
    w->at_once =
        w->evaluator->matrix || w->evaluator->has_all_rows ? ROWS_AT_ONCE : 1;
    murk_pool_run_workers(threads, (w->n + w->at_once - 1) / w->at_once,
                          evaluate_batch, w);
}

/* Time to evaluate a row of clarities, or of detection probabilities, relative
 * to a row of bits. */
#define WORK_OF_CLARITIES 4
#define WORK_OF_CHANCES   64

uint64_t murk_evaluator_work(const murk_evaluator *evaluator,
                             uint64_t candidates)
{
    const uint64_t row = evaluator->problem->photons *
                         (evaluator->is_binary       ? 1
                          : evaluator->layout->doses ? WORK_OF_CHANCES
                                                     : WORK_OF_CLARITIES);
    return candidates * (row > MURK_ROW_WORK_MIN ? row : MURK_ROW_WORK_MIN);
}

unsigned murk_evaluator_threads(const murk_evaluator *evaluator, size_t n)
{
    const bool has_rows = evaluator->matrix || evaluator->has_all_rows;
    const bool is_worth =
        !has_rows || n > BYTES_WORTH_THREADS / (evaluator->row_bytes + 1);
    return is_worth ? evaluator->problem->threads : 1;
}

void murk_evaluator_run(const murk_evaluator *evaluator, size_t n,
                        murk_worker_job job, void *context)
{
    const unsigned threads = murk_evaluator_threads(evaluator, n);
    if (threads > 1) {
        murk_pool_run_workers(threads, n, job, context);
        return;
    }
    for (size_t k = 0; k < n; ++k) {
        job(context, 0, k);
    }
}

/* The order of evaluation by candidate, for free(), if rows lie in a scratch
 * file: rows were written there nearly in this order, so that each page of the
 * file comes into memory once. NULL: the order does not matter, or there is no
 * memory. */
static uint64_t *order_of(const evaluation *w)
{
    const murk_matrix *matrix = w->evaluator->matrix;
    uint64_t *order = NULL;
    if (matrix && w->n >= ORDERED_MIN &&
        murk_tally_read(&matrix->space->in_file) > 0) {
        order = malloc(w->n * sizeof *order);
    }
    for (size_t k = 0; order && k < w->n; ++k) {
        order[k] = (uint64_t)candidate_of(w, k) << 32 | k;
    }
    if (order) {
        murk_sort_uint64(order, w->n);
    }
    return order;
}

/* True if ranks divide the evaluations: several rows have to be computed, which
 * takes much longer than an exchange. All ranks find the same, because they
 * remember the same rows. */
static bool pays_to_divide(const evaluation *w)
{
    const murk_evaluator *o = w->evaluator;
    size_t missing = 0;
    if (o->matrix || o->has_all_rows || murk_ranks_count() == 1) {
        return false;
    }
    for (size_t k = 0; k < w->n && missing < 2; ++k) {
        const uint32_t candidate = candidate_of(w, k);
        missing += !stored_row(o, candidate) && !is_hopeless(w, candidate);
    }
    return missing == 2;
}

static void evaluate_candidates(evaluation w, unsigned threads, unsigned worker)
{
    uint64_t *order = order_of(&w);
    w.order = order;
    w.is_divided = pays_to_divide(&w);
    murk_work_count work = {.list = {.n = 0}};
    if (w.is_divided) {
        work = murk_work_count_begin(w.evaluator->problem);
    }
    if (threads > 1 && murk_evaluator_threads(w.evaluator, w.n) > 1) {
        evaluate_in_batches(&w, threads);
    } else {
        evaluate_range(&w, worker, 0, w.n);
    }
    free(order);
    if (w.is_divided) {
        murk_error err = {0};
        const murk_status status = murk_ranks_complete(
            w.gain, w.n * sizeof *w.gain, murk_interrupt_check(&err), &err);
        (void)murk_work_count_add(&work, status, &err);
    } else {
        murk_evaluator_complete(w.evaluator, w.gain, w.n);
    }
}

void murk_evaluator_gains(const murk_evaluator *evaluator,
                          const murk_cover *cover, const uint32_t *candidate,
                          size_t n, unsigned threads, unsigned worker,
                          uint64_t *gain)
{
    murk_evaluator_needed_gains(evaluator, cover, candidate, n, threads, worker,
                                NULL, gain);
}

void murk_evaluator_needed_gains(const murk_evaluator *evaluator,
                                 const murk_cover *cover,
                                 const uint32_t *candidate, size_t n,
                                 unsigned threads, unsigned worker,
                                 const murk_row_need *need, uint64_t *gain)
{
    evaluate_candidates((evaluation){.evaluator = evaluator,
                                     .cover = cover,
                                     .candidate = candidate,
                                     .gain = gain,
                                     .need = need,
                                     .n = n},
                        threads, worker);
}

void murk_evaluator_gain_bounds(const murk_evaluator *evaluator,
                                const murk_cover *cover,
                                const uint32_t *candidate, size_t n,
                                unsigned threads, unsigned worker,
                                uint64_t *max)
{
    evaluate_candidates((evaluation){.evaluator = evaluator,
                                     .cover = cover,
                                     .candidate = candidate,
                                     .gain = max,
                                     .n = n,
                                     .is_max = true},
                        threads, worker);
}

void murk_ranked_sort(murk_ranked *ranked, size_t n)
{
    qsort(ranked, n, sizeof *ranked, murk_compare_ranked);
}

static murk_ranked ranked_of(const murk_evaluator *o, uint32_t candidate)
{
    return (murk_ranked){murk_evaluator_gain_bound(o, candidate), candidate};
}

/* Fails if a row of this rank that may be cached was not stored: the other
 * ranks would take it for an empty one. */
static murk_status check_stored(const evaluation *w, murk_error *err)
{
    const murk_evaluator *o = w->evaluator;
    bool is_missing = false;
    for (size_t k = 0; k < w->n; ++k) {
        is_missing |=
            murk_row_is_own(k) && !w->offered[k].memory &&
            murk_ranked_rows_wants(&o->cached, ranked_of(o, w->candidate[k]));
    }
    return is_missing ? murk_no_memory(err, "", "for rows of %zu candidates",
                                       o->candidates)
                      : MURK_OK;
}

/* Gives all ranks the gains, slacks and rows of a group of candidates, of which
 * each rank has those of its own candidates. */
static murk_status exchange_group(const evaluation *w, murk_status status,
                                  murk_error *err)
{
    const murk_evaluator *o = w->evaluator;
    uint64_t word[3 * ROWS_OFFERED];
    murk_row_space space; /* without a limit: rows that are not cached are freed
                             soon */
    if (!status) {
        status = check_stored(w, err);
    }
    /* Numbers. */
    for (size_t k = 0; k < w->n; ++k) {
        word[3 * k] = w->gain[k];
        word[3 * k + 1] = w->slack ? w->slack[k] : 0;
        word[3 * k + 2] = !w->is_clear[k];
    }
    status = murk_ranks_sum(word, 3 * w->n, false, status, err);
    for (size_t k = 0; k < w->n && !status; ++k) {
        w->gain[k] = word[3 * k];
        w->is_clear[k] = !word[3 * k + 2];
        if (w->slack) {
            w->slack[k] = word[3 * k + 1];
        }
    }
    /* Rows. */
    if (o->cached.max_bytes > 0) {
        murk_row_space_init(&space, 0, UINT64_MAX);
        status = murk_row_exchange(w->offered, w->n, &space,
                                   murk_row_bytes_max(o->layout), status, err);
        murk_row_space_release(&space);
    }
    return status;
}

/* Unknown environment: asks the problem for the row of each candidate, and
 * caches rows. Their candidates are evaluated in groups of ROWS_OFFERED, and
 * the rows of a group are offered in order. Ranks divide the candidates of a
 * group. */
static murk_status evaluate_and_cache(murk_evaluator *o, evaluation w,
                                      murk_error *err)
{
    murk_row row[ROWS_OFFERED];
    bool is_clear[ROWS_OFFERED];
    uint32_t candidate[ROWS_OFFERED];
    bool is_binary = true;
    const murk_work_count work = murk_work_count_begin(o->problem);
    murk_status status = MURK_OK;
    w.is_divided = murk_ranks_count() > 1;
    w.candidate = candidate;
    w.offered = row;
    w.is_clear = is_clear;
    for (size_t first = 0; first < o->candidates && !status; first += w.n) {
        const size_t left = o->candidates - first;
        w.n = left < ROWS_OFFERED ? left : ROWS_OFFERED;
        w.gain = o->single_value + first;
        w.slack = o->slack ? o->slack + first : NULL;
        for (size_t k = 0; k < w.n; ++k) {
            candidate[k] = (uint32_t)(first + k);
            row[k] = (murk_row){0};
            is_clear[k] = true;
        }
        evaluate_in_batches(&w, o->problem->threads);
        status = murk_interrupt_check(err);
        if (w.is_divided) {
            status = exchange_group(&w, status, err);
        }
        for (size_t k = 0; k < w.n; ++k) {
            is_binary = is_binary && is_clear[k];
            murk_ranked_rows_offer(&o->cached, ranked_of(o, candidate[k]),
                                   &row[k]);
        }
    }
    if (w.is_divided) {
        status = murk_work_count_add(&work, status, err);
    }
    if (status) {
        return status;
    }
    /* The cached rows are the stored ones. */
    const size_t count = o->cached.count;
    o->row = o->cached.row;
    o->row_bytes = count > 0 ? (size_t)o->cached.bytes / count : 0;
    o->has_all_rows = count == o->candidates;
    o->is_binary = is_binary && !o->layout->doses;
    o->queries = o->candidates;
    return MURK_OK;
}

/* Adds the covers of the other ranks to that of this one. */
static murk_status join_ranks(murk_cover *cover, const murk_layout *layout,
                              murk_status status, murk_error *err)
{
    const size_t size = murk_cover_bytes(cover, layout);
    char *bytes = malloc(size);
    if (!status && !bytes) {
        status = murk_no_memory(err, "", "for the coverage of %zu photons",
                                layout->photons);
    }
    if (!status) {
        murk_cover_pack(cover, layout, bytes);
    }
    /* One rank after the other gives its cover, so that one at a time needs
     * memory. */
    for (unsigned r = 0; r < murk_ranks_count() && !status; ++r) {
        const bool is_own = r == murk_ranks_number();
        murk_gathered all = {0};
        status = murk_ranks_gather(&all, bytes, is_own ? size : 0, status, err);
        if (!status && !is_own) {
            const murk_cover other =
                murk_cover_unpack(cover, layout, all.bytes);
            murk_cover_join(cover, layout, &other);
        }
        murk_gathered_release(&all);
    }
    free(bytes);
    return murk_ranks_agree(status, err);
}

murk_status murk_evaluator_cover_all(const murk_evaluator *evaluator,
                                     murk_cover *cover, murk_error *err)
{
    murk_row row;
    for (uint32_t j = 0; j < evaluator->candidates; ++j) {
        if (murk_evaluator_own_row(&row, evaluator, 0, j)) {
            murk_cover_add(cover, evaluator->layout, &row);
        }
    }
    return murk_evaluator_is_distributed(evaluator)
               ? join_ranks(cover, evaluator->layout, MURK_OK, err)
               : MURK_OK;
}

/* Computes the value of each candidate alone, and the ceiling. */
static murk_status evaluate_singles(murk_evaluator *o, murk_error *err)
{
    const unsigned threads = o->problem->threads;
    murk_cover empty = {0};
    murk_cover *seen = calloc(threads, sizeof *seen);
    bool has_memory = seen && murk_cover_init(&empty, o->layout, o->is_binary);
    for (unsigned k = 0; has_memory && k < threads; ++k) {
        has_memory = murk_cover_init(&seen[k], o->layout, o->is_binary);
    }
    murk_status status = MURK_OK;
    if (!has_memory) {
        status = murk_no_memory(err, "", "for the coverage of %zu photons",
                                o->layout->photons);
        goto done;
    }
    evaluation w = {.evaluator = o,
                    .cover = &empty,
                    .gain = o->single_value,
                    .seen = seen,
                    .slack = o->slack,
                    .n = o->candidates};
    murk_progress_begin(o->matrix ? "weigh" : "look", o->candidates,
                        "candidates");
    if (o->matrix) {
        evaluate_in_batches(&w, threads);
    } else {
        status = evaluate_and_cache(o, w, err);
    }
    murk_progress_end();
    /* The value of all rows together is the ceiling. */
    for (unsigned k = 1; k < threads; ++k) {
        murk_cover_join(&seen[0], o->layout, &seen[k]);
    }
    if (murk_evaluator_is_distributed(o) ||
        (!o->matrix && murk_ranks_count() > 1)) {
        status = join_ranks(&seen[0], o->layout, status, err);
    }
    if (murk_evaluator_is_distributed(o)) {
        murk_evaluator_complete(o, o->single_value, o->candidates);
        murk_evaluator_complete(o, o->slack, o->slack ? o->candidates : 0);
    }
    o->ceiling = murk_cover_value(&seen[0], o->layout);
done:
    for (unsigned k = 0; seen && k < threads; ++k) {
        murk_cover_release(&seen[k]);
    }
    free(seen);
    murk_cover_release(&empty);
    return status;
}

/* Sort key of a candidate: candidates of equal value have one number. */
typedef struct costed {
    size_t number;
    uint64_t cost;
    size_t rank;
} costed;

static int by_cost(const void *a, const void *b)
{
    const costed *x = a, *y = b;
    const int number = MURK_ORDER(x->number, y->number);
    const int cost = MURK_ORDER(x->cost, y->cost);
    return number ? number : cost ? cost : MURK_ORDER(x->rank, y->rank);
}

/* Fills order[] with the ranked candidates, those of equal value by cost, so
 * that the cheaper one dominates. */
static void order_by_cost(const murk_evaluator *o, costed *key, uint32_t *order)
{
    const murk_ranked *ranked = o->ranked;
    size_t number = 0;
    for (size_t k = 0; k < o->candidates; ++k) {
        const uint32_t j = ranked[k].candidate;
        number += k > 0 && o->single_value[j] !=
                               o->single_value[ranked[k - 1].candidate];
        key[k] = (costed){number,
                          o->set ? murk_constraint_set_cost(o->set, j) : 0, k};
    }
    qsort(key, o->candidates, sizeof *key, by_cost);
    for (size_t k = 0; k < o->candidates; ++k) {
        order[k] = ranked[key[k].rank].candidate;
    }
}

/* The number of dominators that make a candidate superfluous. A dominator
 * outside the plan may take the place of the candidate. If all dominators are
 * in the plan, each gives every photon an entry at least as large as the
 * candidate's: with redundancy k, k such entries leave the candidate no gain.
 * Probabilities always add up, so the number is then the size of the plan: a
 * plan with the candidate cannot contain so many dominators as well. */
static size_t dominators_needed(const murk_evaluator *o, size_t max)
{
    return o->layout->doses ? max : o->layout->layers;
}

/* Moves dropped candidates behind the others. Returns the number of the others.
 */
static size_t split_dominated(const murk_evaluator *o, murk_ranked *ranked,
                              const uint32_t *order, const bool *is_dropped)
{
    size_t at = 0, remaining = 0;
    for (int pass = 0; pass < 2; ++pass) {
        for (size_t k = 0; k < o->candidates; ++k) {
            const uint32_t j = order[k];
            if (is_dropped[j] == (pass == 1)) {
                ranked[at++] =
                    (murk_ranked){murk_evaluator_gain_bound(o, j), j};
            }
        }
        remaining = pass == 0 ? at : remaining;
    }
    return remaining;
}

/* Ranks the candidates by value, and moves the dominated ones behind the
 * others. */
static murk_status rank(murk_evaluator *o, size_t max, bool keep_dominated,
                        murk_error *err)
{
    const size_t n = o->candidates;
    for (uint32_t j = 0; j < n; ++j) {
        o->ranked[j] = (murk_ranked){murk_evaluator_gain_bound(o, j), j};
        o->dominator[j] = j;
    }
    murk_ranked_sort(o->ranked, n);
    memcpy(o->presolved, o->ranked, n * sizeof *o->presolved);
    o->undominated = o->presolved_count = n;
    if (!o->matrix || keep_dominated) {
        return MURK_OK;
    }
    /* Presolve compares candidates in the order order[]. */
    murk_arena scratch = {0};
    uint32_t *order = murk_arena_array(&scratch, n, sizeof *order);
    bool *is_dropped = murk_arena_array(&scratch, n, sizeof *is_dropped);
    costed *key = murk_arena_array(&scratch, n, sizeof *key);
    murk_status status = MURK_OK;
    if (scratch.is_short) {
        status = murk_no_memory(err, "", "to rank %zu candidates", n);
        goto done;
    }
    order_by_cost(o, key, order);
    /* With redundancy, or with probabilities in plans of several sensors, one
     * dominator is not enough. */
    const size_t needed = dominators_needed(o, max);
    if (needed > 1) {
        status = murk_presolve_many(is_dropped, o->matrix, o->set, order,
                                    needed, err);
        o->presolved_count =
            split_dominated(o, o->presolved, order, is_dropped);
        goto done;
    }
    /* Otherwise each dominated candidate gets its dominator. */
    status = murk_presolve(o->dominator, o->matrix, o->set, order,
                           o->problem->threads, err);
    for (uint32_t j = 0; j < n; ++j) {
        is_dropped[j] = o->dominator[j] != j;
    }
    o->undominated = split_dominated(o, o->ranked, order, is_dropped);
    o->presolved_count = split_dominated(o, o->presolved, order, is_dropped);
done:
    murk_arena_release(&scratch);
    return status;
}

murk_status murk_evaluator_init(murk_evaluator *out,
                                const murk_problem *problem,
                                const murk_matrix *matrix,
                                const murk_constraint_set *set, size_t max,
                                uint64_t row_memory, bool keep_dominated,
                                murk_error *err)
{
    const size_t n = problem->candidates;
    murk_status status = MURK_OK;
    *out = (murk_evaluator){.problem = problem,
                            .matrix = matrix,
                            .set = set,
                            .candidates = n,
                            .is_binary = matrix && matrix->is_binary};
    /* Take layout and rows of the matrix, or make a layout. */
    if (matrix) {
        out->layout = &matrix->layout;
        out->row = matrix->row;
        out->has_all_rows = !matrix->is_distributed;
        out->row_bytes = n ? murk_matrix_bytes(matrix) / n : 0;
    } else {
        status = murk_layout_init(&out->own_layout, problem, false, err);
        if (!status) {
            status = murk_ranked_rows_init(&out->cached, n, row_memory, err);
        }
        if (status) {
            murk_evaluator_release(out);
            return status;
        }
        out->layout = &out->own_layout;
    }
    /* Evaluate and rank the candidates. */
    murk_arena *arena = &out->arena;
    out->single_value = murk_arena_array(arena, n, sizeof *out->single_value);
    out->dominator = murk_arena_array(arena, n, sizeof *out->dominator);
    out->ranked = murk_arena_array(arena, n, sizeof *out->ranked);
    out->presolved = murk_arena_array(arena, n, sizeof *out->presolved);
    if (out->layout->doses) {
        out->slack = murk_arena_array(arena, n, sizeof *out->slack);
    }
    status = arena->is_short ? murk_no_memory(err, "", "for %zu candidates", n)
                             : evaluate_singles(out, err);
    status = status ? status : murk_interrupt_check(err);
    out->grain =
        (uint64_t)out->layout->weight_gcd * (out->is_binary ? MURK_CLEAR : 1);
    if (!status) {
        status = rank(out, max, keep_dominated, err);
    }
    if (status) {
        murk_evaluator_release(out);
    }
    return status;
}

void murk_evaluator_release(murk_evaluator *evaluator)
{
    murk_ranked_rows_release(&evaluator->cached);
    murk_layout_release(&evaluator->own_layout);
    murk_arena_release(&evaluator->arena);
    *evaluator = (murk_evaluator){0};
}
