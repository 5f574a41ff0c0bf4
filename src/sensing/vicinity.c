/* Photons within a fixed radius, from copies of the map that are thinned step
 * by step: each level keeps the records of the first half of the emitted
 * photons, or every second record if that would keep too many. The level is
 * chosen by the number of photons within the radius in the full map. */
#include "sensing/vicinity.h"

#include "sensing/nearby.h"

#include <assert.h>
#include <stdlib.h>

/* Each level holds at most three quarters of the one before: after 78 levels
 * 2^32 records are reduced to one. */
#define LEVELS 80

/* Largest share of the records that halving the emitted photons may keep; with
 * more, few paths left the records, and the records themselves are halved. */
#define SHARE_MAX 0.75

struct murk_vicinity {
    const murk_domain *domain;
    const murk_photon_map *map[LEVELS];
    murk_photon_map *half[LEVELS]; /* owned; half[0] is NULL */
    uint64_t emitted[LEVELS];      /* emitted photons of each level */
    double each[LEVELS]; /* records that one record of a level stands for */
    int levels;
    double radius_m;
    size_t max;
};

/* Adds the next level: the records of the first half of the emitted photons, or
 * every second record if that half would keep more than SHARE_MAX of the
 * records. */
static murk_status halve(murk_vicinity *v, unsigned threads, murk_error *err)
{
    const int level = v->levels;
    const murk_photon *photon = murk_photon_map_photons(v->map[level - 1]);
    const size_t n = murk_photon_map_count(v->map[level - 1]);
    const uint64_t half = (v->emitted[level - 1] + 1) / 2;
    size_t of_half = 0, copied = 0;
    for (size_t i = 0; i < n; ++i) {
        of_half += murk_photon_emitted(&photon[i]) < half;
    }
    const bool by_record = (double)of_half > SHARE_MAX * (double)n;
    v->emitted[level] = by_record ? v->emitted[level - 1] : half;
    v->each[level] = v->each[level - 1] * (by_record ? 2 : 1);
    /* Copy the records of the level into a map of their own. */
    murk_photon *copy =
        malloc((by_record ? (n + 1) / 2 : of_half) * sizeof *copy + 1);
    if (!copy) {
        return murk_no_memory(err, "", "for half of %zu photons", n);
    }
    for (size_t i = 0; i < n; ++i) {
        if (by_record ? i % 2 == 0 : murk_photon_emitted(&photon[i]) < half) {
            copy[copied++] = photon[i];
        }
    }
    const murk_status status =
        murk_photon_map_create(&v->half[level], copy, copied, threads, err);
    if (!status) {
        v->map[level] = v->half[level];
        ++v->levels;
    }
    return status;
}

murk_status murk_vicinity_create(murk_vicinity **out,
                                 const murk_photon_map *map,
                                 const murk_domain *domain,
                                 uint64_t photons_emitted, double radius_m,
                                 size_t maximum, unsigned threads,
                                 murk_error *err)
{
    assert(maximum > 0 && radius_m > 0);
    /* Add levels until one holds no more than the maximum. */
    murk_vicinity *v = calloc(1, sizeof *v);
    if (!v) {
        return murk_no_memory(err, "", "for a vicinity");
    }
    v->domain = domain;
    v->radius_m = radius_m;
    v->max = maximum;
    v->map[0] = map;
    v->emitted[0] = photons_emitted;
    v->each[0] = 1;
    v->levels = 1;
    while (v->levels < LEVELS &&
           murk_photon_map_count(v->map[v->levels - 1]) > maximum) {
        const murk_status status = halve(v, threads, err);
        if (status) {
            murk_vicinity_destroy(v);
            return status;
        }
    }
    *out = v;
    return MURK_OK;
}

void murk_vicinity_destroy(murk_vicinity *v)
{
    for (int i = 0; v && i < v->levels; ++i) {
        murk_photon_map_destroy(v->half[i]);
    }
    free(v);
}

size_t murk_vicinity_capacity(const murk_vicinity *v)
{
    return murk_photon_map_count(v->map[0]) * (v->domain->is_periodic ? 2 : 1);
}

const murk_photon *murk_vicinity_photons(const murk_vicinity *v, int level)
{
    return murk_photon_map_photons(v->map[level]);
}

/* The number of photons within the radius in the full map. Far images may be
 * counted as well; then the photons are thinned once more than necessary. */
static size_t count(const murk_vicinity *v, murk_vec3 center)
{
    size_t n = 0;
    for (int k = 0; k < murk_domain_images(v->domain); ++k) {
        n += murk_photon_map_count_within(
            v->map[0], murk_domain_image(v->domain, center, k), v->radius_m);
    }
    return n;
}

/* The level for n photons within the radius. It depends on the count in the
 * full map, not on the records that a level kept, so the choice is independent
 * of the thinning. */
static int level_for(const murk_vicinity *v, size_t n)
{
    const double all = (double)murk_photon_map_count(v->map[0]);
    int level = 0;
    while (level + 1 < v->levels &&
           (double)n * (double)murk_photon_map_count(v->map[level]) >
               (double)v->max * all) {
        ++level;
    }
    return level;
}

murk_around murk_vicinity_find(const murk_vicinity *v, murk_vec3 place,
                               uint64_t emitted, uint32_t *found)
{
    murk_around around = {.level = level_for(v, count(v, place))};
    const size_t all = murk_photons_nearby(v->map[around.level], v->domain,
                                           place, v->radius_m, found);
    const murk_photon *photon = murk_vicinity_photons(v, around.level);
    for (size_t k = 0; k < all; ++k) {
        if (murk_photon_emitted(&photon[found[k]]) != emitted) {
            found[around.n++] = found[k];
        }
    }
    const uint64_t emitted_here = v->emitted[around.level];
    const uint64_t others = emitted_here - (emitted < emitted_here);
    around.factor = others > 0 ? v->each[around.level] * (double)v->emitted[0] /
                                     (double)others
                               : 0;
    return around;
}
