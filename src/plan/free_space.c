/* Sets up the grids and the entrances of light for the test of free space. */
#include "plan/free_space.h"

#include "plan/entrances.h"

#include <stdlib.h>

/* Points on each axis of the grid of candidates, and of the whole grid over the
 * domain: each grid has at most 16^3 = 4096 points. */
#define POINTS_EACH 16
#define POINTS_ALL  4096

/* Fills *out with a grid over the grid of candidates, not finer than
 * POINTS_EACH points on an axis. False if the scene has no such grid in the
 * domain. */
static bool grid_of_sensors(const murk_stage *stage, murk_candidate_grid *out)
{
    const murk_scene_candidates *settings = &stage->scene->sensors.candidates;
    const murk_box *domain = &stage->world.domain.box;
    *out = (murk_candidate_grid){.min = settings->grid_min,
                                 .max = settings->grid_max};
    for (int i = 0; i < 3; ++i) {
        out->size[i] = settings->grid_size[i] < POINTS_EACH
                           ? settings->grid_size[i]
                           : POINTS_EACH;
    }
    return settings->has_grid && murk_box_contains(domain, out->min) &&
           murk_box_contains(domain, out->max);
}

murk_status murk_stage_free_space(murk_open_space **out,
                                  const murk_stage *stage, unsigned threads,
                                  murk_error *err)
{
    const char *where = stage->scene->placement.where;
    murk_vec3 *lamp = NULL;
    murk_reach reach;
    murk_status status = murk_entrances(&reach, &lamp, stage, where, err);
    if (status) {
        return status;
    }
    murk_candidate_grid grid[MURK_OPEN_SPACE_GRIDS] = {
        murk_candidate_grid_fill(&stage->world.domain.box, POINTS_ALL)};
    const size_t grids = 1 + grid_of_sensors(stage, &grid[1]);
    status = murk_open_space_create(out, grid, grids, stage->surfaces, &reach,
                                    threads, where, err);
    free(lamp);
    return status;
}
