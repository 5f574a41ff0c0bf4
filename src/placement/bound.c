/* The volume algorithm for the Lagrangian bound of placement/bound.h.
 * Multipliers start at the entries of a given plan, or at the multipliers of
 * the last call, and go down the weighted mean of all subgradients. Every
 * evaluation is a valid bound, so the lowest one counts, and the descent may
 * stop at any point. */
#include "placement/bound.h"

#include "base/interrupt.h"

#include <math.h>
#include <string.h>

/* A step starts at the multipliers of the lowest bound and goes down the mean
 * of the subgradients. The length is Polyak's, which aims at the value of the
 * best known plan, times a factor. The factor is multiplied by `grow` after
 * each step that lowers the bound, and by `shrink` after `patience` rounds
 * without gain. The share of the last subgradient in the mean is alike / (alike
 * + round) at first, but not below LATER_SHARE. */
typedef struct descent_rule {
    double first, grow, shrink;
    size_t patience;
    double alike;
} descent_rule;

/* For many rounds: values of the kind that Barahona and Anbil (2000) give for
 * the volume algorithm. For few: as close after 16 rounds as the others after
 * 40, and closer after 100, in the halls of scenes/ (a choice among some twenty
 * that were tried). */
static const descent_rule of_many = {.5, 1.1, .66, 5, 3},
                          of_few = {.4, 1.1, .65, 1, 1};

/* Steps with a factor below this no longer change the bound noticeably. */
#define MIN_STEP 1e-4

/* The smallest share of the last subgradient in the mean, which is multiplied
 * by .8 every 50 rounds, so that the mean settles. */
#define LATER_SHARE     0.03
#define ROUNDS_PER_FALL 50
#define FALL            0.8

/* Subgradients are rounded to these units where a sum must not depend on the
 * order of addition. The maximum keeps a weighted square within 64 bits. */
#define SUBGRADIENT_UNIT 0x1p-10F
#define SUBGRADIENT_MAX  63.0F

murk_status murk_bound_init(murk_bound *out, const murk_evaluator *evaluator,
                            murk_error *err)
{
    const size_t slots = evaluator->layout->slots + 1;
    const size_t n = evaluator->candidates + 1;
    *out = (murk_bound){.evaluator = evaluator};
    murk_arena *arena = &out->arena;
    out->multiplier = murk_arena_array(arena, slots, sizeof *out->multiplier);
    out->lowest = murk_arena_array(arena, slots, sizeof *out->lowest);
    out->mean = murk_arena_array(arena, slots, sizeof *out->mean);
    out->subgradient = murk_arena_array(arena, slots, sizeof *out->subgradient);
    out->gain = murk_arena_array(arena, n, sizeof *out->gain);
    out->live = murk_arena_array(arena, n, sizeof *out->live);
    out->top = murk_arena_array(arena, n, sizeof *out->top);
    murk_status status =
        murk_multipliers_init(&out->multipliers, evaluator, err);
    if (!status && (arena->is_short ||
                    !murk_cover_init(&out->cover, evaluator->layout, false))) {
        status = murk_no_memory(err, "", "to bound plans for %zu photons",
                                evaluator->layout->photons);
    }
    /* Constraints need a relaxation and the partial plan of the fixed sensors.
     */
    if (!status && evaluator->set) {
        status = murk_relaxation_init(&out->relaxed, evaluator->set, err);
    }
    if (!status && evaluator->set) {
        status = murk_partial_plan_init(&out->fixed, evaluator->set, err);
    }
    if (status) {
        murk_bound_release(out);
    }
    return status;
}

void murk_bound_release(murk_bound *bound)
{
    murk_multipliers_release(&bound->multipliers);
    murk_cover_release(&bound->cover);
    murk_relaxation_release(&bound->relaxed);
    murk_partial_plan_release(&bound->fixed);
    murk_arena_release(&bound->arena);
    *bound = (murk_bound){0};
}

static void add_to_cover(murk_bound *b, uint32_t candidate)
{
    const murk_row row = murk_evaluator_row(b->evaluator, 0, candidate);
    b->queries += b->evaluator->matrix ? 0 : 1;
    murk_cover_add(&b->cover, b->evaluator->layout, &row);
}

/* The multipliers start at the cover of plan[n]. */
static void start_at_plan(murk_bound *b, const uint32_t *plan, size_t n)
{
    const murk_layout *layout = b->evaluator->layout;
    murk_cover_clear(&b->cover, layout);
    for (size_t k = 0; k < n; ++k) {
        add_to_cover(b, plan[k]);
    }
    for (size_t i = 0; i < layout->slots; ++i) {
        b->multiplier[i] = b->cover.best[i];
    }
}

