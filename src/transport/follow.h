/* A ray followed through the world as a photon is, from a place in the open:
 * what a camera sees, since light goes the same way in both directions.
 *
 * At each event the ray goes on as light would, by the same roulette, so
 * radiance divided by the square of the index is carried unchanged: through
 * Fresnel's shares, mirrors and sheets, by the diffuse share and the cosine
 * law, by albedo and phase function (Veach, Robust Monte Carlo methods for
 * light transport simulation, 1997, ch. 5.2).
 *
 * One follower belongs to one thread. */
#ifndef MURK_TRANSPORT_FOLLOW_H
#define MURK_TRANSPORT_FOLLOW_H

#include "transport/trace.h"

typedef struct murk_follower murk_follower;

/* trace: seed, stream, caps, flight, sink, leg and context hold for each ray;
 * its photons, threads and tallies do not. The world must outlive it. *out is
 * the caller's. Fails with MURK_NO_MEMORY. */
murk_status murk_follower_create(murk_follower **out, const murk_trace *trace,
                                 murk_error *err);
void murk_follower_destroy(murk_follower *follower); /* NULL is fine */

/* Follows one ray to its end (in one leg and one wrap through heights of a
 * periodic domain without surfaces, bounded regions and lamps), telling its
 * legs and events; `number` addresses its random numbers, as a photon's index
 * does. The origin lies within the domain. The emission is not told. */
void murk_follow(murk_follower *follower, uint64_t number, int band,
                 murk_vec3 origin, murk_vec3 direction);

/* From the sink: the ray may end here. It is told no more but its loss. */
void murk_follower_stop(murk_follower *follower);

#endif
