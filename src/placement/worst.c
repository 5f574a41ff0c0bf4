/* Placement for the worst block. For each count greedy climbs towards a level
 * in every block, and bisection finds the highest level that greedy reaches
 * (SATURATE). Relocation, greedy on each block, random starts and branch and
 * bound follow as the method asks. MURK_PLACE_SPOQ has one random start in
 * place of greedy. A start plan replaces greedy on each block and the random
 * starts. placement/worst.h has the steps of each method. */
#include "placement/worst.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "placement/exact.h"
#include "placement/run.h"
#include "placement/worst_bound.h"
#include "placement/worst_search.h"

#include <assert.h>
#include <string.h>

/* Bisection steps between the incumbent and the bound, and the finest step:
 * 2^-16 of full coverage, the resolution of a clarity. */
#define LEVELS_MAX   16
#define LEVEL_FINEST (MURK_SHARE_ONE >> 16)

/* Steps of lambda (placement/worst_bound.h), evaluations of the bound at each
 * step, and evaluations of the last bound of a count, at most; all are chosen,
 * not derived. A count below the wanted one gets STEPS_CURVE steps, and ROUNDS
 * evaluations of the last bound. */
#define STEPS       60
#define STEPS_CURVE 15
#define ROUNDS      8
#define ROUNDS_LAST 100

typedef struct worst {
    murk_place_run run; /* values are the smallest worths of the blocks */
    size_t blocks;
    murk_block_layouts layouts;
    murk_worst_search search;
    murk_worst_bound bound;
    uint64_t upper; /* upper bound for the present count */
} worst;

/* The smallest worth of the blocks with all candidates chosen. */
static uint64_t ceiling_of(const worst *w)
{
    uint64_t min = UINT64_MAX;
    for (size_t c = 0; c < w->blocks; ++c) {
        const uint64_t share =
            murk_block_worth(&w->layouts, c, w->layouts.ceiling[c]);
        min = share < min ? share : min;
    }
    return min;
}

/* ---- plans ---- */

static bool is_plan(worst *w, const uint32_t *plan, size_t size, size_t n)
{
    const murk_constraint_set *set = w->run.set;
    if (!set) {
        return size == n;
    }
    murk_partial_plan *s = &w->run.search.partial;
    murk_partial_plan_clear(s, set->has_budget ? set->max_sensors : n);
    for (size_t k = 0; k < size; ++k) {
        murk_partial_plan_add(s, plan[k]);
    }
    return murk_partial_plan_is_complete(s);
}

/* Stores the plan in trial if it is complete and better than the incumbent.
 * With `relocates`, a complete plan is also relocated, and stored if it is then
 * better than the incumbent. True if either was stored. */
static bool keep_trial(worst *w, size_t n, uint64_t value, bool relocates)
{
    uint32_t *trial = w->run.trial;
    const size_t *size = &w->run.search.size;
    if (!is_plan(w, trial, *size, n)) {
        return false;
    }
    bool is_better = murk_place_run_keep(&w->run, trial, *size, value);
    if (relocates) {
        value = murk_worst_relocate(&w->search, trial, *size);
        is_better |= is_plan(w, trial, *size, n) &&
                     murk_place_run_keep(&w->run, trial, *size, value);
    }
    return is_better;
}

/* keep_trial() for a plan whose value is not known yet; also relocates the
 * plan. */
static bool try_trial(worst *w, size_t n)
{
    const uint64_t value =
        murk_worst_value(&w->search, w->run.trial, w->run.search.size);
    return keep_trial(w, n, value, true);
}

/* Greedy for one objective; for MURK_PLACE_BEST also relocated. */
static void greedy_and_keep(worst *w, const murk_block_objective *by, size_t n)
{
    const uint64_t value =
        murk_worst_greedy(&w->search, by, w->run.trial, 0, n);
    keep_trial(w, n, value, w->run.desc->method == MURK_PLACE_BEST);
}

/* Greedy towards one level in every block; MURK_NO_LEVEL: for the mean of the
 * worths of the blocks. */
