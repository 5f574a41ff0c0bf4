/* The best plan of one count for the worst block. Greedy climbs towards a level
 * in every block, and bisection finds the highest level that greedy reaches
 * (SATURATE). Relocation, greedy on each block, random starts and branch and
 * bound follow, by method. */
#include "placement/worst_count.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "placement/exact.h"

#include <string.h>

/* Bisection steps between the incumbent and the bound, and the finest step:
 * 2^-16 of full coverage, the resolution of a clarity. */
#define LEVELS_MAX   16
#define LEVEL_FINEST (MURK_SHARE_ONE >> 16)

/* Random starts in a row without gain that end them, as in
 * placement/settings.h. */
#define STARTS_WITHOUT_GAIN 20

/* Steps of lambda, and evaluations of the bound at each (choices); a count
 * below the wanted one gets fewer. */
#define STEPS       60
#define STEPS_CURVE 15
#define ROUNDS      8
#define ROUNDS_LAST 100

/* ---- plans ---- */

static bool is_plan(murk_worst_run *w, const uint32_t *plan, size_t size,
                    size_t n)
{
    if (!w->set) {
        return size == n;
    }
    murk_partial_plan *s = &w->search.partial;
    murk_partial_plan_clear(s, w->set->has_budget ? w->set->max_sensors : n);
    for (size_t k = 0; k < size; ++k) {
        murk_partial_plan_add(s, plan[k]);
    }
    return murk_partial_plan_is_complete(s);
}

/* Stores trial[search.size] if it is a complete plan and better than the
 * incumbent. */
static bool keep_better(murk_worst_run *w, size_t n, uint64_t value)
{
    const size_t size = w->search.size;
    if ((w->has_plan && value <= w->value) || !is_plan(w, w->trial, size, n)) {
        return false;
    }
    memcpy(w->plan, w->trial, size * sizeof *w->plan);
    w->size = size;
    w->value = value;
    w->has_plan = true;
    return true;
}

/* Stores trial as it is, and relocated. */
static bool relocate_and_keep(murk_worst_run *w, size_t n, uint64_t value)
{
    if (!is_plan(w, w->trial, w->search.size, n)) {
        return false;
    }
    bool is_better = keep_better(w, n, value);
    value = murk_worst_relocate(&w->search, w->trial, w->search.size);
    is_better |= keep_better(w, n, value);
    return is_better;
}

static bool relocates(const murk_worst_run *w)
{
    return w->desc->method == MURK_PLACE_BEST;
}

/* Greedy for one objective. */
static void greedy_and_keep(murk_worst_run *w, const murk_block_objective *by,
                            size_t n)
{
    const uint64_t value = murk_worst_greedy(&w->search, by, w->trial, 0, n);
    if (relocates(w)) {
        relocate_and_keep(w, n, value);
    } else {
        keep_better(w, n, value);
    }
}

/* Greedy towards one level in every block; MURK_NO_LEVEL: for the mean. */
static void greedy_to_level(murk_worst_run *w, size_t n, uint64_t level)
{
    murk_block_objective by = {.level = level};
    for (size_t c = 0; c < w->blocks; ++c) {
        by.factor[c] = 1;
    }
    greedy_and_keep(w, &by, n);
}

/* Bisection for the highest level that greedy reaches in every block. */
static void saturate(murk_worst_run *w, size_t n)
{
    greedy_to_level(w, n, MURK_NO_LEVEL);
    uint64_t low = w->has_plan ? w->value : 0, high = w->upper;
    for (int k = 0; k < LEVELS_MAX && high > low && high - low > LEVEL_FINEST &&
                    !murk_interrupted();
         ++k) {
        const uint64_t level = low + (high - low) / 2;
        greedy_to_level(w, n, level);
        if (w->has_plan && w->value >= level) {
            low = w->value;
        } else {
            high = level;
        }
    }
}

static void greedy_per_block(murk_worst_run *w, size_t n)
{
    for (size_t c = 0; c < w->blocks && !murk_interrupted(); ++c) {
        murk_block_objective by = {.level = MURK_NO_LEVEL};
        by.factor[c] = 1;
        greedy_and_keep(w, &by, n);
    }
}

