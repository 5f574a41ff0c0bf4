/* Traces single photons, from the light source to their end. For
 * use inside src/transport only. */
#ifndef MURK_TRANSPORT_WALK_H
#define MURK_TRANSPORT_WALK_H

#include "transport/walker.h"

murk_walk_setup murk_walk_setup_of(const murk_trace *trace);

/* Traces the photon in a place of the trace: reports the events of the photon
 * to the sink of the trace and adds to the sums. murk_walk_photon() is
 * murk_walk_starts_draw(), murk_walk_photon_begin(), murk_walk_photon_on()
 * unless the photon has ended, and murk_walk_photon_end(). */
void murk_walk_photon(const murk_walk_setup *setup, murk_sums *sums,
                      uint64_t batch, uint64_t place);

/* The start of a photon, as its light source gives it. The ray of a photon of a
 * light source that is off is undefined. */
typedef struct murk_photon_start {
    uint64_t photon;
    size_t channel;
    murk_ray ray;
} murk_photon_start;

/* Draws the starts of the photons in n successive places of the trace: apart
 * from their paths, because the processor then works on several at once, which
 * takes half the time. */
void murk_walk_starts_draw(const murk_walk_setup *setup, uint64_t place,
                           size_t n, murk_photon_start *start);

/* Begins and reports a photon. `score` is NULL without tallies. Returns
 * MURK_FATE_NONE, or the fate of a photon that ends at the start. */
murk_fate murk_walk_photon_begin(murk_walker *w, const murk_walk_setup *setup,
                                 murk_sums *sums, murk_score_path *score,
                                 uint64_t batch,
                                 const murk_photon_start *start);

/* Follows the photon to the next event, or to the next boundary at which
 * nothing happens. */
murk_fate murk_walk_photon_event(murk_walker *w);

/* Follows the photon to the end. */
murk_fate murk_walk_photon_on(murk_walker *w);

/* Adds the photon, which has ended, to the sums and the tallies. */
void murk_walk_photon_end(murk_walker *w, murk_fate fate);

/* Traces a photon of the given number and band along a ray that starts at a
 * point on no surface; the sums count it as one of the first channel. The start
 * is not reported. */
void murk_walk_from(const murk_walk_setup *setup, murk_sums *sums,
                    uint64_t photon, int band, murk_ray ray);

#endif
