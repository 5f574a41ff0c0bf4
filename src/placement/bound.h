/* Upper bounds on the value of any plan of a count: the Lagrangian bound of
 * facility location, lowered by subgradient steps.
 *
 * For any multipliers t_i in 0..MURK_CLEAR, with weights w and clarities p,
 *
 *     bound(t) = sum_i w_i t_i + top-n_j sum_i w_i max(0, p_ij - t_i)
 *
 * with top-n_j the sum of the n largest terms over the candidates j, is an
 * upper bound on the value of every plan of n: the value is at most sum w t
 * plus the parts of the members' entries above t. In the usual form the
 * multipliers are u_i = w_i t_i. For 0/1 entries b, and t as a share of
 * MURK_CLEAR, the bound is sum (w - v) + top-n sum b v with v = w (1 - t). With
 * redundancy, and with detection probabilities, both sums differ
 * (placement/multipliers.h). Multipliers are rounded to whole numbers, so the
 * bound is an exact integer and holds in spite of rounding. The volume
 * algorithm lowers the bound: each step starts at the multipliers of the lowest
 * bound and goes down the mean of the subgradients met so far. Candidates that
 * provably belong to no better plan than the best known one are fixed out on
 * the way.
 *
 * Under constraints the sum over the top n becomes an upper bound on that sum
 * over any feasible choice (placement/relaxation.h). Fixed sensors belong to
 * every plan; the multipliers do not go below their entries.
 *
 * Source: Cornuejols, Fisher, Nemhauser, Manage. Sci. 23 (1977) 789,
 * doi:10.1287/mnsc.23.8.789; Barahona and Anbil, Math. Program. 87 (2000) 385,
 * doi:10.1007/s101070050002; step length: Polyak, USSR Comput. Math. Math.
 * Phys. 9 (1969) 14, doi:10.1016/0041-5553(69)90061-5. */
#ifndef MURK_PLACEMENT_BOUND_H
#define MURK_PLACEMENT_BOUND_H

#include "placement/multipliers.h"
#include "placement/relaxation.h"

typedef struct murk_bound {
    const murk_evaluator *evaluator;
    float *multiplier; /* [slots] of the present evaluation */
    float *lowest;     /* [slots] of the lowest bound */
    float
        *mean; /* [slots] weighted mean of the subgradients of `round` rounds */
    size_t round, since_gain;
    double step;
    bool is_quick; /* set by the caller: few rounds will be made, so steps grow
                    * short sooner */
    size_t
        last_count; /* count of sensors that mean and step belong to; 0: none */
    float *subgradient; /* [slots] of the last evaluation, per weight; later the
                           direction of the step */
    murk_multipliers multipliers;
    murk_cover cover; /* of the starting plan, or of the fixed sensors */
    uint64_t *gain;   /* [live_count] weighted part of the row of each live[]
                         above the multipliers */
    uint32_t *live;   /* [candidates] not fixed out */
    size_t live_count;
    uint64_t base;        /* sum_i w_i t_i (or the first sum of
                             placement/multipliers.h) of the last evaluation */
    murk_ranked *top;     /* [candidates] the choice that makes the bound */
    uint64_t evaluations; /* gains computed */
    uint64_t queries;
    murk_relaxation relaxed; /* with constraints: in place of the top n */
    const murk_partial_plan *partial; /* with constraints: the partial plan that
                                         the n candidates extend; else NULL */
    murk_partial_plan fixed;          /* with constraints: the fixed sensors */
    murk_arena arena;
} murk_bound;

murk_status murk_bound_init(murk_bound *out, const murk_evaluator *evaluator,
                            murk_error *err);
void murk_bound_release(murk_bound *bound);

/* Bounds the value of plans of n sensors. The multipliers start at the cover of
 * plan[plan_count]; plan NULL: they go on from the last call. Makes at most
 * `rounds` evaluations (with constraints one more), each of all live
 * candidates. `lower` is the value of a known plan of n, or another value below
 * which the bound is of no use. Returns an upper bound, at least `lower`, and
 * stops early when the bound reaches `lower`, when the steps have become too
 * short, or if the search is asked to finish or to stop. With rounds 0: the
 * value of all candidates together. */
uint64_t murk_bound_tighten(murk_bound *bound, size_t n, uint64_t lower,
                            const uint32_t *plan, size_t plan_count,
                            size_t rounds);

/* The same for plans that consist of a partial plan and n more candidates of
 * bound->live, which the caller fills. `partial` is the cover of the partial
 * plan (clarities or doses); with constraints bound->partial is the partial
 * plan. The multipliers go on from the present ones, raised to the cover.
 * If the returned bound exceeds `lower`, live[] and gain[] afterwards have the
 * candidates that can still belong to a plan worth more than `lower`. */
uint64_t murk_bound_tighten_within(murk_bound *bound, size_t n, uint64_t lower,
                                   const murk_cover *partial, size_t rounds);

/* Fills top[] (room for all candidates) with the live candidates that make the
 * bound at the present multipliers if n candidates are still to be chosen.
 * Returns their number. */
size_t murk_bound_top(murk_bound *bound, size_t n, uint32_t *top);

#endif
