#include "placement/bound.h"

#include "base/interrupt.h"

#include <stdlib.h>
#include <string.h>

/* The Polyak step aims at the best known plan, which the bound may never
 * reach: the step shrinks by SHRINK after PATIENCE rounds without gain, and
 * steps below LEAST_STEP change nothing that matters. */
#define FIRST_STEP 0.5
#define SHRINK     0.8
#define PATIENCE   8
#define LEAST_STEP 1e-4

/* Share of the last direction kept: damps the zigzag of plain subgradients. */
#define MEMORY 0.7F

murk_status murk_bound_init(murk_bound *out, const murk_oracle *oracle,
                            murk_error *err)
{
    const size_t slots = oracle->layout->slots + 1;
    const size_t n = oracle->candidates + 1;
    *out = (murk_bound){.oracle = oracle,
                        .threshold = calloc(slots, sizeof *out->threshold),
                        .lowest = calloc(slots, sizeof *out->lowest),
                        .direction = calloc(slots, sizeof *out->direction),
                        .down = calloc(slots, sizeof *out->down),
                        .gain = calloc(n, sizeof *out->gain),
                        .live = calloc(n, sizeof *out->live),
                        .top = calloc(n, sizeof *out->top)};
    murk_status status = murk_thresholds_init(&out->thresholds, oracle, err);
    if (!status && (!out->threshold || !out->lowest || !out->direction ||
                    !out->down || !out->gain || !out->live || !out->top ||
                    !murk_cover_init(&out->cover, oracle->layout, false))) {
        status = murk_fail(err, MURK_NO_MEMORY, "",
                           "no memory to bound plans for %zu photons",
                           oracle->layout->photons);
    }
    if (!status && oracle->book) {
        status = murk_relaxed_init(&out->relaxed, oracle->book, err);
    }
    if (!status && oracle->book) {
        status = murk_standing_init(&out->fixed, oracle->book, err);
    }
    if (status) {
        murk_bound_release(out);
    }
    return status;
}

void murk_bound_release(murk_bound *bound)
{
    free(bound->threshold);
    free(bound->lowest);
    free(bound->direction);
    free(bound->down);
    free(bound->gain);
    free(bound->live);
    free(bound->top);
    murk_thresholds_release(&bound->thresholds);
    murk_cover_release(&bound->cover);
    murk_relaxed_release(&bound->relaxed);
    murk_standing_release(&bound->fixed);
    *bound = (murk_bound){0};
}

/* What plan[n] sees, in b->cover. */
static void cover_plan(murk_bound *b, const uint32_t *plan, size_t n)
{
    const murk_layout *layout = b->oracle->layout;
    murk_cover_clear(&b->cover, layout);
    for (size_t k = 0; k < n; ++k) {
        const murk_row row = murk_oracle_row(b->oracle, 0, plan[k]);
        b->looks += b->oracle->matrix ? 0 : 1;
        murk_cover_add(&b->cover, layout, &row);
    }
}

static void start_at_plan(murk_bound *b, const uint32_t *plan, size_t n)
{
    cover_plan(b, plan, n);
    for (size_t i = 0; i < b->oracle->layout->slots; ++i) {
        b->threshold[i] = b->cover.best[i];
    }
}

/* The n live candidates with most above the thresholds, lowest number on ties,
 * falling. Returns how many there are. */
static size_t find_top(murk_bound *b, size_t n)
{
    size_t kept = 0;
    for (size_t k = 0; k < b->live_count; ++k) {
        const murk_ranked now = {b->gain[k], b->live[k]};
        if (kept == n && now.bound <= b->top[n - 1].bound) {
            continue;
        }
        size_t at = kept < n ? kept++ : n - 1;
        for (; at > 0 && b->top[at - 1].bound < now.bound; --at) {
            b->top[at] = b->top[at - 1];
        }
        b->top[at] = now;
    }
    return kept;
}

/* Leaves out candidates that are in no plan worth more than `lower`: with j in
 * it, a plan has at most `base`, the best n - 1 others, and j's own. */
