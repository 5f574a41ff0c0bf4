/* Evaluates the Lagrangian bound at given multipliers, and the subgradient, for
 * redundancy and for detection probabilities (formulas:
 * placement/multipliers.h). For redundancy the second sum is an ordinary gain
 * over a cover that holds the multipliers; for probabilities rows are summed
 * with 128-bit integers. */
#include "placement/multipliers.h"

#include <string.h>

/* weight * clarity * dose: at most 47, 16 and 25 bits together. */
__extension__ typedef unsigned __int128 wide;

/* Converts a sum in units of 1 / MURK_DOSE_ONE to whole units, rounded up. */
static uint64_t in_whole(wide sum)
{
    return (uint64_t)((sum + MURK_DOSE_ONE - 1) / MURK_DOSE_ONE);
}

murk_status murk_multipliers_init(murk_multipliers *out,
                                  const murk_evaluator *evaluator,
                                  murk_error *err)
{
    const size_t slots = evaluator->layout->slots + 1;
    *out = (murk_multipliers){.evaluator = evaluator};
    murk_arena *arena = &out->arena;
    out->floor = murk_arena_array(arena, slots, sizeof *out->floor);
    out->count = murk_arena_array(arena, slots, sizeof *out->count);
    if (evaluator->layout->doses) {
        out->factor = murk_arena_array(arena, slots, sizeof *out->factor);
        out->max = murk_arena_array(arena, slots, sizeof *out->max);
        out->drawn = murk_arena_array(arena, slots, sizeof *out->drawn);
    }
    if (murk_evaluator_asks_parts(evaluator)) {
        out->entry_max = murk_arena_array(arena, slots, sizeof *out->entry_max);
    }
    if (arena->is_short ||
        !murk_cover_init_single(&out->rounded, evaluator->layout, false)) {
        murk_multipliers_release(out);
        return murk_no_memory(err, "", "to bound plans for %zu photons",
                              evaluator->layout->photons);
    }
    return MURK_OK;
}

void murk_multipliers_release(murk_multipliers *t)
{
    murk_cover_release(&t->rounded);
    murk_arena_release(&t->arena);
    *t = (murk_multipliers){0};
}

/* The smallest clarity t whose y = -ln(1 - t), rounded down, is not below the
 * dose. */
static uint16_t clarity_above(const murk_doses *doses, uint32_t dose)
{
    uint16_t t = murk_dose_worth(doses, dose);
    while (doses->below[t] < dose) {
        ++t;
    }
    return t;
}

void murk_multipliers_set_partial_plan(murk_multipliers *t,
                                       const murk_cover *partial)
{
    const murk_layout *layout = t->evaluator->layout;
    t->partial = partial;
    for (size_t i = 0; i < layout->slots; ++i) {
        t->floor[i] = !partial ? 0
                      : partial->dose
                          ? clarity_above(layout->doses, partial->dose[i])
                          : partial->best[i];
    }
}

/* The first sum for redundancy: the sum over photons and layers of weight times
 * the larger of the layer's clarity in the partial plan and the multiplier. The
 * lowest layer is at most the multiplier, so the multiplier itself counts
 * there. */
static uint64_t weigh_clearest(const murk_multipliers *t)
{
    const murk_layout *layout = t->evaluator->layout;
    const uint16_t *at = t->rounded.best;
    uint64_t sum = 0;
    for (size_t i = 0; i < layout->slots; ++i) {
        sum += (uint64_t)at[i] * layout->weight[i];
    }
    for (size_t k = 1; k < layout->layers; ++k) {
        const uint16_t *layer =
            t->partial ? t->partial->best + k * layout->slots : NULL;
        for (size_t i = 0; i < layout->slots; ++i) {
            const uint16_t view = layer && layer[i] > at[i] ? layer[i] : at[i];
            sum += (uint64_t)view * layout->weight[i];
        }
    }
    return sum;
}

/* The first sum for detection probabilities, sum w (1 - (1 - t) (1 + y - Y0))
 * (symbols: placement/multipliers.h), rounded up. Also sets factor[] and max[],
 * which weigh_row() needs. */
static uint64_t weigh_chances(murk_multipliers *t)
{
    const murk_layout *layout = t->evaluator->layout;
    wide sum = 0;
    for (size_t i = 0; i < layout->slots; ++i) {
        const uint16_t clarity = t->rounded.best[i];
        const uint64_t rest = (uint64_t)(MURK_CLEAR - clarity);
        const uint32_t present = t->partial ? t->partial->dose[i] : 0;
        const uint64_t range =
            MURK_DOSE_ONE + layout->doses->below[clarity] - present;
        const uint64_t base =
            (uint64_t)MURK_CLEAR * MURK_DOSE_ONE - rest * range;
        sum += (wide)base * layout->weight[i];
        t->factor[i] = rest * layout->weight[i];
        t->max[i] = (uint32_t)range + 1;
    }
    return in_whole(sum);
}

uint64_t murk_multipliers_set(murk_multipliers *t, const float *multiplier)
{
    const size_t slots = t->evaluator->layout->slots;
    uint16_t *restrict rounded = t->rounded.best;
    for (size_t i = 0; i < slots; ++i) {
        rounded[i] = (uint16_t)(int)(multiplier[i] + 0.5F);
    }
    return t->factor ? weigh_chances(t) : weigh_clearest(t);
}

