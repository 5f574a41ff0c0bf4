/* Lazy greedy for candidates that become available one after the other: each
 * step evaluates only candidates that are available.
 *
 * The gain of a candidate over a growing plan does not rise, apart from the
 * rounding of doses (placement/dose.h). So the last computed gain, plus that
 * rounding, is an upper bound, and most candidates need no evaluation. The
 * choice is the same as if all available candidates were evaluated. Memory
 * grows with the photons and the candidates, not with their product.
 *
 * Source: Minoux, Lect. Notes Control Inf. Sci. 7 (1978) 234,
 * doi:10.1007/BFb0006528. */
#ifndef MURK_PLACEMENT_LAZY_GREEDY_H
#define MURK_PLACEMENT_LAZY_GREEDY_H

#include "base/arena.h"
#include "placement/cover.h"
#include "placement/relaxation.h"

typedef struct murk_lazy_greedy {
    const murk_problem *problem;
    const murk_constraint_set *set;
    murk_layout layout;
    murk_cover cover;      /* of the chosen candidates */
    uint64_t value;        /* of the cover: sum weight * clarity */
    uint64_t *bound;       /* [candidates] upper bounds on gains */
    murk_priced *order;    /* [candidates] */
    uint64_t queries;      /* rows asked of the problem */
    murk_priced *chunk;    /* candidates under evaluation */
    uint64_t *chunk_gain;  /* [chunk] present gains */
    uint64_t *chunk_bound; /* [chunk] upper bounds on later gains: rounding of
                              doses may add a little */
    murk_arena arena;
} murk_lazy_greedy;

/* Borrows problem and set; the set must not be NULL. With a budget, gains per
 * cost are compared. Fails with MURK_NO_MEMORY. */
murk_status murk_lazy_greedy_init(murk_lazy_greedy *out,
                                  const murk_problem *problem,
                                  const murk_constraint_set *set,
                                  murk_error *err);
void murk_lazy_greedy_release(murk_lazy_greedy *lazy_greedy);

/* Of open[n], n >= 1: the candidate with the largest gain (with a budget: gain
 * per cost), the lowest index on ties; *gain is the gain. The result has no
 * meaning if the run is interrupted. */
uint32_t murk_lazy_greedy_best(murk_lazy_greedy *lazy_greedy,
                               const uint32_t *open, size_t n, uint64_t *gain);

/* Adds the candidate to the chosen ones and returns the gain. */
uint64_t murk_lazy_greedy_add(murk_lazy_greedy *lazy_greedy,
                              uint32_t candidate);

#endif
