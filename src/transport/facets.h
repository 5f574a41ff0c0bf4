/* Light at a wind-blown water surface: the light interacts with one facet after
 * another until it leaves the surface.
 *
 * The facets of medium/waves.h lie at heights that are independent of their
 * slopes. A ray among the facets hits the next one as in a medium whose
 * extinction is proportional to the area that facets turn towards the ray. The
 * facet reflects or refracts the ray by Fresnel and Snell; a refracted ray
 * continues among the same facets seen from below. The ray leaves when no facet
 * is ahead: upwards above, or downwards below. Waves therefore shadow each
 * other, reflected light can hit the surface again, energy is conserved, and
 * the process is reciprocal: light with radiance n^2 on both sides, the same in
 * all directions, stays the same. Sampling a facet without these heights
 * conserves energy, but is not reciprocal.
 *
 * Light is not displaced sideways; all interactions are one event at the mean
 * level. Foam, spray and polarisation are not modelled.
 *
 * Source: Heitz, Hanika, d'Eon and Dachsbacher, ACM Trans. Graph. 35 (2016) 58,
 * doi:10.1145/2897824.2925943; Smith's heights: medium/waves.h. For
 * use inside src/transport only. */
#ifndef MURK_TRANSPORT_FACETS_H
#define MURK_TRANSPORT_FACETS_H

#include "base/rng.h"
#include "transport/bounce.h"

/* A ray is given up after this many facets. Two or three are common, and at the
 * steepest seas ten occur once in millions of rays. */
#define MURK_FACETS_MAX 1000

/* Follows a ray among the facets. Uses slots 1 to 2 MURK_FACETS_MAX at most of
 * the random address, two for each facet. mean_square_slope > 0; unit
 * directions, with the normal on the side from which the light came, as for
 * murk_refract(). The result is MURK_MIRRORED if the light leaves on that side,
 * after any number of facets, else MURK_TRANSMITTED; the direction is that in
 * which the light leaves. Returns false if the ray is given up. */
bool murk_meet_facets(const murk_address *address, double n_from, double n_to,
                      double mean_square_slope, murk_vec3 direction,
                      murk_vec3 normal, murk_bounce *bounce);

#endif
