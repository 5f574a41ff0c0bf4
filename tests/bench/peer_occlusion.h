/* Raw Embree: the same sightlines, packed 16 wide beforehand, cast and nothing
 * else. */
#ifndef MURK_BENCH_PEER_OCCLUSION_H
#define MURK_BENCH_PEER_OCCLUSION_H

#include "base/vector.h"
#include "geometry/mesh.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct peer_occlusion peer_occlusion;

/* NULL when it fails. */
peer_occlusion *peer_occlusion_create(const murk_mesh *mesh);
void peer_occlusion_destroy(peer_occlusion *peer);

/* Sightlines from[n] to one sensor, less trim_m at either end; a new packet
 * begins. False when out of memory. */
bool peer_occlusion_add(peer_occlusion *peer, const murk_vec3 *from, size_t n,
                        murk_vec3 sensor, double trim_m);

/* Casts all; returns how many are blocked. is_coherent: Embree's hint for rays
 * that share an end. */
size_t peer_occlusion_cast(const peer_occlusion *peer, unsigned threads,
                           bool is_coherent);

#endif