/* Fills b->top with the n live candidates of the largest gain, by falling gain;
 * on ties the candidate that comes first in live[]. Returns their number, which
 * is below n if fewer are live. */
static size_t find_top(murk_bound *b, size_t n)
{
    size_t found = 0;
    for (size_t k = 0; k < b->live_count; ++k) {
        const murk_ranked now = {b->gain[k], b->live[k]};
        if (found == n && now.bound <= b->top[n - 1].bound) {
            continue;
        }
        size_t at = found < n ? found++ : n - 1;
        for (; at > 0 && b->top[at - 1].bound < now.bound; --at) {
            b->top[at] = b->top[at - 1];
        }
        b->top[at] = now;
    }
    return found;
}

/* Fixes candidates out by the last evaluation: a plan with candidate j is worth
 * at most b->base, the n - 1 largest other gains (with constraints: a
 * relaxation of them), and the gain of j. If that does not exceed `lower`, j
 * belongs to no better plan. Does nothing if, without constraints, fewer than n
 * candidates are live. */
static void fix_candidates(murk_bound *b, size_t n, size_t chosen,
                           uint64_t lower)
{
    if (!b->partial && chosen < n) {
        return;
    }
    uint64_t others = 0;
    for (size_t k = 0; !b->partial && k + 1 < n; ++k) {
        others = murk_sum_saturated(others, b->top[k].bound);
    }
    /* Without constraints the candidates of the n largest gains always stay. */
    const uint64_t last = b->partial ? UINT64_MAX : b->top[n - 1].bound;
    size_t remaining = 0;
    for (size_t k = 0; k < b->live_count; ++k) {
        if (b->partial) {
            others =
                murk_relaxation_others(&b->relaxed, b->partial, b->live[k]);
        }
        const uint64_t with =
            murk_sum_saturated(b->base, murk_sum_saturated(others, b->gain[k]));
        if (b->gain[k] >= last || with - with % b->evaluator->grain > lower) {
            b->live[remaining] = b->live[k];
            b->gain[remaining++] = b->gain[k];
        }
    }
    b->live_count = remaining;
}

static const descent_rule *rule_of(const murk_bound *b)
{
    return b->is_quick ? &of_few : &of_many;
}

/* The share of the subgradient of this round in the mean. */
static double share_of(const descent_rule *rule, size_t round)
{
    const double early = rule->alike / (rule->alike + (double)round);
    const double late =
        LATER_SHARE * pow(FALL, (double)(round / ROUNDS_PER_FALL));
    return early > late ? early : late;
}

/* Resets mean and step, but not the multipliers. */
static void begin_descent(murk_bound *b)
{
    memset(b->mean, 0, b->evaluator->layout->slots * sizeof *b->mean);
    b->round = b->since_gain = 0;
    b->step = rule_of(b)->first;
}

/* Adds the present subgradient to the mean. */
static void update_mean(murk_bound *b, size_t chosen)
{
    const size_t slots = b->evaluator->layout->slots;
    const float share = (float)share_of(rule_of(b), b->round++);
    b->queries += b->evaluator->matrix ? 0 : chosen;
    murk_multipliers_subgradient(&b->multipliers, b->top, chosen,
                                 b->subgradient);
    float *restrict mean = b->mean;
    const float *restrict subgradient = b->subgradient;
    for (size_t i = 0; i < slots; ++i) {
        mean[i] += share * (subgradient[i] - mean[i]);
    }
}

/* Replaces the subgradient by the direction of the step: the mean, projected,
 * which is 0 if a step would leave the range of the multiplier. Written without
 * branches, like the loops below, so that compilers use vector registers. */
static void project_mean(murk_bound *b)
{
    const size_t slots = b->evaluator->layout->slots;
    const float *restrict mean = b->mean, *restrict lowest = b->lowest;
    const uint16_t *restrict min = b->multipliers.floor;
    float *restrict direction = b->subgradient;
    for (size_t i = 0; i < slots; ++i) {
        const float low = (float)(int)min[i] + 0.5F;
        const float down = lowest[i] < low ? 0 : mean[i];
        const float up = lowest[i] > MURK_CLEAR - 0.5F ? 0 : mean[i];
        direction[i] = mean[i] > 0 ? down : up;
    }
}

