/* How much the worst block of any plan can be covered at most.
 *
 * For any lambda on the simplex the least of the blocks' shares is at most
 * sum_c lambda_c share_c, which is a plan's value under weights scaled block by
 * block; so its bound (placement/bound.h) bounds the least share, too. Lambda
 * goes down the bound by mirror steps: towards blocks of which the bound sees
 * less. Scaled weights are rounded up and their sum down, so the bound is
 * valid in spite of rounding. Where blocks count by their regret (worth =
 * value / unit + offset, placement/blocks.h), the same holds of worths, with
 * sum_c lambda_c offset_c, rounded up, added; a reference is a constant, so the
 * bound is valid whether or not a better plan than the reference exists.
 *
 * Source: Krause et al., J. Mach. Learn. Res. 9 (2008) 2761 (the problem);
 * Beck and Teboulle, Oper. Res. Lett. 31 (2003) 167,
 * doi:10.1016/S0167-6377(02)00231-6 (mirror descent). */
#ifndef MURK_PLACEMENT_WORST_BOUND_H
#define MURK_PLACEMENT_WORST_BOUND_H

#include "placement/blocks.h"
#include "placement/bound.h"

__extension__ typedef unsigned __int128 murk_uint128;

typedef struct murk_worst_bound {
    const murk_block_views *views;
    murk_evaluator evaluator; /* the views', under the weights of lambda */
    murk_evaluator block[MURK_BLOCKS_MAX]; /* and under those of one block */
    murk_layout layout;
    murk_bound bound;
    uint32_t *weight;                       /* [photons] */
    uint32_t heaviest[MURK_BLOCKS_MAX];     /* weight of one photon */
    double lambda[MURK_BLOCKS_MAX];         /* sum 1 */
    double lowest_lambda[MURK_BLOCKS_MAX];  /* where the bound was lowest */
    double average_lambda[MURK_BLOCKS_MAX]; /* of all steps */
    uint64_t full_value; /* what a least share of 1 is worth at least, */
    murk_uint128
        offset_sum;  /* less what offsets give, times MURK_SHARE_ONE, at most */
    uint32_t *top;   /* [candidates] */
    uint64_t *gains; /* [candidates] */
} murk_worst_bound;

murk_status murk_worst_bound_init(murk_worst_bound *out,
                                  const murk_block_views *views,
                                  murk_error *err);
void murk_worst_bound_release(murk_worst_bound *bound);

/* Weighs the blocks anew: sets lambda and the weights that go with it. */
murk_status murk_worst_bound_set_lambda(murk_worst_bound *bound,
                                        const double *lambda, murk_error *err);

/* An upper bound on the least share of plans of n, in units, at least `lower`,
 * the least share of plan[plan_count], by `steps` steps of lambda from where it
 * is, `rounds` evaluations each. Lambda is left where the bound was lowest. */
murk_status murk_worst_bound_tighten(murk_worst_bound *bound, size_t n,
                                     uint64_t lower, const uint32_t *plan,
                                     size_t plan_count, size_t steps,
                                     size_t rounds, uint64_t *upper,
                                     murk_error *err);

/* Value, under the present weights, that a plan must exceed for its least
 * share to exceed `share`. */
uint64_t murk_worst_bound_value(const murk_worst_bound *bound, uint64_t share);

/* The least share, at most, of a plan worth so much under these weights. */
uint64_t murk_worst_bound_share(const murk_worst_bound *bound, uint64_t value);

#endif
