/* A photon map: stored photons in a balanced kd-tree with bucket leaves.
 *
 * The records are stored in tree order, so a leaf and any subtree is a range of
 * consecutive records, and an index into the map is an index into
 * murk_photon_map_photons(). The order depends on the set of records alone, not
 * on threads or on the order in which the records came. Immutable after
 * creation: any number of threads may query.
 *
 * Distances are compared in single precision, in which positions are stored:
 * with center and radius rounded to float and d = position - center, a photon
 * is within the radius if (dx * dx + dy * dy) + dz * dz <= radius * radius,
 * each step rounded to float. Every machine and every implementation gives the
 * same bits. A query whose center is not finite after rounding to float, or
 * whose radius is negative or NaN, finds nothing.
 *
 * Source: Bentley, Commun. ACM 18 (1975) 509, doi:10.1145/361002.361007;
 * Jensen, Realistic Image Synthesis Using Photon Mapping, 2001. */
#ifndef MURK_PHOTONMAP_MAP_H
#define MURK_PHOTONMAP_MAP_H

#include "base/block.h"
#include "base/status.h"
#include "base/vector.h"
#include "photonmap/photon.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct murk_photon_map murk_photon_map;

/* Takes ownership of photons[n] (from malloc(), freed on failure) and orders
 * them. n may be 0, with NULL. Fails with MURK_BAD_VALUE if n is above 2^32 - 1
 * or a position is not finite, with MURK_NO_MEMORY, or with
 * MURK_INTERRUPTED. */
murk_status murk_photon_map_create(murk_photon_map **out, murk_photon *photons,
                                   size_t n, unsigned threads, murk_error *err);

/* The same with the records in a block, which becomes empty, also on
 * failure. */
murk_status murk_photon_map_create_in(murk_photon_map **out,
                                      murk_block *records, unsigned threads,
                                      murk_error *err);

/* The same, and with ranks (base/ranks.h) the first rank of each machine gives
 * the records, the ranks of the machine divide the work, and all of them share
 * the memory of the map. Collective. */
murk_status murk_photon_map_create_shared(murk_photon_map **out,
                                          murk_block *records, unsigned threads,
                                          murk_status status, murk_error *err);
void murk_photon_map_destroy(murk_photon_map *map); /* NULL is fine */

size_t murk_photon_map_count(const murk_photon_map *map);
const murk_photon *murk_photon_map_photons(const murk_photon_map *map);

/* True if the records are in a scratch file: records that are read in their
 * order are then read faster. */
bool murk_photon_map_is_in_file(const murk_photon_map *map);
size_t murk_photon_map_memory_bytes(const murk_photon_map *map);

/* The memory of a map of n photons with the tree, in bytes; building the map
 * takes no more. If n is NaN or less than 1: the memory of an empty map. */
double murk_photon_map_memory_for(double n);

/* Range query: writes the indices of the photons with |position - center| <=
 * radius_m to found[], in increasing order. The caller provides enough memory
 * for all of them. Returns the number of photons. */
size_t murk_photon_map_within(const murk_photon_map *map, murk_vec3 center,
                              double radius_m, uint32_t *found);

/* The same of n records in memory: their indices in the list. A record is
 * within range here if a map that contains it would find it. */
size_t murk_photons_within(const murk_photon *photon, size_t n,
                           murk_vec3 center, double radius_m, uint32_t *found);

/* Leaves those of the n photons chosen[] of a list that are within range,
 * likewise. Returns their number. */
size_t murk_photons_chosen_within(const murk_photon *photon, uint32_t *chosen,
                                  size_t n, murk_vec3 center, double radius_m);

/* Like murk_photon_map_within(), but only counts. */
size_t murk_photon_map_count_within(const murk_photon_map *map,
                                    murk_vec3 center, double radius_m);

/* The k nearest photons (fewer if the map has fewer), nearest first, ties by
 * index: found[k] and squared distances (as above, in single precision)
 * distance2_m2[k]. Returns the number of photons. */
size_t murk_photon_map_nearest(const murk_photon_map *map, murk_vec3 center,
                               size_t k, uint32_t *found, double *distance2_m2);

#endif
