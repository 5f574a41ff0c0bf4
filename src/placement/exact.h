/* Branch and bound: searches for a plan of n sensors (with a budget: of at most
 * n) that is better than the best known plan, and lowers the upper bound on the
 * value of all these plans.
 *
 * The search goes depth first over sets of candidates. A node consists of the
 * chosen candidates and those that may be added. The bound of a node is that of
 * placement/bound.h. A few subgradient steps lower this bound; they begin at
 * the multipliers of the parent node, and the multiplier of a photon does not
 * go below the entries of the chosen candidates. Candidates that belong to no
 * plan better than the best known one are fixed out on the way. The children of
 * a node add one candidate each, in falling order of the part of the
 * candidate's row above the multipliers (with a budget: of that part per cost).
 * Each child leaves out the candidates that earlier children added.
 *
 * Under constraints the root holds the fixed sensors, and a node passes on only
 * candidates that can be added. The chosen candidates of a node count as a plan
 * if they certainly can be completed: at every node if no candidates are in
 * conflict, else only if they are a complete plan already
 * (placement/partial_plan.h).
 *
 * Source: Land and Doig, Econometrica 28 (1960) 497, doi:10.2307/1910129. */
#ifndef MURK_PLACEMENT_EXACT_H
#define MURK_PLACEMENT_EXACT_H

#include "placement/bound.h"

/* A unit of work is this many evaluations of one photon for one candidate
 * (murk_evaluator_work). Work is limited instead of time, so the same run gives
 * the same plan. 2^15 evaluations are some 2 microseconds for 0/1 rows. */
#define MURK_NODE_WEIGHINGS 32768

/* Replaces the value as the objective of the search by an objective of the
 * caller. There must be a cutoff such that a plan whose value does not exceed
 * the cutoff is not the best one by the other objective. The callback receives
 * each plan found whose value exceeds the cutoff `known`, stores the plan if it
 * is better by the other objective than the plan stored before, and returns the
 * new cutoff. */
typedef struct murk_exact_callback {
    uint64_t (*callback)(void *context, const uint32_t *plan, size_t size,
                         uint64_t known);
    void *context;
} murk_exact_callback;

typedef struct murk_exact {
    uint64_t value, upper; /* value of the plan, or with a callback the last
                              cutoff; upper bound on any plan of n */
    uint64_t nodes;        /* units of work done */
    bool is_cut; /* the limit on work, lack of memory or an interrupt ended the
                    search */
    size_t size; /* sensors of the plan; under constraints the caller may have
                    to complete it with any candidates that can be added */
} murk_exact;

/* Improves plan[size], worth `value`, with some `nodes` units of work at most;
 * plan has room for n sensors. size is n, or with a budget at most n. The last
 * call of murk_bound_tighten() must have been for plans of n; `upper` is the
 * bound that it returned, and the root starts at its multipliers. Needs a
 * matrix. callback NULL: the value is the objective. Otherwise `value` is the
 * first cutoff, and plan[] stays as it is. Nothing is searched if `upper` does
 * not exceed `value`, or if `nodes` is 0. Fails with MURK_NO_MEMORY. */
murk_status murk_exact_search(murk_exact *out, murk_bound *bound,
                              uint32_t *plan, size_t size, size_t n,
                              uint64_t value, uint64_t upper, uint64_t nodes,
                              const murk_exact_callback *callback,
                              murk_error *err);

#endif
