/* Range queries of a photon map for a sensor, with images in periodic domains.
 */
#include "sensing/nearby.h"

#include "base/sort.h"
#include "path/segment.h"

#include <stdlib.h>

/* Keeps the photons whose nearest image of the sensor is `image`. Returns their
 * number. */
static size_t keep_nearest(uint32_t *found, size_t n, const murk_photon *photon,
                           const murk_domain *domain, murk_vec3 sensor,
                           murk_vec3 image)
{
    const murk_vec3 period = murk_sub(domain->box.max, domain->box.min);
    size_t remaining = 0;
    for (size_t f = 0; f < n; ++f) {
        const murk_vec3 nearest = murk_path_nearest_image(
            domain, sensor, murk_photon_place(&photon[found[f]]));
        /* images are a whole period apart, so half a period decides */
        if (fabs(nearest.x - image.x) < period.x / 2 &&
            fabs(nearest.y - image.y) < period.y / 2) {
            found[remaining++] = found[f];
        }
    }
    return remaining;
}

size_t murk_photons_nearby(const murk_photon_map *map,
                           const murk_domain *domain, murk_vec3 sensor,
                           double range_m, uint32_t *found)
{
    if (!domain->is_periodic) {
        return murk_photon_map_within(map, sensor, range_m, found);
    }
    const murk_photon *photon = murk_photon_map_photons(map);
    size_t photons = 0;
    for (int k = 0; k < murk_domain_images(domain); ++k) {
        const murk_vec3 image = murk_domain_image(domain, sensor, k);
        const size_t n =
            murk_photon_map_within(map, image, range_m, found + photons);
        photons +=
            keep_nearest(found + photons, n, photon, domain, sensor, image);
    }
    qsort(found, photons, sizeof *found, murk_by_uint32);
    return photons;
}
