#include "placement/incumbent.h"

#include "base/interrupt.h"
#include "base/progress.h"

#include <stdlib.h>
#include <string.h>

/* A curve point gets one start for each of so many of the plan's own. */
#define RESTARTS_PER_CURVE_START 10
#define CURVE_STARTS_MAX         20

/* Evaluations of the bound in a known environment, at most; matrices so large
 * that these would take long get fewer, by pairs. In an unknown environment
 * each costs a look at every candidate: one is made, where greedy's own scans
 * do not say enough. */
#define ROUNDS_MAX        400
#define ROUNDS_MIN        40
#define PAIRS_WEIGHED_MAX 20000000000.0
#define PAIRS_OF_A_CHANCE 16 /* it takes so many times as long */

/* A curve point gets one round for each of so many of the plan's own. */
#define ROUNDS_PER_CURVE_ROUND 3

static bool has_budget(const murk_incumbent *p)
{
    return p->set && p->set->has_budget;
}

static size_t fixed_count(const murk_incumbent *p)
{
    return p->set ? p->set->constraints->fixed_count : 0;
}

/* Keeps the plan of p->size sensors, if the rules let it stand and it is worth
 * more than p->plan. */
static void keep_better(murk_incumbent *p, uint64_t value, uint64_t *best,
                        size_t *size)
{
    if (murk_partial_plan_is_complete(&p->search.partial) &&
        (*size == 0 || value > *best)) {
        *best = value;
        *size = p->search.size;
        memcpy(p->plan, p->trial, *size * sizeof *p->plan);
    }
}

/* Under a budget: by gain per cost, and by gain alone, which begins with the
 * best single sensor. */
static uint64_t greedy_with_budget(murk_incumbent *p)
{
    murk_gain_scan *s = &p->search;
    const size_t max = p->set->max_sensors;
    uint64_t best = 0;
    size_t size = 0;
    keep_better(p, murk_search_budget_greedy(s, p->trial, 0), &best, &size);
    keep_better(p, murk_search_greedy(s, p->trial, 0, max, UINT64_MAX, NULL),
                &best, &size);
    p->size = size;
    return best;
}

/* Greedy's plan of n; under rules that bring it to a dead end, any. */
static uint64_t plan_greedily(murk_incumbent *p, size_t n)
{
    uint64_t value;
    if (!p->set) {
        memcpy(p->plan, p->greedy, n * sizeof *p->plan);
        p->size = n;
        return p->greedy_value[n - 1];
    }
    if (has_budget(p)) {
        value = greedy_with_budget(p);
    } else {
        value = murk_search_greedy(&p->search, p->plan, 0, n, UINT64_MAX, NULL);
        p->size = p->search.size < n ? 0 : n;
    }
    p->is_greedy_done = p->size > 0;
    if (p->size == 0) {
        memcpy(p->plan, p->fallback, p->fallback_size * sizeof *p->plan);
        p->size = p->fallback_size;
        value = murk_search_value(&p->search, p->plan, p->size);
    }
    return value;
}

/* The bound from so many rounds, and from greedy's scans. Where there are many
 * rounds, they go on from the thresholds of the count before, which differ
 * little; a single one does best at the plan's own. Of independent chances the
 * thresholds of another count lead nowhere: all begin at the plan's. */
static uint64_t tighten(murk_incumbent *p, size_t n, uint64_t value,
                        const uint32_t *plan, size_t rounds)
{
    const bool may_go_on =
        p->has_multipliers &&
        (!p->evaluator->layout->doses || p->bound.last_count == n);
    if (rounds == 0 || (p->evaluator->matrix && may_go_on)) {
        plan = NULL;
    }
    p->has_multipliers = p->has_multipliers || plan;
    murk_progress_text("bounds %zu sensors", n);
    const uint64_t upper =
        murk_bound_tighten(&p->bound, n, value, plan, p->size, rounds);
    return !p->set && p->greedy_bound[n - 1] < upper ? p->greedy_bound[n - 1]
                                                     : upper;
}

