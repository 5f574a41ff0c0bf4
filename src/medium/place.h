/* One region in its place: which part of a ray lies in it, what density it has
 * at a point, which box it fills. Inside this room only.
 *
 * Lower faces belong to a region and upper faces do not, so that regions that
 * share a face never count twice. */
#ifndef MURK_MEDIUM_PLACE_H
#define MURK_MEDIUM_PLACE_H

#include "base/vector.h"
#include "medium/bricks.h"
#include "medium/march.h"
#include "medium/media.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_place {
    size_t medium;
    murk_region_shape shape;
    bool replaces;
    bool is_moved; /* to_local is not the identity */
    murk_box box;  /* the shape in its own frame */
    murk_vec3 center;
    double radius;
    double level;          /* half spaces */
    murk_affine to_local;  /* of a grid: index space shifted by a half */
    const murk_tree *tree; /* grids */
    murk_bricks *bricks;   /* grids, where prepared for delta tracking; owned
                              by the murk_media */
    murk_box bounds;       /* in the world; infinite when everywhere, empty when
                              nothing is there */
} murk_place;

/* Places a checked region; its placement must be invertible, or false. */
bool murk_place_make(murk_place *place, const murk_region *region,
                     const murk_grid *grid);

/* The part of the ray inside, cut to [*t0, *t1] as given. False when nothing
 * is left. */
bool murk_place_clip(const murk_place *place, const murk_vec3 *origin,
                     const murk_vec3 *direction, double *t0, double *t1);

/* Sets out through a grid's place, for t0 and t1 from murk_place_clip(). */
void murk_place_march(const murk_place *place, murk_vec3 origin,
                      murk_vec3 direction, double t0, double t1,
                      murk_march *march);

/* Whether p lies inside, and the density there (1 but in grids). */
bool murk_place_density(const murk_place *place, murk_vec3 p, double *density);

#endif
