/* Coverage of each region of interest. For use inside src/sensing only;
 * definition: murk_region_coverage in sensing/sight.h. */
#ifndef MURK_SENSING_REGION_COVERAGE_H
#define MURK_SENSING_REGION_COVERAGE_H

#include "sensing/sight.h"

/* The share of photon i that is seen, 0..1. */
typedef double (*murk_photon_view)(const void *context, size_t i);

/* Fills out[n] for the n regions of the sight's interest. key[photons]: all
 * photons sorted by emitted photon, as emitted << 32 | photon. */
void murk_region_coverage_measure(murk_region_coverage *out,
                                  const murk_sight *sight, const uint64_t *key,
                                  murk_photon_view seen, const void *context);

#endif
