/* Tests whether a flat disc lies entirely on surfaces with no other surface
 * nearby. A density estimate on a surface photon map uses the answer before
 * it takes the area of the disc for the area of the surface. */
#ifndef MURK_GEOMETRY_DISC_H
#define MURK_GEOMETRY_DISC_H

#include "geometry/surfaces.h"

/* True only if the parts inside the disc of all triangles in the plane of the
 * disc add up to the area of the disc, to one part in a thousand, and no other
 * surface reaches into the ball with the centre and radius of the disc.
 * `normal` is a unit vector. False means unknown: on spheres, and on meshes
 * that are not quite flat, the answer is always false. */
bool murk_surfaces_fill_disc(const murk_surfaces *surfaces, murk_vec3 center,
                             murk_vec3 normal, double radius_m);

/* Area, 0 or more, of the intersection of a triangle and a circle about the
 * origin; the corners are given in the plane of the circle, in the same unit as
 * the radius. */
double murk_disc_area_in_triangle(double corner[3][2], double radius);

#endif
