/* The shadow that a triangle throws from a point: all points that it hides
 * for certain.
 *
 * Neighbouring sightlines to one sensor are mostly stopped by the same few
 * triangles; four dot products then answer what Embree would take some
 * hundred nanoseconds for. The shadow is drawn in by margins well above
 * Embree's own rounding, so a point inside is one for which Embree says
 * blocked, too, whatever its kernel; all others are left to Embree. */
#ifndef MURK_GEOMETRY_SHADOW_H
#define MURK_GEOMETRY_SHADOW_H

#include "geometry/triangle.h"

/* Four planes: a point is inside when normal . point + offset > 0 for all:
 * three through the eye and an edge, one the triangle's own. */
typedef struct murk_shadow {
    murk_vec3 normal[4];
    double offset[4];
} murk_shadow;

/* False when the triangle throws none that is certain. unit_m: spacing of
 * floats in the scene; farthest_m: of any point asked, from the eye. */
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
