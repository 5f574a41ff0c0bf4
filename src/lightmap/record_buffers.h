/* Turns the events of the photon tracer into records of the photon maps.
 *
 * Each batch of a wave has a buffer of its own, which one thread writes. The
 * buffers are emptied in the order of the batches, so the records are ordered
 * by photon for any number of threads. */
#ifndef MURK_LIGHTMAP_RECORD_BUFFERS_H
#define MURK_LIGHTMAP_RECORD_BUFFERS_H

#include "photonmap/map.h"
#include "scene/scene.h"
#include "transport/trace.h"

/* Largest number of batches that are traced before the records are counted: for
 * one process, enough work for the threads of a large machine; and for all
 * ranks together */
#define MURK_WAVE_BATCHES     64
#define MURK_WAVE_BATCHES_MAX 1024

typedef struct murk_record_list {
    murk_block block;
    double memory_max; /* bytes beyond which the block is in a scratch file; 0:
                        * no limit */
    murk_photon *photon; /* the records, in the block */
    size_t n, capacity;
    bool is_short_of_memory;
} murk_record_list;

/* Gives an empty list memory for so many records at once, in huge pages where
 * the machine has them: a list that grows maps its pages anew each time. Pages
 * that no record reaches take no memory. Where that much memory is not to be
 * had, the list grows record by record. */
void murk_record_list_reserve(murk_record_list *list, double records);

/* Appends a record; a full list grows by half. Fails, with the list unchanged,
 * with MURK_NO_MEMORY, or with MURK_RUN_FAILED if the disk with the scratch
 * file is full. */
murk_status murk_record_list_put(murk_record_list *list,
                                 const murk_photon *photon, murk_error *err);
void murk_record_list_release(murk_record_list *list);

/* The records of one batch in the lists of both maps, in the order of
 * photons. */
typedef struct murk_record_batch {
    uint64_t number;      /* of the batch, from 0 */
    uint64_t first, last; /* numbers of the first and the last emitted photon */
    murk_photon *surface, *volume;
    size_t n_surface, n_volume;
} murk_record_batch;

/* Receives each batch when its records are gathered. A failure ends the
 * emission. */
typedef murk_status (*murk_record_batch_sink)(void *context,
                                              const murk_record_batch *batch,
                                              murk_error *err);

typedef struct murk_record_buffers {
    const murk_scene_photons *settings;
    bool keeps_surface, keeps_volume; /* which maps the scene asks for */
    murk_record_list
        buffer[MURK_WAVE_BATCHES_MAX]; /* records of this wave, one buffer for
                                        * each batch, in the order of events */
    murk_record_list surface, volume;  /* all records gathered so far */
    uint64_t gathered;                 /* batches gathered so far */
    uint64_t stored;                   /* records gathered so far */
    murk_record_batch_sink each;       /* may be NULL */
    void *each_context;
    bool passes; /* records are dropped after the sink, if there is one, has
                    received them */
} murk_record_buffers;

/* The settings must outlive the result. NULL when out of memory. */
murk_record_buffers *
murk_record_buffers_create(const murk_scene_photons *settings);
void murk_record_buffers_destroy(
    murk_record_buffers *buffers); /* NULL is fine */

/* The share of a photon packet that a record of the event gets. With
 * settings->store_hits, the share is the expected part of the packet that is
 * reflected diffusely or scattered at the event; else, the share is the actual
 * part that leaves, 0 if the photon was not reflected diffusely or scattered. 0
 * if the event belongs to no map that is kept. */
double murk_record_buffers_share(const murk_record_buffers *buffers,
                                 const murk_event *event);

/* The event sink of the photon tracer; context is the murk_record_buffers,
 * batch is counted from the beginning of the wave. An event with a share of 0
 * (murk_record_buffers_share()) gives no record. The power of a record is a
 * share of the packet until murk_record_buffers_to_watts() is called.
 * murk_record_buffers_gather() reports a lack of memory. */
void murk_record_buffers_event(void *context, uint64_t batch,
                               const murk_event *event);

/* Makes the buffers the sink of a trace of one wave, with the events that they
 * need. Call murk_record_buffers_sort() after the trace. */
void murk_record_buffers_receive(murk_record_buffers *buffers,
                                 murk_trace *trace);

/* Exchanges the records of two batches of this wave; and gives a batch of this
 * wave the records of a part of the run, in the order of photons.
 * murk_record_buffers_gather() reports a lack of memory. */
void murk_record_buffers_swap(murk_record_buffers *buffers, size_t a, size_t b);
void murk_record_buffers_fill(murk_record_buffers *buffers, size_t batch,
                              const murk_photon *records, size_t n);

/* Sorts the records of each batch of this wave by photon, after a trace whose
 * events came in any order of photons (takes_any_order of transport/trace.h).
 * murk_record_buffers_gather() reports a lack of memory. */
void murk_record_buffers_sort(murk_record_buffers *buffers, unsigned threads);

/* The number of the photon that gave the `wanted`-th record (counted from 1) of
 * this wave; UINT64_MAX if the wave has fewer records. */
uint64_t murk_record_buffers_photon_of(const murk_record_buffers *buffers,
                                       uint64_t wanted);

/* Moves the records of this wave, whose last photon is `last`, to the lists of
 * surface and volume records, and drops the records of later photons. Fails if
 * the sink of batches fails, with MURK_NO_MEMORY, or with MURK_RUN_FAILED if
 * more than settings->max_stored records are stored or passed or if the disk
 * with a scratch file is full. */
murk_status murk_record_buffers_gather(murk_record_buffers *buffers,
                                       uint64_t last, murk_error *err);

/* murk_records_to_watts() multiplies the power of each of n records by the
 * power of a packet of the same channel, packet_w[light * bands + band], so
 * that shares become watts. murk_record_buffers_to_watts() does so for all
 * gathered records. */
void murk_records_to_watts(murk_photon *photon, size_t n,
                           const double *packet_w, int bands);
void murk_record_buffers_to_watts(murk_record_buffers *buffers,
                                  const double *packet_w, int bands);

/* Passes the records of a list to a new photon map, which owns them; the list
 * becomes empty, also on failure. The caller owns *out. Fails as
 * murk_photon_map_create(). The second function makes a map that the ranks of a
 * machine share, and is collective: murk_photon_map_create_shared(). */
murk_status murk_record_list_map(murk_photon_map **out, murk_record_list *list,
                                 unsigned threads, murk_error *err);
murk_status murk_record_list_map_shared(murk_photon_map **out,
                                        murk_record_list *list,
                                        unsigned threads, murk_status status,
                                        murk_error *err);

#endif