static void greedy_to_level(worst *w, size_t n, uint64_t level)
{
    murk_block_objective by = {.level = level};
    for (size_t c = 0; c < w->blocks; ++c) {
        by.factor[c] = 1;
    }
    greedy_and_keep(w, &by, n);
}

/* Bisection for the highest level that greedy reaches in every block. */
static void saturate(worst *w, size_t n)
{
    greedy_to_level(w, n, MURK_NO_LEVEL);
    uint64_t low = w->run.value, high = w->upper;
    for (int k = 0; k < LEVELS_MAX && high > low && high - low > LEVEL_FINEST &&
                    !murk_must_finish();
         ++k) {
        const uint64_t level = low + (high - low) / 2;
        greedy_to_level(w, n, level);
        if (w->run.value >= level) {
            low = w->run.value;
        } else {
            high = level;
        }
    }
}

static void greedy_per_block(worst *w, size_t n)
{
    for (size_t c = 0; c < w->blocks && !murk_must_finish(); ++c) {
        murk_block_objective by = {.level = MURK_NO_LEVEL};
        by.factor[c] = 1;
        greedy_and_keep(w, &by, n);
    }
}

/* With a budget: greedy by gain per cost on the value of the whole problem, in
 * which each block counts by its weight; then relocation. Without a budget
 * nothing is done. */
static void greedy_with_budget(worst *w, size_t n)
{
    if (murk_has_budget(w->run.set)) {
        murk_search_budget_greedy(&w->run.search, w->run.trial, 0);
        try_trial(w, n);
    }
}

/* A random start, relocated. True if it improves the incumbent. */
static bool try_start(worst *w, size_t n, uint64_t restart)
{
    murk_gain_scan *scan = &w->run.search;
    scan->size =
        murk_search_draw(scan, w->run.trial, n, w->run.desc->seed, restart);
    ++w->run.result.restarts;
    return try_trial(w, n);
}

/* The plan of n sensors made from the start plan, relocated. */
static void try_start_plan(worst *w, size_t n)
{
    murk_place_run *run = &w->run;
    run->search.size =
        murk_search_begin_at(&run->search, run->trial, n, run->desc->start_plan,
                             run->desc->start_size, &run->result.started_from);
    try_trial(w, n);
}

static void try_starts(worst *w, size_t n, size_t max)
{
    size_t without_gain = 0;
    for (size_t k = 0; k < max && without_gain < MURK_STARTS_WITHOUT_GAIN &&
                       w->run.value < w->upper && !murk_must_finish();
         ++k) {
        without_gain = try_start(w, n, k) ? 0 : without_gain + 1;
        murk_progress_add(1);
    }
}

/* ---- branch and bound ---- */

/* Callback of branch and bound: stores a plan of larger smallest worth, and
 * raises the cutoff. */
static uint64_t check_plan(void *context, const uint32_t *plan, size_t size,
                           uint64_t known)
{
    worst *w = context;
    const uint64_t value = murk_worst_value(&w->search, plan, size);
    return murk_place_run_keep(&w->run, plan, size, value)
               ? murk_worst_bound_value(&w->bound, value)
               : known;
}

static murk_status branch_and_bound(worst *w, size_t n, murk_error *err)
{
    murk_place_run *run = &w->run;
    if (!murk_place_has_proof(run->desc) || run->value >= w->upper) {
        return MURK_OK;
    }
    const murk_exact_callback by = {check_plan, w};
    murk_exact exact;
    const murk_status status =
        murk_exact_search(&exact, &w->bound.bound, run->plan, run->size, n,
                          murk_worst_bound_value(&w->bound, run->value),
                          w->bound.evaluator.ceiling,
                          murk_place_run_nodes_left(run, run->desc), &by, err);
    if (status) {
        return status;
    }
    run->result.nodes += exact.nodes;
    run->result.is_cut = run->result.is_cut || exact.is_cut;
    const uint64_t upper = murk_worst_bound_share(&w->bound, exact.upper);
    w->upper = upper < w->upper ? upper : w->upper;
    if (run->set) { /* the incumbent may have to be completed */
        run->value = murk_worst_greedy(&w->search, &MURK_MINIMUM_FIRST,
                                       run->plan, run->size, n);
        run->size = run->search.size;
    }
    w->upper = w->upper > run->value ? w->upper : run->value;
    return MURK_OK;
}

