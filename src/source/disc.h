/* The disc of a distant source, such as the sun, and the irradiance that the
 * disc gives on a plane entry face. For use inside src/source only.
 *
 * A direction of travel is the central direction of the light plus a vector
 * from the center to a point of a disc of radius tan(angular radius) at right
 * angles to that direction. Equal areas of the disc give equal irradiance. The
 * radiance is then proportional to 1 / cosine^4 of the angle from the direction
 * of the light, which for the disc of the sun is constant to 5e-5, and all
 * results of this file are exact for this radiance. */
#ifndef MURK_SOURCE_DISC_H
#define MURK_SOURCE_DISC_H

#include "base/vector.h"

/* The mean over the disc of max(0, p . inward), where p = direction + point of
 * the disc, a vector that is not normalised. The mean is the irradiance on an
 * entry face for an irradiance of 1 W/m2 on a plane perpendicular to
 * `direction`. radius: tan(angular radius), 0 or more. `direction` and `inward`
 * are unit vectors. */
double murk_disc_cosine(murk_vec3 direction, double radius, murk_vec3 inward);

/* Draws a point of the disc with a density proportional to max(0, p . inward)
 * from three uniform numbers, and returns p as a unit direction of travel. A
 * radius of 0 gives `direction`. murk_disc_cosine() must be above 0. */
murk_vec3 murk_disc_draw(murk_vec3 direction, double radius, murk_vec3 inward,
                         const double u[3]);

#endif
