/* Convex polygons: intersections of polygons with boxes and of triangles with
 * half spaces. */
#ifndef MURK_GEOMETRY_POLYGON_H
#define MURK_GEOMETRY_POLYGON_H

#include "geometry/triangle.h"

/* A triangle has three corners and each of the six planes of a box adds at most
 * one: nine. Rounding may add a few to slivers; corners beyond 16 are left
 * out. */
#define MURK_POLYGON_MAX 16

typedef struct murk_polygon {
    size_t n; /* 0: the intersection is empty */
    murk_vec3 corner[MURK_POLYGON_MAX];
} murk_polygon;

murk_polygon murk_polygon_of_triangle(const murk_triangle *t);

/* The part of a polygon in a closed box. Points on a face of the box are
 * kept, so a flat box leaves segments and points. */
murk_polygon murk_polygon_in_box(murk_polygon polygon, const murk_box *box);

/* The area [m2]; 0 for segments and points. */
double murk_polygon_area_m2(const murk_polygon *polygon);

/* The part of a triangle whose points x have `normal` . x >= height. */
murk_polygon murk_triangle_above(const murk_triangle *t, murk_vec3 normal,
                                 double height);

#endif
