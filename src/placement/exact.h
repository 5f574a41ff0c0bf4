/* Branch and bound: the best plan of a count, or how far from it the best
 * known can be.
 *
 * Depth first over sets of undominated candidates. A node holds the candidates
 * chosen so far and those that may still join them; its bound is that of
 * placement/bound.h with thresholds not below what the chosen see, lowered by
 * a few subgradient steps from where its parent stopped; on the way candidates
 * that are in no better plan drop out. Children take the candidates in falling
 * order of what they add above the thresholds, each leaving those before it to
 * its elder brothers.
 *
 * Under rules the root holds the fixed sensors, a node hands on only whom its
 * chosen admit, and it is itself a plan where it can be filled up with anyone:
 * where nothing excludes.
 *
 * Source: Land and Doig, Econometrica 28 (1960) 497, doi:10.2307/1910129. */
#ifndef MURK_PLACEMENT_EXACT_H
#define MURK_PLACEMENT_EXACT_H

#include "placement/bound.h"

/* The unit of work that is limited, so that the same run gives the same plan:
 * so many weighings of one photon for one candidate (murk_evaluator_work). */
#define MURK_NODE_WEIGHINGS 32768

/* Where a plan is not judged by its value under the bound's weights: judge()
 * is shown each plan worth more than the value known, and says what a plan must
 * be worth more than from then on to be worth showing. It keeps what it likes.
 */
typedef struct murk_exact_callback {
    uint64_t (*callback)(void *context, const uint32_t *plan, size_t size,
                         uint64_t known);
    void *context;
} murk_exact_callback;

typedef struct murk_exact {
    uint64_t value, upper; /* of the plan; no plan of n is worth more */
    uint64_t nodes;        /* work done */
    bool is_cut;           /* by the limit, or interrupted */
    size_t size; /* of the plan: under rules it may still have to be filled up,
                    by whoever the rules admit */
} murk_exact;

/* Improves plan[size], worth `value`, by at most `nodes` of work; size is n,
 * or with a budget at most n. The bound must have been tightened for plans of
 * n last, and gives `upper`; its thresholds are then the root's. Needs a
 * matrix. judge NULL: plans are worth their value; with one, plan stays as it
 * is. Fails when out of memory. */
murk_status murk_exact_search(murk_exact *out, murk_bound *bound,
                              uint32_t *plan, size_t size, size_t n,
                              uint64_t value, uint64_t upper, uint64_t nodes,
                              const murk_exact_callback *callback,
                              murk_error *err);

#endif