/* The sum over the slots of weight times the square of the direction, added in
 * whole numbers: the result is the same for any order of the slots, and whether
 * or not photons with equal columns are merged. */
static double squared_norm(const murk_bound *b)
{
    const murk_layout *layout = b->evaluator->layout;
    const float *direction = b->subgradient;
    const uint32_t *weight = layout->weight;
    const float max = SUBGRADIENT_MAX / SUBGRADIENT_UNIT;
    uint64_t low = 0, high = 0;
    for (size_t i = 0; i < layout->slots; ++i) {
        const float size = fabsf(direction[i]) / SUBGRADIENT_UNIT;
        const float rounded = size + 0.5F;
        /* At most 2^16, so the square fits 32 bits; an int, because processors
         * convert to signed numbers faster. */
        const int whole = (int)(size < max ? rounded : max);
        const uint32_t square = (uint32_t)whole * (uint32_t)whole;
        const uint64_t term = (uint64_t)weight[i] * square;
        low += term & UINT32_MAX;
        high += term >> 32;
    }
    high += low >> 32;
    low &= UINT32_MAX;
    return ((double)high * 0x1p32 + (double)low) * (double)SUBGRADIENT_UNIT *
           (double)SUBGRADIENT_UNIT;
}

/* One projected step from the multipliers of the lowest bound. The step divides
 * by squared_norm(), in which each multiplier counts by the weight of the
 * photon, so merging photons with equal columns changes nothing. */
static void take_step(murk_bound *b, double excess)
{
    project_mean(b);
    const double square = squared_norm(b);
    const float length = square > 0 ? (float)(b->step * excess / square) : 0;
    const size_t slots = b->evaluator->layout->slots;
    const float *restrict direction = b->subgradient;
    const float *restrict lowest = b->lowest;
    const uint16_t *restrict floor = b->multipliers.floor;
    float *restrict multiplier = b->multiplier;
    for (size_t i = 0; i < slots; ++i) {
        const float min = (float)(int)floor[i];
        const float to = lowest[i] - length * direction[i];
        const float above = to > min ? to : min;
        multiplier[i] = to > MURK_CLEAR ? MURK_CLEAR : above;
    }
}

/* The largest sum of gains that n live candidates can have, plus b->base; with
 * constraints an upper bound on that sum. b->top[chosen] make the result. */
static uint64_t sum_top(murk_bound *b, size_t n, size_t *chosen)
{
    if (b->partial) {
        return murk_sum_saturated(
            b->base,
            murk_relaxation_top(&b->relaxed, b->partial, b->live, b->gain,
                                b->live_count, b->top, chosen));
    }
    *chosen = find_top(b, n);
    uint64_t sum = b->base;
    for (size_t k = 0; k < *chosen; ++k) {
        sum = murk_sum_saturated(sum, b->top[k].bound);
    }
    return sum;
}

/* The bound at the present multipliers; b->top[chosen] make it. */
static uint64_t evaluate(murk_bound *b, size_t n, size_t *chosen)
{
    b->base = murk_multipliers_set(&b->multipliers, b->multiplier);
    if (b->partial) { /* less the moves that the partial plan has made */
        b->base =
            murk_less_moves(b->partial->set, b->base,
                            murk_moves_with(b->partial, b->partial->newcomers));
    }
    murk_multipliers_gains(&b->multipliers, b->live, b->live_count, b->gain);
    b->evaluations += b->live_count;
    b->queries += b->evaluator->matrix ? 0 : b->live_count;
    return sum_top(b, n, chosen);
}

