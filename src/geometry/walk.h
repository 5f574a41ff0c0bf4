/* Visits the surfaces along a ray one after the other, nearest first: Embree
 * finds the next primitive in single precision, and the distance is computed in
 * double precision from the plane or sphere. The functions are inline, because
 * every part of a photon's path between surfaces takes one call of each. */
#ifndef MURK_GEOMETRY_WALK_H
#define MURK_GEOMETRY_WALK_H

#include "geometry/ray_scene.h"
#include "geometry/triangle.h"

#include <float.h>

/* A ray starts this many float steps (geometry/ray_scene.h) early, so that an
 * origin which rounding pushed through a nearby surface does not miss that
 * surface. Hits behind the true origin are skipped by the caller. 2 exceeds the
 * 0.9 steps by which rounding moves an origin. */
#define MURK_WALK_BACK_UNITS 2

/* The distance of a plane in double precision is accepted if it agrees with
 * Embree's to this many float steps, which is far above Embree's own error.
 * Otherwise the ray is almost parallel to the plane, and Embree's point is
 * at least inside the triangle. */
#define MURK_WALK_AGREE_UNITS 64

/* The state of a ray between two hits. */
typedef struct murk_walk {
    const murk_surfaces *s;
    murk_vec3 origin, direction; /* relative to the anchor */
    double start_m;              /* Embree's origin along the ray */
    murk_ray_context context;
    struct RTCRayHit ray;
    float reach;  /* Embree's largest distance of the ray */
    bool has_hit; /* Embree has found a candidate, at the distance ray.ray.tfar
                   */
} murk_walk;

/* Starts a ray of the length max_m, which may be INFINITY; `origin` is in world
 * coordinates and `direction` a unit vector. Only faces whose bit is in `mask`
 * (MURK_MASK_...) are visited. False if the ray cannot hit anything. */
static inline bool murk_walk_begin(murk_walk *w, const murk_surfaces *s,
                                   murk_vec3 origin, murk_vec3 direction,
                                   double max_m, unsigned mask)
{
    if (!s->scene || !(max_m > 0)) {
        return false;
    }
    w->s = s;
    w->origin = murk_sub(origin, s->soup.anchor);
    w->direction = direction;
    double first = 0, last = max_m;
    if (!murk_box_contains(&s->reach, w->origin) &&
        !murk_box_clip(&s->reach, w->origin, direction, &first, &last)) {
        return false;
    }
    w->start_m = first - MURK_WALK_BACK_UNITS * s->unit_m;
    murk_embree_context_init(&w->context.embree);
    w->context.origin = murk_along(w->origin, w->start_m, direction);
    w->context.direction = direction;
    if (!murk_is_finite(origin) ||
        !murk_ray_is_sound(w->context.origin, direction)) {
        return false;
    }
    /* An infinite max_m stays infinite; a finite max_m is enlarged so that
     * rounding loses no hit at the end. */
    const double reach_m = (max_m - w->start_m) * (1 + (double)FLT_EPSILON);
    murk_ray_set(&w->ray.ray, w->context.origin, direction, (float)reach_m,
                 mask);
    w->reach = w->ray.ray.tfar;
    w->has_hit = false;
    return true;
}

/* Finds Embree's next candidate, in walk->ray. The candidate may lie up to a
 * few float steps (geometry/ray_scene.h) behind the origin: murk_walk_locate()
 * gives the true distance. Of candidates at the same float distance only one is
 * found. False if there is no further candidate. */
static inline bool murk_walk_next(murk_walk *w)
{
    /* Beyond the last candidate: from the next float on. */
    w->ray.ray.tnear = w->has_hit ? nextafterf(w->ray.ray.tfar, INFINITY) : 0;
    w->ray.ray.tfar = w->reach;
    w->ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    murk_embree_intersect(w->s->scene, &w->context.embree, &w->ray);
    w->has_hit = w->ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    return w->has_hit;
}

/* The distance of the sphere along the ray that is nearer to `about`. */
static inline double murk_walk_sphere_distance(const murk_walk *w,
                                               const murk_stored_sphere *sphere,
                                               double about)
{
    double t[2];
    if (!murk_sphere_roots(sphere->center, sphere->radius, w->origin,
                           w->direction, t)) {
        return about;
    }
    return fabs(t[0] - about) <= fabs(t[1] - about) ? t[0] : t[1];
}

/* Distance from the true origin to the candidate, and the normal there
 * (either side, any length). */
static inline double murk_walk_locate(const murk_walk *w, murk_primitive p,
                                      murk_vec3 *normal)
{
    const murk_soup *soup = &w->s->soup;
    const double about = (double)w->ray.ray.tfar + w->start_m;
    if (p.is_sphere) {
        const murk_stored_sphere *sphere = &soup->sphere[p.index];
        const double distance = murk_walk_sphere_distance(w, sphere, about);
        *normal = murk_sub(murk_along(w->origin, distance, w->direction),
                           sphere->center);
        return distance;
    }
    const murk_plane *plane = &soup->plane[p.index];
    *normal = plane->normal;
    const double distance =
        murk_dot(murk_sub(plane->point, w->origin), *normal) /
        murk_dot(w->direction, *normal);
    return fabs(distance - about) <= MURK_WALK_AGREE_UNITS * w->s->unit_m
               ? distance
               : about;
}

#endif
