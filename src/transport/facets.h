/* Light at a wind-blown boundary: from facet to facet until it goes away.
 *
 * The facets of medium/waves.h lie at heights that do not go with their slopes.
 * A ray among them meets the next one as in a fog whose extinction goes by the
 * area that facets turn towards the ray; what it meets reflects or refracts it
 * by Fresnel and Snell, and refracted it goes on among the same facets seen
 * from below. It leaves where no facet is left to meet: upwards above, or
 * downwards below. So a wave hides another, light that is thrown back at the
 * surface meets it again, nothing is ever made or lost, and the way back has
 * the weight of the way there: light of radiance n^2 on both sides, the same
 * in all directions, stays so. A choice of facet without these hidden heights
 * keeps energy, but not that balance.
 *
 * No light is displaced sideways, all is one event at the mean level; nor are
 * there foam, spray or polarisation.
 *
 * Source: Heitz, Hanika, d'Eon and Dachsbacher, ACM Trans. Graph. 35 (2016) 58,
 * doi:10.1145/2897824.2925943; Smith's heights: medium/waves.h.
 * Private to this room. */
#ifndef MURK_TRANSPORT_FACETS_H
#define MURK_TRANSPORT_FACETS_H

#include "base/rng.h"
#include "transport/bounce.h"

/* Light that has met as many is given up. Two or three are common, and at the
 * steepest seas ten are one in millions. */
#define MURK_FACETS_MAX 1000

/* Draws slots 1 to 2 MURK_FACETS_MAX at most of the address, two a facet.
 * mean_square_slope > 0; unit directions, the normal facing where the light
 * came from, as of murk_refract(). MURK_MIRRORED when it leaves on that side,
 * however many facets it met, else MURK_TRANSMITTED; the direction leads to
 * the side it leaves on. False when it is given up. */
bool murk_meet_facets(const murk_address *address, double n_from, double n_to,
                      double mean_square_slope, murk_vec3 direction,
                      murk_vec3 normal, murk_bounce *bounce);

#endif
