/* Free heights of a periodic domain, and legs through them.
 *
 * A ray wraps about height / (period * tan(elevation)) times on its way through
 * a domain that is much higher than its period. Where neither surfaces nor
 * bounded regions nor lamps are, media are even in x and y, so a leg may lead
 * on as if the domain had no sides, and the place at its end is brought back
 * by whole periods. */
#include "transport/jump.h"

#include <stdlib.h>

/* A ray jumps that has wrapped so often since its last event. Fewer wraps cost
 * less than looking for free heights. */
#define WRAPS_BEFORE 8

/* The least a jump leads sideways [periods]. */
#define MIN_PERIODS 2

/* Share of the domain's largest coordinate by which heights that are not free
 * are grown: some times what surfaces in single precision are off by. */
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
        return murk_fail(err, MURK_NO_MEMORY, "render",
                         "no memory for the heights of %zu lights", lights);
    }
    const murk_box *box = &world->domain.box;
    const double grow =
        GROWN_BY * fmax(fmax(fmax(fabs(box->min.x), fabs(box->max.x)),
                             fmax(fabs(box->min.y), fabs(box->max.y))),
                        fmax(fabs(box->min.z), fabs(box->max.z)));
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

double murk_jump_ahead(const murk_walker *w)
{
    const murk_walk_setup *course = w->course;
    const double z = w->position.z, dz = w->direction.z;
    if (w->wraps < WRAPS_BEFORE || !course->jumps || dz == 0) {
        return 0;
    }
    const murk_walls *walls = &course->walls;
    double end = walls->z[dz > 0];
    for (size_t i = 0; i < course->n_busy; ++i) {
        const double *busy = course->busy[i];
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
    const double x = run * fabs(w->direction.x) / (walls->x[1] - walls->x[0]);
    const double y = run * fabs(w->direction.y) / (walls->y[1] - walls->y[0]);
    return fmax(x, y) > MIN_PERIODS ? run : 0;
}

static double brought_back(double x, const double wall[2])
{
    const double period = wall[1] - wall[0];
    return murk_wall_held(x - period * floor((x - wall[0]) / period), wall);
}

void murk_jump(murk_walker *w, double length_m)
{
    const murk_walls *walls = &w->course->walls;
    const murk_vec3 from = w->position;
    murk_vec3 end = murk_along(from, length_m, w->direction);
    end.z = murk_wall_held(end.z, walls->z);
    if (w->sums->are_legs_wanted) {
        murk_walker_score(w, from, length_m, w->quanta, end, 0);
    }
    w->position = end;
    if (murk_walker_is_heard(w)) {
        murk_event event = murk_walker_event(w, MURK_EVENT_WRAPPED);
        event.direction_out = w->direction;
        event.path_m = length_m;
        murk_walker_tell(w, &event);
    }
    w->position = murk_vec(brought_back(end.x, walls->x),
                           brought_back(end.y, walls->y), end.z);
    w->probe = w->position;
    ++w->wraps;
}
