/* Delta tracking through overlapping grids (medium/delta.h). The majorant of an
 * interval is the sum of the majorants of all grids and the constant
 * extinction. The ray walks through the bricks of each grid separately
 * (medium/bricks.h). */
#include "medium/delta.h"

#include "base/logarithm.h"
#include "medium/bricks.h"
#include "medium/linear.h"

#include <assert.h>
#include <math.h>

/* Edge of a brick in voxels: the smallest. Smaller bricks have tighter
 * majorants, and the null collisions that are saved cost more time than the
 * additional steps between bricks (figures in medium/README.md). */
#define EDGE MURK_BRICK_EDGE_MIN

/* A grid that the ray crosses. */
typedef struct grid_track {
    const murk_place *place;
    double extinction_per_m; /* extinction at density 1 */
    murk_brick_walk walk;
    murk_tree_cursor cursor;
} grid_track;

/* Sets f->limit, the optical depth of the next collision, and f->u, the number
 * that decides whether this collision is real or null, from the next pair of
 * random numbers of the flight. One call of murk_random_at() gives two pairs.
 */
static void next_randoms(murk_flight *f)
{
    murk_flight_randoms *stream = f->stream;
    if (stream->has_pair) {
        stream->has_pair = false;
        f->limit = -murk_log(stream->pair[0]);
        f->u = stream->pair[1];
        return;
    }
    const murk_random4 random = murk_random_at(stream->address, ++stream->slot);
    f->limit = -murk_log(random.u[0]);
    f->u = random.u[1];
    stream->pair[0] = random.u[2];
    stream->pair[1] = random.u[3];
    stream->has_pair = true;
}

/* The density at t, which is inside the tree's box except for rounding. */
static inline double density_at(grid_track *k, double t)
{
    const murk_grid_ray *r = &k->walk.ray;
    const murk_tree *tree = k->place->tree;
    const double at[3] = {r->origin[0] + t * r->direction[0],
                          r->origin[1] + t * r->direction[1],
                          r->origin[2] + t * r->direction[2]};
    if (k->place->filling == MURK_FILLED_BY_LINEAR) {
        double density = 0;
        return murk_linear_density(k->place->blocks,
                                   murk_vec(at[0], at[1], at[2]), &density)
                   ? density
                   : 0;
    }
    /* The voxel at t, clamped to the box. */
    int32_t voxel[3];
    for (int axis = 0; axis < 3; ++axis) {
        voxel[axis] =
            murk_voxel_at(at[axis], tree->first[axis], tree->last[axis]);
    }
    const murk_tree_node node = murk_tree_node_at(&k->cursor, voxel);
    return (double)(node.leaf ? node.leaf[murk_offset_in_leaf(voxel)]
                              : node.value);
}

/* True if the collision at t is real. Sets density[n] to the densities at t; at
 * a real collision also f->collision_m, and f->u to a fresh uniform number. */
static inline bool is_real(murk_flight *f, double t, double bound,
                           grid_track *tracks, size_t n, double even_per_m,
                           double *density)
{
    double real = even_per_m;
    for (size_t i = 0; i < n; ++i) {
        density[i] = density_at(&tracks[i], t);
        real += tracks[i].extinction_per_m * density[i];
    }
    if (!(f->u * bound < real)) {
        return false;
    }
    f->u *= bound / real; /* given acceptance, uniform in (0, 1) again */
    f->collision_m = t;
    return true;
}

bool murk_delta_cross(murk_flight *flight, double *from, double to,
                      const murk_place *const *grids, size_t n,
                      double even_per_m, double *density)
{
    murk_flight *f = flight;
    const double factor = f->media->bound_factor;
    grid_track tracks[MURK_REGIONS_MAX];
    for (size_t i = 0; i < n; ++i) {
        const murk_affine *to_index = &grids[i]->to_index;
        tracks[i].place = grids[i];
        tracks[i].extinction_per_m = murk_flight_extinction(f, grids[i]);
        tracks[i].cursor = (murk_tree_cursor){.tree = grids[i]->tree};
        murk_brick_walk_begin(&tracks[i].walk, grids[i]->bricks,
                              murk_affine_point(to_index, f->origin),
                              murk_affine_direction(to_index, f->direction),
                              *from, to);
    }
    /* Interval by interval of constant majorant. */
    double t = *from;
    while (t < to) {
        /* The sum of the majorants, and the nearest end of a segment of
         * constant bound. */
        double bound = even_per_m, end = to;
        for (size_t i = 0; i < n; ++i) {
            murk_brick_walk *w = &tracks[i].walk;
            while (w->ray.to <= t && murk_brick_walk_next(w)) {
            }
            bound += tracks[i].extinction_per_m * w->bound;
            end = w->ray.to < end ? w->ray.to : end;
        }
        bound *= factor;
        /* Collision by collision, up to the end of the interval with these
         * majorants. */
        for (;;) {
            const double more = f->depth + bound * (end - t);
            if (!(more >= f->limit && bound > 0)) {
                f->depth = more;
                t = end;
                break;
            }
            const double next = t + (f->limit - f->depth) / bound;
            t = next < end ? next : end;
            if (is_real(f, t, bound, tracks, n, even_per_m, density)) {
                return true;
            }
            next_randoms(f);
            f->depth = 0;
            /* Too many null collisions: continue by marching. */
            if (++f->stream->nulls > MURK_NULLS_MAX) {
                f->stream = NULL;
                *from = t;
                return false;
            }
        }
    }
    *from = to;
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
            const bool is_linear = place->filling == MURK_FILLED_BY_LINEAR;
            const murk_status status =
                murk_bricks_create(&bricks, place->tree, edge, 0, is_linear,
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
