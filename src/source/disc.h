/* The disc of a distant source, such as the sun, and the irradiance of a plane
 * entry face by it. Private to this room.
 *
 * A direction is the direction of the light plus a point of a disc of radius
 * tan(angular radius) across it, uniformly. The radiance is then proportional
 * to the fourth power of the cosine, which for the disc of the sun is constant
 * to 5e-5, and all results of this file are exact for it. */
#ifndef MURK_SOURCE_DISC_H
#define MURK_SOURCE_DISC_H

#include "base/vector.h"

/* The mean over the disc of max(0, cosine between the direction of travel and
 * `inward`): the irradiance on an entry face for 1 W/m2 on a plane across the
 * light. radius: tan(angular radius), 0 or more. Vectors are unit. */
double murk_disc_cosine(murk_vec3 direction, double radius, murk_vec3 inward);

/* Draws a unit direction of travel with a density proportional to that cosine
 * from three uniform numbers. murk_disc_cosine() must be above 0. */
murk_vec3 murk_disc_draw(murk_vec3 direction, double radius, murk_vec3 inward,
                         const double u[3]);

#endif
