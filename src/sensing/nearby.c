/* Range queries of a photon map for a sensor, with images in periodic domains.
 */
#include "sensing/nearby.h"

#include <stdbool.h>
#include <string.h>

/* True if the image of the sensor that is nearest to a photon is shifted by
 * `periods` from the sensor; the arithmetic is that of
 * murk_path_nearest_image(), without rounding down. */
static bool is_nearest(double sensor, double photon, double period, int periods)
{
    const double to_round_down = (sensor - photon) / period + 0.5;
    return to_round_down >= -periods && to_round_down < 1 - periods;
}

/* Keeps the photons whose nearest image of the sensor is image k
 * (murk_domain_image()). Returns their number. */
static size_t keep_nearest(uint32_t *found, size_t n, const murk_photon *photon,
                           const murk_domain *domain, murk_vec3 sensor, int k)
{
    const murk_vec3 period = murk_sub(domain->box.max, domain->box.min);
    size_t remaining = 0;
    for (size_t f = 0; f < n; ++f) {
        const murk_vec3 at = murk_photon_place(&photon[found[f]]);
        if (is_nearest(sensor.x, at.x, period.x, k % 3 - 1) &&
            is_nearest(sensor.y, at.y, period.y, k / 3 - 1)) {
            found[remaining++] = found[f];
        }
    }
    return remaining;
}

/* Merges the increasing runs found[0..n) and found[n..n + added) into one. The
 * second run is first copied behind the two, so that the merge can proceed from
 * the end in place. */
static void merge(uint32_t *found, size_t n, size_t added)
{
    uint32_t *run = found + n + added;
    memcpy(run, found + n, added * sizeof *run);
    while (added > 0) {
        const bool takes_run = n == 0 || run[added - 1] > found[n - 1];
        const size_t to = n + added - 1;
        found[to] = takes_run ? run[--added] : found[--n];
    }
}

/* The photons of a map, or of a list if map is NULL. */
typedef struct photons {
    const murk_photon_map *map;
    const murk_photon *photon;
    size_t n;
} photons;

static size_t within(const photons *of, murk_vec3 center, double range_m,
                     uint32_t *found)
{
    return of->map
               ? murk_photon_map_within(of->map, center, range_m, found)
               : murk_photons_within(of->photon, of->n, center, range_m, found);
}

static size_t nearby(const photons *of, const murk_domain *domain,
                     murk_vec3 sensor, double range_m, uint32_t *found)
{
    if (!domain->is_periodic) {
        return within(of, sensor, range_m, found);
    }
    /* Each photon is kept for one image only, so the merged runs and the copy
     * of a run fit into twice the number of photons. */
    size_t n = 0;
    for (int k = 0; k < murk_domain_images(domain); ++k) {
        const murk_vec3 image = murk_domain_image(domain, sensor, k);
        const size_t in = within(of, image, range_m, found + n);
        const size_t added =
            keep_nearest(found + n, in, of->photon, domain, sensor, k);
        merge(found, n, added);
        n += added;
    }
    return n;
}

size_t murk_photons_nearby(const murk_photon_map *map,
                           const murk_domain *domain, murk_vec3 sensor,
                           double range_m, uint32_t *found)
{
    const photons of = {.map = map, .photon = murk_photon_map_photons(map)};
    return nearby(&of, domain, sensor, range_m, found);
}

size_t murk_photons_listed_nearby(const murk_photon *photon, size_t n,
                                  const murk_domain *domain, murk_vec3 sensor,
                                  double range_m, uint32_t *found)
{
    const photons of = {.photon = photon, .n = n};
    return nearby(&of, domain, sensor, range_m, found);
}
