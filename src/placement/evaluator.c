/* Gains of candidates over a cover, single-threaded or spread over threads, and
 * the ranking of the candidates at the start of a placement: the value of each
 * candidate alone, the ceiling (the value of all candidates together), and the
 * dominated candidates (placement/presolve.h). Results never depend on the
 * number of threads. The caller owns the cover and must not change the cover
 * during a call. */
#include "placement/evaluator.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "base/sort.h"
#include "placement/presolve.h"

#include <stdlib.h>
#include <string.h>

/* Starting threads costs some 50 us. A scan over so many bytes takes 200 us and
 * more, so threads pay. */
#define BYTES_WORTH_THREADS 2097152

/* Candidates in one batch of a thread: evaluating 16 rows takes longer than
 * fetching the next batch. In an unknown environment each row is a batch by
 * itself, because computing a row always takes longer than fetching a batch. */
#define ROWS_AT_ONCE 16

/* A task for the thread pool: gains of n candidates. */
typedef struct evaluation {
    const murk_evaluator *evaluator;
    const murk_cover *cover;
    const uint32_t *candidate; /* NULL: candidate k is k */
    uint64_t *gain;
    murk_cover *seen; /* [threads] covers, each of which receives the rows that
                         the thread evaluates; or NULL */
    uint64_t *slack;  /* receives the rounding slacks, or NULL */
    size_t n, at_once;
    bool is_max; /* upper bounds instead of gains */
} evaluation;

murk_row murk_evaluator_row(const murk_evaluator *evaluator, unsigned worker,
                            uint32_t candidate)
{
    if (evaluator->matrix) {
        return evaluator->matrix->row[candidate];
    }
    murk_sparse_row entries;
    evaluator->problem->get_row(evaluator->problem->context, worker, candidate,
                                &entries);
    return murk_row_borrow(&entries);
}

static uint32_t candidate_of(const evaluation *w, size_t k)
{
    return w->candidate ? w->candidate[k] : (uint32_t)k;
}

static void evaluate(const evaluation *w, unsigned worker, size_t batch)
{
    const murk_layout *layout = w->evaluator->layout;
    const uint32_t candidate = candidate_of(w, batch);
    const murk_row row = murk_evaluator_row(w->evaluator, worker, candidate);
    if (w->is_max) {
        w->gain[batch] = murk_row_gain_bound(layout, &row, w->cover) +
                         MURK_GAIN_BOUND_SLACK / MURK_WORTH_SLACK *
                             w->evaluator->slack[candidate];
        return;
    }
    w->gain[batch] = murk_row_gain(layout, &row, w->cover);
    if (w->seen) {
        murk_cover_add(&w->seen[worker], layout, &row);
        if (w->slack) {
            w->slack[batch] = MURK_WORTH_SLACK * murk_row_weight(layout, &row);
        }
        murk_progress_add(1);
    }
}

/* Prefetches the next row of the matrix, as rows lie in separate blocks of
 * memory. */
static void prefetch_next(const evaluation *w, size_t k, size_t end)
{
    if (w->evaluator->matrix && k + 1 < end) {
        const murk_row *row = w->evaluator->matrix->row;
        const char *next = row[candidate_of(w, k + 1)].memory;
        __builtin_prefetch(next);
        __builtin_prefetch(next + 64);
        __builtin_prefetch(&row[candidate_of(w, k + 2 < end ? k + 2 : k + 1)]);
    }
}

static void evaluate_range(const evaluation *w, unsigned worker, size_t begin,
                           size_t end)
{
    for (size_t k = begin; k < end; ++k) {
        prefetch_next(w, k, end);
        evaluate(w, worker, k);
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
    w->at_once = w->evaluator->matrix ? ROWS_AT_ONCE : 1;
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
    const bool is_worth = !evaluator->matrix ||
                          n > BYTES_WORTH_THREADS / (evaluator->row_bytes + 1);
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

static void evaluate_candidates(evaluation w, unsigned threads, unsigned worker)
{
    if (threads > 1 && murk_evaluator_threads(w.evaluator, w.n) > 1) {
        evaluate_in_batches(&w, threads);
    } else {
        evaluate_range(&w, worker, 0, w.n);
    }
}

void murk_evaluator_gains(const murk_evaluator *evaluator,
                          const murk_cover *cover, const uint32_t *candidate,
                          size_t n, unsigned threads, unsigned worker,
                          uint64_t *gain)
{
    evaluate_candidates((evaluation){.evaluator = evaluator,
                                     .cover = cover,
                                     .candidate = candidate,
                                     .gain = gain,
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

static int by_rank(const void *a, const void *b)
{
    const murk_ranked *x = a, *y = b;
    const int falling = MURK_ORDER(y->bound, x->bound);
    return falling ? falling : MURK_ORDER(x->candidate, y->candidate);
}

void murk_ranked_sort(murk_ranked *ranked, size_t n)
{
    qsort(ranked, n, sizeof *ranked, by_rank);
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
    evaluate_in_batches(&w, threads);
    murk_progress_end();
    /* The value of all rows together is the ceiling. */
    for (unsigned k = 1; k < threads; ++k) {
        murk_cover_join(&seen[0], o->layout, &seen[k]);
    }
    o->ceiling = murk_cover_value(&seen[0], o->layout);
    o->queries = o->matrix ? 0 : o->candidates;
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
                                bool keep_dominated, murk_error *err)
{
    const size_t n = problem->candidates;
    *out = (murk_evaluator){.problem = problem,
                            .matrix = matrix,
                            .set = set,
                            .candidates = n,
                            .is_binary = matrix && matrix->is_binary};
    /* Take the layout of the matrix, or make one. */
    if (matrix) {
        out->layout = &matrix->layout;
        out->row_bytes = n ? matrix->memory_bytes / n : 0;
    } else {
        const murk_status status =
            murk_layout_init(&out->own_layout, problem, false, err);
        if (status) {
            return status;
        }
        out->layout = &out->own_layout;
    }
    out->grain =
        (uint64_t)out->layout->weight_gcd * (out->is_binary ? MURK_CLEAR : 1);
    /* Evaluate and rank the candidates. */
    murk_arena *arena = &out->arena;
    out->single_value = murk_arena_array(arena, n, sizeof *out->single_value);
    out->dominator = murk_arena_array(arena, n, sizeof *out->dominator);
    out->ranked = murk_arena_array(arena, n, sizeof *out->ranked);
    out->presolved = murk_arena_array(arena, n, sizeof *out->presolved);
    if (out->layout->doses) {
        out->slack = murk_arena_array(arena, n, sizeof *out->slack);
    }
    murk_status status = arena->is_short
                             ? murk_no_memory(err, "", "for %zu candidates", n)
                             : evaluate_singles(out, err);
    status = status ? status : murk_interrupt_check(err);
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
    murk_layout_release(&evaluator->own_layout);
    murk_arena_release(&evaluator->arena);
    *evaluator = (murk_evaluator){0};
}
