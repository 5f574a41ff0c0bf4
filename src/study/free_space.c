#include "study/free_space.h"

#include <stdlib.h>

/* Points along the longest axis, or the only one. */
#define POINTS_EACH 16
#define POINTS_ALL  4096

/* In the middles of equal cells, as nearly cubes as the domain allows. */
static murk_candidate_grid grid_over(const murk_box *box)
{
    const murk_vec3 size = murk_sub(box->max, box->min);
    const double step = cbrt(size.x * size.y * size.z / POINTS_ALL);
    const double n[3] = {fmin(fmax(1, round(size.x / step)), POINTS_ALL),
                         fmin(fmax(1, round(size.y / step)), POINTS_ALL),
                         fmin(fmax(1, round(size.z / step)), POINTS_ALL)};
    const murk_vec3 half = {size.x / n[0] / 2, size.y / n[1] / 2,
                            size.z / n[2] / 2};
    return (murk_candidate_grid){
        .min = murk_add(box->min, half),
        .max = murk_sub(box->max, half),
        .size = {(size_t)n[0], (size_t)n[1], (size_t)n[2]}};
}

/* Over where the scene wants candidates, as finely as it does, within bounds.
 */
static bool grid_of_sensors(const murk_stage *stage, murk_candidate_grid *out)
{
    const murk_scene_candidates *wish = &stage->scene->sensors.candidates;
    const murk_box *domain = &stage->world.domain.box;
    *out = (murk_candidate_grid){.min = wish->grid_min, .max = wish->grid_max};
    for (int i = 0; i < 3; ++i) {
        out->size[i] =
            wish->grid_size[i] < POINTS_EACH ? wish->grid_size[i] : POINTS_EACH;
    }
    return wish->has_grid && murk_box_contains(domain, out->min) &&
           murk_box_contains(domain, out->max);
}

murk_status murk_stage_free_space(murk_open_space **out,
                                  const murk_stage *stage, unsigned threads,
                                  murk_error *err)
{
    const char *where = stage->scene->placement.where;
    const size_t n = murk_lights_count(stage->lights);
    murk_vec3 *lamp = calloc(n + 1, sizeof *lamp);
    if (!lamp) {
        return murk_fail(err, MURK_NO_MEMORY, where,
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
    murk_candidate_grid grid[MURK_OPEN_SPACE_GRIDS] = {
        grid_over(&stage->world.domain.box)};
    const size_t grids = 1 + grid_of_sensors(stage, &grid[1]);
    const murk_status status = murk_open_space_create(
        out, grid, grids, stage->surfaces, &reach, threads, where, err);
    free(lamp);
    return status;
}