/* ---- one count ---- */

/* Makes the first plans: those of the method or, if constraints leave these
 * incomplete, any feasible plan; and, for MURK_PLACE_BEST, the plan of one
 * sensor fewer with one more. */
static void make_first_plans(worst *w, size_t n, const uint32_t *from)
{
    murk_place_run *run = &w->run;
    const murk_place_method method = run->desc->method;
    const bool has_start = run->desc->start_plan && method != MURK_PLACE_GREEDY;
    if (has_start) { /* first, so that it stays on ties */
        try_start_plan(w, n);
    }
    if (method == MURK_PLACE_SPOQ && has_start) {
        ++run->result.restarts;
    } else if (method == MURK_PLACE_SPOQ && !murk_must_finish()) {
        try_start(w, n, 0);
    } else if (run->desc->target) {
        greedy_to_level(w, n, run->desc->target);
    } else {
        saturate(w, n);
        greedy_with_budget(w, n);
    }
    if (run->size == 0) { /* constraints stopped greedy early */
        run->search.size = run->search.fallback_size;
        memcpy(run->trial, run->search.fallback,
               run->search.size * sizeof *run->trial);
        try_trial(w, n);
    }
    if (from && method == MURK_PLACE_BEST) {
        memcpy(run->trial, from, (n - 1) * sizeof *from);
        const uint64_t value = murk_worst_greedy(
            &w->search, &MURK_MINIMUM_FIRST, run->trial, n - 1, n);
        keep_trial(w, n, value, true);
    }
}

/* With a target that no plan reaches yet: decides whether n sensors may reach
 * the target, by a bound that is lowered no further than just below the target.
 * Otherwise *may_reach is true. */
static murk_status test_target(worst *w, size_t n, bool *may_reach,
                               murk_error *err)
{
    const uint64_t below = w->run.desc->target - 1;
    *may_reach = true;
    if (!w->run.desc->target || w->run.value > below) {
        return MURK_OK;
    }
    uint64_t upper = w->upper;
    const murk_status status =
        murk_worst_bound_tighten(&w->bound, n, below, w->run.plan, w->run.size,
                                 STEPS_CURVE, ROUNDS, &upper, err);
    *may_reach = upper > below;
    w->upper = upper < w->upper ? upper : w->upper;
    return status;
}

/* Finds the best plan of n sensors by the method, and a bound. A count below
 * the wanted one (is_plan_asked false) gets less work. */
static murk_status search_count(worst *w, size_t n, bool is_plan_asked,
                                const uint32_t *from, murk_error *err)
{
    murk_place_run *run = &w->run;
    const murk_place_desc *desc = run->desc;
    bool may_reach = true;
    murk_status status = murk_place_run_find_fallback(run, n, err);
    run->size = 0;
    run->value = 0;
    w->upper = ceiling_of(w);
    if (!status && !murk_interrupted()) {
        make_first_plans(w, n, from);
        status = test_target(w, n, &may_reach, err);
    }
    if (status || !may_reach || murk_interrupted()) {
        return status;
    }
    const bool is_best = desc->method == MURK_PLACE_BEST;
    if (desc->target && is_best) {
        saturate(w, n);
    }
    /* With a start plan the bound gets the work of a smaller count, which would
     * otherwise take most of the time. */
    const size_t steps =
        is_plan_asked && !desc->start_plan ? STEPS : STEPS_CURVE;
    status = murk_worst_bound_tighten(&w->bound, n, run->value, run->plan,
                                      run->size, steps, ROUNDS, &w->upper, err);
    if (status || murk_must_finish()) {
        return status;
    }
    if (is_best && !desc->start_plan && run->value < w->upper) {
        greedy_per_block(w, n);
        saturate(w, n); /* again, as the bound is known now */
        try_starts(w, n, is_plan_asked ? desc->restarts : desc->restarts / 10);
    }
    return murk_worst_bound_tighten(&w->bound, n, run->value, NULL, 0, 0,
                                    is_plan_asked ? ROUNDS_LAST : ROUNDS,
                                    &w->upper, err);
}

