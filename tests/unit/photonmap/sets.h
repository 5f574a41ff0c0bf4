/* Sets of photons for the tests of the map, in a box of 8 x 5 x 3 m. The
 * coordinates of LATTICE_SET are multiples of 1/4 m, so that ties and photons
 * exactly on the surface of a query ball are common. */
#ifndef MURK_TESTS_PHOTON_SETS_H
#define MURK_TESTS_PHOTON_SETS_H

#include "base/rng.h"
#include "photonmap/map.h"

#include <stdlib.h>

typedef enum photon_set {
    RANDOM_SET,
    LATTICE_SET, /* many ties */
    CLUSTERED_SET,
    PLANAR_SET, /* walls at right angles */
    COPIES_SET, /* few different positions, many photons at each */
    LINE_SET,
    PHOTON_SETS
} photon_set;

static inline void place_photon(float p[3], photon_set set, uint64_t i,
                                uint32_t seed)
{
    /* `r` belongs to the photon; `s` is one of seven places. */
    const murk_random4 r = murk_random(seed, MURK_TEST, i, 0, 0);
    const murk_random4 s = murk_random(seed, MURK_TEST, i % 7, 1, 0);
    const double size[3] = {8, 5, 3};
    for (int a = 0; a < 3; ++a) {
        /* One coordinate of a random place, changed as the set demands. */
        double x = size[a] * r.u[a];
        switch (set) {
        case LATTICE_SET:
            x = floor(x * 4) / 4;
            break;
        case CLUSTERED_SET:
            x = size[a] * s.u[a] + 0.01 * (r.u[a] + r.u[(a + 1) % 3]);
            break;
        case PLANAR_SET:
            x = (int)(i % 3) == a ? size[a] * (double)(i / 3 % 2) : x;
            break;
        case COPIES_SET:
            x = size[a] * s.u[a];
            break;
        case LINE_SET:
            x = size[a] * r.u[0];
            break;
        default:
            break;
        }
        p[a] = (float)x;
    }
}

/* The caller frees it; never NULL, also for n = 0. */
static inline murk_photon *make_photons(photon_set set, size_t n, uint32_t seed)
{
    murk_photon *photons = calloc(n + 1, sizeof *photons);
    if (!photons) {
        abort();
    }
    for (size_t i = 0; i < n; ++i) {
        place_photon(photons[i].position_m, set, i, seed);
        photons[i].emitted = (uint32_t)(i / 2);
        photons[i].power_w = 1;
        photons[i].kind = (uint8_t)(i % 3);
    }
    return photons;
}

static inline murk_photon_map *make_map(const murk_photon *photons, size_t n,
                                        unsigned threads)
{
    murk_photon *given = malloc((n + 1) * sizeof *given);
    murk_photon_map *map = NULL;
    if (!given) {
        abort();
    }
    memcpy(given, photons, n * sizeof *given);
    if (murk_photon_map_create(&map, given, n, threads, NULL)) {
        abort();
    }
    return map;
}

/* The definition of map.h, word for word. */
static inline float distance2_to(const murk_photon *photon, murk_vec3 center)
{
    const float dx = photon->position_m[0] - (float)center.x;
    const float dy = photon->position_m[1] - (float)center.y;
    const float dz = photon->position_m[2] - (float)center.z;
    return (dx * dx + dy * dy) + dz * dz;
}

#endif
