/* The bound on the smallest worth: a Lagrangian bound for each lambda, and
 * steps of mirror descent on lambda. The multipliers go on from lambda to
 * lambda. All rounding is towards a larger bound. */
#include "placement/worst_bound.h"

#include "base/interrupt.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef murk_uint128 wide;

/* Scaled weights add up to at most 2^46, plus 1 for each photon by rounding up:
 * far below the 2^47 of placement/problem.h. None reaches the 2^32 of the
 * layout: half of that leaves room for rounding. */
#define WEIGHT_SUM 0x1p46
#define WEIGHT_MAX 0x1p31

/* Factors of the blocks are whole numbers below FACTOR_MAX, divided by 2^shift.
 * Both limits keep a product with a 32-bit weight within 64 bits. */
#define FACTOR_MAX 0x1p31
#define SHIFT_MAX  31

/* Larger than the smallest worth of any plan. With regret a worth can exceed 1,
 * because a plan may beat the reference. */
#define WORTH_MAX (UINT64_C(1) << 60)

/* The smallest lambda, so that no block drops out for good. */
#define LAMBDA_MIN 1e-9

murk_status murk_worst_bound_init(murk_worst_bound *out,
                                  const murk_block_layouts *layouts,
                                  murk_error *err)
{
    const murk_evaluator *o = layouts->evaluator;
    const size_t n = o->candidates + 1, blocks = layouts->blocks->n;
    *out = (murk_worst_bound){
        .layouts = layouts,
        .evaluator = *o,
        .weight = calloc(o->problem->photons + 1, sizeof *out->weight),
        .top = calloc(n, sizeof *out->top),
        .gains = calloc(n, sizeof *out->gains)};
    /* Begin with equal lambda. */
    double lambda[MURK_BLOCKS_MAX];
    for (size_t c = 0; c < blocks; ++c) {
        lambda[c] = 1 / (double)blocks;
        out->block[c] = *o;
        out->block[c].layout = &layouts->layout[c];
        for (size_t i = layouts->blocks->first[c];
             i < layouts->blocks->first[c + 1]; ++i) {
            const uint32_t w = o->problem->weight[i];
            out->heaviest[c] = w > out->heaviest[c] ? w : out->heaviest[c];
        }
    }
    murk_status status =
        out->weight && out->top && out->gains
            ? murk_worst_bound_set_lambda(out, lambda, err)
            : murk_no_memory(err, "", "to bound plans for %zu conditions",
                             blocks);
    out->evaluator.layout = &out->layout;
    return status ? status : murk_bound_init(&out->bound, &out->evaluator, err);
}

void murk_worst_bound_release(murk_worst_bound *b)
{
    murk_bound_release(&b->bound);
    murk_layout_release(&b->layout);
    free(b->weight);
    free(b->top);
    free(b->gains);
    *b = (murk_worst_bound){0};
}

/* The factor of each block, factor[c] / 2^shift: lambda over the unit, times a
 * common scale that is as large as the limits on weights allow. Returns shift.
 */
static unsigned find_factors(const murk_worst_bound *b, const double *lambda,
                             uint64_t *factor)
{
    const size_t n = b->layouts->blocks->n;
    double sum = 0, max = 0;
    for (size_t c = 0; c < n; ++c) {
        sum += lambda[c] * (double)b->layouts->whole[c] /
               (double)b->layouts->unit[c];
    }
    /* the sum is 1, but for rounding, and more with relative regret */
    double scale = WEIGHT_SUM * MURK_CLEAR / fmax(1, sum * (1 - 0x1p-40));
    for (size_t c = 0; c < n; ++c) {
        const double per_unit = lambda[c] / (double)b->layouts->unit[c];
        scale = fmin(scale, WEIGHT_MAX / (per_unit * b->heaviest[c]));
        scale = fmin(scale, FACTOR_MAX / per_unit);
        max = fmax(max, per_unit);
    }
    const int exponent = ilogb(scale * max * (1 - 0x1p-50));
    const unsigned shift = exponent >= 30   ? 0
                           : exponent <= -1 ? SHIFT_MAX
                                            : (unsigned)(30 - exponent);
    for (size_t c = 0; c < n; ++c) {
        factor[c] = (uint64_t)ldexp(scale * (1 - 0x1p-50) * lambda[c] /
                                        (double)b->layouts->unit[c],
                                    (int)shift);
    }
    return shift;
}

murk_status murk_worst_bound_set_lambda(murk_worst_bound *b,
                                        const double *lambda, murk_error *err)
{
    const murk_block_layouts *layouts = b->layouts;
    const murk_problem *problem = layouts->evaluator->problem;
    uint64_t factor[MURK_BLOCKS_MAX];
    const unsigned shift = find_factors(b, lambda, factor);
    const uint64_t up = ((uint64_t)1 << shift) - 1;
    wide one = 0;
    b->offset_sum = 0;
    for (size_t c = 0; c < layouts->blocks->n; ++c) {
        b->lambda[c] = lambda[c];
        const wide unit = (wide)factor[c] * layouts->unit[c];
        one += unit;
        b->offset_sum += ((unit + up) >> shift) * layouts->offset[c];
        for (size_t i = layouts->blocks->first[c];
             i < layouts->blocks->first[c + 1]; ++i) {
            b->weight[i] =
                (uint32_t)((problem->weight[i] * factor[c] + up) >> shift);
        }
    }
    b->full_value = (uint64_t)(one >> shift);
    const murk_status status = murk_layout_reweigh(
        &b->layout, layouts->evaluator->layout, b->weight, err);
    if (!status) {
        b->bound.last_count =
            0; /* the mean of subgradients was that of other weights */
        b->evaluator.ceiling = b->layout.whole;
        b->evaluator.grain = (uint64_t)b->layout.weight_gcd *
                             (b->evaluator.is_binary ? MURK_CLEAR : 1);
    }
    return status;
}

