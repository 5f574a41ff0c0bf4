/* Plans of one count after another. MURK_PLACE_BEST takes greedy's plan, or the
 * plan of one sensor fewer with one sensor added, relocates the sensors, tries
 * random starts, and tightens the bound before and after the random starts. The
 * other methods make one plan and one bound. A start plan replaces the random
 * starts of MURK_PLACE_BEST and the random draw of MURK_PLACE_SPOQ, and
 * competes with greedy's plan in MURK_PLACE_EXACT. In a known environment
 * branch and bound follows with MURK_PLACE_BEST and MURK_PLACE_EXACT: for the
 * wanted count, or, with a target, for each count whose plan misses the target
 * while the bound reaches it. Under a rule on moves every method relocates the
 * start plan by the value less the cost of moves. */
#include "placement/incumbent.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "placement/moves.h"

#include <math.h>
#include <string.h>

/* Starts for each point of the curve: a tenth of those for the plan, 20 at most
 * (a choice: the curve has as many points as the plan sensors). */
#define RESTARTS_PER_CURVE_START 10
#define CURVE_STARTS_MAX         20

/* Maximum number of evaluations of the bound in a known environment. Large
 * matrices get fewer: as many as 2e10 evaluated entries allow, some seconds of
 * work, but ROUNDS_MIN at least; a quick search as many as 1.2e8 entries allow,
 * a tenth of a second, but ROUNDS_QUICK_MIN at least. In an unknown environment
 * each evaluation asks for every row, so at most one is made; rounds_of() says
 * for which counts. */
#define ROUNDS_MAX        400
#define ROUNDS_MIN        40
#define PAIRS_WEIGHED_MAX 20000000000.0
#define ROUNDS_QUICK_MAX  100
#define ROUNDS_QUICK_MIN  16
#define PAIRS_QUICK_MAX   120000000.0
/* An entry of detection probabilities takes 16 times as long. */
#define PAIRS_OF_A_CHANCE 16

/* Evaluations for each point of the curve: a third of those for the plan (a
 * choice). */
#define ROUNDS_PER_CURVE_ROUND 3

/* Greedy with a budget: the better one of greedy by gain per cost, and plain
 * greedy, which begins with the best single sensor. */
static uint64_t greedy_with_budget(murk_incumbent *p)
{
    murk_place_run *run = p->run;
    murk_gain_scan *s = p->search;
    run->size = 0;
    run->value = 0;
    for (int pass = 0; pass < 2; ++pass) {
        const uint64_t value =
            pass == 0
                ? murk_search_budget_greedy(s, run->trial, 0)
                : murk_search_greedy(s, run->trial, 0, run->set->max_sensors,
                                     UINT64_MAX, NULL);
        if (murk_partial_plan_is_complete(&s->partial)) {
            murk_place_run_keep(run, run->trial, s->size, value);
        }
    }
    p->size = run->size;
    return run->value;
}

/* Greedy's plan of n: the first sensors of murk_incumbent_greedy() if that ran.
 * If constraints stop greedy early, the fallback plan. */
static uint64_t plan_greedily(murk_incumbent *p, size_t n)
{
    uint64_t value;
    if (p->has_greedy) {
        memcpy(p->plan, p->greedy, n * sizeof *p->plan);
        p->size = n;
        return p->greedy_value[n - 1];
    }
    if (murk_has_budget(p->run->set)) {
        value = greedy_with_budget(p);
    } else {
        value = murk_search_greedy(p->search, p->plan, 0, n, UINT64_MAX, NULL);
        p->size = p->search->size < n ? 0 : n;
    }
    p->is_greedy_done = p->size > 0;
    if (p->size == 0) {
        memcpy(p->plan, p->search->fallback,
               p->search->fallback_size * sizeof *p->plan);
        p->size = p->search->fallback_size;
        value =
            murk_gain_scan_set_all_but(p->search, p->plan, p->size, p->size);
    }
    return value;
}

/* Tightens the bound by `rounds` evaluations, and without constraints takes
 * greedy's bound if that is lower. In a known environment the multipliers go on
 * from those of the last call, even if that was for the count before, whose
 * multipliers differ little. In an unknown environment a single evaluation is
 * made, which does best at the multipliers of the plan. For detection
 * probabilities the multipliers of another count are a poor start, so every
 * count begins at the plan. */
