/* The nearest photons from which the light at the place of a stored photon is
 * estimated. For use inside src/sensing only.
 *
 * These photons have the same band, lie on the same side of a surface, and
 * belong to other emitted photons: the photon's own path says nothing about the
 * density of stored photons. The distance of the k-th such photon is the radius
 * of the estimate, and the k-th photon itself does not count. So the power of
 * the others over the area or volume within the radius is an estimate without
 * bias, and the relative error of the estimate, 1 / sqrt(k - 2), does not
 * depend on the number of photons. If the k-th photon lies beyond a maximum
 * radius, all photons within the maximum radius count, which is without bias,
 * too. murk_neighbours_find() names one more limit.
 *
 * Source: Moore and Yackel, IEEE Trans. Comput. 26 (1977) 143,
 * doi:10.1109/TC.1977.5009294 (k - 1 in place of k). */
#ifndef MURK_SENSING_NEIGHBOURS_H
#define MURK_SENSING_NEIGHBOURS_H

#include "base/vector.h"
#include "photonmap/map.h"

/* Borrows all members. */
typedef struct murk_neighbours {
    const murk_photon_map *map;
    const murk_domain *domain;
    size_t k;     /* at least 2 */
    double max_m; /* maximum radius; at most half a period */
} murk_neighbours;

/* Workspace of one thread, for searches with this k. NULL when out of
 * memory. */
typedef struct murk_neighbours_workspace murk_neighbours_workspace;
murk_neighbours_workspace *murk_neighbours_workspace_create(size_t k);
void murk_neighbours_workspace_destroy(
    murk_neighbours_workspace *workspace); /* accepts NULL */

/* Writes the indices of the photons that count, nearest first, to found[], at
 * most k - 1, and the radius. Returns their number. Photons of the emitted
 * photon `emitted` are left out. If few of the nearest photons are of the same
 * band and side, the search ends after 32 k photons, and the radius is the
 * distance of the last of these, which does not count. */
size_t murk_neighbours_find(const murk_neighbours *neighbours,
                            murk_neighbours_workspace *workspace,
                            const murk_photon *of, uint64_t emitted,
                            uint32_t *found, double *radius_m);

/* True if the photon has the band of `of` and, for surface photons, the normals
 * differ by less than 90 degrees. Both photons are of the same map. */
bool murk_neighbours_alike(const murk_photon *of, const murk_photon *photon);

#endif
