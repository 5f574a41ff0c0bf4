/* The frame of a placement for the worst scenario: checks the settings, ranks
 * the candidates, finds the plan of each count (placement/worst_count.h), and
 * makes the result. */
#include "placement/worst.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "placement/settings.h"
#include "placement/worst_count.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static murk_status begin(murk_worst_run *w, const murk_problem *problem,
                         const murk_matrix *matrix, const murk_blocks *blocks,
                         murk_place_result *result, murk_error *err)
{
    const murk_place_desc *desc = w->desc;
    murk_status status = murk_evaluator_init(
        &w->evaluator, problem, matrix, w->set,
        w->set ? w->set->max_sensors : desc->count, desc->keep_dominated, err);
    if (!status) {
        status =
            murk_block_layouts_init(&w->layouts, &w->evaluator, blocks, err);
    }
    if (!status) {
        status = murk_worst_search_init(&w->search, &w->layouts, err);
    }
    if (!status) {
        status = murk_worst_bound_init(&w->bound, &w->layouts, err);
    }
    if (status) {
        return status;
    }
    /* A curve starts at the smallest feasible count. */
    const bool is_curve =
        (desc->with_curve || desc->target) && !(w->set && w->set->has_budget);
    w->last = w->set ? w->set->max_sensors : desc->count;
    w->first = !is_curve ? w->last : w->set ? w->set->min_sensors : 1;
    w->plan = calloc(w->last, sizeof *w->plan);
    w->trial = calloc(w->last, sizeof *w->trial);
    w->fallback = calloc(w->last, sizeof *w->fallback);
    result->sensor = calloc(w->last, sizeof *result->sensor);
    result->curve = is_curve ? calloc(w->last, sizeof *result->curve) : NULL;
    return w->plan && w->trial && w->fallback && result->sensor &&
                   (result->curve || !is_curve)
               ? MURK_OK
               : murk_fail(err, MURK_NO_MEMORY, "", "no memory for %zu sensors",
                           w->last);
}

static void release(murk_worst_run *w)
{
    murk_worst_bound_release(&w->bound);
    murk_worst_search_release(&w->search);
    murk_block_layouts_release(&w->layouts);
    murk_evaluator_release(&w->evaluator);
    free(w->plan);
    free(w->trial);
    free(w->fallback);
}

static murk_status find_all(murk_worst_run *w, murk_error *err)
{
    murk_place_result *result = w->result;
    const uint64_t target = w->desc->target;
    uint32_t *from = calloc(w->last, sizeof *from);
    murk_status status = from ? MURK_OK
                              : murk_fail(err, MURK_NO_MEMORY, "",
                                          "no memory for %zu sensors", w->last);
    for (size_t k = w->first; !status && !murk_interrupted(); ++k) {
        /* With a target, any count may become the plan; branch and bound is for
         * the plan only. */
        const bool is_asked = target || k == w->last;
        status =
            murk_worst_count(w, k, is_asked, k > w->first ? from : NULL, err);
        const bool is_open =
            target == 0 || (w->value < target && w->upper >= target);
        if (!status && is_asked && is_open && !murk_interrupted()) {
            status = murk_worst_branch_and_bound(w, k, err);
        }
        if (status) {
            break;
        }
        if (result->curve) {
            result->curve[k - w->first] =
                (murk_curve_point){w->size, w->value, w->upper};
            result->curve_points = k - w->first + 1;
        }
        if (target && result->fewest == 0 && w->upper >= target) {
            result->fewest = k;
        }
        memcpy(from, w->plan, w->size * sizeof *from);
        if (k == w->last || (target && w->value >= target)) {
            break;
        }
    }
    free(from);
    return status;
}

/* A plan of fewer sensors covers no more, if every plan can be completed. */
static void join_bounds(murk_curve_point *curve, size_t n,
                        const murk_constraint_set *set)
{
    for (size_t k = n - 1; k > 0 && !(set && set->has_conflicts); --k) {
        if (curve[k].upper < curve[k - 1].upper) {
            curve[k - 1].upper = curve[k].upper;
        }
    }
}

