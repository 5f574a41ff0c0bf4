/* Geometry of triangles and spheres in double precision, relative to the
 * anchor of a soup (geometry/soup.h). The stored float vertices define the
 * geometry. */
#ifndef MURK_GEOMETRY_TRIANGLE_H
#define MURK_GEOMETRY_TRIANGLE_H

#include "base/vector.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct murk_triangle {
    murk_vec3 a, b, c;
} murk_triangle;

static inline murk_vec3 murk_vertex(const float *vertex, uint32_t i)
{
    const float *v = vertex + 3 * (size_t)i;
    return murk_vec((double)v[0], (double)v[1], (double)v[2]);
}

static inline murk_triangle murk_triangle_at(const float *vertex,
                                             const uint32_t corner[3])
{
    return (murk_triangle){murk_vertex(vertex, corner[0]),
                           murk_vertex(vertex, corner[1]),
                           murk_vertex(vertex, corner[2])};
}

/* Normal by the winding; the length is twice the area. */
static inline murk_vec3 murk_triangle_normal(const murk_triangle *t)
{
    return murk_cross(murk_sub(t->b, t->a), murk_sub(t->c, t->a));
}

static inline double murk_triangle_area(const murk_triangle *t)
{
    return 0.5 * murk_length(murk_triangle_normal(t));
}

/* True if the corners are collinear to rounding: the sine of the angle at the
 * first corner is at most 2^-31, or two corners are equal. At that angle a
 * rounding error of 2^-51 turns the normal by 1e-6 rad. */
bool murk_triangle_is_degenerate(const murk_triangle *t);

/* Squared distance from a point to the nearest point of the triangle. */
double murk_triangle_distance2(const murk_triangle *t, murk_vec3 p);

/* Intersections of the line o + t d with a sphere: t[0] <= t[1]. False, with t
 * unchanged, if the line misses the sphere or touches it. d need not be a unit
 * vector. */
bool murk_sphere_roots(murk_vec3 center, double radius, murk_vec3 o,
                       murk_vec3 d, double t[2]);

#endif