/* Greedy, relocated, then starts. Where `from`, a plan of n - 1, is worth more
 * than that, it is completed and taken instead. */
static murk_curve_point find_best(murk_incumbent *p, size_t n,
                                  const uint32_t *from, uint64_t from_value,
                                  size_t max, size_t rounds, size_t *made)
{
    uint32_t *plan = p->plan;
    murk_progress_text("plans %zu sensors", n);
    uint64_t value = plan_greedily(p, n);
    if (value == p->evaluator->ceiling) { /* all that can be seen */
        return (murk_curve_point){p->size, value, value};
    }
    /* of one that is free, greedy finds the best */
    const bool is_open = n > fixed_count(p) + 1 || has_budget(p) ||
                         (p->set && !p->is_greedy_done);
    if (is_open) {
        value = murk_search_relocate(&p->search, plan, p->size);
        p->size = p->search.size;
    }
    if (from && from_value > value) {
        memcpy(p->trial, from, (n - 1) * sizeof *plan);
        murk_search_greedy(&p->search, p->trial, n - 1, n, UINT64_MAX, NULL);
        if (p->search.size == n) {
            memcpy(plan, p->trial, n * sizeof *plan);
            value = murk_search_relocate(&p->search, plan, n);
        }
    }
    uint64_t upper = value;
    if (is_open) {
        const size_t before = p->evaluator->matrix ? rounds / 2 : 0;
        upper = tighten(p, n, value, plan, before);
        value = murk_starts_try(&p->starts, plan, &p->size, n, value, upper,
                                max, made);
        const uint64_t again = tighten(p, n, value, plan, rounds - before);
        upper = again < upper ? again : upper;
    }
    return (murk_curve_point){p->size, value, upper};
}

/* The plan of one method without more ado, and its bound. */
static murk_curve_point find_once(murk_incumbent *p, size_t n, size_t rounds,
                                  size_t *made)
{
    uint64_t value = 0;
    if (p->desc->method == MURK_PLACE_SPOQ) {
        value = murk_search_spoq(&p->search, p->plan, n, p->desc->seed, 0);
        p->size = p->search.size;
        ++*made;
    } else {
        value = plan_greedily(p, n);
    }
    const uint64_t upper = tighten(p, n, value, p->plan, rounds);
    return (murk_curve_point){p->size, value, upper};
}

/* Under rules: a plan of fewer, filled up to n by whoever may join. */
static uint64_t complete_plan(murk_incumbent *p, size_t n)
{
    murk_gain_scan *s = &p->search;
    const uint64_t value =
        has_budget(p)
            ? murk_search_budget_greedy(s, p->plan, p->size)
            : murk_search_greedy(s, p->plan, p->size, n, UINT64_MAX, NULL);
    p->size = s->size;
    return value;
}

/* Branch and bound from a plan whose bound was tightened last. */
static murk_status branch_and_bound(murk_incumbent *p, size_t n,
                                    murk_curve_point *point, murk_error *err)
{
    const bool is_wanted = p->desc->method == MURK_PLACE_BEST ||
                           p->desc->method == MURK_PLACE_EXACT;
    if (!p->evaluator->matrix || !is_wanted || (n < 2 && !p->set)) {
        return MURK_OK;
    }
    murk_exact exact;
    const uint64_t left = p->desc->nodes > p->result->nodes
                              ? p->desc->nodes - p->result->nodes
                              : 0;
    const murk_status status =
        murk_exact_search(&exact, &p->bound, p->plan, p->size, n, point->value,
                          point->upper, left, NULL, err);
    if (!status) {
        p->size = exact.size;
        point->value = p->set ? complete_plan(p, n) : exact.value;
        point->count = p->size;
        point->upper = exact.upper > point->value ? exact.upper : point->value;
        p->result->nodes += exact.nodes;
        p->result->is_cut = p->result->is_cut || exact.is_cut;
    }
    return status;
}

