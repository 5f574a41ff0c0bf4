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

/* The share 0..1 of distant light travelling along *direction (unit, at the
 * top of the domain) that arrives at `place` on the domain's boundary. Where
 * the index of refraction changes on the way, *direction becomes the refracted
 * direction, and *is_bent (may be NULL) true. 1 unless the domain's media
 * continue and the place is on a side. */
double murk_outside_share(const murk_transport_world *world, int band,
                          murk_vec3 place, murk_vec3 *direction, bool *is_bent);

/* The same along a straight line, for pictures: 0 where the line would be
 * bent. */
double murk_outside_straight(const murk_transport_world *world, int band,
                             murk_vec3 place, murk_vec3 direction);

#endif
