/* The canonical problems 1 and 2 of Mobley et al., Appl. Opt. 32 (1993) 7484,
 * doi:10.1364/AO.32.007484, in the words of a scene: the sun by place and time,
 * 30 degrees above the horizon, a sea below z = 0, its water by a preset of
 * which extinction, albedo and phase function are said, tallies at depths.
 *
 * The sea is a tile that repeats, 60 optical depths deep. */
#ifndef MURK_TESTS_MOBLEY_SEA_H
#define MURK_TESTS_MOBLEY_SEA_H

#include "base/stats.h"

#include <stdint.h>

#define MOBLEY_DEPTHS 2

typedef struct mobley_sea {
    int problem; /* 1: Rayleigh, 2: Petzold's average particle */
    double albedo;
    double index;     /* 1.34 */
    const char *time; /* NULL: when the sun stands 30 degrees high */
} mobley_sea;

/* At optical depths of mobley_tau, where Ed on the surface is .5 W/m2 by the
 * problems' sun. Eou is the mean over a ball of .1 optical depths, which adds
 * no more than 1.5e-3 of it in the darkest of these waters. */
typedef struct mobley_light {
    double sun_deg;                                      /* its height */
    murk_estimate ed[MOBLEY_DEPTHS], eou[MOBLEY_DEPTHS]; /* W/m2 */
} mobley_light;

extern const double mobley_tau[MOBLEY_DEPTHS]; /* 1 and 5 */

/* NANs, and a line that says why, where it cannot. */
mobley_light mobley_sea_lit(const mobley_sea *sea, uint64_t photons,
                            uint32_t seed);

#endif
