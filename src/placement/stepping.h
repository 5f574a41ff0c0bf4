/* Greedy where candidates come into question one after the other: at each step
 * only those that are open by then are weighed.
 *
 * What a candidate adds to a growing plan only falls, so that what it added
 * when it was last weighed bounds what it adds now, and most need no second
 * look (Minoux, Lect. Notes Control Inf. Sci. 7 (1978) 234,
 * doi:10.1007/BFb0006528). The answer is that of weighing all. Memory follows
 * photons and candidates, not their pairs. */
#ifndef MURK_PLACEMENT_STEPPING_H
#define MURK_PLACEMENT_STEPPING_H

#include "placement/cover.h"
#include "placement/relaxed.h"

typedef struct murk_stepping {
    const murk_problem *problem;
    const murk_rulebook *book;
    murk_layout layout;
    murk_cover cover;   /* of what stands */
    uint64_t value;     /* its worth: sum weight * clarity */
    uint64_t *bound;    /* [candidates] the most each can add */
    murk_priced *order; /* [candidates] */
    uint64_t looks;     /* made so far */
    murk_priced *chunk; /* those being weighed */
    uint64_t *addition; /* [chunk] what each adds now, */
    uint64_t *later;    /* [chunk] and at most later on: rounding of doses may
                           bring a little */
} murk_stepping;

/* Borrows both; the book's costs count where it has a budget. */
murk_status murk_stepping_init(murk_stepping *out, const murk_problem *problem,
                               const murk_rulebook *book, murk_error *err);
void murk_stepping_release(murk_stepping *stepping);

/* Of open[n], n >= 1, the one that adds most to what stands (with a budget:
 * most per cost), the lowest number on ties, and in *gain how much. Means
 * nothing when interrupted. */
uint32_t murk_stepping_best(murk_stepping *stepping, const uint32_t *open,
                            size_t n, uint64_t *gain);

/* The candidate stands from now on; returns what it added. */
uint64_t murk_stepping_take(murk_stepping *stepping, uint32_t candidate);

#endif
