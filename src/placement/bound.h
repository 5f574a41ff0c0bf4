/* How much any plan of a count can be worth at most.
 *
 * For any thresholds t_i in 0..MURK_CLEAR, with w the weights, p the clarities:
 *
 *     bound(t) = sum_i w_i t_i + top-n_j sum_i w_i max(0, p_ij - t_i)
 *
 * is at least the value of every plan of n (a plan's value is at most
 * sum w t + the sum over its members of what lies above t). It is the
 * Lagrangian bound of facility location, with u_i = w_i t_i; for 0/1 rows it
 * is sum (w - u) + top-n sum b u with u = w (1 - t). Where more than the
 * clearest view counts, or views are independent chances, both sums are others
 * (placement/multipliers.h). Thresholds are whole numbers, so the bound is an
 * exact integer and holds in spite of rounding. Subgradient steps lower it,
 * by the volume algorithm: from where it was lowest, down the mean of the
 * slopes met. Candidates that provably are in no plan better than the best
 * known are left out on the way.
 *
 * Under rules the top n become the best that the rules allow, or a little more
 * (placement/relaxation.h); fixed sensors are in every set, by thresholds that
 * do not go below what they see.
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
    float *multiplier; /* [slots] where the last call stopped */
    float *lowest;     /* [slots] where its bound was lowest */
    float *mean;       /* [slots] of slopes, of `round` rounds so far */
    size_t round, since_gain;
    double step;
    size_t last_count;  /* that these belong to; 0: to none */
    float *subgradient; /* [slots] slopes */
    murk_multipliers multipliers;
    murk_cover cover; /* of the plan it starts from, or of the fixed */
    uint64_t *gain;   /* [candidates] above the thresholds */
    uint32_t *live;   /* [candidates] not yet left out */
    size_t live_count;
    uint64_t base;        /* the first sum of the last evaluation */
    murk_ranked *top;     /* [candidates] */
    uint64_t evaluations; /* candidates weighed */
    uint64_t queries;
    murk_relaxation relaxed;          /* with rules: instead of the top n */
    const murk_partial_plan *partial; /* what the n join; NULL: no rules */
    murk_partial_plan fixed;          /* with rules: the fixed sensors */
} murk_bound;

murk_status murk_bound_init(murk_bound *out, const murk_evaluator *evaluator,
                            murk_error *err);
void murk_bound_release(murk_bound *bound);

/* Starts the thresholds at the plan's cover (NULL: goes on from where the last
 * call stopped), and makes at most `rounds` evaluations, each a weighing of the
 * live candidates. `lower` is the value of a known plan of n. Returns an upper
 * bound for plans of n, at least `lower`, and stops early when it meets it. */
uint64_t murk_bound_tighten(murk_bound *bound, size_t n, uint64_t lower,
                            const uint32_t *plan, size_t plan_count,
                            size_t rounds);

/* The same for plans that hold a given set and n more, all of them among
 * bound->live, which the caller fills: `stand` is the set's cover, of clarities
 * or doses, and with rules bound->standing the set itself.
 * Goes on from the present thresholds, raised to what stands. Afterwards live
 * and gain are those that can still be in a plan worth more than `lower`. */
uint64_t murk_bound_tighten_within(murk_bound *bound, size_t n, uint64_t lower,
                                   const murk_cover *partial, size_t rounds);

/* Which of the live candidates the bound adds up at the thresholds of the last
 * call, where `n` may still join: top[], room for all candidates. Returns how
 * many they are. */
size_t murk_bound_top(murk_bound *bound, size_t n, uint32_t *top);

#endif
