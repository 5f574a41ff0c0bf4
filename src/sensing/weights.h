/* Whole-number weights of photons, in proportion to their power. Internal to
 * the room; their meaning and rounding: murk_sight_weights(). */
#ifndef MURK_SENSING_WEIGHTS_H
#define MURK_SENSING_WEIGHTS_H

#include "sensing/sight.h"

/* Fills weight[surface + volume]. */
murk_status murk_photon_weights(uint32_t *weight,
                                const murk_photon_map *surface,
                                const murk_photon_map *volume,
                                const murk_map_weights *maps, murk_error *err);

#endif
