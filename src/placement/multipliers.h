/* What a bound's thresholds are worth, and how it changes with them, for each
 * way in which views combine. A threshold t is a clarity; w are the weights, p
 * clarities, all sums over photons i.
 *
 * The k clearest views (k = 1: the clearest), of which those that stand already
 * have L_1 >= .. >= L_k: of the k clearest of all, a_i are among the L, the
 * others joined, and each view is at most max(view, t), so
 *
 *     worth <= sum w (max(L_1, t) + .. + max(L_k, t)) + sum_j sum w max(0,
 *              p_j - t)  over those j that join. Below L_k a threshold only
 * adds to the second sum: there it ends.
 *
 * Independent chances, of which a dose Y0 stands, with d = -ln(1 - p) and y =
 * -ln(1 - t): 1 - exp(-Y) lies below its tangent at y and below 1, and is
 * reached by doses Y - Y0 of those who join, so
 *
 *     worth <= sum w (1 - exp(-y) (1 + y - Y0)) + sum_j sum w exp(-y) min(d_j,
 *              1 + y - Y0). Below Y0 a threshold ends, too.
 *
 * exp(-y) = 1 - t is exact here; y is rounded down in the first sum and up in
 * the second, sums have 128 bits and are rounded up, so that it holds in spite
 * of rounding. */
#ifndef MURK_PLACEMENT_MULTIPLIERS_H
#define MURK_PLACEMENT_MULTIPLIERS_H

#include "placement/evaluator.h"

typedef struct murk_multipliers {
    const murk_evaluator *evaluator;
    murk_cover rounded;        /* the thresholds, in whole units */
    const murk_cover *partial; /* what stands: of clarities or doses, the
                                evaluator's objective; NULL: nobody */
    uint16_t *floor;           /* [slots] where thresholds end */
    uint16_t *count;           /* [slots] scratch: rows that are above */
    /* Independent chances. */
    uint64_t *factor; /* [slots] weight * (1 - t) */
    uint32_t *max;    /* [slots] 1 + y - Y0, rounded up */
    float *drawn;     /* [slots] scratch: doses that count */
} murk_multipliers;

murk_status murk_multipliers_init(murk_multipliers *out,
                                  const murk_evaluator *evaluator,
                                  murk_error *err);
void murk_multipliers_release(murk_multipliers *multipliers);

/* Borrows what stands; NULL: nobody. Sets the floor. */
void murk_multipliers_set_partial_plan(murk_multipliers *multipliers,
                                       const murk_cover *partial);

/* Takes threshold[slots], not below the floor, rounded to whole clarities;
 * returns the first sum, rounded up. */
uint64_t murk_multipliers_set(murk_multipliers *multipliers,
                              const float *multiplier);

/* gain[k] = the second sum's part of candidate[k], rounded up; over threads. */
void murk_multipliers_gains(const murk_multipliers *multipliers,
                            const uint32_t *candidate, size_t n,
                            uint64_t *gain);

/* down[slots]: what the bound falls, per weight, as a threshold does, where
 * chosen[n] join. */
void murk_multipliers_subgradient(murk_multipliers *multipliers,
                                  const murk_ranked *chosen, size_t n,
                                  float *subgradient);

#endif