static murk_status find_count(void *context, size_t n, const uint32_t *from,
                              murk_curve_point *point, murk_error *err)
{
    worst *w = context;
    const murk_place_run *run = &w->run;
    const uint64_t target = run->desc->target;
    /* With a target, any count may become the plan; branch and bound is for the
     * plan only. */
    const bool is_asked = target || n == run->last;
    murk_status status = search_count(w, n, is_asked, from, err);
    const bool is_open =
        target == 0 || (run->value < target && w->upper >= target);
    if (!status && is_asked && is_open && !murk_must_finish()) {
        status = branch_and_bound(w, n, err);
    }
    *point = (murk_curve_point){run->size, run->value, w->upper};
    return status;
}

/* ---- frame ---- */

static murk_status check_ceiling(const worst *w, murk_error *err)
{
    const uint64_t target = w->run.desc->target;
    return target > ceiling_of(w)
               ? murk_fail(err, MURK_BAD_VALUE, "",
                           "target %.6g cannot be reached in the worst "
                           "condition: all %zu usable candidates together see "
                           "%.6g of it",
                           (double)target / (double)MURK_SHARE_ONE,
                           w->run.evaluator.candidates,
                           (double)ceiling_of(w) / (double)MURK_SHARE_ONE)
               : MURK_OK;
}

static murk_status check_target(const murk_place_run *run, murk_error *err)
{
    const double target = (double)run->desc->target / (double)MURK_SHARE_ONE;
    if (run->result.value >= run->desc->target) {
        return MURK_OK;
    }
    const double best = (double)run->result.value / (double)MURK_SHARE_ONE;
    const double upper = (double)run->result.upper / (double)MURK_SHARE_ONE;
    return run->result.upper < run->desc->target
               ? murk_fail(err, MURK_BAD_VALUE, "",
                           "target %.6g cannot be reached in the worst "
                           "condition: %zu sensors see at most %.6g of it",
                           target, run->last, upper)
               : murk_fail(err, MURK_RUN_FAILED, "",
                           "no plan found that reaches the target %.6g in the "
                           "worst condition with at most %zu sensors: the "
                           "best found sees %.6g",
                           target, run->last, best);
}

static murk_status begin(worst *w, const murk_blocks *blocks, murk_error *err)
{
    murk_status status =
        murk_block_layouts_init(&w->layouts, &w->run.evaluator, blocks, err);
    if (!status) {
        status = murk_worst_search_init(&w->search, &w->layouts, &w->run.search,
                                        &w->run.arena, err);
    }
    return status ? status : murk_worst_bound_init(&w->bound, &w->layouts, err);
}

murk_status murk_place_worst(murk_place_result *out,
                             const murk_problem *problem,
                             const murk_matrix *matrix,
                             const murk_blocks *blocks,
                             const murk_place_desc *desc, murk_error *err)
{
    assert(out && problem && matrix && blocks && desc && blocks->n >= 1);
    assert(blocks->n <= MURK_BLOCKS_MAX);
    worst w = {.blocks = blocks->n};
    murk_status status =
        murk_place_run_begin(&w.run, problem, matrix, desc, err);
    if (!status) {
        status = begin(&w, blocks, err);
    }
    if (!status) {
        status = check_ceiling(&w, err);
    }
    /* Find the plans, and make the result. */
    if (!status) {
        status = murk_place_run_counts(&w.run, find_count, &w, err);
    }
    if (!status) {
        status = check_target(&w.run, err);
    }
    if (!status) {
        murk_place_run_join_bounds(&w.run);
        w.run.result.ceiling = ceiling_of(&w);
        w.run.result.whole = MURK_SHARE_ONE;
        w.run.result.evaluations = w.search.evaluations;
    }
    murk_worst_bound_release(&w.bound);
    murk_block_layouts_release(&w.layouts);
    return murk_place_run_end(out, &w.run, status);
}
