/* Delta tracking through overlapping grids (medium/delta.h). The majorant of
 * an interval is the sum of the majorants of all grids and the constant
 * extinction; each grid walks through the bricks on its own
 * (medium/bricks.h). */
#include "medium/delta.h"

#include "medium/bricks.h"
#include "medium/linear.h"
#include "medium/nodes.h"
#include "medium/steps.h"

#include <assert.h>
#include <math.h>

/* Edge of a brick in voxels: the smallest. Tighter majorants make fewer null
 * collisions, which cost more than steps between bricks (figures in
 * medium/README.md). */
#define EDGE MURK_BRICK_EDGE_MIN

/* A grid that the ray crosses. */
typedef struct grid_track {
    const murk_place *place;
    double extinction_per_m; /* extinction at density 1 */
    murk_brick_walk walk;

    /* The cell of 128 voxels visited last. */
    const unsigned char *lower;
    int32_t lower_first[3];
} grid_track;

/* Takes the next pair of random numbers of the flight: the optical depth of
 * the next collision, and the number that decides between real and null. One
 * Philox call gives two pairs. */
static void next_randoms(murk_flight *f)
{
    murk_flight_randoms *stream = f->stream;
    if (stream->has_pair) {
        stream->has_pair = false;
        f->limit = -log(stream->pair[0]);
        f->u = stream->pair[1];
        return;
    }
    const murk_random4 random = murk_random_at(stream->address, ++stream->slot);
    f->limit = -log(random.u[0]);
    f->u = random.u[1];
    stream->pair[0] = random.u[2];
    stream->pair[1] = random.u[3];
    stream->has_pair = true;
}

/* The lower node around a voxel of the tree. NULL if there is none: then
 * *value is the constant value there. */
static const unsigned char *find_lower(const murk_tree *tree,
                                       const int32_t voxel[3], float *value)
{
    const murk_root_cell *root = murk_tree_root_cell(tree, voxel);
    *value = root ? root->value : 0;
    if (!root || !root->node) {
        return NULL;
    }
    const murk_cell cell =
        murk_upper_cell(root->node, voxel[0], voxel[1], voxel[2]);
    *value = cell.value;
    return cell.child;
}

/* Trilinear density at t. */
static double linear_at(const grid_track *k, double t)
{
    const murk_brick_walk *w = &k->walk;
    const murk_vec3 p = {w->origin[0] + t * w->direction[0],
                         w->origin[1] + t * w->direction[1],
                         w->origin[2] + t * w->direction[2]};
    double density = 0;
    return murk_linear_density(k->place->tree, p, &density) ? density : 0;
}

/* The density at t, which is inside the tree's box except for rounding. */
static inline double density_at(grid_track *k, double t)
{
    const murk_brick_walk *w = &k->walk;
    const murk_tree *tree = k->place->tree;
    if (k->place->filling == MURK_FILLED_BY_LINEAR) {
        return linear_at(k, t);
    }
    /* The voxel at t, clamped to the box. */
    int32_t voxel[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double at = w->origin[axis] + t * w->direction[axis];
        voxel[axis] = murk_voxel_at(at, tree->first[axis], tree->last[axis]);
    }
    /* Descend from the root only if the ray has left the last cell of 128
     * voxels. */
    if (!k->lower || !murk_cell_contains(k->lower_first, voxel, 128)) {
        float value;
        k->lower = find_lower(tree, voxel, &value);
        if (!k->lower) {
            return (double)value;
        }
        murk_cell_first(k->lower_first, voxel, 128);
    }
    const murk_cell cell =
        murk_lower_cell(k->lower, voxel[0], voxel[1], voxel[2]);
    return cell.child ? (double)murk_leaf_values(
                            cell.child)[(voxel[0] & 7) << 6 |
                                        (voxel[1] & 7) << 3 | (voxel[2] & 7)]
                      : (double)cell.value;
}

/* Decides whether the collision at t is real. */
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
        tracks[i].lower = NULL;
        murk_brick_walk_begin(&tracks[i].walk, grids[i]->bricks,
                              murk_affine_point(to_index, f->origin),
                              murk_affine_direction(to_index, f->direction),
                              *from, to);
    }
    /* Interval by interval of constant majorant. */
    double t = *from;
    while (t < to) {
        /* The sum of the majorants, and the nearest end of a brick. */
        double bound = even_per_m, end = to;
        for (size_t i = 0; i < n; ++i) {
            murk_brick_walk *w = &tracks[i].walk;
            while (w->to <= t && murk_brick_walk_next(w)) {
            }
            bound += tracks[i].extinction_per_m * w->bound;
            end = w->to < end ? w->to : end;
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