static void leave_out(murk_bound *b, uint64_t base, size_t n, size_t chosen,
                      uint64_t lower)
{
    if (chosen < n) {
        return;
    }
    uint64_t others = base;
    for (size_t k = 0; k + 1 < n; ++k) {
        others = murk_sum_saturated(others, b->top[k].bound);
    }
    const uint64_t grain = b->oracle->grain;
    const uint64_t last = b->top[n - 1].bound;
    size_t kept = 0;
    for (size_t k = 0; k < b->live_count; ++k) {
        const uint64_t with = murk_sum_saturated(others, b->gain[k]);
        if (b->gain[k] >= last || with - with % grain > lower) {
            b->live[kept] = b->live[k];
            b->gain[kept++] = b->gain[k];
        }
    }
    b->live_count = kept;
}

/* The same under rules. */
static void leave_out_by_rules(murk_bound *b, uint64_t base, uint64_t lower)
{
    const uint64_t grain = b->oracle->grain;
    size_t kept = 0;
    for (size_t k = 0; k < b->live_count; ++k) {
        const uint64_t others =
            murk_relaxed_others(&b->relaxed, b->standing, b->live[k]);
        const uint64_t with =
            murk_sum_saturated(base, murk_sum_saturated(others, b->gain[k]));
        if (with - with % grain > lower) {
            b->live[kept] = b->live[k];
            b->gain[kept++] = b->gain[k];
        }
    }
    b->live_count = kept;
}

/* One projected step down the subgradient w * down, in the metric of the
 * weights, so that merging equal photons would change nothing. */
static void step_down(murk_bound *b, size_t chosen, double excess, double step,
                      bool is_first)
{
    const murk_layout *layout = b->oracle->layout;
    b->looks += b->oracle->matrix ? 0 : chosen;
    murk_thresholds_slopes(&b->thresholds, b->top, chosen, b->down);
    double norm = 0;
    for (size_t i = 0; i < layout->slots; ++i) {
        float down = b->down[i];
        if (!is_first) {
            down += MEMORY * (b->direction[i] - down);
        }
        b->direction[i] = down;
        norm += (double)layout->weight[i] * (double)(down * down);
    }
    if (!(norm > 0)) {
        return;
    }
    const float length = (float)(step * excess / norm);
    for (size_t i = 0; i < layout->slots; ++i) {
        const float to = b->threshold[i] - length * b->direction[i];
        const float least = b->thresholds.floor[i];
        b->threshold[i] = to > MURK_CLEAR ? MURK_CLEAR
                          : to > least    ? to
                                          : least;
    }
}

/* What the live candidates can make at most; b->top[chosen] do. */
static uint64_t sum_top(murk_bound *b, size_t n, size_t *chosen)
{
    if (b->standing) {
        return murk_sum_saturated(
            b->base, murk_relaxed_top(&b->relaxed, b->standing, b->live,
                                      b->gain, b->live_count, b->top, chosen));
    }
    *chosen = find_top(b, n);
    uint64_t sum = b->base;
    for (size_t k = 0; k < *chosen; ++k) {
        sum = murk_sum_saturated(sum, b->top[k].bound);
    }
    return sum;
}

