#include "render/gather.h"

#include <stdlib.h>

#include "light/shine.h"

/* Cosine between two normals of one surface, which may be curved. */
#define ALIKE 0.5

struct murk_gather {
    const murk_world *world;
    size_t k;
    murk_photon_map *surface[MURK_BANDS_MAX], *volume[MURK_BANDS_MAX];
};

static bool counts(const murk_world *world, const murk_photon *p, int band)
{
    return p->band == band && (murk_photon_class(p) != 0 ||
                               !murk_lights_can_shine(world->lights, p->light));
}

/* Those that count, of one map. */
static murk_status pick(murk_photon_map **out, const murk_world *world,
                        const murk_photon_map *map, int band, unsigned threads,
                        murk_error *err)
{
    const murk_photon *all = murk_photon_map_photons(map);
    const size_t n = murk_photon_map_count(map);
    size_t kept = 0;
    for (size_t i = 0; i < n; ++i) {
        kept += counts(world, &all[i], band);
    }
    murk_photon *photons = malloc((kept + 1) * sizeof *photons);
    if (!photons) {
        return murk_fail(err, MURK_NO_MEMORY, "render",
                         "no memory for %zu photons", kept);
    }
    kept = 0;
    for (size_t i = 0; i < n; ++i) {
        if (counts(world, &all[i], band)) {
            photons[kept++] = all[i];
        }
    }
    return murk_photon_map_create(out, photons, kept, threads, err);
}

murk_status murk_gather_create(murk_gather **out, const murk_world *world,
                               const murk_photon_map *surface,
                               const murk_photon_map *volume, size_t k,
                               unsigned threads, murk_error *err)
{
    murk_gather *g = calloc(1, sizeof *g);
    if (!g) {
        return murk_fail(err, MURK_NO_MEMORY, "render", "no memory for maps");
    }
    g->world = world;
    g->k = k;
    murk_status status = MURK_OK;
    for (int band = 0; band < world->bands && !status; ++band) {
        status = pick(&g->surface[band], world, surface, band, threads, err);
        if (!status) {
            status = pick(&g->volume[band], world, volume, band, threads, err);
        }
    }
    if (status) {
        murk_gather_destroy(g);
        return status;
    }
    *out = g;
    return MURK_OK;
}

void murk_gather_destroy(murk_gather *gather)
{
    if (gather) {
        for (int band = 0; band < MURK_BANDS_MAX; ++band) {
            murk_photon_map_destroy(gather->surface[band]);
            murk_photon_map_destroy(gather->volume[band]);
        }
        free(gather);
    }
}

/* Power that one record sends towards who looks, for each steradian. */
static double sent(const murk_world *world, const murk_place *place,
                   const murk_photon *p)
{
    if (!place->phase) {
        const murk_vec3 normal = murk_direction_unpack(p->normal);
        return murk_dot(normal, place->normal) > ALIKE ? p->power_w / MURK_PI
                                                       : 0;
    }
    const murk_phase *phase =
        murk_media_phase(world->media, p->material, place->band);
    const double mu =
        -murk_dot(murk_direction_unpack(p->direction), place->sight);
    return p->power_w * murk_phase_density(phase, fmax(-1, fmin(1, mu)));
}

murk_gathered murk_gather_light(const murk_gather *g, const murk_place *place)
{
    const murk_photon_map *map =
        place->phase ? g->volume[place->band] : g->surface[place->band];
    uint32_t found[MURK_GATHER_MAX];
    double square_m2[MURK_GATHER_MAX];
    const size_t n =
        murk_photon_map_nearest(map, place->position, g->k, found, square_m2);
    murk_gathered gathered = {0, 0};
    if (n < 2 || !(square_m2[n - 1] > 0)) {
        return gathered;
    }
    const murk_photon *photons = murk_photon_map_photons(map);
    double sum = 0, squares = 0;
    for (size_t i = 0; i + 1 < n; ++i) {
        const double one = sent(g->world, place, &photons[found[i]]);
        sum += one;
        squares += one * one;
    }
    const double square = square_m2[n - 1];
    const double kernel =
        (place->phase ? 4 * MURK_PI / 3 * square * sqrt(square)
                      : MURK_PI * square) *
        place->index * place->index;
    gathered.radiance = sum / kernel;
    gathered.variance = squares / (kernel * kernel);
    return gathered;
}
