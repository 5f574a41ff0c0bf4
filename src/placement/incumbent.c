/* Plans of one count after another. MURK_PLACE_BEST takes greedy's plan, or the
 * plan of one sensor fewer with one more, relocates it, tries random starts,
 * and tightens the bound before and after; branch and bound follows for the
 * wanted count. The other methods make one plan and one bound. */
#include "placement/incumbent.h"

#include "base/interrupt.h"
#include "base/progress.h"

#include <stdlib.h>
#include <string.h>

/* Starts for each point of the curve: a tenth of those for the plan, 20 at most
 * (a choice: the curve has as many points as the plan sensors). */
#define RESTARTS_PER_CURVE_START 10
#define CURVE_STARTS_MAX         20

/* Maximum number of evaluations of the bound in a known environment. Large
 * matrices get fewer: as many as 2e10 evaluated entries allow, some seconds of
 * work. In an unknown environment each evaluation asks for every row, so one is
 * made, and only if greedy's own scans do not bound the value well enough. */
#define ROUNDS_MAX        400
#define ROUNDS_MIN        40
#define PAIRS_WEIGHED_MAX 20000000000.0
/* An entry of detection probabilities takes 16 times as long. */
#define PAIRS_OF_A_CHANCE 16

/* Evaluations for each point of the curve: a third of those for the plan (a
 * choice). */
#define ROUNDS_PER_CURVE_ROUND 3

static bool has_budget(const murk_incumbent *p)
{
    return p->set && p->set->has_budget;
}

static size_t fixed_count(const murk_incumbent *p)
{
    return p->set ? p->set->constraints->fixed_count : 0;
}

/* Stores the plan in trial if it is complete and worth more than *best. */
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

/* Greedy with a budget: the better one of greedy by gain per cost, and plain
 * greedy, which begins with the best single sensor. */
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

/* Greedy's plan of n. If constraints stop greedy early, the fallback plan. */
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

/* Tightens the bound by `rounds` evaluations, and takes greedy's bound if that
 * is lower. With many rounds the multipliers go on from those of the count
 * before, which differ little. A single evaluation does best at the multipliers
 * of the plan. For detection probabilities the multipliers of another count are
 * a poor start, so every count begins at the plan. */
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

/* MURK_PLACE_BEST for one count: greedy, relocation, the plan `from` of n - 1
 * sensors completed if that is worth more, and random starts. Returns value and
 * bound. */
static murk_curve_point find_best(murk_incumbent *p, size_t n,
                                  const uint32_t *from, uint64_t from_value,
                                  size_t max, size_t rounds, size_t *made)
{
    uint32_t *plan = p->plan;
    murk_progress_text("plans %zu sensors", n);
    uint64_t value = plan_greedily(p, n);
    if (value == p->evaluator->ceiling) { /* the plan reaches the ceiling */
        return (murk_curve_point){p->size, value, value};
    }
    /* greedy is optimal if a single sensor is free */
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

/* The plan of the other methods: one search and one bound. */
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

/* With constraints: completes a plan of fewer than n sensors. */
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

/* Branch and bound, from the incumbent and the bound that was tightened last.
 */
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

/* With conflicts a random start may end early: finds any feasible plan of n. */
static murk_status find_fallback(murk_incumbent *p, size_t n, murk_error *err)
{
    /* Complete a plan of the fixed sensors with any candidates. */
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

/* Number of evaluations of the bound for k sensors. */
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

/* Number of evaluations of the bound for the plan: by the size of the matrix.
 */
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
    /* A curve starts at the smallest feasible count. */
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
    /* Workspaces of the searches and the bound. */
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

/* True if a point of the curve should cost no further work: without constraints
 * greedy's plan is at hand. */
static bool is_curve_work_done(const murk_incumbent *p)
{
    const uint64_t rows =
        p->search.rows + p->starts.all_rows + p->bound.evaluations;
    return !p->set && p->desc->method != MURK_PLACE_SPOQ &&
           rows > murk_gain_scan_rows_max(p->evaluator) / 2;
}

/* A point of the curve from greedy's plan, or from the plan of one sensor fewer
 * with one more if that is worth more, and the bound of greedy's scans. */
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
    /* with a target, any count may become the plan */
    const bool is_plan = desc->target || k == p->last;
    const size_t rounds = rounds_of(p, k, is_plan);
    size_t extra = 0;
    size_t *made = is_plan ? &p->result->restarts : &extra;
    const size_t max = is_plan ? desc->restarts : curve_starts(desc->restarts);
    /* say that the wanted count is infeasible before a smaller one is tried */
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