/* With a budget: greedy by gain per cost, over the mean of the blocks. */
static void greedy_with_budget(murk_worst_run *w, size_t n)
{
    if (w->set && w->set->has_budget) {
        murk_search_budget_greedy(&w->search.draw, w->trial, 0);
        w->search.size = w->search.draw.size;
        relocate_and_keep(
            w, n, murk_worst_value(&w->search, w->trial, w->search.size));
    }
}

static void draw(murk_worst_run *w, size_t n, uint64_t restart)
{
    murk_worst_draw(&w->search, w->trial, n, w->desc->seed, restart);
}

static void try_starts(murk_worst_run *w, size_t n, size_t max)
{
    size_t without_gain = 0;
    for (size_t k = 0; k < max && without_gain < STARTS_WITHOUT_GAIN &&
                       w->value < w->upper && !murk_interrupted();
         ++k) {
        draw(w, n, k);
        ++without_gain;
        ++w->result->restarts;
        if (relocate_and_keep(
                w, n, murk_worst_value(&w->search, w->trial, w->search.size))) {
            without_gain = 0;
        }
        murk_progress_add(1);
    }
}

/* ---- branch and bound ---- */

/* Callback of branch and bound: stores a plan of larger smallest worth, and
 * raises the cutoff. */
static uint64_t check_plan(void *context, const uint32_t *plan, size_t size,
                           uint64_t known)
{
    murk_worst_run *w = context;
    const uint64_t value = murk_worst_value(&w->search, plan, size);
    if (w->has_plan && value <= w->value) {
        return known;
    }
    memcpy(w->plan, plan, size * sizeof *plan);
    w->size = size;
    w->value = value;
    w->has_plan = true;
    return murk_worst_bound_value(&w->bound, value);
}

murk_status murk_worst_branch_and_bound(murk_worst_run *w, size_t n,
                                        murk_error *err)
{
    const bool is_wanted = w->desc->method == MURK_PLACE_BEST ||
                           w->desc->method == MURK_PLACE_EXACT;
    if (!is_wanted || w->value >= w->upper) {
        return MURK_OK;
    }
    const murk_exact_callback by = {check_plan, w};
    murk_exact exact;
    const murk_status status =
        murk_exact_search(&exact, &w->bound.bound, w->plan, w->size, n,
                          murk_worst_bound_value(&w->bound, w->value),
                          w->bound.evaluator.ceiling, w->desc->nodes, &by, err);
    if (status) {
        return status;
    }
    w->result->nodes += exact.nodes;
    w->result->is_cut = exact.is_cut;
    const uint64_t upper = murk_worst_bound_share(&w->bound, exact.upper);
    w->upper = upper < w->upper ? upper : w->upper;
    if (w->set) { /* the incumbent may have to be completed */
        const murk_block_objective min = {.is_min = true};
        memcpy(w->trial, w->plan, w->size * sizeof *w->plan);
        w->value = murk_worst_greedy(&w->search, &min, w->trial, w->size, n);
        w->size = w->search.size;
        memcpy(w->plan, w->trial, w->size * sizeof *w->plan);
    }
    w->upper = w->upper > w->value ? w->upper : w->value;
    return MURK_OK;
}

/* ---- one count ---- */

/* With conflicts: finds any feasible plan of n. */
static murk_status find_fallback(murk_worst_run *w, size_t n, murk_error *err)
{
    /* Complete a plan of the fixed sensors with any candidates. */
    if (!w->set || !w->set->has_conflicts) {
        return MURK_OK;
    }
    murk_partial_plan *partial = &w->search.partial;
    bool is_sure;
    murk_partial_plan_clear(partial, n);
    for (size_t k = 0; k < w->set->constraints->fixed_count; ++k) {
        murk_partial_plan_add(partial, (uint32_t)w->set->constraints->fixed[k]);
    }
    if (!murk_partial_plan_complete(partial, &is_sure)) {
        return murk_interrupted()
                   ? MURK_OK
                   : murk_fail(err, MURK_RUN_FAILED, "",
                               is_sure ? "no plan: no %zu of %zu usable "
                                         "candidates keep all rules"
                                       : "no plan found: of %zu sensors at "
                                         "%zu usable candidates that keeps "
                                         "all rules",
                               n, w->evaluator.candidates);
    }
    w->search.fallback_size = partial->size;
    memcpy(w->fallback, partial->member, partial->size * sizeof *w->fallback);
    w->search.fallback = w->fallback;
    return MURK_OK;
}

