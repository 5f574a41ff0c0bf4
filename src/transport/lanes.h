/* Traces the photons of a batch side by side: collisions in media are computed
 * for MURK_LANE_COUNT photons at once (transport/lanes_step.h), and so are
 * diffuse reflections (transport/lanes_surfaces.h); every other event of a
 * photon is that of the walker (transport/walk.h). Both compute the same
 * numbers in the same order, so the result is that of the walker to the bit.
 * For use inside src/transport only. */
#ifndef MURK_TRANSPORT_LANES_H
#define MURK_TRANSPORT_LANES_H

#include "transport/lanes_step.h"
#include "transport/walk.h"

/* The steps for the photons of a trace; NULL if they are traced one by one: in
 * clear air without surfaces, with surfaces beside media whose flights are not
 * loops over lanes (medium/lane_regions.h), with boundaries of regions, by
 * delta tracking, for a sink that needs the order of the photons, or if lanes
 * are switched off. */
const murk_lane_steps *murk_photon_lanes_for(const murk_walk_setup *setup);

/* Traces the photons [first, last) of a batch, as murk_walk_photon() does one
 * after the other. After an interrupt no further photon is begun. */
void murk_photon_lanes_trace(const murk_lane_steps *steps,
                             const murk_walk_setup *setup, murk_sums *sums,
                             uint64_t batch, uint64_t first, uint64_t last);

#endif