/* Where candidates exclude each other a start may end short: any plan of n. */
static murk_status find_fallback(murk_incumbent *p, size_t n, murk_error *err)
{
    if (!p->set || !p->set->has_conflicts) {
        return MURK_OK;
    }
    murk_partial_plan *partial = &p->search.partial;
    bool is_sure;
    murk_partial_plan_clear(partial, n);
    for (size_t k = 0; k < fixed_count(p); ++k) {
        murk_partial_plan_add(partial, (uint32_t)p->set->constraints->fixed[k]);
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
                               n, p->evaluator->candidates);
    }
    p->fallback_size = partial->size;
    memcpy(p->fallback, partial->member,
           p->fallback_size * sizeof *p->fallback);
    murk_starts_set_fallback(&p->starts, p->fallback, p->fallback_size);
    p->search.fallback = p->fallback;
    p->search.fallback_size = p->fallback_size;
    return MURK_OK;
}

static size_t curve_starts(size_t restarts)
{
    const size_t share = restarts / RESTARTS_PER_CURVE_START;
    return share < CURVE_STARTS_MAX ? share : CURVE_STARTS_MAX;
}

static size_t curve_rounds(size_t rounds)
{
    return rounds > ROUNDS_PER_CURVE_ROUND ? rounds / ROUNDS_PER_CURVE_ROUND
                                           : rounds;
}

/* Evaluations of the bound for k sensors. */
static size_t rounds_of(const murk_incumbent *p, size_t k, bool is_plan)
{
    const murk_place_desc *desc = p->desc;
    if (p->evaluator->matrix) {
        return is_plan ? p->rounds : curve_rounds(p->rounds);
    }
    const bool has_greedy_bound = !p->set && desc->method != MURK_PLACE_SPOQ;
    const bool is_wanted = is_plan && desc->method == MURK_PLACE_BEST &&
                           p->greedy_bound[k - 1] >= desc->target;
    return !has_greedy_bound || is_wanted ? 1 : 0;
}

static size_t rounds_for(const murk_evaluator *evaluator)
{
    if (!evaluator->matrix) {
        return 1;
    }
    const double pairs = (double)murk_matrix_pairs(evaluator->matrix);
    const double max = evaluator->layout->doses
                           ? PAIRS_WEIGHED_MAX / PAIRS_OF_A_CHANCE
                           : PAIRS_WEIGHED_MAX;
    const double rounds = max / (pairs > 1 ? pairs : 1);
    return rounds > ROUNDS_MAX   ? ROUNDS_MAX
           : rounds < ROUNDS_MIN ? ROUNDS_MIN
                                 : (size_t)rounds;
}

murk_status murk_incumbent_init(murk_incumbent *p,
                                const murk_evaluator *evaluator,
                                const murk_constraint_set *set,
                                const murk_place_desc *desc,
                                murk_place_result *result, murk_error *err)
{
    const size_t n = set ? set->max_sensors : desc->count;
    const bool is_curve =
        (desc->with_curve || desc->target) && !(set && set->has_budget);
    *p = (murk_incumbent){.evaluator = evaluator,
                          .desc = desc,
                          .set = set,
                          .first = !is_curve ? n
                                   : set     ? set->min_sensors
                                             : 1,
                          .last = n,
                          .result = result,
                          .rounds = rounds_for(evaluator),
                          .greedy = calloc(n, sizeof *p->greedy),
                          .greedy_value = calloc(n, sizeof *p->greedy_value),
                          .greedy_bound =
                              malloc((n + 1) * sizeof *p->greedy_bound),
                          .plan = calloc(n, sizeof *p->plan),
                          .last_plan = calloc(n, sizeof *p->last_plan),
                          .trial = calloc(n, sizeof *p->trial),
                          .fallback = calloc(n, sizeof *p->fallback)};
    result->sensor = calloc(n, sizeof *result->sensor);
    if (is_curve) {
        result->curve = calloc(n, sizeof *result->curve);
    }
    if (!p->greedy || !p->trial || !p->fallback || !p->greedy_value ||
        !p->greedy_bound || !p->plan || !p->last_plan || !result->sensor ||
        (is_curve && !result->curve)) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for %zu sensors",
                         n);
    }
    murk_status status = murk_gain_scan_init(&p->search, evaluator, 0,
                                             evaluator->problem->threads, err);
    p->search.rows_max = murk_gain_scan_rows_max(evaluator);
    memset(p->greedy_bound, 0xff, n * sizeof *p->greedy_bound);
    p->search.greedy_bound = p->greedy_bound;
    p->search.greedy_bound_count = set ? 0 : n;
    if (!status) {
        status = murk_bound_init(&p->bound, evaluator, err);
    }
    if (!status) {
        status = murk_starts_init(&p->starts, evaluator, n, desc->seed, err);
    }
    return status;
}

