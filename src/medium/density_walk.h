/* Walk along a ray through the density of a region: the value of a grid
 * (nearest, trilinear or rectilinear) or the extinction of a profile. The ray
 * is divided into segments on which the density is a cubic. For use inside
 * src/medium only. */
#ifndef MURK_MEDIUM_DENSITY_WALK_H
#define MURK_MEDIUM_DENSITY_WALK_H

#include "medium/cubic.h"
#include "medium/layers.h"
#include "medium/linear.h"
#include "medium/march.h"
#include "medium/place.h"
#include "medium/rectilinear.h"

#include <stdbool.h>

/* The state of a walk. It must not be copied after the walk has begun, because
 * murk_linear contains pointers to itself. */
typedef struct murk_density_walk {
    murk_filling filling;
    union {
        murk_march march;
        murk_linear linear;
        murk_layers layers;
        murk_rectilinear_walk field;
    } in;
} murk_density_walk;

/* Starts a walk through a region that is not homogeneous, between t0 and t1
 * from murk_place_clip_filling(). */
void murk_density_walk_begin(murk_density_walk *walk, const murk_place *place,
                             int band, murk_vec3 origin, murk_vec3 direction,
                             double t0, double t1);

/* Advances to the next segment; false at the end. Some segments have length
 * 0. */
bool murk_density_walk_next(murk_density_walk *walk);

/* End of the current segment. */
double murk_density_walk_to(const murk_density_walk *walk);

/* The density on the part [t0, t1] of the current segment. */
murk_cubic murk_density_walk_cubic(const murk_density_walk *walk, double t0,
                                   double t1);

/* Adds the integral of (scale * density + offset) over the rest of the walk to
 * *sum. Returns true if *sum reaches the limit: then *sum is the limit,
 * *collision_t the ray parameter and *density the density there, which is above
 * 0 if offset is 0. If the result is false, *collision_t and *density have no
 * meaning. */
bool murk_density_walk_integrate(murk_density_walk *walk, double scale,
                                 double offset, double limit, double *sum,
                                 double *collision_t, double *density);

#endif
