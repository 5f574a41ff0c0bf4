/* Follows a ray of a camera through the world as if it were a photon. Light
 * paths are reversible, so the camera sees the light that arrives at the places
 * of the ray from there. The ray must start at a position that is on no
 * surface.
 *
 * At each event the ray continues with the probabilities of a photon: of
 * Fresnel reflectance at interfaces; of the diffuse and specular reflectance
 * and the transmittance of surfaces, with the cosine law after diffuse
 * reflection; and of albedo and phase function in media. Absorption ends the
 * ray by roulette, or lowers the weight of the ray (least_weight in
 * transport/trace.h). The mean over rays therefore carries radiance divided by
 * the square of the refractive index (Veach, Robust Monte Carlo methods for
 * light transport simulation, 1997, ch. 5.2).
 *
 * A follower must not be used by two threads at the same time. */
#ifndef MURK_TRANSPORT_FOLLOW_H
#define MURK_TRANSPORT_FOLLOW_H

#include "transport/trace.h"

typedef struct murk_follower murk_follower;

/* Creates a follower. `trace` is copied: its members world, seed, stream,
 * events_max, wraps_max, least_weight, by_delta, sink, segment_sink and context
 * apply to each ray; the others (first, last, threads, tallies, takes_back) do
 * not. The world must outlive the follower. The caller destroys *out. Fails
 * with MURK_NO_MEMORY. */
murk_status murk_follower_create(murk_follower **out, const murk_trace *trace,
                                 murk_error *err);
void murk_follower_destroy(murk_follower *follower); /* NULL is fine */

/* Follows one ray to its end and reports segments and events; `number`
 * addresses the random numbers, as the index of a photon does. After a number
 * of wraps without another event, a ray passes heights of a periodic domain
 * without surfaces, bounded regions and lamps in one segment and one wrap
 * (transport/jump.h). The origin lies within the domain. The emission is not
 * reported. */
void murk_follow_photon(murk_follower *follower, uint64_t number, int band,
                        murk_vec3 origin, murk_vec3 direction);

/* Called from the event sink: ends the ray, which is then reported as lost with
 * MURK_LOSS_EVENTS unless it has ended already. */
void murk_follower_stop(murk_follower *follower);

#endif
