/* The steps that the objectives share, from the checks of the settings to the
 * result. Each objective (placement/place.c, worst.c, at_least.c) gives a
 * function that finds the best plan for one number of sensors. The numbers are
 * tried in rising order, because a search may start at the plan with one sensor
 * fewer. */
#include "placement/run.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "base/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The cost of a move as a value: a multiple of the grain, as values are. */
static void price_moves(murk_place_run *run)
{
    const double grain = (double)run->evaluator.grain;
    const double cost = run->own_set.constraints->move_cost *
                        (double)run->evaluator.layout->whole;
    run->own_set.move_cost =
        (uint64_t)floor(cost / grain + .5) * run->evaluator.grain;
}

murk_status murk_place_run_begin(murk_place_run *run,
                                 const murk_problem *problem,
                                 const murk_matrix *matrix,
                                 const murk_place_desc *desc, murk_error *err)
{
    *run = (murk_place_run){.desc = desc,
                            .set = desc->constraints ? &run->own_set : NULL};
    /* Check settings and constraints, rank the candidates. In an unknown
     * environment ranking asks for every row, which takes long and leaves no
     * plan, so requests to finish are taken later. */
    murk_status status = murk_place_check(problem, matrix != NULL, desc, err);
    if (!status && matrix) {
        murk_finish_search_begins();
    }
    if (!status && run->set) {
        const bool is_max = desc->target || desc->constraints->budget > 0;
        status = murk_constraint_set_init(
            &run->own_set, desc->constraints, problem->candidates,
            desc->count > 0 ? desc->count : problem->candidates, is_max, err);
    }
    const size_t n = run->set ? run->set->max_sensors : desc->count;
    if (!status) {
        status =
            murk_evaluator_init(&run->evaluator, problem, matrix, run->set, n,
                                desc->row_memory, desc->keep_dominated, err);
    }
    if (!status) {
        run->evaluator.search_work = desc->search_work;
        if (murk_has_moves(run->set)) {
            price_moves(run);
        }
        status = murk_gain_scan_init(&run->search, &run->evaluator, 0,
                                     problem->threads, err);
    }
    if (status) {
        return status;
    }
    /* A curve starts at the smallest count that the checks of the constraints
     * allow. */
    const bool is_curve =
        (desc->with_curve || desc->target) && !murk_has_budget(run->set);
    run->last = n;
    run->first = !is_curve ? n : run->set ? run->set->min_sensors : 1;
    run->plan = murk_arena_array(&run->arena, n, sizeof *run->plan);
    run->trial = murk_arena_array(&run->arena, n, sizeof *run->trial);
    run->search.fallback =
        murk_arena_array(&run->arena, n, sizeof *run->search.fallback);
    murk_place_result *result = &run->result;
    result->guarantee = "none";
    result->fewest = desc->target ? run->first : 0;
    result->sensor = calloc(n, sizeof *result->sensor);
    result->curve = is_curve ? calloc(n, sizeof *result->curve) : NULL;
    return run->arena.is_short || !result->sensor ||
                   (is_curve && !result->curve)
               ? murk_no_memory(err, "", "for %zu sensors", n)
               : MURK_OK;
}

bool murk_place_run_keep(murk_place_run *run, const uint32_t *plan, size_t size,
                         uint64_t value)
{
    if (run->size > 0 && value <= run->value) {
        return false;
    }
    memcpy(run->plan, plan, size * sizeof *plan);
    run->size = size;
    run->value = value;
    return true;
}

/* Completes a plan of the fixed sensors with any candidates, and stores it as
 * the fallback. False if there is no plan of n, or (*is_sure false) if the
 * search for one is given up; an interrupted search is not told. */
static bool complete_fallback(murk_place_run *run, size_t n, bool *is_sure)
{
    const murk_constraint_set *set = run->set;
    *is_sure = true;
    if (!set || !set->has_conflicts) {
        return true;
    }
    murk_partial_plan *partial = &run->search.partial;
    murk_partial_plan_clear(partial, n);
    for (size_t k = 0; k < set->constraints->fixed_count; ++k) {
        murk_partial_plan_add(partial, (uint32_t)set->constraints->fixed[k]);
    }
    if (!murk_partial_plan_complete(partial, is_sure)) {
        return murk_interrupted();
    }
    memcpy(run->search.fallback, partial->member,
           partial->size * sizeof *partial->member);
    run->search.fallback_size = partial->size;
    return true;
}

murk_status murk_place_run_find_fallback(murk_place_run *run, size_t n,
                                         murk_error *err)
{
    bool is_sure;
    return complete_fallback(run, n, &is_sure)
               ? MURK_OK
               : murk_fail(err, MURK_RUN_FAILED, "",
                           is_sure ? "no plan: no %zu of %zu usable "
                                     "candidates keep all rules"
                                   : "no plan found: of %zu sensors at "
                                     "%zu usable candidates that keeps "
                                     "all rules",
                           n, run->evaluator.candidates);
}

/* Raises `fewest`, the lower bound on the number of sensors, if the upper bound
 * on the value of n sensors is below the target. Without conflicts between
 * candidates every smaller plan can be extended to n sensors, so all smaller
 * numbers are excluded as well. With conflicts, `fewest` is raised only if each
 * smaller number was excluded by the bound for that number (is_open). */
