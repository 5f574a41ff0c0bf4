/* Jumps through the free heights of a periodic domain (transport/jump.h).
 *
 * A ray through a domain that is much higher than its period wraps about height
 * / (period * tan(elevation)) times. At heights without surfaces, bounded
 * regions and lamps the media do not depend on x and y. A segment may therefore
 * continue there as if the domain had no sides; the position at the end of the
 * segment is then moved back by whole periods. */
#include "transport/jump.h"

#include <stdlib.h>

/* A ray jumps only after this many wraps since the last other event. Fewer
 * wraps cost less than the search for free heights. */
#define WRAPS_BEFORE 8

/* The smallest sideways length of a jump [periods]. */
#define MIN_PERIODS 2

/* Share of the domain's largest coordinate by which a range of heights that is
 * not free grows at both ends: a multiple of the rounding error of surfaces in
 * single precision. */
#define GROWN_BY 1e-5

static void add(double (*height)[2], size_t *n, double low, double high,
                double grow)
{
    if (low <= high) {
        height[*n][0] = low - grow;
        height[*n][1] = high + grow;
        ++*n;
    }
}

murk_status murk_jump_heights(double (**out)[2], size_t *n,
                              const murk_transport_world *world,
                              murk_error *err)
{
    *out = NULL;
    *n = 0;
    if (!world->domain.is_periodic) {
        return MURK_OK;
    }
    const size_t lights = murk_sources_count(world->lights);
    double(*height)[2] = calloc(lights + 2, sizeof *height);
    if (!height) {
        return murk_no_memory(err, "render", "for the heights of %zu lights",
                              lights);
    }
    /* The heights of surfaces, bounded regions and lamps, enlarged by the
     * rounding error. */
    const double grow =
        GROWN_BY * murk_box_largest_coordinate(&world->domain.box);
    const murk_box surfaces = murk_surfaces_describe(world->surfaces).bounds_m;
    const murk_box regions = murk_media_bounds(world->media);
    add(height, n, surfaces.min.z, surfaces.max.z, grow);
    add(height, n, regions.min.z, regions.max.z, grow);
    for (size_t i = 0; i < lights; ++i) {
        const murk_source *light = murk_sources_get(world->lights, i);
        const murk_box lamp = murk_source_box(light);
        add(height, n, lamp.min.z, lamp.max.z, grow);
    }
    *out = height;
    return MURK_OK;
}

bool murk_trace_may_jump(const murk_domain *domain, murk_vec3 direction)
{
    /* A path of p periods along an axis passes at most p + 1 sides. */
    const murk_vec3 size = murk_sub(domain->box.max, domain->box.min);
    const double x = fabs(direction.x) / size.x, y = fabs(direction.y) / size.y,
                 periods = size.z * (x + y) / fabs(direction.z);
    return domain->is_periodic && !(periods + 2 < WRAPS_BEFORE);
}

double murk_jump_ahead(const murk_walker *w)
{
    const murk_walk_setup *setup = w->setup;
    const double z = w->path.position.z, dz = w->path.direction.z;
    if (w->wraps < WRAPS_BEFORE || !setup->jumps || dz == 0) {
        return 0;
    }
    /* The jump ends at the next height that is not free. */
    const murk_path_sides *sides = &setup->space.sides;
    double end = sides->z[dz > 0];
    for (size_t i = 0; i < setup->n_busy; ++i) {
        const double *busy = setup->busy[i];
        if (z > busy[0] && z < busy[1]) {
            return 0;
        }
        if (dz > 0 && busy[0] >= z) {
            end = fmin(end, busy[0]);
        } else if (dz < 0 && busy[1] <= z) {
            end = fmax(end, busy[1]);
        }
    }
    const double run = (end - z) / dz;
    const double x =
        run * fabs(w->path.direction.x) / (sides->x[1] - sides->x[0]);
    const double y =
        run * fabs(w->path.direction.y) / (sides->y[1] - sides->y[0]);
    return fmax(x, y) > MIN_PERIODS ? run : 0;
}

void murk_jump(murk_walker *w, double length_m)
{
    const murk_path_sides *sides = &w->setup->space.sides;
    const murk_vec3 from = w->path.position;
    murk_vec3 end = murk_along(from, length_m, w->path.direction);
    end.z = murk_path_side_hold(end.z, sides->z);
    murk_walker_score(w, from, length_m, w->quanta, end, 0);
    w->path.position = end;
    if (murk_walker_is_heard(w)) {
        murk_event event;
        murk_walker_event(&event, w, MURK_EVENT_WRAPPED);
        event.direction_out = w->path.direction;
        event.path_m = length_m;
        murk_walker_tell(w, &event);
    }
    w->path.position = murk_vec(murk_path_side_wrap(end.x, sides->x),
                                murk_path_side_wrap(end.y, sides->y), end.z);
    w->probe = w->path.position;
    ++w->wraps;
}