static uint64_t tighten(murk_incumbent *p, size_t n, uint64_t value,
                        const uint32_t *plan, size_t rounds)
{
    const bool may_go_on =
        p->has_multipliers &&
        (!p->run->evaluator.layout->doses || p->bound.last_count == n);
    if (rounds == 0 || (p->run->evaluator.matrix && may_go_on)) {
        plan = NULL;
    }
    p->has_multipliers = p->has_multipliers || plan;
    murk_progress_text("bounds %zu sensors", n);
    const uint64_t upper =
        murk_bound_tighten(&p->bound, n, value, plan, p->size, rounds);
    return !p->run->set && p->greedy_bound[n - 1] < upper
               ? p->greedy_bound[n - 1]
               : upper;
}

/* With a start plan: makes the plan of n sensors from the start plan, and
 * relocates its sensors. Replaces the incumbent, which is worth `value`, unless
 * the incumbent is worth more: on ties the start plan stays, so that no sensor
 * is moved in vain. Returns the value of the incumbent. */
static uint64_t try_start_plan(murk_incumbent *p, size_t n, uint64_t value)
{
    const murk_place_desc *desc = p->desc;
    uint32_t *trial = p->run->trial;
    if (!desc->start_plan) {
        return value;
    }
    const size_t size =
        murk_search_begin_at(p->search, trial, n, desc->start_plan,
                             desc->start_size, &p->run->result.started_from);
    const uint64_t relocated = murk_search_relocate(p->search, trial, size);
    if (relocated < value || murk_interrupted()) {
        return value;
    }
    p->size = p->search->size;
    memcpy(p->plan, trial, p->size * sizeof *trial);
    return relocated;
}

/* MURK_PLACE_BEST for one count: greedy, relocation, random starts or the start
 * plan. If the plan `from` of n - 1 sensors is already worth more than the
 * relocated plan, `from` with one more sensor, if one can be added, is
 * relocated in place of that plan. Leaves the plan in p->plan, and returns
 * count, value and bound. */
static murk_curve_point find_best(murk_incumbent *p, size_t n,
                                  const uint32_t *from, uint64_t from_value,
                                  size_t max, size_t rounds, size_t *made)
{
    uint32_t *plan = p->plan, *trial = p->run->trial;
    murk_progress_text("plans %zu sensors", n);
    uint64_t value = plan_greedily(p, n);
    if (value == p->run->evaluator.ceiling) { /* the plan reaches the ceiling */
        value = try_start_plan(p, n, value);
        return (murk_curve_point){p->size, value, value};
    }
    /* greedy is optimal if a single sensor is free */
    const bool is_open = n > murk_fixed_count(p->run->set) + 1 ||
                         murk_has_budget(p->run->set) ||
                         (p->run->set && !p->is_greedy_done);
    if (is_open) {
        value = murk_search_relocate(p->search, plan, p->size);
        p->size = p->search->size;
    }
    if (from && from_value > value) {
        memcpy(trial, from, (n - 1) * sizeof *plan);
        murk_search_greedy(p->search, trial, n - 1, n, UINT64_MAX, NULL);
        if (p->search->size == n) {
            memcpy(plan, trial, n * sizeof *plan);
            value = murk_search_relocate(p->search, plan, n);
        }
    }
    value = try_start_plan(p, n, value);
    uint64_t upper = value;
    if (is_open) {
        const bool has_starts = !p->desc->start_plan;
        const size_t before =
            p->run->evaluator.matrix && has_starts ? rounds / 2 : 0;
        upper = tighten(p, n, value, plan, before);
        value = murk_starts_try(&p->starts, p->search, plan, &p->size, n, value,
                                upper, has_starts ? max : 0, made);
        const uint64_t again = tighten(p, n, value, plan, rounds - before);
        upper = again < upper ? again : upper;
    }
    return (murk_curve_point){p->size, value, upper};
}

/* SPOQ from the start plan, or else from a random start. Leaves the plan in
 * p->plan and returns the value. */
static uint64_t find_by_spoq(murk_incumbent *p, size_t n)
{
    const murk_place_desc *desc = p->desc;
    murk_gain_scan *s = p->search;
    uint64_t value;
    if (desc->start_plan) {
        const size_t size = murk_search_begin_at(
            s, p->plan, n, desc->start_plan, desc->start_size,
            &p->run->result.started_from);
        value = murk_search_spoq_from(s, p->plan, size, desc->seed);
    } else {
        value = murk_search_spoq(s, p->plan, n, desc->seed, 0);
    }
    p->size = s->size;
    return value;
}

