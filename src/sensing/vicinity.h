/* Which photons of a map lie around a place: what it is judged by. Internal to
 * the room.
 *
 * All within a radius. Where a photon is stored, those of other emitted photons
 * alone: that one's path is stored there says nothing of how much is. Where
 * more than some `most` lie there, only those of the first half, quarter, .. of
 * all emitted photons are looked at, and stand for the others: any first ones
 * of them are shared out among lights in proportion. Where few paths left that
 * many, every second record of theirs is left out, as often as it takes. So
 * work is bounded however many lie together, as where a beam meets a wall, and
 * a sum over them, times its factor, is without bias. Immutable after creation.
 */
#ifndef MURK_SENSING_VICINITY_H
#define MURK_SENSING_VICINITY_H

#include "base/vector.h"
#include "photonmap/map.h"

typedef struct murk_vicinity murk_vicinity;

/* Borrows map and domain. Copies of parts take about as much memory as the
 * map, at most three times. Fails with MURK_NO_MEMORY. */
murk_status murk_vicinity_create(murk_vicinity **out,
                                 const murk_photon_map *map,
                                 const murk_domain *domain,
                                 uint64_t photons_emitted, double radius_m,
                                 size_t max, unsigned threads, murk_error *err);
void murk_vicinity_destroy(murk_vicinity *vicinity); /* NULL is fine */

typedef struct murk_around {
    size_t n;
    int level;     /* of thinning: the numbers found are of this level */
    double factor; /* on sums of power */
} murk_around;

#define MURK_VICINITY_ALL UINT64_MAX

/* Around a place, in the domain, but for what `emitted` left (or
 * MURK_VICINITY_ALL): writes numbers to found[], which has room for
 * murk_vicinity_room(). */
murk_around murk_vicinity_find(const murk_vicinity *vicinity, murk_vec3 place,
                               uint64_t emitted, uint32_t *found);
size_t murk_vicinity_room(const murk_vicinity *vicinity);

/* The photons of a level. */
const murk_photon *murk_vicinity_photons(const murk_vicinity *vicinity,
                                         int level);

#endif
