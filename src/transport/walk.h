/* Traces single photons, from the light source to their end. For
 * use inside src/transport only. */
#ifndef MURK_TRANSPORT_WALK_H
#define MURK_TRANSPORT_WALK_H

#include "transport/walker.h"

murk_walk_setup murk_walk_setup_of(const murk_trace *trace);

/* Traces one photon of the trace: reports the events of the photon to the sink
 * of the trace and adds to the sums. */
void murk_walk_photon(const murk_walk_setup *setup, murk_sums *sums,
                      uint64_t batch, uint64_t photon);

/* Traces a photon of the given number and band along a ray that starts at a
 * point on no surface; the sums count it as one of the first channel. The start
 * is not reported. */
void murk_walk_from(const murk_walk_setup *setup, murk_sums *sums,
                    uint64_t photon, int band, murk_ray ray);

#endif
