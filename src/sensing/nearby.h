/* Photons within range of a sensor. Internal to the room.
 *
 * In a periodic domain the map is asked around each image of the sensor, and a
 * photon counts where that image is its nearest. */
#ifndef MURK_SENSING_NEARBY_H
#define MURK_SENSING_NEARBY_H

#include "base/vector.h"
#include "photonmap/map.h"

#include <stddef.h>
#include <stdint.h>

/* Writes their numbers, increasing, to found[], which has room for the map;
 * for twice the map where the domain is periodic. Returns how many. */
size_t murk_photons_nearby(const murk_photon_map *map,
                           const murk_domain *domain, murk_vec3 sensor,
                           double range_m, uint32_t *found);

#endif
