/* Traces photons in waves of batches: either a given number of photons, or as
 * many as it takes until a given number of records is stored. In the second
 * case the photon that reaches the number is the last one; all of its records
 * are kept, and photons that were traced beyond it are removed from the ledger
 * and the tallies. */
#ifndef MURK_LIGHTMAP_EMISSION_H
#define MURK_LIGHTMAP_EMISSION_H

#include "lightmap/light_part.h"
#include "world/stage.h"

/* A run that loses a larger share of the photons fails, because the result
 * would not be the light of the scene. murk.h states the same share. */
#define MURK_LOST_SHARE_MAX 0.01

typedef struct murk_emission {
    const murk_stage *stage;
    uint32_t stream;
    unsigned threads;
    uint64_t emit;       /* photons to emit; 0: until
                          * stage->scene->photons.store records are stored */
    bool is_first_small; /* the first wave is one batch, so that its records can
                          * be used for a forecast */
    murk_record_buffers *buffers; /* stores and counts the records; NULL
                                   * (only with emit, sink and gather): no
                                   * records */
    murk_ledger *ledger;
    murk_tallies *tallies; /* NULL if the scene has none */

    /* Optional sinks that receive events and segments instead of the record
     * buffers; they must pass the events on to the record buffers, which count
     * them. gather is called after each wave in place of
     * murk_record_buffers_gather(), with gather_context and the number of the
     * last photon that is kept; if there are record buffers, gather must call
     * that function, and gather must drop what it stores of later photons. If
     * sink and gather are NULL, the record buffers alone are used.
     *
     * Ranks divide the batches of a wave if `exchange` is given, too. It is
     * called when a rank has traced its share: place[n] are the places in the
     * wave of the batches that are traced, and the rank has traced those whose
     * index in place[] it owns (murk_ranks_owns()), the k-th of them as batch k
     * of the sinks. exchange must move these to their places and receive those
     * of the other ranks. Collective. */
    murk_event_sink sink;
    murk_segment_sink segment_sink;
    void *context;        /* passed to both sinks */
    bool takes_any_order; /* of sink: as murk_trace.takes_any_order */
    murk_status (*gather)(void *gather_context, uint64_t last, murk_error *err);
    murk_status (*exchange)(void *gather_context, const size_t *place, size_t n,
                            murk_status status, murk_error *err);
    void *gather_context;

    const murk_light_parts *parts; /* batches that need not be traced; the sums
                                      of the parts are in ledger and tallies
                                      already, those of rank 0 if there are
                                      ranks; only with buffers, and without
                                      sink and gather. NULL: none */
    struct murk_checkpoint *checkpoint; /* under the same conditions
                                           (lightmap/checkpoint.h). NULL: none
                                           is written */

    uint64_t emitted; /* photons so far */
    uint64_t reached; /* end of the waves so far: photons from `emitted` on were
                         traced and removed again */
} murk_emission;

/* The most batches of a wave that ranks divide, for which sinks with an
 * exchange need room. Not collective. */
size_t murk_emission_wave_batches(void);

/* Fails with MURK_BAD_VALUE if `emit` is given and smaller than the number of
 * channels (light source and band) with power. */
murk_status murk_emission_check(const murk_emission *emission, murk_error *err);

/* Traces all photons; none if no light source emits. Fails with MURK_RUN_FAILED
 * if fewer than `store` records are stored after as many photons as are tried
 * (murk_light_photons_max()), with MURK_INTERRUPTED, or as gather or
 * murk_record_buffers_gather() does. */
murk_status murk_emission_run(murk_emission *emission, murk_error *err);

/* Fails with MURK_RUN_FAILED if more than MURK_LOST_SHARE_MAX of the photons
 * were lost. */
murk_status murk_emission_check_losses(const murk_emission *emission,
                                       murk_error *err);

/* Sets packet_w[channels] to the power of one photon packet of each channel,
 * light * bands + band, and emitted_in[channels] to the number of photons
 * emitted in each channel. The power is 0 for a channel without photons. */
void murk_emission_packet_powers(const murk_emission *emission,
                                 uint64_t *emitted_in, double *packet_w);

/* Traces a few photons of each band. Fails with MURK_BAD_VALUE if at least 4
 * photons of a band were lost and no photon of that band ended otherwise,
 * usually because they exceeded the limits on events or on wraps through
 * periodic sides: such a scene would be refused for lost photons
 * (murk_emission_check_losses()) after hours of tracing. Fails with
 * MURK_NO_MEMORY, too. */
murk_status murk_ending_check(const murk_stage *stage, uint32_t stream,
                              murk_error *err);

#endif
