/* The relaxation of the constraints: an upper bound on the sum of gains that a
 * feasible set of candidates can have, if gains simply add up.
 *
 * Maximum and minimum counts by class are kept exactly (they form a matroid,
 * for which the greedy choice is best). For other constraints the smallest of
 * several relaxations counts: one sensor a site; the fractional knapsack of a
 * budget, in which maximum counts by class have Lagrangian multipliers; the
 * rule on moves, whose costs are subtracted from the gains. Spacing and listed
 * conflicts are left out.
 *
 * Source: Edmonds, Math. Program. 1 (1971) 127, doi:10.1007/BF01584082
 * (matroids); Dantzig, Oper. Res. 5 (1957) 266, doi:10.1287/opre.5.2.266
 * (knapsack). */
#ifndef MURK_PLACEMENT_RELAXATION_H
#define MURK_PLACEMENT_RELAXATION_H

#include "base/arena.h"
#include "placement/evaluator.h"
#include "placement/partial_plan.h"

/* A candidate with gain and cost. */
typedef struct murk_priced {
    uint64_t gain, cost;
    uint32_t candidate;
} murk_priced;

/* The Lagrangian multiplier of the maximum count of one class: each sensor of
 * the class is charged this much. The multiplier is improved from call to call;
 * the bound is valid for any multiplier. */
typedef struct murk_constraint_multiplier {
    uint64_t multiplier, step;
    uint64_t charged; /* multiplier of the last bound */
    int direction;    /* of the last step: -1, 0, 1 */
} murk_constraint_multiplier;

typedef struct murk_relaxation {
    const murk_constraint_set *set;
    murk_ranked *order;     /* [candidates] by falling gain */
    murk_ranked *picked;    /* [candidates] */
    murk_priced *priced;    /* [candidates] by falling gain per cost */
    uint64_t *value, *cost; /* [candidates + 1] prefix sums over priced */
    size_t live;
    size_t *class_count; /* [classes] scratch */
    bool *is_used;       /* [sites] scratch */
    uint64_t others;     /* bound on the sum of the gains if one candidate fewer
                            is chosen; leaves the budget out */
    murk_constraint_multiplier *
        multiplier; /* [classes] with a budget and maximum counts; NULL: none */
    uint64_t cap_charges; /* sum of the charges for all places that maximum
                             counts leave */
    double carry;         /* sum of the fractions of candidates that were paid
                             in part and not yet chosen */
    murk_arena arena;
} murk_relaxation;

murk_status murk_relaxation_init(murk_relaxation *out,
                                 const murk_constraint_set *set,
                                 murk_error *err);
void murk_relaxation_release(murk_relaxation *relaxed);

/* Upper bound on the sum of gains, less the cost of their moves, of a
 * feasible extension of the partial plan by live[n] with gain[n]. top[*chosen]
 * receives the choice that makes the bound. A candidate that the knapsack takes
 * in part is in the choice of some calls only, as often as its fraction. */
uint64_t murk_relaxation_top(murk_relaxation *relaxed,
                             const murk_partial_plan *partial,
                             const uint32_t *live, const uint64_t *gain,
                             size_t n, murk_ranked *top, size_t *chosen);

/* After murk_relaxation_top(): the same bound for the gains of the other
 * candidates of an extension that contains this candidate. */
uint64_t murk_relaxation_others(const murk_relaxation *relaxed,
                                const murk_partial_plan *partial,
                                uint32_t candidate);

/* Sorts the candidates for murk_relaxation_rest(): by falling gain, with a
 * budget by falling gain per cost. */
void murk_relaxation_sort(murk_relaxation *relaxed, murk_ranked *ranked,
                          size_t n);

/* Upper bound on the sum of gains, less the cost of their moves, of a
 * feasible extension of the partial plan by ranked[n], sorted as above. The
 * bound of a part of the list is at most that of the whole list. */
uint64_t murk_relaxation_rest(murk_relaxation *relaxed,
                              const murk_partial_plan *partial,
                              const murk_ranked *ranked, size_t n);

/* Comparison of two murk_priced for qsort(): candidates with a gain but no cost
 * first, by falling gain; then by falling gain per cost; candidates without a
 * gain last; then by index. */
int murk_compare_density(const void *a, const void *b);

/* a + b, or UINT64_MAX where that would overflow. */
static inline uint64_t murk_sum_saturated(uint64_t a, uint64_t b)
{
    return a > UINT64_MAX - b ? UINT64_MAX : a + b;
}

#endif
