/* Photons sent out wave by wave: a number of them, or as many as it takes until
 * enough are stored. The photon that reaches that is the last, and its records
 * are kept whole; what was traced beyond it is taken back. */
#ifndef MURK_LIGHTMAP_EMISSION_H
#define MURK_LIGHTMAP_EMISSION_H

#include "lightmap/record_buffers.h"
#include "world/stage.h"

/* A light whose lost share is above this is refused: it would not be the
 * scene's light. */
#define MURK_LOST_SHARE_MAX 0.01

typedef struct murk_emission {
    const murk_stage *stage;
    uint32_t stream;
    unsigned threads;
    uint64_t emit;       /* photons; 0: until the scene's `store` are stored */
    bool is_first_small; /* one batch, for whoever forecasts from it */
    murk_record_buffers *buffers; /* counts what is stored */
    murk_ledger *ledger;
    murk_tallies *tallies; /* NULL: none */

    /* Who hears of events and legs instead of the set of record buffers, and
     * must let it know; and keeps, after each wave, what came of it up to and
     * with photon `last`. NULL: the set of record buffers alone. */
    murk_event_sink sink;
    murk_leg_sink leg;
    void *context; /* of both */
    murk_status (*gather)(void *gather_context, uint64_t last, murk_error *err);
    void *gather_context;

    uint64_t emitted; /* so far */
} murk_emission;

/* Refuses fewer photons than there are channels with power. */
murk_status murk_emission_check(const murk_emission *emission, murk_error *err);

/* All of them; none where all is dark. Fails where too many photons would be
 * needed for `store`, when interrupted, and as gathering does. */
murk_status murk_emission_run(murk_emission *emission, murk_error *err);

/* Fails where too many of them were lost. */
murk_status murk_emission_check_losses(const murk_emission *emission,
                                       murk_error *err);

/* What a packet is worth: packet_w[light * bands + band] is 0 without photons;
 * emitted_in[channels] photons. */
void murk_emission_price(const murk_emission *emission, uint64_t *emitted_in,
                         double *packet_w);

#endif