/* Under a rule on moves: relocates the start plan, and with is_plan greedy's
 * plan as well. The first evaluation of the bound is made at the cover of the
 * start plan. Values are objectives (placement/moves.h). */
static murk_curve_point find_by_moves(murk_incumbent *p, size_t n,
                                      size_t rounds, bool is_plan, size_t *made)
{
    const murk_place_desc *desc = p->desc;
    murk_gain_scan *s = p->search;
    uint32_t *trial = p->run->trial;
    const bool is_spoq = desc->method == MURK_PLACE_SPOQ;
    murk_progress_text("plans %zu sensors", n);
    /* The start plan. */
    p->size =
        murk_search_begin_at(s, p->plan, n, desc->start_plan, desc->start_size,
                             &p->run->result.started_from);
    uint64_t value = murk_moves_objective(s, p->plan, p->size);
    const uint64_t first =
        murk_bound_tighten(&p->bound, n, value, p->plan, p->size, 1);
    /* The searches. */
    if (is_spoq) {
        value = murk_search_spoq_from(s, p->plan, p->size, desc->seed);
        ++*made;
    } else {
        value = murk_moves_relocate(s, p->plan, p->size);
    }
    if (!is_spoq && is_plan && !murk_must_finish()) {
        murk_search_greedy(s, trial, 0, n, UINT64_MAX, NULL);
        const size_t size = s->size;
        const uint64_t other =
            size == n ? murk_moves_relocate(s, trial, size) : 0;
        if (other > value && !murk_interrupted()) {
            memcpy(p->plan, trial, size * sizeof *trial);
            p->size = size;
            value = other;
        }
    }
    murk_progress_text("bounds %zu sensors", n);
    const uint64_t upper = murk_bound_tighten(&p->bound, n, value, p->plan,
                                              p->size, is_plan ? rounds : 1);
    const uint64_t lower = first < upper ? first : upper;
    return (murk_curve_point){p->size, value, lower > value ? lower : value};
}

/* Callback of branch and bound under a rule on moves: stores a plan with a
 * larger objective, which becomes the cutoff. */
static uint64_t take_by_moves(void *context, const uint32_t *plan, size_t size,
                              uint64_t known)
{
    murk_incumbent *p = context;
    const uint64_t objective = murk_moves_objective(p->search, plan, size);
    if (objective <= known) {
        return known;
    }
    memcpy(p->plan, plan, size * sizeof *plan);
    p->size = size;
    return objective;
}

/* Under a rule on moves: completes a plan of fewer than n sensors by those of
 * the start plan, which cost nothing. Returns the objective. */
static uint64_t complete_by_moves(murk_incumbent *p, size_t n)
{
    const murk_place_desc *desc = p->desc;
    uint32_t *list = p->with_start;
    size_t taken;
    memcpy(list, p->plan, p->size * sizeof *list);
    memcpy(list + p->size, desc->start_plan, desc->start_size * sizeof *list);
    p->size = murk_search_begin_at(p->search, p->plan, n, list,
                                   p->size + desc->start_size, &taken);
    return murk_moves_objective(p->search, p->plan, p->size);
}

/* The plan of the other methods: one search and one bound. */
static murk_curve_point find_once(murk_incumbent *p, size_t n, size_t rounds,
                                  size_t *made)
{
    uint64_t value;
    if (p->desc->method == MURK_PLACE_SPOQ) {
        value = find_by_spoq(p, n);
        ++*made;
    } else {
        value = plan_greedily(p, n);
    }
    if (p->desc->method == MURK_PLACE_EXACT) {
        value = try_start_plan(p, n, value);
    }
    const uint64_t upper = tighten(p, n, value, p->plan, rounds);
    return (murk_curve_point){p->size, value, upper};
}

/* With constraints: completes a plan of fewer than n sensors. */
static uint64_t complete_plan(murk_incumbent *p, size_t n)
{
    murk_gain_scan *s = p->search;
    const uint64_t value =
        murk_has_budget(p->run->set)
            ? murk_search_budget_greedy(s, p->plan, p->size)
            : murk_search_greedy(s, p->plan, p->size, n, UINT64_MAX, NULL);
    p->size = s->size;
    return value;
}

/* Branch and bound, from the incumbent and the bound that was tightened last.
 * Does nothing in an unknown environment, for a method without branch and
 * bound, and for a single sensor without constraints. */
