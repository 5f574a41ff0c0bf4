/* A region placed in the world: the part of a ray inside it, the density at a
 * point, and the bounding box. For use inside src/medium only.
 *
 * A region has a shape and a filling: a constant density, a grid or a profile.
 * A region that replaces other media replaces them in all of its shape. Its
 * density is above 0 only in the part of the shape that the filling covers. A
 * box contains its faces at the low end of each axis and not those at the high
 * end, so boxes that share a face never count a point twice. */
#ifndef MURK_MEDIUM_PLACE_H
#define MURK_MEDIUM_PLACE_H

#include "base/vector.h"
#include "medium/bricks.h"
#include "medium/leaf_table.h"
#include "medium/linear_blocks.h"
#include "medium/media.h"
#include "medium/rectilinear.h"
#include "medium/tree.h"

#include <stdbool.h>
#include <stddef.h>

/* The source of the density inside. */
typedef enum murk_filling {
    MURK_FILLED_EVENLY,
    MURK_FILLED_BY_NEAREST,     /* a grid, one value per voxel */
    MURK_FILLED_BY_LINEAR,      /* a grid, trilinear */
    MURK_FILLED_BY_RECTILINEAR, /* a rectilinear grid */
    MURK_FILLED_BY_LAYERS       /* a profile */
} murk_filling;

typedef struct murk_place {
    size_t medium;
    murk_region_shape shape;
    murk_filling filling;
    bool replaces;
    bool is_moved;  /* to_local is not the identity */
    bool is_around; /* a box that is not moved and contains the domain; set by
                     * murk_media_create() */
    murk_box box;   /* of a box; box, center and radius are in the frame of the
                       region */
    murk_vec3 center;
    double radius;
    double level;         /* height of a half space */
    murk_affine to_local; /* to the frame of shape and profile; if the grid is
                             the shape: to_index */
    /* Grids: to the index space in which cell i covers [i, i + 1). Nearest:
     * shifted by one half, cell i is voxel i. Linear: not shifted, cell i
     * lies between the centres of voxels i and i + 1. */
    murk_affine to_index;
    const murk_tree *tree;
    const murk_rectilinear *field; /* in metres, to which to_index leads; NULL
                                    * for a grid of voxels */
    /* Grids: the tables for walks, owned by the murk_media; NULL if they belong
     * to the other interpolation. */
    const murk_leaf_table *leaves;
    const murk_linear_blocks *blocks;
    murk_affine
        to_albedo; /* to the index space of the albedo grid, not shifted */
    murk_bricks *bricks; /* majorants of a grid, once computed for delta
                            tracking; owned by the murk_media */
    const murk_profile *profile;
    murk_box bounds; /* bounding box of the shape in the world; infinite in
                        all directions for everywhere, sideways and downwards
                        for below; empty if the shape is a grid without active
                        voxels */
} murk_place;

/* Places a region that has been checked. False if the placement cannot be
 * inverted or is not finite. */
bool murk_place_make(murk_place *place, const murk_region *region,
                     const murk_medium *medium);

/* False if the region is a mesh and the ray is outside of it, according to the
 * bits `inside`; `region` is the number of the place in murk_media. Call the
 * functions below only if the result is true, because they assume that a mesh
 * contains the ray or point. */
static inline bool murk_place_may_hold(const murk_place *place, size_t region,
                                       murk_inside inside)
{
    return place->shape != MURK_REGION_MESH || (inside >> region & 1);
}

/* Clips [*t0, *t1] to the part of the ray inside the shape. False if nothing
 * is left. */
bool murk_place_clip(const murk_place *place, const murk_vec3 *origin,
                     const murk_vec3 *direction, double *t0, double *t1);

/* Clips [*t0, *t1] to the box of a grid or the heights of a profile, beyond
 * which the density is 0. No change if the grid is the shape or the density is
 * constant. False if nothing is left. */
bool murk_place_clip_filling(const murk_place *place, const murk_vec3 *origin,
                             const murk_vec3 *direction, double *t0,
                             double *t1);

/* True if p is inside the shape; *density is then the density there (1 for a
 * constant density). */
bool murk_place_density(const murk_place *place, int band, murk_vec3 p,
                        double *density);

#endif
