/* The nearest photons that tell of the light where one is stored. Internal to
 * the room.
 *
 * They are of its band, on a surface of its side, and left by other emitted
 * photons: its own path says nothing of how much is stored there. The k-th is
 * as far as the place's radius reaches and no part of it: so the others' power
 * over the area or volume within that radius is without bias, and its relative
 * error, 1 / sqrt(k - 2), is the same however many photons there are. Where the
 * k-th is farther than a largest radius, all within that one count, which is
 * without bias too.
 *
 * Source: Moore and Yackel, IEEE Trans. Comput. 26 (1977) 143,
 * doi:10.1109/TC.1977.5009294 (k - 1 in place of k). */
#ifndef MURK_SENSING_NEIGHBOURS_H
#define MURK_SENSING_NEIGHBOURS_H

#include "base/vector.h"
#include "photonmap/map.h"

/* Borrows what it names. */
typedef struct murk_neighbours {
    const murk_photon_map *map;
    const murk_domain *domain;
    size_t k;     /* at least 2 */
    double max_m; /* the largest radius; half a period at most */
} murk_neighbours;

/* What one thread works in. NULL without memory. */
typedef struct murk_neighbours_workspace murk_neighbours_workspace;
murk_neighbours_workspace *murk_neighbours_workspace_create(size_t k);
void murk_neighbours_workspace_destroy(
    murk_neighbours_workspace *workspace); /* or NULL */

/* Writes the numbers of those within the radius, nearest first, to found[k],
 * and the radius. Returns how many. Leaves out what `emitted` left. Where few
 * of the nearest are of its kind, it ends after a number of them, and the
 * radius is the last one's. */
size_t murk_neighbours_find(const murk_neighbours *neighbours,
                            murk_neighbours_workspace *workspace,
                            const murk_photon *of, uint64_t emitted,
                            uint32_t *found, double *radius_m);

/* Whether a photon tells of the place where another is stored: by band and
 * side. */
bool murk_neighbours_alike(const murk_photon *of, const murk_photon *photon);

#endif