/* A task for the thread pool: terms of candidates. */
typedef struct evaluation {
    const murk_multipliers *multipliers;
    const uint32_t *candidate;
    uint64_t *gain;
} evaluation;

/* The term of one row in the second sum for detection probabilities: sum w (1 -
 * t) min(d, 1 + y - Y0) (symbols: placement/multipliers.h), rounded up. */
static void weigh_row(void *context, unsigned worker, uint64_t batch)
{
    const evaluation *w = context;
    const murk_multipliers *t = w->multipliers;
    const murk_layout *layout = t->evaluator->layout;
    murk_row row;
    wide sum = 0;
    size_t i;
    uint16_t p;
    w->gain[batch] = 0;
    if (!murk_evaluator_own_row(&row, t->evaluator, worker,
                                w->candidate[batch])) {
        return;
    }
    for (murk_row_walk walk = murk_row_begin(layout, &row);
         murk_row_next(&walk, &i, &p);) {
        const uint32_t dose = layout->doses->of[p];
        sum += (wide)t->factor[i] * (dose < t->max[i] ? dose : t->max[i]);
    }
    w->gain[batch] = in_whole(sum);
}

void murk_multipliers_gains(murk_multipliers *t, const uint32_t *candidate,
                            size_t n, uint64_t *gain)
{
    if (!t->factor) {
        const murk_row_need need = {t->entry_max, 0};
        if (t->entry_max) {
            murk_evaluator_bound_entries(t->evaluator, &t->rounded,
                                         t->entry_max);
        }
        murk_evaluator_needed_gains(t->evaluator, &t->rounded, candidate, n,
                                    t->evaluator->problem->threads, 0,
                                    t->entry_max ? &need : NULL, gain);
        return;
    }
    evaluation w = {t, candidate, gain};
    murk_evaluator_run(t->evaluator, n, weigh_row, &w);
    murk_evaluator_complete(t->evaluator, gain, n);
}

/* The number of the partial plan's k entries for this slot that the multiplier
 * replaces in the first sum: those that do not exceed the multiplier. The
 * lowest entry never exceeds it. */
static size_t layers_below(const murk_multipliers *t, size_t slot)
{
    const murk_layout *layout = t->evaluator->layout;
    size_t n = layout->layers;
    for (size_t k = 1; t->partial && k < layout->layers; ++k) {
        n -= t->partial->best[k * layout->slots + slot] > t->rounded.best[slot];
    }
    return n;
}

static void subgradient_of_clearest(murk_multipliers *t,
                                    const murk_ranked *chosen, size_t n,
                                    float *subgradient)
{
    const murk_layout *layout = t->evaluator->layout;
    memset(t->count, 0, layout->slots * sizeof *t->count);
    for (size_t k = 0; k < n; ++k) {
        const murk_row row =
            murk_evaluator_row(t->evaluator, 0, chosen[k].candidate);
        murk_row_count_above(layout, &row, t->rounded.best, t->count);
    }
    for (size_t i = 0; layout->layers > 1 && i < layout->slots; ++i) {
        subgradient[i] = (float)layers_below(t, i) - (float)t->count[i];
    }
    for (size_t i = 0; layout->layers == 1 && i < layout->slots; ++i) {
        subgradient[i] = 1 - (float)t->count[i];
    }
}

/* The subgradient by the multipliers t; all derivatives are divided by the
 * weights, and dy/dt = 1 / (1 - t), because y = -ln(1 - t). d is the dose of a
 * row, and Y0 that of the partial plan (placement/multipliers.h). The first
 * sum, whose terms are 1 - (1 - t) (1 + y - Y0), has the derivative y - Y0. The
 * term (1 - t) min(d, 1 + y - Y0) of a row has the derivative -d, or -(y - Y0)
 * if d exceeds 1 + y - Y0. */
static void subgradient_of_chances(murk_multipliers *t,
                                   const murk_ranked *chosen, size_t n,
                                   float *subgradient)
{
    const murk_layout *layout = t->evaluator->layout;
    memset(t->drawn, 0, layout->slots * sizeof *t->drawn);
    for (size_t k = 0; k < n; ++k) {
        const murk_row row =
            murk_evaluator_row(t->evaluator, 0, chosen[k].candidate);
        size_t i;
        uint16_t p;
        for (murk_row_walk walk = murk_row_begin(layout, &row);
             murk_row_next(&walk, &i, &p);) {
            const uint32_t dose = layout->doses->of[p];
            t->drawn[i] +=
                (float)(dose < t->max[i] ? dose
                                         : t->max[i] - 1 - MURK_DOSE_ONE);
        }
    }
    for (size_t i = 0; i < layout->slots; ++i) {
        const float above = (float)(t->max[i] - 1 - MURK_DOSE_ONE);
        subgradient[i] = (above - t->drawn[i]) / (float)MURK_DOSE_ONE;
    }
}

void murk_multipliers_subgradient(murk_multipliers *t,
                                  const murk_ranked *chosen, size_t n,
                                  float *subgradient)
{
    if (t->factor) {
        subgradient_of_chances(t, chosen, n, subgradient);
    } else {
        subgradient_of_clearest(t, chosen, n, subgradient);
    }
}
