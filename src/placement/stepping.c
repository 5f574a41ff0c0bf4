#include "placement/stepping.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "placement/gain.h"

#include <assert.h>
#include <stdlib.h>

/* Candidates weighed between two looks at the best so far. Fixed, so that who
 * is weighed does not depend on the threads. */
#define CHUNK 32

murk_status murk_stepping_init(murk_stepping *out, const murk_problem *problem,
                               const murk_rulebook *book, murk_error *err)
{
    const size_t n = problem->candidates + 1;
    *out = (murk_stepping){.problem = problem, .book = book};
    murk_status status = murk_layout_init(&out->layout, problem, false, err);
    if (status) {
        return status;
    }
    out->bound = malloc(n * sizeof *out->bound);
    out->order = malloc(n * sizeof *out->order);
    out->chunk = malloc(CHUNK * sizeof *out->chunk);
    out->addition = malloc(CHUNK * sizeof *out->addition);
    out->later = malloc(CHUNK * sizeof *out->later);
    if (!out->bound || !out->order || !out->chunk || !out->addition ||
        !out->later || !murk_cover_init(&out->cover, &out->layout, false)) {
        murk_stepping_release(out);
        return murk_fail(err, MURK_NO_MEMORY, "",
                         "no memory to weigh %zu candidates",
                         problem->candidates);
    }
    for (size_t j = 0; j < problem->candidates; ++j) {
        out->bound[j] = out->layout.whole;
    }
    return MURK_OK;
}

void murk_stepping_release(murk_stepping *s)
{
    murk_cover_release(&s->cover);
    murk_layout_release(&s->layout);
    free(s->bound);
    free(s->order);
    free(s->chunk);
    free(s->addition);
    free(s->later);
    *s = (murk_stepping){0};
}

static murk_priced priced(const murk_stepping *s, uint32_t candidate,
                          uint64_t gain)
{
    const uint64_t cost =
        s->book->has_budget ? murk_rulebook_cost(s->book, candidate) : 1;
    return (murk_priced){gain, cost, candidate};
}

static void weigh(void *context, unsigned worker, uint64_t batch)
{
    murk_stepping *s = context;
    murk_look look;
    s->problem->look(s->problem->context, worker, s->chunk[batch].candidate,
                     &look);
    const murk_row row = murk_row_borrow(&look);
    s->addition[batch] = murk_row_gain(&s->layout, &row, &s->cover);
    s->later[batch] =
        s->addition[batch] +
        (s->layout.doses ? MURK_WORTH_SLACK * murk_row_weight(&s->layout, &row)
                         : 0);
}

uint32_t murk_stepping_best(murk_stepping *s, const uint32_t *open, size_t n,
                            uint64_t *gain)
{
    assert(n >= 1);
    for (size_t k = 0; k < n; ++k) {
        s->order[k] = priced(s, open[k], s->bound[open[k]]);
    }
    qsort(s->order, n, sizeof *s->order, murk_by_density);
    murk_priced best = {0};
    bool has_best = false;
    for (size_t at = 0; at < n && !murk_interrupted();) {
        size_t taken = 0;
        while (at < n && taken < CHUNK &&
               (!has_best || murk_by_density(&s->order[at], &best) < 0)) {
            s->chunk[taken++] = s->order[at++];
        }
        if (taken == 0) {
            break;
        }
        murk_pool_run_workers(s->problem->threads, taken, weigh, s);
        s->looks += taken;
        for (size_t k = 0; k < taken; ++k) {
            const uint32_t j = s->chunk[k].candidate;
            const murk_priced now = priced(s, j, s->addition[k]);
            s->bound[j] = s->later[k];
            if (!has_best || murk_by_density(&now, &best) < 0) {
                best = now;
                has_best = true;
            }
        }
    }
    *gain = best.gain;
    return best.candidate;
}

uint64_t murk_stepping_take(murk_stepping *s, uint32_t candidate)
{
    murk_look look;
    s->problem->look(s->problem->context, 0, candidate, &look);
    const murk_row row = murk_row_borrow(&look);
    const uint64_t gain = murk_row_gain(&s->layout, &row, &s->cover);
    murk_cover_add(&s->cover, &s->layout, &row);
    ++s->looks;
    s->value += gain;
    return gain;
}