/* Lowers the bound over the live candidates. */
static uint64_t descend(murk_bound *b, size_t n, uint64_t lower, size_t rounds)
{
    const murk_evaluator *o = b->evaluator;
    const descent_rule *rule = rule_of(b);
    const size_t slots = o->layout->slots;
    uint64_t upper = o->ceiling, lowest = UINT64_MAX;
    size_t chosen = 0;
    memcpy(b->lowest, b->multiplier, slots * sizeof *b->lowest);
    for (size_t round = 0; round < rounds && upper > lower; ++round) {
        if (murk_must_finish() || (round > 0 && b->step < MIN_STEP)) {
            break;
        }
        uint64_t now = evaluate(b, n, &chosen);
        /* If the bound has fallen, store the multipliers and lengthen the step.
         * Otherwise shorten the step in time. */
        if (now < lowest) {
            b->step *= lowest < UINT64_MAX ? rule->grow : 1;
            lowest = now;
            b->since_gain = 0;
            memcpy(b->lowest, b->multiplier, slots * sizeof *b->lowest);
        } else if (++b->since_gain >= rule->patience) {
            b->step *= rule->shrink;
            b->since_gain = 0;
        }
        /* Plans with candidates that were fixed out are worth at most `lower`,
         * so the larger of `now` and `lower` bounds all plans. */
        now -= now % o->grain;
        now = now > lower ? now : lower;
        upper = now < upper ? now : upper;
        if (upper <= lower) {
            break;
        }
        if (round + 1 == rounds && !b->multipliers.partial) {
            break;
        }
        /* Fix candidates out, then step. */
        fix_candidates(b, n, chosen, lower);
        if (round + 1 < rounds) {
            update_mean(b, chosen);
            take_step(b, (double)(lowest - lower));
        }
    }
    /* Within a partial plan the caller needs gains at the lowest bound. */
    if (b->multipliers.partial && upper > lower && rounds > 0) {
        memcpy(b->multiplier, b->lowest, slots * sizeof *b->multiplier);
        evaluate(b, n, &chosen);
        fix_candidates(b, n, chosen, lower);
    }
    memcpy(b->multiplier, b->lowest, slots * sizeof *b->multiplier);
    return upper > lower ? upper : lower;
}

static void set_partial_plan(murk_bound *b, const murk_cover *partial)
{
    murk_multipliers_set_partial_plan(&b->multipliers, partial);
    for (size_t i = 0; partial && i < b->evaluator->layout->slots; ++i) {
        const float min = b->multipliers.floor[i];
        b->multiplier[i] = b->multiplier[i] > min ? b->multiplier[i] : min;
    }
}

/* The fixed sensors form the partial plan; live are the candidates that can be
 * added. */
static uint64_t tighten_by_constraints(murk_bound *b, size_t n, uint64_t lower,
                                       size_t rounds)
{
    const murk_evaluator *o = b->evaluator;
    const murk_constraints *constraints = o->set->constraints;
    murk_cover_clear(&b->cover, o->layout);
    murk_partial_plan_clear(&b->fixed, n);
    for (size_t k = 0; k < constraints->fixed_count; ++k) {
        const uint32_t j = (uint32_t)constraints->fixed[k];
        add_to_cover(b, j);
        murk_partial_plan_add(&b->fixed, j);
    }
    b->partial = &b->fixed;
    b->live_count = 0;
    for (size_t k = 0; k < o->presolved_count; ++k) {
        if (murk_partial_plan_can_add(&b->fixed, o->presolved[k].candidate,
                                      false)) {
            b->live[b->live_count++] = o->presolved[k].candidate;
        }
    }
    set_partial_plan(b, &b->cover);
    return descend(b, n - b->fixed.size, lower, rounds);
}

uint64_t murk_bound_tighten(murk_bound *b, size_t n, uint64_t lower,
                            const uint32_t *plan, size_t plan_count,
                            size_t rounds)
{
    const murk_evaluator *o = b->evaluator;
    if (plan) {
        start_at_plan(b, plan, plan_count);
    }
    if (plan || b->last_count != n) {
        begin_descent(b);
    }
    b->last_count = n;
    b->partial = NULL;
    if (o->set) {
        return tighten_by_constraints(b, n, lower, rounds);
    }
    set_partial_plan(b, NULL);
    b->live_count = o->presolved_count;
    for (size_t k = 0; k < o->presolved_count; ++k) {
        b->live[k] = o->presolved[k].candidate;
    }
    return descend(b, n, lower, rounds);
}

uint64_t murk_bound_tighten_within(murk_bound *b, size_t n, uint64_t lower,
                                   const murk_cover *partial, size_t rounds)
{
    set_partial_plan(b, partial);
    if (b->last_count != n) {
        begin_descent(b);
    }
    b->last_count = 0;
    return descend(b, n, lower, rounds);
}

size_t murk_bound_top(murk_bound *b, size_t n, uint32_t *top)
{
    size_t chosen = 0;
    b->base = murk_multipliers_set(&b->multipliers, b->multiplier);
    murk_multipliers_gains(&b->multipliers, b->live, b->live_count, b->gain);
    b->evaluations += b->live_count;
    sum_top(b, n, &chosen);
    for (size_t k = 0; k < chosen; ++k) {
        top[k] = b->top[k].candidate;
    }
    return chosen;
}
