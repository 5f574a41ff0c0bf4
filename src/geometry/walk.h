/* Visits the surfaces along a ray one after the other, nearest first. */
#ifndef MURK_GEOMETRY_WALK_H
#define MURK_GEOMETRY_WALK_H

#include "geometry/ray_scene.h"

/* The state of a ray between two hits. */
typedef struct murk_walk {
    const murk_surfaces *s;
    murk_vec3 origin, direction; /* relative to the anchor */
    double start_m;              /* Embree's origin along the ray */
    murk_ray_context context;
    struct RTCRayHit ray;
    float reach;  /* Embree's largest distance of the ray */
    float passed; /* the next float beyond Embree's distance of the last hit */
} murk_walk;

/* Starts a ray of the length max_m, which may be INFINITY; `origin` is in world
 * coordinates and `direction` a unit vector. Only faces whose bit is in `mask`
 * (MURK_MASK_...) are visited. False if the ray cannot hit anything. */
bool murk_walk_begin(murk_walk *walk, const murk_surfaces *s, murk_vec3 origin,
                     murk_vec3 direction, double max_m, unsigned mask);

/* Finds Embree's next candidate, in walk->ray. The candidate may lie up to a
 * few float steps (geometry/ray_scene.h) behind the origin: murk_walk_locate()
 * gives the true distance. Of candidates at the same float distance only one is
 * found. False if there is no further candidate. */
bool murk_walk_next(murk_walk *walk);

/* Distance from the true origin to the candidate, and the normal there
 * (either side, any length). */
double murk_walk_locate(const murk_walk *walk, murk_primitive p,
                        murk_vec3 *normal);

#endif
