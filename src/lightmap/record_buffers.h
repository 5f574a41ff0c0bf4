/* From events to records: what the tracer's callback keeps for the maps.
 *
 * Each batch of a wave has its own record buffer, written by one thread; record
 * buffers are emptied in batch order, so the records come in the order of the
 * photons' indices whatever the threads did. */
#ifndef MURK_LIGHTMAP_RECORD_BUFFERS_H
#define MURK_LIGHTMAP_RECORD_BUFFERS_H

#include "photonmap/map.h"
#include "scene/scene.h"
#include "transport/trace.h"

#define MURK_WAVE_BATCHES 64 /* traced between two looks at the count */

typedef struct murk_record_list {
    murk_photon *photon;
    size_t n, room;
    bool is_short_of_memory;
} murk_record_list;

typedef struct murk_record_buffers {
    const murk_scene_photons *settings;
    bool keeps_surface, keeps_volume;
    murk_record_list
        buffer[MURK_WAVE_BATCHES];    /* this wave's, in order of events */
    murk_record_list surface, volume; /* all that was gathered */
} murk_record_buffers;

/* NULL when out of memory. */
murk_record_buffers *
murk_record_buffers_create(const murk_scene_photons *settings);
void murk_record_buffers_destroy(
    murk_record_buffers *buffers); /* NULL is fine */

/* The share of a packet that a record of the event is worth: what leaves it in
 * the mean (stored when hit) or now (stored when reflected); 0 where none is
 * stored. */
double murk_record_buffers_share(const murk_record_buffers *buffers,
                                 const murk_event *event);

/* The tracer's callback; context is the set of record buffers. A record's power
 * is a share of its packet until murk_record_buffers_price(). */
void murk_record_buffers_event(void *context, uint64_t batch,
                               const murk_event *event);

/* The photon whose record is the `wanted`th (1..) of this wave; UINT64_MAX
 * when the wave has fewer. */
uint64_t murk_record_buffers_photon_of(const murk_record_buffers *buffers,
                                       uint64_t wanted);

/* Moves this wave's records, up to and with photon `last`, to surface and
 * volume. Fails when out of memory or beyond wish->max_stored. */
murk_status murk_record_buffers_gather(murk_record_buffers *buffers,
                                       uint64_t last, murk_error *err);

/* Shares of a packet become watts. packet_w[light * bands + band]. */
void murk_record_buffers_price(murk_record_buffers *buffers,
                               const double *packet_w, int bands);

/* Hands the record buffer's records over to a new map; *out is the caller's. */
murk_status murk_record_buffers_map(murk_photon_map **out,
                                    murk_record_list *buffer, unsigned threads,
                                    murk_error *err);

#endif
