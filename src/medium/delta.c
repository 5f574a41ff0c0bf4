#include "medium/delta.h"

#include "medium/bricks.h"

#include <assert.h>
#include <math.h>

/* Of the edges tried, bricks of 16 voxels cost least on most grids (see
 * src/README.md). */
#define EDGE 16

/* The next pair of the flight's numbers: how far, and what is met there. */
static void throw(murk_flight * f)
{
    murk_dice *dice = f->dice;
    if (dice->has_pair) {
        dice->has_pair = false;
        f->limit = -log(dice->pair[0]);
        f->u = dice->pair[1];
        return;
    }
    const murk_random4 random = murk_random_at(dice->address, ++dice->slot);
    f->limit = -log(random.u[0]);
    f->u = random.u[1];
    dice->pair[0] = random.u[2];
    dice->pair[1] = random.u[3];
    dice->has_pair = true;
}

/* Whether what was met at t is real. */
static bool is_real(murk_flight *f, double t, double bound,
                    const murk_place *const *grids, size_t n, double even_per_m,
                    double *density)
{
    const murk_vec3 p = murk_along(f->origin, t, f->direction);
    double real = even_per_m;
    for (size_t i = 0; i < n; ++i) {
        if (!murk_place_density(grids[i], p, &density[i])) {
            density[i] = 0;
        }
        real += murk_flight_extinction(f, grids[i]) * density[i];
    }
    if (!(f->u * bound < real)) {
        return false;
    }
    f->u *= bound / real; /* given that, even in (0, 1) again */
    f->stop_m = t;
    return true;
}

bool murk_delta_cross(murk_flight *flight, double *from, double to,
                      const murk_place *const *grids, size_t n,
                      double even_per_m, double *density)
{
    murk_flight *f = flight;
    const double factor = f->media->bound_factor;
    murk_brick_walk walk[MURK_REGIONS_MAX];
    for (size_t i = 0; i < n; ++i) {
        const murk_affine *to_local = &grids[i]->to_local;
        murk_brick_walk_begin(
            &walk[i], grids[i]->bricks, murk_affine_point(to_local, f->origin),
            murk_affine_direction(to_local, f->direction), *from, to);
    }
    double t = *from;
    while (t < to) {
        double bound = even_per_m, end = to;
        for (size_t i = 0; i < n; ++i) {
            while (walk[i].to <= t && murk_brick_walk_next(&walk[i])) {
            }
            bound += murk_flight_extinction(f, grids[i]) * walk[i].bound;
            end = fmin(end, walk[i].to);
        }
        bound *= factor;
        const double more = f->depth + bound * (end - t);
        if (!(more >= f->limit && bound > 0)) {
            f->depth = more;
            t = end;
            continue;
        }
        t = fmin(end, t + (f->limit - f->depth) / bound);
        if (is_real(f, t, bound, grids, n, even_per_m, density)) {
            return true;
        }
        throw(f);
        f->depth = 0;
        if (++f->dice->nulls > MURK_NULLS_MAX) {
            f->dice = NULL;
            break;
        }
    }
    *from = t;
    return false;
}

murk_status murk_delta_prepare(murk_media *media, int32_t edge, double factor,
                               murk_error *err)
{
    assert(factor > 0);
    media->bound_factor = factor;
    for (size_t i = 0; i < media->n_places; ++i) {
        murk_place *place = &media->places[i];
        if (place->tree) {
            murk_bricks *bricks;
            const murk_status status =
                murk_bricks_create(&bricks, place->tree, edge, 0, 0,
                                   media->media[place->medium].where, err);
            if (status) {
                return status;
            }
            murk_bricks_destroy(place->bricks);
            place->bricks = bricks;
        }
    }
    return MURK_OK;
}

murk_status murk_media_prepare_delta(murk_media *media, murk_error *err)
{
    return murk_delta_prepare(media, EDGE, 1, err);
}
