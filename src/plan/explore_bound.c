/* Upper bounds on the value of any plan over all candidates, for comparison
 * with a plan that was found by exploration. Greedy placement
 * (placement/place.h), which knows all candidates, computes the bounds. */
#include "plan/explore.h"

#include "base/ranks.h"

#include <assert.h>
#include <stdlib.h>

/* True if a sensor type has a minimum count. */
static bool has_min(const murk_constraints *constraints)
{
    size_t sum = 0;
    for (size_t k = 0; constraints->min && k < constraints->classes; ++k) {
        sum += constraints->min[k];
    }
    return sum > 0;
}

/* Bounds the plans of desc->count sensors, and without a budget also those of
 * each smaller number (out->curve). The plan at an intermediate station need
 * not meet minimum counts of types yet, so smaller numbers are bounded without
 * minimum counts and desc->count with them. *fewest is the smallest number in
 * the curve with minimum counts, a lower bound on the number of sensors of a
 * plan that meets them; 0 without a curve. */
static murk_status bound_all(murk_place_result *out, size_t *fewest,
                             const murk_problem *problem,
                             const murk_matrix *matrix,
                             const murk_place_desc *desc, murk_error *err)
{
    const murk_status status =
        murk_place_sensors(out, problem, matrix, desc, err);
    *fewest = out->curve ? out->curve[0].count : 0;
    if (status || !has_min(desc->constraints) || !out->curve) {
        return status;
    }
    /* Once more without minimum counts. */
    murk_constraints constraints = *desc->constraints;
    murk_place_desc freer = *desc;
    murk_place_result intermediate = {0};
    constraints.min = NULL;
    freer.constraints = &constraints;
    const murk_status later =
        murk_place_sensors(&intermediate, problem, matrix, &freer, err);
    /* The curve of the second run, with the smaller bound of both runs at the
     * last number. */
    if (!later) {
        free(out->curve);
        out->curve = intermediate.curve;
        out->curve_points = intermediate.curve_points;
        intermediate.curve = NULL;
        murk_curve_point *last = &out->curve[out->curve_points - 1];
        last->upper = out->upper < last->upper ? out->upper : last->upper;
        out->upper = last->upper;
        out->is_interrupted |= intermediate.is_interrupted;
        out->is_late |= intermediate.is_late;
    }
    murk_place_release(&intermediate);
    return later;
}

/* Computes the bounds from the rows of all candidates. The rows are stored in a
 * matrix; if neither memory nor the scratch file holds the matrix, each row is
 * asked of the problem when it is needed. */
static murk_status bound_by_rows(murk_place_result *out, size_t *fewest,
                                 const murk_problem *problem,
                                 const murk_place_desc *desc, murk_error *err)
{
    murk_matrix *matrix = NULL;
    murk_error full = {0};
    /* Each rank computes all rows, because the failure of one of them, whose
     * disk is too small, is no failure of the others. */
    const murk_ranks *ranks = murk_ranks_leave();
    murk_status status =
        murk_matrix_create(&matrix, problem, desc->row_memory, &full);
    murk_ranks_return(ranks);
    status = status == MURK_OK || status == MURK_RUN_FAILED
                 ? bound_all(out, fewest, problem, matrix, desc, err)
                 : murk_fail(err, status, full.where, "%s", full.text);
    murk_matrix_destroy(matrix);
    return status;
}

/* Replaces the value at each number n of sensors in the curve by that of the
 * first n stations, fixed sensors included. Sets all->fewest to the smallest
 * number in the curve that is at least `fewest` and whose upper bound reaches
 * the target; 0 if there is none, and without a target. */
static void take_values(murk_place_result *all, const murk_explore *explore,
                        uint64_t target, size_t fewest)
{
    all->fewest = 0;
    for (size_t k = 0; k < all->curve_points; ++k) {
        murk_curve_point *point = &all->curve[k];
        point->value = explore->step[point->count - 1].value;
        if (all->fewest == 0 && target > 0 && point->upper >= target &&
            point->count >= fewest) {
            all->fewest = point->count;
        }
    }
}

murk_status murk_explore_bound(murk_place_result *place,
                               const murk_explore *explore,
                               const murk_problem *problem,
                               const murk_place_desc *desc, murk_error *err)
{
    assert(desc->constraints);
    /* Greedy placement over all candidates, for the number of sensors of the
     * explored plan, or with a budget for the maximum number desc->count. */
    murk_place_desc greedy = *desc;
    murk_place_result all = {0};
    const bool has_budget = desc->constraints->budget > 0;
    greedy.method = MURK_PLACE_GREEDY;
    greedy.target = 0;
    greedy.nodes = 0;
    greedy.count = has_budget ? desc->count : place->count;
    size_t fewest = 0;
    const murk_status status =
        bound_by_rows(&all, &fewest, problem, &greedy, err);
    if (status) {
        murk_place_release(&all);
        return status;
    }
    /* Take over the bounds; *place keeps the value and the sensors of the
     * explored plan. */
    take_values(&all, explore, desc->target, fewest);
    place->upper = all.upper;
    place->proven_optimal = place->value == place->upper;
    place->guarantee = "none";
    place->is_interrupted = all.is_interrupted;
    place->is_late = all.is_late;
    place->fewest = all.fewest;
    place->ceiling = all.ceiling;
    place->after_presolve = all.after_presolve;
    place->curve = all.curve;
    place->curve_points = all.curve_points;
    all.curve = NULL;
    murk_place_release(&all);
    return MURK_OK;
}