static murk_status check_target(const murk_worst_run *w, murk_error *err)
{
    const uint64_t target = w->desc->target;
    const double share = (double)target / (double)MURK_SHARE_ONE;
    if (w->value >= target) {
        return MURK_OK;
    }
    const double best = (double)w->value / (double)MURK_SHARE_ONE;
    const double upper = (double)w->upper / (double)MURK_SHARE_ONE;
    return w->upper < target
               ? murk_fail(err, MURK_BAD_VALUE, "",
                           "target %.6g cannot be reached in the worst "
                           "condition: %zu sensors see at most %.6g of it",
                           share, w->last, upper)
               : murk_fail(err, MURK_RUN_FAILED, "",
                           "no plan found that reaches the target %.6g in the "
                           "worst condition with at most %zu sensors: the "
                           "best found sees %.6g",
                           share, w->last, best);
}

static int by_number(const void *a, const void *b)
{
    const size_t x = *(const size_t *)a, y = *(const size_t *)b;
    return (x > y) - (x < y);
}

static void fill(murk_place_result *result, const murk_worst_run *w)
{
    result->count = w->size;
    for (size_t k = 0; k < w->size; ++k) {
        result->sensor[k] = w->plan[k];
        result->cost +=
            w->set ? murk_constraint_set_cost(w->set, w->plan[k]) : 0;
    }
    qsort(result->sensor, result->count, sizeof *result->sensor, by_number);
    if (result->curve) {
        join_bounds(result->curve, result->curve_points, w->set);
    }
    result->value = w->value;
    result->upper = w->upper;
    result->proven_optimal = w->value == w->upper;
    result->guarantee = "none";
    result->ceiling = murk_worst_ceiling(w);
    result->whole = MURK_SHARE_ONE;
    result->after_presolve = w->evaluator.undominated;
    result->evaluations = w->search.evaluations;
}

murk_status murk_place_worst(murk_place_result *out,
                             const murk_problem *problem,
                             const murk_matrix *matrix,
                             const murk_blocks *blocks,
                             const murk_place_desc *desc, murk_error *err)
{
    assert(out && problem && matrix && blocks && desc && blocks->n >= 1);
    assert(blocks->n <= MURK_BLOCKS_MAX);
    murk_constraint_set rulebook = {0};
    murk_place_result result = {0};
    murk_worst_run w = {.desc = desc,
                        .set = desc->constraints ? &rulebook : NULL,
                        .blocks = blocks->n,
                        .result = &result};
    /* Check settings and constraints, rank the candidates. */
    murk_status status = murk_place_check(problem, true, desc, err);
    if (!status && desc->constraints) {
        const bool is_max = desc->target || desc->constraints->budget > 0;
        status = murk_constraint_set_init(
            &rulebook, desc->constraints, problem->candidates,
            desc->count > 0 ? desc->count : problem->candidates, is_max, err);
    }
    if (!status) {
        status = begin(&w, problem, matrix, blocks, &result, err);
    }
    if (!status && desc->target > murk_worst_ceiling(&w)) {
        status = murk_fail(
            err, MURK_BAD_VALUE, "",
            "target %.6g cannot be reached in the worst condition: all %zu "
            "usable candidates together see %.6g of it",
            (double)desc->target / (double)MURK_SHARE_ONE,
            w.evaluator.candidates,
            (double)murk_worst_ceiling(&w) / (double)MURK_SHARE_ONE);
    }
    if (status) {
        goto done;
    }
    /* Find the plans, and make the result. */
    const bool starts =
        desc->method == MURK_PLACE_BEST || desc->method == MURK_PLACE_SPOQ;
    murk_progress_begin("place", starts ? desc->restarts : 0,
                        starts ? "starts at most" : "");
    status = find_all(&w, err);
    murk_progress_end();
    if (!status && murk_interrupted()) {
        status = murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    if (!status && desc->target) {
        status = check_target(&w, err);
    }
    if (!status) {
        fill(&result, &w);
        *out = result;
        result = (murk_place_result){0};
    }
done:
    release(&w);
    murk_constraint_set_release(&rulebook);
    murk_place_release(&result);
    return status;
}
