/* Whole-number weights of photons, proportional to their power. For
 * use inside src/sensing only; meaning and rounding: murk_sight_weights(). */
#ifndef MURK_SENSING_WEIGHTS_H
#define MURK_SENSING_WEIGHTS_H

#include "sensing/sight.h"

/* Fills weight[surface + volume]. The power of each photon counts times the
 * factor of its regions[surface + volume] of interest; regions NULL: all
 * factors are 1. The sum is below 2^47 divided by `combined`, the number of
 * entries of a photon that count (or of sensors that must see a photon, if
 * larger). Fails with MURK_BAD_VALUE (maps), or with MURK_RUN_FAILED at `where`
 * if no photon has weight. */
murk_status
murk_photon_weights(uint32_t *weight, const murk_photon_map *surface,
                    const murk_photon_map *volume, const murk_map_weights *maps,
                    const murk_interest *interest, const uint64_t *regions,
                    unsigned combined, const char *where, murk_error *err);

/* Number, sum and maximum of the powers of the photons of one map. */
typedef struct murk_power_sum {
    size_t n;
    double sum, max;
} murk_power_sum;

void murk_power_sum_add(murk_power_sum *sum, double power_w);

/* Sets the factor of each map, surface and volume, by which powers become
 * weights: murk_photon_weights() in two steps. Fails in the same way. */
murk_status murk_weight_factors(double factor[2], const murk_power_sum power[2],
                                const murk_map_weights *maps, unsigned combined,
                                const char *where, murk_error *err);
uint32_t murk_weight_of(double power_w, double factor);

#endif