void murk_incumbent_release(murk_incumbent *p)
{
    murk_gain_scan_release(&p->search);
    murk_bound_release(&p->bound);
    murk_starts_release(&p->starts);
    free(p->greedy);
    free(p->greedy_value);
    free(p->greedy_bound);
    free(p->plan);
    free(p->last_plan);
    free(p->trial);
    free(p->fallback);
}

void murk_incumbent_greedy(murk_incumbent *p)
{
    const uint64_t enough = p->desc->target ? p->desc->target : UINT64_MAX;
    murk_search_greedy(&p->search, p->greedy, 0, p->last, enough,
                       p->greedy_value);
}

/* Points of the curve without rules have greedy's plan to fall back on. */
static bool is_curve_work_done(const murk_incumbent *p)
{
    const uint64_t rows =
        p->search.rows + p->starts.all_rows + p->bound.evaluations;
    return !p->set && p->desc->method != MURK_PLACE_SPOQ &&
           rows > murk_gain_scan_rows_max(p->evaluator) / 2;
}

/* Greedy's plan of n, or the plan of one fewer completed where that is worth
 * more, and the bound that greedy's scans gave. */
static murk_curve_point greedy_point(murk_incumbent *p, size_t n,
                                     const uint32_t *from, uint64_t from_value)
{
    const uint64_t ceiling = p->evaluator->ceiling;
    uint64_t value = plan_greedily(p, n);
    if (from && from_value > value) {
        memcpy(p->plan, from, (n - 1) * sizeof *p->plan);
        value =
            murk_search_greedy(&p->search, p->plan, n - 1, n, UINT64_MAX, NULL);
    }
    const uint64_t greedy_bound = p->greedy_bound[n - 1];
    return (murk_curve_point){n, value,
                              greedy_bound < ceiling ? greedy_bound : ceiling};
}

murk_status murk_incumbent_count(murk_incumbent *p, size_t k,
                                 const uint32_t *from, murk_curve_point *last,
                                 murk_error *err)
{
    const murk_place_desc *desc = p->desc;
    /* With a target, any count may turn out to be the plan's. */
    const bool is_plan = desc->target || k == p->last;
    const size_t rounds = rounds_of(p, k, is_plan);
    size_t extra = 0;
    size_t *made = is_plan ? &p->result->restarts : &extra;
    const size_t max = is_plan ? desc->restarts : curve_starts(desc->restarts);
    /* Where the whole count cannot stand, say so of it. */
    murk_status status = k == p->first && !desc->target
                             ? find_fallback(p, p->last, err)
                             : MURK_OK;
    if (!status) {
        status = find_fallback(p, k, err);
    }
    if (status || murk_interrupted()) {
        return status;
    }
    if (!is_plan && is_curve_work_done(p)) {
        *last = greedy_point(p, k, from, last->value);
        return MURK_OK;
    }
    *last = desc->method == MURK_PLACE_BEST
                ? find_best(p, k, from, last->value, max, rounds, made)
                : find_once(p, k, rounds, made);
    const bool is_open = desc->target == 0 || (last->value < desc->target &&
                                               last->upper >= desc->target);
    return is_plan && is_open && !murk_interrupted()
               ? branch_and_bound(p, k, last, err)
               : MURK_OK;
}
