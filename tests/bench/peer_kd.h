/* nanoflann behind a C interface: the peer of the photon map's queries. */
#ifndef MURK_BENCH_PEER_KD_H
#define MURK_BENCH_PEER_KD_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct peer_kd peer_kd;

/* Over points[3 n], borrowed. */
peer_kd *peer_kd_create(const float *points, size_t n, size_t leaf);
void peer_kd_destroy(peer_kd *index);

/* radiusSearch, unsorted, one center after the other: centers[3 n]. Returns
 * how many points were found in all. */
size_t peer_kd_within(const peer_kd *index, const float *centers, size_t n,
                      float radius);

/* The same, with a result set that only adds up. */
size_t peer_kd_sums(const peer_kd *index, const float *centers, size_t n,
                    float radius);

#ifdef __cplusplus
}
#endif

#endif
