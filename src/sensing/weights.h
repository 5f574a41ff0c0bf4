/* Whole-number weights of photons, proportional to their power. Internal to the
 * room; meaning and rounding: murk_sight_weights(). */
#ifndef MURK_SENSING_WEIGHTS_H
#define MURK_SENSING_WEIGHTS_H

#include "sensing/sight.h"

/* Factors on the powers of photons. */
typedef struct murk_photon_factors {
    const murk_interest *interest;
    const uint64_t *regions; /* [surface + volume] regions of each photon; NULL:
                                all factors are 1 */
} murk_photon_factors;

/* Fills weight[surface + volume]; factors NULL: all factors are 1. The sum is
 * below 2^47 divided by `views`, the number of entries of a photon that count.
 * Fails with MURK_BAD_VALUE (maps), or with MURK_RUN_FAILED at `where` if no
 * photon has weight. */
murk_status
murk_photon_weights(uint32_t *weight, const murk_photon_map *surface,
                    const murk_photon_map *volume, const murk_map_weights *maps,
                    const murk_photon_factors *factors, unsigned combined,
                    const char *where, murk_error *err);

#endif
