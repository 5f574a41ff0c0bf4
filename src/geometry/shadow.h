/* The shadow of a triangle as seen from a point: a region in which every point
 * is certainly occluded by the triangle.
 *
 * Neighbouring sightlines to one sensor are mostly blocked by the same few
 * triangles. Four dot products then answer a question for which Embree takes
 * some hundred nanoseconds. The shadow is reduced by margins well above
 * Embree's own rounding, so Embree would report any point inside as occluded
 * too, whichever of Embree's kernels runs. All other points are left to
 * Embree. */
#ifndef MURK_GEOMETRY_SHADOW_H
#define MURK_GEOMETRY_SHADOW_H

#include "geometry/triangle.h"

/* Four planes: a point is inside if normal . point + offset > 0 for all of
 * them. Three planes pass through the eye and an edge; the fourth is the
 * plane of the triangle. */
typedef struct murk_shadow {
    murk_vec3 normal[4];
    double offset[4];
} murk_shadow;

/* Computes the shadow; false if the triangle has none that is certain.
 * unit_m: spacing of floats in the scene; farthest_m: the largest distance
 * of any queried point from the eye. */
bool murk_shadow_make(murk_shadow *shadow, const murk_triangle *triangle,
                      murk_vec3 eye, double unit_m, double farthest_m);

static inline bool murk_shadow_hides(const murk_shadow *s, murk_vec3 p)
{
    for (int i = 0; i < 4; ++i) {
        if (!(murk_dot(s->normal[i], p) + s->offset[i] > 0)) {
            return false;
        }
    }
    return true;
}

#endif