static murk_status branch_and_bound(murk_incumbent *p, size_t n,
                                    murk_curve_point *point, murk_error *err)
{
    if (!p->run->evaluator.matrix || !murk_place_has_proof(p->desc) ||
        (n < 2 && !p->run->set)) {
        return MURK_OK;
    }
    /* Search, then complete the plan. */
    murk_exact exact;
    const bool has_moves = murk_has_moves(p->run->set);
    const murk_exact_callback by_moves = {take_by_moves, p};
    const murk_status status = murk_exact_search(
        &exact, &p->bound, p->plan, p->size, n, point->value, point->upper,
        murk_place_run_nodes_left(p->run, p->desc),
        has_moves ? &by_moves : NULL, err);
    if (!status && has_moves) {
        point->value = complete_by_moves(p, n);
    } else if (!status) {
        p->size = exact.size;
        point->value = p->run->set ? complete_plan(p, n) : exact.value;
    }
    if (!status) {
        point->count = p->size;
        point->upper = exact.upper > point->value ? exact.upper : point->value;
        p->run->result.nodes += exact.nodes;
        p->run->result.is_cut = p->run->result.is_cut || exact.is_cut;
    }
    return status;
}

static size_t curve_starts(size_t restarts)
{
    const size_t share = restarts / RESTARTS_PER_CURVE_START;
    return share < CURVE_STARTS_MAX ? share : CURVE_STARTS_MAX;
}

/* Number of evaluations of the bound for k sensors. */
static size_t rounds_of(const murk_incumbent *p, size_t k, bool is_plan)
{
    const murk_place_desc *desc = p->desc;
    if (p->run->evaluator.matrix) {
        return is_plan ? p->rounds : p->rounds / ROUNDS_PER_CURVE_ROUND;
    }
    const bool has_greedy_bound =
        !p->run->set && desc->method != MURK_PLACE_SPOQ;
    const bool is_wanted = is_plan && desc->method == MURK_PLACE_BEST &&
                           p->greedy_bound[k - 1] >= desc->target;
    return !has_greedy_bound || is_wanted ? 1 : 0;
}

/* True if a plan is found quickly: one of a sequence, with little work for the
 * bound and none for the curve. */
static bool is_quick(const murk_place_desc *desc)
{
    return (desc->start_plan && desc->method == MURK_PLACE_BEST) ||
           (desc->is_of_sequence && desc->method == MURK_PLACE_GREEDY &&
            !desc->target);
}

/* Number of evaluations of the bound for the plan: by the size of the matrix;
 * few if the search is quick, because they would take most of its time
 * (smoke-hall, 50,000 photons: .9 of 1.1 s). */
static size_t rounds_for(const murk_evaluator *evaluator,
                         const murk_place_desc *desc)
{
    const bool quick = is_quick(desc);
    const double min = quick ? ROUNDS_QUICK_MIN : ROUNDS_MIN,
                 max = quick ? ROUNDS_QUICK_MAX : ROUNDS_MAX,
                 weighed = quick ? PAIRS_QUICK_MAX : PAIRS_WEIGHED_MAX;
    if (!evaluator->matrix) {
        return 1;
    }
    const double pairs = (double)murk_matrix_pairs(evaluator->matrix),
                 each = evaluator->layout->doses ? PAIRS_OF_A_CHANCE : 1;
    const double wanted = fmin(weighed / each / fmax(pairs, 1), max);
    return (size_t)fmax(wanted, min);
}

murk_status murk_incumbent_init(murk_incumbent *p, murk_place_run *run,
                                const murk_place_desc *desc, uint32_t *plan,
                                murk_error *err)
{
    const size_t n = run->last;
    *p = (murk_incumbent){.run = run,
                          .desc = desc,
                          .search = &run->search,
                          .plan = plan,
                          .rounds = rounds_for(&run->evaluator, desc)};
    p->greedy = murk_arena_array(&run->arena, n, sizeof *p->greedy);
    p->greedy_value = murk_arena_array(&run->arena, n, sizeof *p->greedy_value);
    p->greedy_bound = murk_arena_array(&run->arena, n, sizeof *p->greedy_bound);
    p->with_start = murk_arena_array(&run->arena, n + desc->start_size,
                                     sizeof *p->with_start);
    if (run->arena.is_short) {
        return murk_no_memory(err, "", "for %zu sensors", n);
    }
    /* No bound is known yet. */
    memset(p->greedy_bound, 0xff, n * sizeof *p->greedy_bound);
    p->search->rows_max = murk_gain_scan_rows_max(&run->evaluator);
    p->search->greedy_bound = p->greedy_bound;
    p->search->greedy_bound_count = run->set ? 0 : n;
    const murk_status status = murk_bound_init(&p->bound, &run->evaluator, err);
    p->bound.is_quick = is_quick(desc);
    return status ? status
                  : murk_starts_init(&p->starts, &run->evaluator, n, desc->seed,
                                     err);
}