uint64_t murk_worst_ceiling(const murk_worst_run *w)
{
    uint64_t min = UINT64_MAX;
    for (size_t c = 0; c < w->blocks; ++c) {
        const uint64_t share =
            murk_block_worth(&w->layouts, c, w->layouts.ceiling[c]);
        min = share < min ? share : min;
    }
    return min;
}

/* Makes the first plans: by the method, or any plan; and the plan of one sensor
 * fewer with one more. */
static void begin(murk_worst_run *w, size_t n, const uint32_t *from)
{
    const murk_place_method method = w->desc->method;
    if (method == MURK_PLACE_SPOQ) {
        draw(w, n, 0);
        ++w->result->restarts;
        relocate_and_keep(
            w, n, murk_worst_value(&w->search, w->trial, w->search.size));
    } else if (w->desc->target) {
        greedy_to_level(w, n, w->desc->target);
    } else {
        saturate(w, n);
        greedy_with_budget(w, n);
    }
    if (!w->has_plan) { /* constraints stopped greedy early */
        memcpy(w->trial, w->fallback,
               w->search.fallback_size * sizeof *w->trial);
        w->search.size = w->search.fallback_size;
        relocate_and_keep(
            w, n, murk_worst_value(&w->search, w->trial, w->search.size));
    }
    if (from && method == MURK_PLACE_BEST) {
        const murk_block_objective min = {.is_min = true};
        memcpy(w->trial, from, (n - 1) * sizeof *from);
        const uint64_t value =
            murk_worst_greedy(&w->search, &min, w->trial, n - 1, n);
        relocate_and_keep(w, n, value);
    }
}

/* With a target: decides whether n sensors may reach it, by a bound that is
 * lowered no further than that takes. */
static murk_status test_target(murk_worst_run *w, size_t n, bool *may_reach,
                               murk_error *err)
{
    const uint64_t below = w->desc->target - 1;
    *may_reach = true;
    if (!w->desc->target || w->value > below) {
        return MURK_OK;
    }
    uint64_t upper = w->upper;
    const murk_status status =
        murk_worst_bound_tighten(&w->bound, n, below, w->plan, w->size,
                                 STEPS_CURVE, ROUNDS, &upper, err);
    *may_reach = upper > below;
    w->upper = upper < w->upper ? upper : w->upper;
    return status;
}

murk_status murk_worst_count(murk_worst_run *w, size_t n, bool is_plan_asked,
                             const uint32_t *from, murk_error *err)
{
    bool may_reach = true;
    murk_status status = find_fallback(w, n, err);
    w->has_plan = false;
    w->value = 0;
    w->upper = murk_worst_ceiling(w);
    if (!status && !murk_interrupted()) {
        begin(w, n, from);
        status = test_target(w, n, &may_reach, err);
    }
    if (status || !may_reach || murk_interrupted()) {
        return status;
    }
    const bool is_best = w->desc->method == MURK_PLACE_BEST;
    if (w->desc->target && is_best) {
        saturate(w, n);
    }
    status = murk_worst_bound_tighten(&w->bound, n, w->value, w->plan, w->size,
                                      is_plan_asked ? STEPS : STEPS_CURVE,
                                      ROUNDS, &w->upper, err);
    if (status || murk_interrupted()) {
        return status;
    }
    if (is_best && w->value < w->upper) {
        greedy_per_block(w, n);
        saturate(w, n); /* again, as the bound is known now */
        try_starts(w, n,
                   is_plan_asked ? w->desc->restarts : w->desc->restarts / 10);
    }
    return murk_worst_bound_tighten(&w->bound, n, w->value, NULL, 0, 0,
                                    is_plan_asked ? ROUNDS_LAST : ROUNDS,
                                    &w->upper, err);
}
