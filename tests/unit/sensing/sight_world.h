/* For tests of sight: photons in a hall, and how clearly a sensor sees them. */
#ifndef MURK_TESTS_SIGHT_WORLD_H
#define MURK_TESTS_SIGHT_WORLD_H

#include "base/rng.h"
#include "sensing/sight.h"
#include "world.h"

static const murk_domain hall = {.box = {{0, 0, 0}, {10, 8, 4}}};
static const murk_vec3 none = {0, 0, 0};

typedef struct world {
    murk_surfaces *surfaces;
    murk_media *media;
    murk_photon_map *surface_map, *volume_map;
    murk_sight *sight;
} world;

/* Makes a world with a sight. Photons with a normal go to the surface map.
 * Takes over media. */
static inline world build(const murk_surface_desc *desc, size_t n_desc,
                          murk_media *media, const murk_photon *photons,
                          size_t n, murk_sight_desc sight)
{
    /* Sort the photons by map: surface records first, volume records after
     * them. */
    murk_photon *split = malloc(n * sizeof *split + 1);
    size_t surface = 0, volume = 0;
    for (size_t i = 0; i < n; ++i) {
        if (!murk_photon_is_volume(&photons[i])) {
            split[surface++] = photons[i];
        }
    }
    for (size_t i = 0; i < n; ++i) {
        if (murk_photon_is_volume(&photons[i])) {
            split[surface + volume++] = photons[i];
        }
    }
    /* Surfaces and both maps of the world. */
    world w = {.surfaces = surfaces_of(desc, n_desc), .media = media};
    w.surface_map = map_of(split, surface);
    w.volume_map = map_of(split + surface, volume);
    free(split);
    /* A sight of this world, otherwise as the caller describes. */
    sight.surfaces = w.surfaces;
    sight.media = media;
    sight.surface_map = w.surface_map;
    sight.volume_map = w.volume_map;
    murk_error err = {0};
    CHECK(murk_sight_create(&w.sight, &sight, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return w;
}

static inline void tear_down(world *w)
{
    murk_sight_destroy(w->sight);
    murk_photon_map_destroy(w->surface_map);
    murk_photon_map_destroy(w->volume_map);
    murk_media_destroy(w->media);
    murk_surfaces_destroy(w->surfaces);
}

static const murk_sensor_type FAR = {.range_m = 100};

static inline murk_sight_desc plain(const murk_domain *domain)
{
    return (murk_sight_desc){.domain = *domain,
                             .photons_emitted = 1u << 20,
                             .type = &FAR,
                             .types = 1,
                             .through_sheets = true,
                             .weights = {.balanced = true},
                             .threads = 2};
}

/* Clarity of each photon, by emitted index. */
static inline int seen_from(const world *w, murk_vec3 sensor, uint32_t emitted)
{
    murk_sparse_row row;
    murk_sight_row(w->sight, 0, partial_at(&sensor, 1), &row);
    for (size_t k = 1; k < row.seen; ++k) {
        CHECK(row.photon[k - 1] < row.photon[k]);
    }
    return clarity_of(w->sight, &row, emitted);
}

static inline int clarity(double transmittance)
{
    return (int)floor(transmittance * MURK_CLEAR + 0.5);
}

#endif
