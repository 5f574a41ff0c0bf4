/* One region in its place: which part of a ray lies in it, what density it has
 * at a point, which box it fills. Inside this room only.
 *
 * Lower faces belong to a region and upper faces do not, so that regions that
 * share a face never count twice. */
#ifndef MURK_MEDIUM_PLACE_H
#define MURK_MEDIUM_PLACE_H

#include "base/vector.h"
#include "medium/bricks.h"
#include "medium/media.h"
#include "medium/tree.h"

#include <stdbool.h>
#include <stddef.h>

/* What gives the density inside. */
typedef enum murk_filling {
    MURK_FILLED_EVENLY,
    MURK_FILLED_BY_NEAREST, /* a grid, a value a voxel */
    MURK_FILLED_BY_LINEAR,  /* a grid, trilinear */
    MURK_FILLED_BY_LAYERS   /* a profile */
} murk_filling;

typedef struct murk_place {
    size_t medium;
    murk_region_shape shape;
    murk_filling filling;
    bool replaces;
    bool is_moved; /* to_local is not the identity */
    murk_box box;  /* the shape in its own frame */
    murk_vec3 center;
    double radius;
    double level;         /* half spaces */
    murk_affine to_local; /* the shape's frame, and a profile's; where the grid
                             is the shape: to_index */
    /* Grids: index space in which cell i covers [i, i + 1). Nearest: shifted
     * by a half, cell i is voxel i. Linear: as it is, cell i lies between the
     * centres of voxels i and i + 1. */
    murk_affine to_index;
    const murk_tree *tree;
    murk_affine to_albedo; /* index space of the albedo's grid, as it is */
    murk_bricks *bricks;   /* grids, where prepared for delta tracking; owned by
                              the murk_media */
    const murk_profile *profile;
    murk_box bounds; /* of the shape in the world; infinite when everywhere,
                        empty when nothing is there */
} murk_place;

/* Places a checked region; its placement must be invertible, or false. */
bool murk_place_make(murk_place *place, const murk_region *region,
                     const murk_medium *medium);

/* False for a mesh that a ray of this set is not in; region: the place's
 * number. What follows holds for the others. */
static inline bool murk_place_may_hold(const murk_place *place, size_t region,
                                       murk_inside inside)
{
    return place->shape != MURK_REGION_MESH || (inside >> region & 1);
}

/* The part of the ray inside the shape, cut to [*t0, *t1] as given. False when
 * nothing is left. */
bool murk_place_clip(const murk_place *place, const murk_vec3 *origin,
                     const murk_vec3 *direction, double *t0, double *t1);

/* The same of the box of a grid, or of the heights of a profile, beyond which
 * the density is 0; all of it where the grid is the shape, or evenly filled. */
bool murk_place_clip_filling(const murk_place *place, const murk_vec3 *origin,
                             const murk_vec3 *direction, double *t0,
                             double *t1);

/* Whether p lies inside the shape, and the density there (1 where evenly
 * filled). */
bool murk_place_density(const murk_place *place, int band, murk_vec3 p,
                        double *density);

#endif
