/* Intersections of triangles with boxes and half spaces: convex polygons.
 * Internal to the room. */
#ifndef MURK_GEOMETRY_POLYGON_H
#define MURK_GEOMETRY_POLYGON_H

#include "geometry/triangle.h"

/* A triangle has three corners and each of the six planes of a box adds one:
 * nine. Rounding may add a few to slivers; corners beyond 16 are left out. */
#define MURK_POLYGON_MAX 16

typedef struct murk_polygon {
    size_t n; /* 0: the intersection is empty */
    murk_vec3 corner[MURK_POLYGON_MAX];
} murk_polygon;

/* The part of a triangle in a closed box. Points on a face of the box are
 * kept, so a flat box leaves segments and points. */
murk_polygon murk_triangle_in_box(const murk_triangle *t, const murk_box *box);

/* The part of a triangle at `normal` . x >= height. */
murk_polygon murk_triangle_above(const murk_triangle *t, murk_vec3 normal,
                                 double height);

#endif