/* Lowers the bound over the live candidates. */
static uint64_t descend(murk_bound *b, size_t n, uint64_t lower, size_t rounds)
{
    const murk_oracle *o = b->oracle;
    const size_t slots = o->layout->slots;
    uint64_t upper = o->ceiling;
    uint64_t lowest = UINT64_MAX;
    double step = FIRST_STEP;
    size_t since_gain = 0;
    memcpy(b->lowest, b->threshold, slots * sizeof *b->lowest);
    for (size_t round = 0; round < rounds && upper > lower; ++round) {
        if (murk_interrupted() || step < LEAST_STEP) {
            break;
        }
        b->base = murk_thresholds_take(&b->thresholds, b->threshold);
        murk_thresholds_gains(&b->thresholds, b->live, b->live_count, b->gain);
        b->evaluations += b->live_count;
        b->looks += o->matrix ? 0 : b->live_count;
        size_t chosen = 0;
        uint64_t now = sum_top(b, n, &chosen);
        ++since_gain;
        if (now < lowest) {
            lowest = now;
            since_gain = 0;
            memcpy(b->lowest, b->threshold, slots * sizeof *b->lowest);
        }
        /* of plans worth more than lower, all are made of the live */
        now -= now % o->grain;
        now = now > lower ? now : lower;
        upper = now < upper ? now : upper;
        if (upper <= lower) {
            break;
        }
        if (round + 1 == rounds && !b->thresholds.stand) {
            break;
        }
        if (b->standing) {
            leave_out_by_rules(b, b->base, lower);
        } else {
            leave_out(b, b->base, n, chosen, lower);
        }
        if (since_gain >= PATIENCE) {
            step *= SHRINK;
            since_gain = 0;
            memcpy(b->threshold, b->lowest, slots * sizeof *b->threshold);
            continue; /* the next round measures there again */
        }
        const double excess = (double)now - (double)lower;
        step_down(b, chosen, excess, step, round == 0);
    }
    memcpy(b->threshold, b->lowest, slots * sizeof *b->threshold);
    return upper > lower ? upper : lower;
}

static void raise_to(murk_bound *b, const murk_cover *stand)
{
    murk_thresholds_stand(&b->thresholds, stand);
    for (size_t i = 0; stand && i < b->oracle->layout->slots; ++i) {
        const float least = b->thresholds.floor[i];
        b->threshold[i] = b->threshold[i] > least ? b->threshold[i] : least;
    }
}

/* The fixed sensors stand, and whom they admit may join. */
static uint64_t tighten_by_rules(murk_bound *b, size_t n, uint64_t lower,
                                 size_t rounds)
{
    const murk_oracle *o = b->oracle;
    const murk_rules *rules = o->book->rules;
    murk_cover_clear(&b->cover, o->layout);
    murk_standing_clear(&b->fixed, n);
    for (size_t k = 0; k < rules->fixed_count; ++k) {
        const uint32_t j = (uint32_t)rules->fixed[k];
        const murk_row row = murk_oracle_row(o, 0, j);
        b->looks += o->matrix ? 0 : 1;
        murk_cover_add(&b->cover, o->layout, &row);
        murk_standing_add(&b->fixed, j);
    }
    b->standing = &b->fixed;
    b->live_count = 0;
    for (size_t k = 0; k < o->needed_count; ++k) {
        if (murk_standing_admits(&b->fixed, o->needed[k].candidate, false)) {
            b->live[b->live_count++] = o->needed[k].candidate;
        }
    }
    raise_to(b, &b->cover);
    return descend(b, n - b->fixed.size, lower, rounds);
}

uint64_t murk_bound_tighten(murk_bound *b, size_t n, uint64_t lower,
                            const uint32_t *plan, size_t plan_count,
                            size_t rounds)
{
    const murk_oracle *o = b->oracle;
    if (plan) {
        start_at_plan(b, plan, plan_count);
    }
    b->standing = NULL;
    if (o->book) {
        return tighten_by_rules(b, n, lower, rounds);
    }
    raise_to(b, NULL);
    b->live_count = o->needed_count;
    for (size_t k = 0; k < o->needed_count; ++k) {
        b->live[k] = o->needed[k].candidate;
    }
    return descend(b, n, lower, rounds);
}

uint64_t murk_bound_tighten_within(murk_bound *b, size_t n, uint64_t lower,
                                   const murk_cover *stand, size_t rounds)
{
    raise_to(b, stand);
    return descend(b, n, lower, rounds);
}

size_t murk_bound_top(murk_bound *b, size_t n, uint32_t *top)
{
    size_t chosen = 0;
    b->base = murk_thresholds_take(&b->thresholds, b->threshold);
    murk_thresholds_gains(&b->thresholds, b->live, b->live_count, b->gain);
    b->evaluations += b->live_count;
    sum_top(b, n, &chosen);
    for (size_t k = 0; k < chosen; ++k) {
        top[k] = b->top[k].candidate;
    }
    return chosen;
}
