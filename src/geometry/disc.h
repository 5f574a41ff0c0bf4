/* Whether a flat disc lies wholly on the surfaces, with nothing else about it:
 * what the kernel of a density estimate asks before it takes the disc's area
 * for that of the surface. */
#ifndef MURK_GEOMETRY_DISC_H
#define MURK_GEOMETRY_DISC_H

#include "geometry/surfaces.h"

/* True only where flat triangles in the disc's plane fill it, once, to one part
 * in a thousand of its area, and no other surface reaches into the ball around
 * it. normal: unit. False is no answer: so it is on spheres, and where a mesh
 * is not quite flat. */
bool murk_surfaces_fill_disc(const murk_surfaces *surfaces, murk_vec3 center,
                             murk_vec3 normal, double radius_m);

/* Area of a triangle within a circle about the origin of its plane, by its
 * corners there. */
double murk_disc_area_in_triangle(double corner[3][2], double radius);

#endif
