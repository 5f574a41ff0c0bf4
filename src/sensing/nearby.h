/* Photons within range of a sensor. For use inside src/sensing only.
 *
 * In a periodic domain the map is queried around each image of the sensor, and
 * a photon counts if no other image of the sensor is nearer to the photon. */
#ifndef MURK_SENSING_NEARBY_H
#define MURK_SENSING_NEARBY_H

#include "base/vector.h"
#include "photonmap/map.h"

#include <stddef.h>
#include <stdint.h>

/* Writes the indices, increasing, to found[], which needs space for all photons
 * of the map, and for twice as many in a periodic domain. Returns their number.
 */
size_t murk_photons_nearby(const murk_photon_map *map,
                           const murk_domain *domain, murk_vec3 sensor,
                           double range_m, uint32_t *found);

/* The same of n records in memory, with their indices in the list. */
size_t murk_photons_listed_nearby(const murk_photon *photon, size_t n,
                                  const murk_domain *domain, murk_vec3 sensor,
                                  double range_m, uint32_t *found);

#endif
