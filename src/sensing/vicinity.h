/* The photons of a map within a fixed radius of a place. For use inside
 * src/sensing only.
 *
 * At the place of a stored photon only photons of other emitted photons count:
 * a photon's own path says nothing about the density. If more than a maximum
 * lie within the radius, only the photons of the first half, quarter, .. of all
 * emitted photons are used, with larger factors: any first part of the emitted
 * photons is dealt to the lights in proportion. If this half has more than
 * three quarters of the records, because few paths left them, every second
 * record is left out instead. So the number of photons used is about the
 * maximum or less however dense the photons are, for example where a beam meets
 * a wall, and a sum over the photons times the factor is without bias. The
 * number can exceed the maximum at single places, because a part of the emitted
 * photons may have left more than its share of the records there. Immutable
 * after creation. */
#ifndef MURK_SENSING_VICINITY_H
#define MURK_SENSING_VICINITY_H

#include "base/vector.h"
#include "photonmap/map.h"

typedef struct murk_vicinity murk_vicinity;

/* Borrows map and domain. The thinned copies need about as much memory as the
 * map, at most three times. Fails with MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_vicinity_create(murk_vicinity **out,
                                 const murk_photon_map *map,
                                 const murk_domain *domain,
                                 uint64_t photons_emitted, double radius_m,
                                 size_t max, unsigned threads, murk_error *err);
void murk_vicinity_destroy(murk_vicinity *vicinity); /* accepts NULL */

typedef struct murk_around {
    size_t n;
    int level;     /* thinning level, to which the indices refer */
    double factor; /* factor on sums of power; 0 without other photons */
} murk_around;

/* In place of an emitted photon: none is left out. */
#define MURK_VICINITY_ALL UINT64_MAX

/* Finds the photons within the radius around a place in the domain, without
 * those of the emitted photon `emitted` (MURK_VICINITY_ALL: none is left out).
 * If more than the maximum are there, only those of a thinned copy. Writes the
 * indices in the copy of level murk_around.level to found[], which needs space
 * for murk_vicinity_capacity(). */
murk_around murk_vicinity_find(const murk_vicinity *vicinity, murk_vec3 place,
                               uint64_t emitted, uint32_t *found);
size_t murk_vicinity_capacity(const murk_vicinity *vicinity);

/* The photons of a thinning level. */
const murk_photon *murk_vicinity_photons(const murk_vicinity *vicinity,
                                         int level);

#endif
