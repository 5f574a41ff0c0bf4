/* Greedy where candidates come into question one after the other: at each step
 * only those that are open by then are weighed.
 *
 * What a candidate adds to a growing plan only falls, so that what it added
 * when it was last weighed bounds what it adds now, and most need no second
 * look (Minoux, Lect. Notes Control Inf. Sci. 7 (1978) 234,
 * doi:10.1007/BFb0006528). The answer is that of weighing all. Memory follows
 * photons and candidates, not their pairs. */
#ifndef MURK_PLACEMENT_LAZY_GREEDY_H
#define MURK_PLACEMENT_LAZY_GREEDY_H

#include "placement/cover.h"
#include "placement/relaxation.h"

typedef struct murk_lazy_greedy {
    const murk_problem *problem;
    const murk_constraint_set *set;
    murk_layout layout;
    murk_cover cover;      /* of what stands */
    uint64_t value;        /* its worth: sum weight * clarity */
    uint64_t *bound;       /* [candidates] the most each can add */
    murk_priced *order;    /* [candidates] */
    uint64_t queries;      /* made so far */
    murk_priced *chunk;    /* those being weighed */
    uint64_t *chunk_gain;  /* [chunk] what each adds now, */
    uint64_t *chunk_bound; /* [chunk] and at most later on: rounding of doses
                        may bring a little */
} murk_lazy_greedy;

/* Borrows both; the book's costs count where it has a budget. */
murk_status murk_lazy_greedy_init(murk_lazy_greedy *out,
                                  const murk_problem *problem,
                                  const murk_constraint_set *set,
                                  murk_error *err);
void murk_lazy_greedy_release(murk_lazy_greedy *lazy_greedy);

/* Of open[n], n >= 1, the one that adds most to what stands (with a budget:
 * most per cost), the lowest number on ties, and in *gain how much. Means
 * nothing when interrupted. */
uint32_t murk_lazy_greedy_best(murk_lazy_greedy *lazy_greedy,
                               const uint32_t *open, size_t n, uint64_t *gain);

/* The candidate stands from now on; returns what it added. */
uint64_t murk_lazy_greedy_add(murk_lazy_greedy *lazy_greedy,
                              uint32_t candidate);

#endif
