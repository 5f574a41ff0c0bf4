/* The Lagrangian bound and its subgradient as functions of the multipliers, for
 * each way in which entries combine. Each photon has a multiplier t, which is a
 * clarity; w are weights and p clarities, as shares of MURK_CLEAR. All sums are
 * over photons, whose index is left out, also of the entries L and doses Y0 of
 * the partial plan.
 *
 * Redundancy k (k = 1: the largest entry). The partial plan has the entries L_1
 * >= .. >= L_k. Each of the k largest entries of the complete plan is either
 * among the L or of an added candidate, and each is at most max(entry, t). So
 *
 *     value <= sum w (max(L_1, t) + .. + max(L_k, t))
 *              + sum_j sum w max(0, p_j - t) over the added candidates j.
 *
 * A multiplier below L_k would only increase the second sum, so L_k is the
 * smallest multiplier.
 *
 * Detection probabilities. The partial plan has the dose Y0; d = -ln(1 - p) and
 * y = -ln(1 - t). The function 1 - exp(-Y) lies below the tangent at y and
 * below 1, and the added candidates contribute the dose Y - Y0. So
 *
 *     value <= sum w (1 - exp(-y) (1 + y - Y0))
 *              + sum_j sum w exp(-y) min(d_j, 1 + y - Y0).
 *
 * Multipliers with y below Y0 are not used. c = exp(-y) (1 + y - Y0) rises up
 * to y = Y0 and then falls towards 0, so for each such y with c > 0 there is a
 * larger y, above Y0, with the same c. With the larger y the first sum and the
 * terms c of the second sum are the same, and the terms exp(-y) d_j smaller.
 *
 * exp(-y) = 1 - t is exact here. y is rounded down in the first sum and up in
 * the second, sums have 128 bits and are rounded up, so the bound holds in
 * spite of rounding. */
#ifndef MURK_PLACEMENT_MULTIPLIERS_H
#define MURK_PLACEMENT_MULTIPLIERS_H

#include "base/arena.h"
#include "placement/evaluator.h"

typedef struct murk_multipliers {
    const murk_evaluator *evaluator;
    murk_cover rounded;        /* the multipliers as whole clarities */
    const murk_cover *partial; /* cover of the partial plan, clarities or doses;
                                  NULL: empty */
    uint16_t *floor;           /* [slots] smallest multipliers */
    uint16_t *count;     /* [slots] scratch: number of chosen rows whose clarity
                            exceeds the multiplier */
    uint64_t *entry_max; /* [slots] scratch, if rows are asked of the problem in
                            parts (murk_evaluator_asks_parts()) */
    /* Detection probabilities only. */
    uint64_t *factor; /* [slots] weight * (1 - t) */
    uint32_t *max;    /* [slots] 1 + y - Y0, rounded up */
    float *drawn;     /* [slots] scratch: sum over the chosen rows of d, or of y
                         - Y0 if d exceeds 1 + y - Y0 */
    murk_arena arena;
} murk_multipliers;

murk_status murk_multipliers_init(murk_multipliers *out,
                                  const murk_evaluator *evaluator,
                                  murk_error *err);
void murk_multipliers_release(murk_multipliers *multipliers);

/* Sets the partial plan and the smallest multipliers. Borrows the cover; NULL:
 * an empty plan. */
void murk_multipliers_set_partial_plan(murk_multipliers *multipliers,
                                       const murk_cover *partial);

/* Sets the multipliers, multiplier[slots], rounded to whole clarities; none may
 * be below floor[slot]. Returns the first sum, rounded up. */
uint64_t murk_multipliers_set(murk_multipliers *multipliers,
                              const float *multiplier);

/* gain[k] = the term of candidate[k] in the second sum, rounded up; over all
 * threads. */
void murk_multipliers_gains(murk_multipliers *multipliers,
                            const uint32_t *candidate, size_t n,
                            uint64_t *gain);

/* subgradient[slots]: the derivative of the bound by each multiplier, divided
 * by the weight, if chosen[n] are added. */
void murk_multipliers_subgradient(murk_multipliers *multipliers,
                                  const murk_ranked *chosen, size_t n,
                                  float *subgradient);

#endif
