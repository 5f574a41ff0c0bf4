/* What no plan of all candidates exceeds, for one that was explored. */
#include "study/explore.h"

#include <stdlib.h>

/* Greedy's plan of as many sensors comes with bounds for that count and the
 * fewer ones. It looks at every candidate, in a matrix where there is room. */
static murk_status place_all(murk_place_result *out,
                             const murk_problem *problem,
                             const murk_place_desc *desc, uint64_t most_bytes,
                             murk_error *err)
{
    murk_matrix *matrix = NULL;
    murk_error full = {0};
    murk_status status =
        murk_matrix_create(&matrix, problem, most_bytes, &full);
    if (!status) {
        status = murk_place_known(out, problem, matrix, desc, err);
    } else if (status == MURK_RUN_FAILED) {
        status = murk_place_unknown(out, problem, desc, err);
    } else {
        status = murk_fail(err, status, full.where, "%s", full.text);
    }
    murk_matrix_destroy(matrix);
    return status;
}

/* The curve of the stations in their order, with the bounds. */
static void follow(murk_place_result *all, const murk_explore *explore,
                   uint64_t target)
{
    all->fewest = 0;
    for (size_t k = 0; k < all->curve_points; ++k) {
        murk_curve_point *point = &all->curve[k];
        point->value = explore->step[point->count - 1].value;
        if (all->fewest == 0 && target > 0 && point->upper >= target) {
            all->fewest = point->count;
        }
    }
}

murk_status murk_explore_bound(murk_place_result *place,
                               const murk_explore *explore,
                               const murk_problem *problem,
                               const murk_place_desc *desc, uint64_t most_bytes,
                               murk_error *err)
{
    murk_place_desc greedy = *desc;
    murk_place_result all = {0};
    const bool has_budget = desc->rules && desc->rules->budget > 0;
    greedy.method = MURK_PLACE_GREEDY;
    greedy.target = 0;
    greedy.nodes = 0;
    greedy.count = has_budget ? desc->count : place->count;
    const murk_status status =
        place_all(&all, problem, &greedy, most_bytes, err);
    if (status) {
        return status;
    }
    follow(&all, explore, desc->target);
    place->upper = all.upper;
    place->proven_optimal = place->value == place->upper;
    place->guarantee = "none";
    place->fewest = all.fewest;
    place->ceiling = all.ceiling;
    place->after_presolve = all.after_presolve;
    place->curve = all.curve;
    place->curve_points = all.curve_points;
    all.curve = NULL;
    murk_place_release(&all);
    return MURK_OK;
}