void murk_incumbent_release(murk_incumbent *p)
{
    murk_bound_release(&p->bound);
    murk_starts_release(&p->starts);
}

void murk_incumbent_greedy(murk_incumbent *p)
{
    const uint64_t enough = p->desc->target ? p->desc->target : UINT64_MAX;
    murk_search_greedy(p->search, p->greedy, 0, p->run->last, enough,
                       p->greedy_value);
    p->has_greedy = true;
}

/* True if a point of the curve should cost no further work, because the search
 * is quick, or half of the limit on work is spent, and greedy's plan is at hand
 * (without constraints, except for MURK_PLACE_SPOQ). */
static bool is_curve_work_done(const murk_incumbent *p)
{
    const uint64_t rows =
        p->search->rows + p->starts.all_rows + p->bound.evaluations;
    return !p->run->set && p->desc->method != MURK_PLACE_SPOQ &&
           (is_quick(p->desc) ||
            rows > murk_gain_scan_rows_max(&p->run->evaluator) / 2);
}

/* A point from greedy's plan, or from the plan of one sensor fewer with one
 * more if that is worth more, and the bound of greedy's scans. */
static murk_curve_point greedy_point(murk_incumbent *p, size_t n,
                                     const uint32_t *from, uint64_t from_value)
{
    const uint64_t ceiling = p->run->evaluator.ceiling;
    uint64_t value = plan_greedily(p, n);
    if (from && from_value > value) {
        uint32_t *trial = p->run->trial;
        memcpy(trial, from, (n - 1) * sizeof *trial);
        const uint64_t with =
            murk_search_greedy(p->search, trial, n - 1, n, UINT64_MAX, NULL);
        if (p->search->size == n) { /* constraints may admit no sensor more */
            memcpy(p->plan, trial, n * sizeof *trial);
            p->size = n;
            value = with;
        }
    }
    const uint64_t greedy_bound = p->greedy_bound[n - 1];
    return (murk_curve_point){p->size, value,
                              greedy_bound < ceiling ? greedy_bound : ceiling};
}

murk_status murk_incumbent_count(murk_incumbent *p, size_t k,
                                 const uint32_t *from, murk_curve_point *last,
                                 murk_error *err)
{
    const murk_place_desc *desc = p->desc;
    /* with a target, any count may become the plan */
    const bool is_plan = desc->target || k == p->run->last;
    const size_t rounds = rounds_of(p, k, is_plan);
    size_t extra = 0;
    size_t *made = is_plan ? &p->run->result.restarts : &extra;
    const size_t max = is_plan ? desc->restarts : curve_starts(desc->restarts);
    /* say that the wanted count is infeasible before a smaller one is tried */
    murk_status status =
        k == p->run->first && !desc->target
            ? murk_place_run_find_fallback(p->run, p->run->last, err)
            : MURK_OK;
    if (!status) {
        status = murk_place_run_find_fallback(p->run, k, err);
    }
    if (status || murk_interrupted()) {
        return status;
    }
    if (murk_has_moves(p->run->set)) {
        *last = find_by_moves(p, k, rounds, is_plan, made);
    } else if (murk_must_finish() || (!is_plan && is_curve_work_done(p))) {
        *last = greedy_point(p, k, from, last->value);
        if (is_plan && desc->method != MURK_PLACE_GREEDY) {
            last->value = try_start_plan(p, k, last->value);
            last->count = p->size;
        }
        return MURK_OK;
    } else {
        *last = desc->method == MURK_PLACE_BEST
                    ? find_best(p, k, from, last->value, max, rounds, made)
                    : find_once(p, k, rounds, made);
    }
    const bool is_open = desc->target == 0 || (last->value < desc->target &&
                                               last->upper >= desc->target);
    return is_plan && is_open && !murk_must_finish()
               ? branch_and_bound(p, k, last, err)
               : MURK_OK;
}

void murk_incumbent_count_work(const murk_incumbent *p)
{
    murk_place_result *result = &p->run->result;
    result->is_work_cut |= p->search->is_cut || p->starts.is_cut;
    result->evaluations += p->search->evaluations + p->starts.all_evaluations;
    result->queries += p->search->queries + p->starts.all_queries +
                       p->bound.queries + p->run->evaluator.queries;
}
