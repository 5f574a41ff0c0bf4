/* One ray and the surfaces along it, nearest first. */
#ifndef MURK_GEOMETRY_WALK_H
#define MURK_GEOMETRY_WALK_H

#include "geometry/world.h"

/* A ray from which hits are drawn one after the other. */
typedef struct murk_walk {
    const murk_surfaces *s;
    murk_vec3 origin, direction; /* relative to the anchor */
    double start_m;              /* Embree's origin along the ray */
    murk_ray_context context;
    struct RTCRayHit ray;
    float reach;  /* its largest distance */
    float passed; /* Embree's distance that is done with */
} murk_walk;

/* False when the ray cannot meet anything. origin is in the world. */
bool murk_walk_begin(murk_walk *walk, const murk_surfaces *s, murk_vec3 origin,
                     murk_vec3 direction, double max_m, unsigned mask);

/* Embree's next candidate beyond those had, in walk->ray. It may lie up to a
 * few units behind the origin: ask murk_walk_locate(). Candidates at the very
 * same float distance are one. */
bool murk_walk_next(murk_walk *walk);

/* Distance from the true origin to the candidate, and its normal (any side,
 * any length). */
double murk_walk_locate(const murk_walk *walk, murk_primitive p,
                        murk_vec3 *normal);

#endif
