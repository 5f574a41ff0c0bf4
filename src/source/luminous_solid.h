/* The luminous part of a luminaire with luminous sides: a box or an upright
 * cylinder, convex, with the same radiance at every point of its outside that
 * is seen from one direction.
 *
 * Light in a direction leaves through all faces that are seen from there, in
 * proportion to their projected areas, so the intensity of the whole is that of
 * the photometric file at any distance that is large against the solid. The
 * radiance towards a direction is the intensity divided by the silhouette, the
 * area that the solid shows.
 *
 * Coordinates are those of the solid: the center at 0, x along C = 0, y along C
 * = 90 degrees, z along the photometric zero. */
#ifndef MURK_SOURCE_LUMINOUS_SOLID_H
#define MURK_SOURCE_LUMINOUS_SOLID_H

#include "base/vector.h"

#include <stdbool.h>

typedef struct murk_luminous_solid {
    double half[3]; /* [m] half the length along each axis; of a cylinder along
                     * z alone */
    double radius;  /* [m] of a cylinder; 0: a box */
} murk_luminous_solid;

/* The projected area [m2] along a unit direction. */
double murk_luminous_silhouette(const murk_luminous_solid *solid,
                                murk_vec3 direction);

/* The point at which light that travels in a unit direction leaves the solid,
 * uniform over the silhouette, from two numbers in (0, 1). */
murk_vec3 murk_luminous_leave(const murk_luminous_solid *solid,
                              murk_vec3 direction, const double u[2]);

typedef struct murk_luminous_point {
    murk_vec3 point, normal; /* on the outside, unit normal outwards */
    double area;             /* [m2] of all faces that the place sees */
} murk_luminous_point;

/* Draws a point of the faces that a place sees, uniform over their area, from
 * two numbers in (0, 1). False if the place sees none: it is in the solid. */
bool murk_luminous_draw(const murk_luminous_solid *solid, murk_vec3 place,
                        const double u[2], murk_luminous_point *out);

/* The point in which a ray from a place outside enters the solid, with the
 * distance to it; out->area is the same as in murk_luminous_draw(). False if
 * the ray misses the solid or begins in it. */
bool murk_luminous_meet(const murk_luminous_solid *solid, murk_vec3 place,
                        murk_vec3 sight, murk_luminous_point *out,
                        double *distance_m);

#endif
