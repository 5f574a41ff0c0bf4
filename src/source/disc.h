/* The disc of a distant source, as the sun's, seen by a plane opening. Private
 * to this room.
 *
 * Directions are the light's own plus a place on a disc of radius tan(angular
 * radius) across it, evenly: radiance goes as the fourth power of the cosine,
 * which for the sun's disc is even to 5e-5, and makes all here exact. */
#ifndef MURK_SOURCE_DISC_H
#define MURK_SOURCE_DISC_H

#include "base/vector.h"

/* Mean of the part above 0 of the cosine between directions of travel and
 * `inward`, over the disc, for cosine 1 at right angles: irradiance on the
 * opening for 1 W/m2 on a plane across the light. radius: tan(angular radius),
 * 0 or more. Vectors are unit. */
double murk_disc_cosine(murk_vec3 direction, double radius, murk_vec3 inward);

/* A unit direction of travel by that cosine, for three uniform numbers; where
 * murk_disc_cosine() is above 0. */
murk_vec3 murk_disc_draw(murk_vec3 direction, double radius, murk_vec3 inward,
                         const double u[3]);

#endif