static void update_fewest(murk_place_run *run, size_t n, uint64_t upper)
{
    const bool may_fill = !(run->set && run->set->has_conflicts);
    if (upper >= run->desc->target) {
        run->is_open = true;
    } else if (!run->is_open || may_fill) {
        run->result.fewest = n + 1;
    }
}

/* True for a number below the wanted one of which no plan is found: a rule on
 * moves may hold a small plan to sensors of the start plan that break other
 * constraints, and admit a larger one. */
static bool is_gap(murk_place_run *run, size_t n)
{
    bool is_sure;
    return murk_has_moves(run->set) && n < run->last &&
           !complete_fallback(run, n, &is_sure);
}

static murk_status find_all(murk_place_run *run, murk_find_count find,
                            void *context, murk_error *err)
{
    murk_place_result *result = &run->result;
    const uint64_t target = run->desc->target;
    uint32_t *last_plan =
        murk_arena_array(&run->arena, run->last, sizeof *last_plan);
    if (!last_plan) {
        return murk_no_memory(err, "", "for %zu sensors", run->last);
    }
    /* Each count builds on the plan of the count before. */
    murk_curve_point point = {0};
    bool has_last = false; /* the plan of k - 1 sensors */
    for (size_t k = run->first; k <= run->last && !murk_interrupted(); ++k) {
        if (is_gap(run, k)) {
            run->is_open = true; /* no bound excludes this number */
            has_last = false;
            continue;
        }
        result->started_from = 0;
        const murk_status status =
            find(context, k, has_last ? last_plan : NULL, &point, err);
        if (status) {
            return status;
        }
        if (result->curve) {
            result->curve[result->curve_points++] = point;
        }
        if (target) {
            update_fewest(run, k, point.upper);
        }
        memcpy(last_plan, run->plan, run->size * sizeof *last_plan);
        has_last = true;
        if (target && point.value >= target) {
            break;
        }
    }
    result->count = run->size;
    result->value = point.value;
    result->upper = point.upper;
    return MURK_OK;
}

/* Fails because the searches ended before a plan reached the target. */
static murk_status fail_early(murk_error *err)
{
    return murk_finish_was_late()
               ? murk_fail(err, MURK_RUN_FAILED, "",
                           "the time limit came before a plan was found that "
                           "reaches the target")
               : murk_fail(err, MURK_INTERRUPTED, "",
                           "interrupted before a plan was found that reaches "
                           "the target");
}

murk_status murk_place_run_counts(murk_place_run *run, murk_find_count find,
                                  void *context, murk_error *err)
{
    const murk_place_desc *desc = run->desc;
    const bool starts =
        desc->method == MURK_PLACE_BEST || desc->method == MURK_PLACE_SPOQ;
    murk_finish_search_begins();
    murk_progress_begin("place", starts ? desc->restarts : 0,
                        starts ? "starts at most" : "");
    murk_status status = find_all(run, find, context, err);
    murk_progress_end();
    status = status ? status : murk_interrupt_check(err);
    /* A plan that misses the target is no result. */
    const murk_place_result *result = &run->result;
    return !status && murk_must_finish() && result->value < desc->target &&
                   result->upper >= desc->target
               ? fail_early(err)
               : status;
}

uint64_t murk_place_run_nodes_left(const murk_place_run *run,
                                   const murk_place_desc *desc)
{
    const uint64_t done = run->result.nodes;
    return desc->nodes > done ? desc->nodes - done : 0;
}

void murk_place_run_join_bounds(murk_place_run *run)
{
    murk_curve_point *curve = run->result.curve;
    if (!curve || run->result.curve_points == 0 ||
        (run->set && (run->set->has_conflicts || murk_has_moves(run->set)))) {
        return;
    }
    for (size_t k = run->result.curve_points - 1; k > 0; --k) {
        if (curve[k - 1].upper > curve[k].upper) {
            curve[k - 1].upper = curve[k].upper;
        }
    }
}

murk_status murk_place_run_end(murk_place_result *out, murk_place_run *run,
                               murk_status status)
{
    murk_place_result *result = &run->result;
    /* What ended the search, and the plan. */
    result->is_interrupted = murk_finish_search_ends();
    result->is_late = murk_finish_was_late();
    for (size_t k = 0; !status && k < result->count; ++k) {
        result->sensor[k] = run->plan[k];
        result->cost +=
            run->set ? murk_constraint_set_cost(run->set, run->plan[k]) : 0;
    }
    if (!status) {
        qsort(result->sensor, result->count, sizeof *result->sensor,
              murk_by_size);
        result->proven_optimal = murk_place_objective(result) == result->upper;
        result->after_presolve = run->evaluator.undominated;
        *out = *result;
        *result = (murk_place_result){0};
    }
    murk_place_release(result);
    murk_gain_scan_release(&run->search);
    murk_evaluator_release(&run->evaluator);
    murk_constraint_set_release(&run->own_set);
    murk_arena_release(&run->arena);
    return status;
}
