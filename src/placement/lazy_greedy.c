/* Lazy greedy (Minoux 1978): candidates are evaluated in falling order of an
 * upper bound on the gain, in chunks over all threads, until the bound of the
 * next candidate falls below the best gain. */
#include "placement/lazy_greedy.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "placement/gain.h"

#include <assert.h>
#include <stdlib.h>

/* Candidates evaluated between two comparisons with the best gain so far. A
 * constant, so the set of evaluated candidates does not depend on the number of
 * threads. */
#define CHUNK 32

murk_status murk_lazy_greedy_init(murk_lazy_greedy *out,
                                  const murk_problem *problem,
                                  const murk_constraint_set *set,
                                  murk_error *err)
{
    const size_t n = problem->candidates;
    *out = (murk_lazy_greedy){.problem = problem, .set = set};
    murk_status status = murk_layout_init(&out->layout, problem, false, err);
    if (status) {
        return status;
    }
    murk_arena *arena = &out->arena;
    out->bound = murk_arena_array(arena, n, sizeof *out->bound);
    out->order = murk_arena_array(arena, n, sizeof *out->order);
    out->chunk = murk_arena_array(arena, CHUNK, sizeof *out->chunk);
    out->chunk_gain = murk_arena_array(arena, CHUNK, sizeof *out->chunk_gain);
    out->chunk_bound = murk_arena_array(arena, CHUNK, sizeof *out->chunk_bound);
    if (arena->is_short || !murk_cover_init(&out->cover, &out->layout, false)) {
        murk_lazy_greedy_release(out);
        return murk_no_memory(err, "", "to weigh %zu candidates", n);
    }
    /* Before the first evaluation each bound is the value of everything. */
    for (size_t j = 0; j < n; ++j) {
        out->bound[j] = out->layout.whole;
    }
    return MURK_OK;
}

void murk_lazy_greedy_release(murk_lazy_greedy *s)
{
    murk_cover_release(&s->cover);
    murk_layout_release(&s->layout);
    murk_arena_release(&s->arena);
    *s = (murk_lazy_greedy){0};
}

static murk_priced priced(const murk_lazy_greedy *s, uint32_t candidate,
                          uint64_t gain)
{
    const uint64_t cost =
        s->set->has_budget ? murk_constraint_set_cost(s->set, candidate) : 1;
    return (murk_priced){gain, cost, candidate};
}

static void evaluate(void *context, unsigned worker, uint64_t batch)
{
    murk_lazy_greedy *s = context;
    murk_sparse_row entries;
    s->problem->get_row(s->problem->context, worker, s->chunk[batch].candidate,
                        &entries);
    const murk_row row = murk_row_borrow(&entries);
    s->chunk_gain[batch] = murk_row_gain(&s->layout, &row, &s->cover);
    s->chunk_bound[batch] =
        s->chunk_gain[batch] +
        (s->layout.doses ? MURK_WORTH_SLACK * murk_row_weight(&s->layout, &row)
                         : 0);
}

uint32_t murk_lazy_greedy_best(murk_lazy_greedy *s, const uint32_t *open,
                               size_t n, uint64_t *gain)
{
    assert(n >= 1);
    /* Sort the available candidates by upper bound. */
    for (size_t k = 0; k < n; ++k) {
        s->order[k] = priced(s, open[k], s->bound[open[k]]);
    }
    qsort(s->order, n, sizeof *s->order, murk_compare_density);
    murk_priced best = {0};
    bool has_best = false;
    for (size_t at = 0; at < n && !murk_interrupted();) {
        size_t taken = 0;
        /* Gather candidates that may be the best. */
        while (at < n && taken < CHUNK &&
               (!has_best || murk_compare_density(&s->order[at], &best) < 0)) {
            s->chunk[taken++] = s->order[at++];
        }
        if (taken == 0) {
            break;
        }
        /* Evaluate them and update bounds and best. */
        murk_pool_run_workers(s->problem->threads, taken, evaluate, s);
        s->queries += taken;
        for (size_t k = 0; k < taken; ++k) {
            const uint32_t j = s->chunk[k].candidate;
            const murk_priced now = priced(s, j, s->chunk_gain[k]);
            s->bound[j] = s->chunk_bound[k];
            if (!has_best || murk_compare_density(&now, &best) < 0) {
                best = now;
                has_best = true;
            }
        }
    }
    *gain = best.gain;
    return best.candidate;
}

uint64_t murk_lazy_greedy_add(murk_lazy_greedy *s, uint32_t candidate)
{
    murk_sparse_row entries;
    s->problem->get_row(s->problem->context, 0, candidate, &entries);
    const murk_row row = murk_row_borrow(&entries);
    const uint64_t gain = murk_row_gain(&s->layout, &row, &s->cover);
    murk_cover_add(&s->cover, &s->layout, &row);
    ++s->queries;
    s->value += gain;
    return gain;
}
