#include "study/sites.h"

#include <math.h>
#include <stdlib.h>

#define LAID_POINTS 1000 /* of a grid that the scene leaves to murk */

/* The scene's grid, or one in the middles of about LAID_POINTS equal cells of
 * the domain, as nearly cubes as the domain allows. */
static murk_candidate_grid grid_of(const murk_stage *stage)
{
    const murk_scene_candidates *wish = &stage->scene->sensors.candidates;
    if (wish->has_grid) {
        return (murk_candidate_grid){.min = wish->grid_min,
                                     .max = wish->grid_max,
                                     .size = {wish->grid_size[0],
                                              wish->grid_size[1],
                                              wish->grid_size[2]},
                                     .clearance_m = wish->clearance_m};
    }
    const murk_box *box = &stage->world.domain.box;
    const murk_vec3 size = murk_sub(box->max, box->min);
    const double step = cbrt(size.x * size.y * size.z / LAID_POINTS);
    const double n[3] = {fmin(fmax(1, round(size.x / step)), LAID_POINTS),
                         fmin(fmax(1, round(size.y / step)), LAID_POINTS),
                         fmin(fmax(1, round(size.z / step)), LAID_POINTS)};
    const murk_vec3 half = {size.x / n[0] / 2, size.y / n[1] / 2,
                            size.z / n[2] / 2};
    return (murk_candidate_grid){
        .min = murk_add(box->min, half),
        .max = murk_sub(box->max, half),
        .size = {(size_t)n[0], (size_t)n[1], (size_t)n[2]},
        .clearance_m = wish->clearance_m};
}

murk_status murk_sites_find(murk_candidates **out, const murk_stage *stage,
                            unsigned threads, murk_error *err)
{
    const murk_scene_candidates *wish = &stage->scene->sensors.candidates;
    const size_t n = murk_lights_count(stage->lights);
    murk_vec3 *lamp = calloc(n + 1, sizeof *lamp);
    if (!lamp) {
        return murk_fail(err, MURK_NO_MEMORY, wish->where,
                         "no memory for the lamps' places");
    }
    murk_reach reach = {.lamps = lamp, .domain = stage->world.domain};
    for (size_t i = 0; i < n; ++i) {
        if (murk_lights_place(stage->lights, i, &lamp[reach.n_lamps])) {
            ++reach.n_lamps;
        } else {
            reach.from_sides = true;
        }
    }
    const murk_candidate_grid grid = grid_of(stage);
    const murk_status status = murk_candidates_create(
        out, &grid, stage->surfaces, &reach, threads,
        wish->has_grid ? wish->grid_where : wish->where, err);
    free(lamp);
    return status;
}
