/* From events to records: what the tracer's callback keeps for the maps.
 *
 * Each batch of a wave has its own pile, written by one thread; piles are
 * emptied in batch order, so the records come in the order of the photons'
 * indices whatever the threads did. */
#ifndef MURK_STUDY_HARVEST_H
#define MURK_STUDY_HARVEST_H

#include "photonmap/map.h"
#include "scene/scene.h"
#include "transport/trace.h"

#define MURK_WAVE_BATCHES 64 /* traced between two looks at the count */

typedef struct murk_pile {
    murk_photon *photon;
    size_t n, room;
    bool is_short_of_memory;
} murk_pile;

typedef struct murk_harvest {
    const murk_scene_photons *wish;
    bool keeps_surface, keeps_volume;
    murk_pile pile[MURK_WAVE_BATCHES]; /* this wave's, in order of events */
    murk_pile surface, volume;         /* all that was gathered */
} murk_harvest;

/* NULL when out of memory. */
murk_harvest *murk_harvest_create(const murk_scene_photons *wish);
void murk_harvest_destroy(murk_harvest *harvest); /* NULL is fine */

/* The share of a packet that a record of the event is worth: what leaves it in
 * the mean (stored when hit) or now (stored when reflected); 0 where none is
 * stored. */
double murk_harvest_share(const murk_harvest *harvest, const murk_event *event);

/* The tracer's callback; context is the harvest. A record's power is a share
 * of its packet until murk_harvest_price(). */
void murk_harvest_event(void *context, uint64_t batch, const murk_event *event);

/* The photon whose record is the `wanted`th (1..) of this wave; UINT64_MAX
 * when the wave has fewer. */
uint64_t murk_harvest_photon_of(const murk_harvest *harvest, uint64_t wanted);

/* Moves this wave's records, up to and with photon `last`, to surface and
 * volume. Fails when out of memory or beyond wish->max_stored. */
murk_status murk_harvest_gather(murk_harvest *harvest, uint64_t last,
                                murk_error *err);

/* Shares of a packet become watts. packet_w[light * bands + band]. */
void murk_harvest_price(murk_harvest *harvest, const double *packet_w,
                        int bands);

/* Hands the pile's records over to a new map; *out is the caller's. */
murk_status murk_harvest_map(murk_photon_map **out, murk_pile *pile,
                             unsigned threads, murk_error *err);

#endif
