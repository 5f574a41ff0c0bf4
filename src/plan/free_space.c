/* The free space of a scene: the places where light enters it, the test whether
 * light can reach a point, and the free share of a box or a ball.
 *
 * The share is estimated by stratified sampling: 24^3 equal cells of the
 * bounding box with one random point each; points outside a ball are ignored.
 * Source of the method: any text on Monte Carlo integration, for example A. B.
 * Owen, Monte Carlo theory, methods and examples, chapter 8. */
#include "plan/free_space.h"

#include "base/log.h"
#include "base/pool.h"
#include "base/position.h"
#include "base/rng.h"
#include "base/tally.h"

#include <math.h>
#include <stdlib.h>

/* ---- entrances of light ---- */

static bool is_same(murk_vec3 a, murk_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Appends the centre of a portal to place[n], unless this point is among
 * place[first .. n - 1] already: sun and sky usually share their portals.
 * Returns the new number of places. */
static size_t add_portal(murk_vec3 *place, size_t first, size_t n,
                         const murk_portal *portal)
{
    murk_vec3 middle = murk_along(portal->corner, 0.5, portal->edge1);
    middle = murk_along(middle, 0.5, portal->edge2);
    for (size_t i = first; i < n; ++i) {
        if (is_same(place[i], middle)) {
            return n;
        }
    }
    place[n] = middle;
    return n + 1;
}

murk_status murk_entrances(murk_reach *out, murk_vec3 **places,
                           const murk_stage *stage, const char *where,
                           murk_error *err)
{
    const murk_sources *lights = stage->lights;
    const size_t n = murk_sources_count(lights);
    /* Allocate for one position of each lamp and one of each portal. */
    size_t capacity = n + 1;
    for (size_t i = 0; i < n; ++i) {
        capacity += murk_sources_get(lights, i)->portals;
    }
    murk_vec3 *place = calloc(capacity, sizeof *place);
    if (!place) {
        return murk_no_memory(err, where, "for the lamps' places");
    }
    /* The positions of lamps, and whether any light source is distant. */
    murk_reach reach = {.lamps = place, .domain = stage->world.domain};
    for (size_t i = 0; i < n; ++i) {
        if (murk_sources_place(lights, i, &place[reach.n_lamps])) {
            ++reach.n_lamps;
        } else {
            reach.from_sides = true;
        }
    }
    /* Portals. */
    const size_t lamps = reach.n_lamps;
    for (size_t i = 0; i < n; ++i) {
        const murk_source *light = murk_sources_get(lights, i);
        for (size_t k = 0; k < light->portals; ++k) {
            reach.n_lamps =
                add_portal(place, lamps, reach.n_lamps, &light->portal[k]);
        }
    }
    *out = reach;
    *places = place;
    return MURK_OK;
}

/* ---- the test of a point ---- */

/* Largest number of points on each axis of the grid over the candidates, and
 * approximate number of points of the whole grid over the domain: 16^3. */
#define POINTS_EACH 16
#define POINTS_ALL  4096

/* Fills *out with a grid of at most POINTS_EACH points on each axis over the
 * grid of candidates of the scene. Returns false if the scene gives no grid of
 * candidates, or if that grid does not lie in the domain. */
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

void murk_warn_unless_open(const murk_open_space *space, const char *where,
                           const char *name, murk_vec3 place)
{
    if (!murk_open_space_holds(space, place, murk_vec(0, 0, 0))) {
        murk_warn(where,
                  "%s stands at %s m, from where no open way to any light was "
                  "found: it may be inside something or behind a wall",
                  name, murk_position_show(place).text);
    }
}

murk_status murk_warn_of_fixed_sensors(const murk_stage *stage,
                                       unsigned threads, murk_error *err)
{
    const murk_scene_sensors *sensors = &stage->scene->sensors;
    murk_open_space *space = NULL;
    if (sensors->n_fixed == 0 || murk_stage_is_dark(stage)) {
        return MURK_OK;
    }
    const murk_status status =
        murk_stage_free_space(&space, stage, threads, err);
    for (size_t k = 0; k < sensors->n_fixed && !status; ++k) {
        murk_warn_unless_open(space, sensors->fixed[k].where, "a fixed sensor",
                              sensors->fixed[k].position);
    }
    murk_open_space_destroy(space);
    return status;
}

/* ---- the free share ---- */

/* Cells on each axis. With 24^3 points the standard error is at most .5 /
 * 24^1.5 = 0.004. */
#define CELLS_EACH 24

typedef struct job {
    const murk_part *part;
    const murk_open_space *space;
    uint32_t seed;
    murk_tally inside, free;
} job;

/* Tests the random points of all cells of one layer (equal z), and adds to the
 * numbers of points inside the part and of points in free space. */
static void ask(void *context, uint64_t layer)
{
    job *j = context;
    const murk_part *part = j->part;
    const murk_vec3 size = murk_sub(part->box.max, part->box.min);
    int64_t inside = 0, is_free = 0;
    for (uint64_t i = 0; i < CELLS_EACH * CELLS_EACH; ++i) {
        const uint64_t place = layer * CELLS_EACH * CELLS_EACH + i;
        /* A random point in the cell. */
        const murk_random4 r =
            murk_random(j->seed, MURK_FREE_SPACE, place, part->number, 0);
        const murk_vec3 at = murk_vec(
            part->box.min.x +
                size.x * ((double)(i % CELLS_EACH) + r.u[0]) / CELLS_EACH,
            part->box.min.y +
                size.y * ((double)(i / CELLS_EACH) + r.u[1]) / CELLS_EACH,
            part->box.min.z + size.z * ((double)layer + r.u[2]) / CELLS_EACH);
        /* Count the points in the part, and those in free space. */
        if (part->is_ball &&
            murk_length(murk_sub(at, part->center)) > part->radius_m) {
            continue;
        }
        ++inside;
        is_free += murk_open_space_holds(j->space, at, murk_vec(0, 0, 0));
    }
    murk_tally_add(&j->inside, inside);
    murk_tally_add(&j->free, is_free);
}

murk_estimate murk_free_share(const murk_part *part,
                              const murk_open_space *space, uint32_t seed,
                              unsigned threads)
{
    job j = {.part = part, .space = space, .seed = seed};
    if (!space) {
        return (murk_estimate){1, 0};
    }
    murk_pool_run(threads, CELLS_EACH, ask, &j);
    const double n = (double)murk_tally_read(&j.inside),
                 share = n > 0 ? (double)murk_tally_read(&j.free) / n : 0;
    return (murk_estimate){share, n > 0 ? sqrt(share * (1 - share) / n) : 0};
}