uint64_t murk_worst_bound_value(const murk_worst_bound *b, uint64_t share)
{
    const wide needed = (wide)(share + 1) * b->full_value;
    if (needed <= b->offset_sum) { /* the offsets alone reach it */
        return 0;
    }
    const wide min = (needed - b->offset_sum - 1) / MURK_SHARE_ONE + 1;
    return (uint64_t)min - 1;
}

uint64_t murk_worst_bound_share(const murk_worst_bound *b, uint64_t value)
{
    const wide share =
        ((wide)value * MURK_SHARE_ONE + b->offset_sum) / b->full_value;
    return share < WORTH_MAX ? (uint64_t)share : WORTH_MAX;
}

/* The share of each block at the present multipliers, in the choice that makes
 * the bound. */
static void find_shares(murk_worst_bound *b, size_t n, double *share)
{
    const murk_block_layouts *v = b->layouts;
    murk_multipliers *t = &b->bound.multipliers;
    const size_t chosen = murk_bound_top(&b->bound, n, b->top);
    for (size_t c = 0; c < v->blocks->n; ++c) {
        t->evaluator = &b->block[c];
        double sum = (double)murk_multipliers_set(t, b->bound.multiplier);
        murk_multipliers_gains(t, b->top, chosen, b->gains);
        for (size_t k = 0; k < chosen; ++k) {
            sum += (double)b->gains[k];
        }
        share[c] = sum / (double)v->unit[c] +
                   (double)v->offset[c] / (double)MURK_SHARE_ONE;
    }
    t->evaluator = &b->evaluator;
}

/* One step of mirror descent: lambda_c times exp(-step * (share_c - mean) /
 * widest), at least LAMBDA_MIN, scaled to sum 1. `mean` is the mean of the
 * shares under lambda, `widest` the largest difference from it. */
static void step_lambda(const murk_worst_bound *b, const double *share,
                        double step, double *lambda)
{
    const size_t n = b->layouts->blocks->n;
    double mean = 0, widest = 0, sum = 0;
    for (size_t c = 0; c < n; ++c) {
        mean += b->lambda[c] * share[c];
    }
    for (size_t c = 0; c < n; ++c) {
        widest = fmax(widest, fabs(share[c] - mean));
    }
    for (size_t c = 0; c < n; ++c) {
        const double off = widest > 0 ? (share[c] - mean) / widest : 0;
        lambda[c] = fmax(LAMBDA_MIN, b->lambda[c] * exp(-step * off));
        sum += lambda[c];
    }
    for (size_t c = 0; c < n; ++c) {
        lambda[c] /= sum;
    }
}

/* The bound at the present lambda, as a share. */
static uint64_t bound_here(murk_worst_bound *b, size_t n, uint64_t lower,
                           const uint32_t *plan, size_t plan_count,
                           size_t rounds)
{
    const uint64_t floor = murk_worst_bound_value(b, lower);
    const uint64_t upper =
        murk_bound_tighten(&b->bound, n, floor, plan, plan_count, rounds);
    const uint64_t share = murk_worst_bound_share(b, upper);
    return share > lower ? share : lower;
}

murk_status murk_worst_bound_tighten(murk_worst_bound *b, size_t n,
                                     uint64_t lower, const uint32_t *plan,
                                     size_t plan_count, size_t steps,
                                     size_t rounds, uint64_t *upper,
                                     murk_error *err)
{
    const size_t blocks = b->layouts->blocks->n;
    const murk_constraint_set *set = b->evaluator.set;
    const size_t left = n - (set ? set->constraints->fixed_count : 0);
    double lambda[MURK_BLOCKS_MAX], average[MURK_BLOCKS_MAX] = {0};
    /* The bound at the present lambda, with twice the rounds if the multipliers
     * start at a plan. */
    uint64_t lowest =
        bound_here(b, n, lower, plan, plan_count, plan ? rounds * 2 : rounds);
    memcpy(b->lowest_lambda, b->lambda, sizeof b->lambda);
    for (size_t t = 0; t < steps && lowest > lower && !murk_must_finish();
         ++t) {
        double share[MURK_BLOCKS_MAX];
        /* Step; the last evaluation is at the mean of all lambda, which mirror
         * descent is proven for. */
        find_shares(b, left, share);
        step_lambda(b, share, 1 / sqrt((double)t + 1), lambda);
        for (size_t c = 0; c < blocks; ++c) {
            average[c] += lambda[c] / (double)steps;
        }
        const bool is_last = t + 1 == steps;
        const murk_status status =
            murk_worst_bound_set_lambda(b, is_last ? average : lambda, err);
        if (status) {
            return status;
        }
        const uint64_t now = bound_here(b, n, lower, NULL, 0, rounds);
        if (now < lowest) {
            lowest = now;
            memcpy(b->lowest_lambda, b->lambda, sizeof b->lambda);
        }
    }
    *upper = lowest < *upper ? lowest : *upper;
    return murk_worst_bound_set_lambda(b, b->lowest_lambda, err);
}
