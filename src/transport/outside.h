/* Light of the sun and sky on its way to the sides of a domain whose media
 * continue beyond them (domain.outside: continued).
 *
 * The medium just inside of a side is taken to continue level outside: its
 * extinction and index of refraction depend on z alone there. Surfaces do not
 * continue. Only light that arrives without a collision is let in: light that
 * is scattered or reflected outside is left out. */
#ifndef MURK_TRANSPORT_OUTSIDE_H
#define MURK_TRANSPORT_OUTSIDE_H

#include "transport/trace.h"

/* The share 0..1 of distant light that arrives at `place` on a side of the
 * domain; 0 if the light is totally reflected on the way. *direction is the
 * unit direction of travel with which the light enters the media outside, at
 * the height of the domain's top, or of its bottom if the light travels
 * upwards. If the index of refraction changes at any height between there and
 * `place`, *is_bent becomes true, and *direction becomes the direction of
 * travel at `place`. Otherwise *is_bent becomes false, and *direction does not
 * change. is_bent may be NULL. The share is 1 if the media do not continue
 * (world->continues), if no medium attenuates or refracts light, or if `place`
 * is at the height at which the light enters. */
double murk_outside_share(const murk_transport_world *world, int band,
                          murk_vec3 place, murk_vec3 *direction, bool *is_bent);

/* Like murk_outside_share(), but along a straight line, for pictures: 0 if the
 * index of refraction changes on the way. */
double murk_outside_straight(const murk_transport_world *world, int band,
                             murk_vec3 place, murk_vec3 direction);

#endif
