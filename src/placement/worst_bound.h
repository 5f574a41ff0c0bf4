/* Upper bounds on the smallest worth of the blocks for any plan.
 *
 * For any lambda on the simplex (lambda_c >= 0, with sum 1) the smallest share
 * of the blocks is at most sum_c lambda_c share_c. This sum is the value of the
 * plan under weights that are scaled block by block, so the Lagrangian bound
 * (placement/bound.h) on that value bounds the smallest share, too. Lambda
 * moves by steps of mirror descent, towards blocks of which the bound sees
 * less. Scaled weights are rounded up, and the value that stands for a smallest
 * share of 1 (full_value) is rounded down, so the bound is valid in spite of
 * rounding. With regret (worth = value / unit + offset, placement/blocks.h) the
 * same holds for worths, plus sum_c lambda_c offset_c, rounded up. A reference
 * is a constant, so the bound is valid even if a plan better than the reference
 * exists.
 *
 * Source: Krause et al., J. Mach. Learn. Res. 9 (2008) 2761 (the problem); Beck
 * and Teboulle, Oper. Res. Lett. 31 (2003) 167,
 * doi:10.1016/S0167-6377(02)00231-6 (mirror descent). */
#ifndef MURK_PLACEMENT_WORST_BOUND_H
#define MURK_PLACEMENT_WORST_BOUND_H

#include "placement/blocks.h"
#include "placement/bound.h"

__extension__ typedef unsigned __int128 murk_uint128;

typedef struct murk_worst_bound {
    const murk_block_layouts *layouts;
    murk_evaluator evaluator;              /* with the weights of lambda */
    murk_evaluator block[MURK_BLOCKS_MAX]; /* with the weights of one block */
    murk_layout layout;
    murk_bound bound;
    uint32_t *weight;                      /* [photons] */
    uint32_t heaviest[MURK_BLOCKS_MAX];    /* largest weight of a photon in each
                                              block */
    double lambda[MURK_BLOCKS_MAX];        /* of the present weights; sum 1 */
    double lowest_lambda[MURK_BLOCKS_MAX]; /* of the lowest bound */
    uint64_t full_value;     /* lower bound on the value plus offset_sum /
                                MURK_SHARE_ONE of a plan whose smallest worth is
                                1 */
    murk_uint128 offset_sum; /* upper bound on the weighted sum of the offsets,
                                in units of 1 / MURK_SHARE_ONE of a value */
    uint32_t *top;           /* [candidates] */
    uint64_t *gains;         /* [candidates] */
} murk_worst_bound;

murk_status murk_worst_bound_init(murk_worst_bound *out,
                                  const murk_block_layouts *layouts,
                                  murk_error *err);
void murk_worst_bound_release(murk_worst_bound *bound);

/* Sets lambda and the weights that belong to it. */
murk_status murk_worst_bound_set_lambda(murk_worst_bound *bound,
                                        const double *lambda, murk_error *err);

/* Lowers *upper to an upper bound on the smallest share of plans of n, in units
 * of 1 / MURK_SHARE_ONE. `lower` is in the same units; the bound is not lowered
 * further than to `lower`. The multipliers start at plan[plan_count], or, with
 * plan NULL, go on from the last call. Makes at most `steps` steps of lambda
 * from the present one, with `rounds` evaluations each; before the first step
 * with `rounds` evaluations, with a plan twice as many. Leaves lambda at the
 * lowest bound. */
murk_status murk_worst_bound_tighten(murk_worst_bound *bound, size_t n,
                                     uint64_t lower, const uint32_t *plan,
                                     size_t plan_count, size_t steps,
                                     size_t rounds, uint64_t *upper,
                                     murk_error *err);

/* The value under the present weights that a plan must exceed if its smallest
 * share is to exceed `share`; 0 if the offsets alone suffice. */
uint64_t murk_worst_bound_value(const murk_worst_bound *bound, uint64_t share);

/* Upper bound on the smallest share of a plan with this value under the present
 * weights. */
uint64_t murk_worst_bound_share(const murk_worst_bound *bound, uint64_t value);

#endif
