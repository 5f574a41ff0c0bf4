/* The most that candidates which simply add up can bring under the rules, or
 * a little more: what bounds are made of.
 *
 * Caps and least counts are kept to exactly (they form a matroid, where taking
 * the greatest that still fits is best); of several kinds of rules the least
 * of what each allows alone counts: at most one a site, and of a budget the
 * fractional knapsack, with caps by Lagrangian multipliers on places. Spacing
 * and lists of conflicts are left out.
 *
 * Source: Edmonds, Math. Program. 1 (1971) 127, doi:10.1007/BF01584082
 * (matroids); Dantzig, Oper. Res. 5 (1957) 266, doi:10.1287/opre.5.2.266
 * (knapsack). */
#ifndef MURK_PLACEMENT_RELAXATION_H
#define MURK_PLACEMENT_RELAXATION_H

#include "placement/evaluator.h"
#include "placement/partial_plan.h"

typedef struct murk_priced {
    uint64_t gain, cost;
    uint32_t candidate;
} murk_priced;

/* What each sensor of a class is charged for its place, so that classes keep
 * their caps; it is learnt from call to call, and any is valid. */
typedef struct murk_constraint_multiplier {
    uint64_t multiplier, step;
    uint64_t charged; /* when last priced */
    int direction;    /* of the last step: -1, 0, 1 */
} murk_constraint_multiplier;

typedef struct murk_relaxation {
    const murk_constraint_set *set;
    murk_ranked *order;     /* [candidates] by falling gain */
    murk_ranked *picked;    /* [candidates] */
    murk_priced *priced;    /* [candidates] by falling gain per cost */
    uint64_t *value, *cost; /* [candidates + 1] of the first k of priced */
    size_t live;
    size_t *class_count; /* [classes] */
    bool *is_used;       /* [sites] */
    uint64_t others;     /* that one fewer can bring, without a budget */
    murk_constraint_multiplier
        *multiplier;      /* [classes] with a budget and caps; NULL: none */
    uint64_t cap_charges; /* of all places that the caps leave, last priced */
    double carry;         /* of fractions of candidates not yet picked */
} murk_relaxation;

murk_status murk_relaxation_init(murk_relaxation *out,
                                 const murk_constraint_set *set,
                                 murk_error *err);
void murk_relaxation_release(murk_relaxation *relaxed);

/* The most that live[n], each bringing gain[k], can bring to what stands.
 * top[] gets those that do, *chosen many; of a candidate picked in part, as
 * often as its part is. */
uint64_t murk_relaxation_top(murk_relaxation *relaxed,
                             const murk_partial_plan *partial,
                             const uint32_t *live, const uint64_t *gain,
                             size_t n, murk_ranked *top, size_t *chosen);

/* After that: the most that others can bring where this candidate is in. */
uint64_t murk_relaxation_others(const murk_relaxation *relaxed,
                                const murk_partial_plan *partial,
                                uint32_t candidate);

/* Puts the candidates in the order in which murk_relaxation_rest() picks. */
void murk_relaxation_sort(murk_relaxation *relaxed, murk_ranked *ranked,
                          size_t n);

/* At least what ranked[n], so ordered, can bring to what stands; of a part of
 * the order no more than of the whole. */
uint64_t murk_relaxation_rest(murk_relaxation *relaxed,
                              const murk_partial_plan *partial,
                              const murk_ranked *ranked, size_t n);

/* For qsort() of murk_priced: gain per cost, falling, what brings nothing
 * last; then number. */
int murk_compare_density(const void *a, const void *b);

static inline uint64_t murk_sum_saturated(uint64_t a, uint64_t b)
{
    return a > UINT64_MAX - b ? UINT64_MAX : a + b;
}

#endif
