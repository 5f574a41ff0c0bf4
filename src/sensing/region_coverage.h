/* How much of each region of interest is in view. Internal to the room; what it
 * means: murk_region_coverage in sensing/sight.h. */
#ifndef MURK_SENSING_REGION_COVERAGE_H
#define MURK_SENSING_REGION_COVERAGE_H

#include "sensing/sight.h"

/* How well photon i is seen, 0..1. */
typedef double (*murk_photon_view)(const void *context, size_t i);

/* Fills out[n] for the n regions of the sight's interest. key[photons]: all
 * photons in order of emitted photon, emitted << 32 | photon. */
void murk_region_coverage_measure(murk_region_coverage *out,
                                  const murk_sight *sight, const uint64_t *key,
                                  murk_photon_view seen, const void *context);

#endif
