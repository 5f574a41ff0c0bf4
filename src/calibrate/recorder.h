/* Converts the segments and events of the photon tracer into contributions.
 * For use inside src/calibrate only.
 *
 * Each batch of a wave has a buffer of its own, which one thread writes.
 * Buffers are emptied in the order of batches, as in lightmap/record_buffers.h,
 * whose functions also decide which events become records, and store the
 * records. */
#ifndef MURK_CALIBRATE_RECORDER_H
#define MURK_CALIBRATE_RECORDER_H

#include "base/arena.h"
#include "calibrate/receiver_tree.h"
#include "lightmap/record_buffers.h"

/* The contributions of a batch (buffer), and the history of the photon that the
 * batch traces at present. */
typedef struct murk_photon_history {
    murk_histories buffer;
    bool is_short_of_memory;
    size_t first;      /* index of the first cosine of the photon in the buffer
                        */
    size_t needed;     /* cosines of the buffer that contributions need */
    uint32_t turns;    /* scatterings of the photon */
    double *path_m;    /* [media] */
    uint32_t *count;   /* [media] */
    murk_chord *chord; /* [receivers]; workspace */
} murk_photon_history;

typedef struct murk_recorder {
    const murk_histories_desc *desc;
    murk_histories *all;          /* histories of all waves */
    const murk_media *world;      /* media of the world */
    murk_media **alone;           /* [media]; each medium by itself */
    int index_of[MURK_MEDIA_MAX]; /* index in desc->medium; -1: not recorded */
    murk_receiver_tree *tree;
    murk_record_buffers *buffers; /* NULL: no records are stored or counted */
    size_t batches;               /* of a wave, at most */
    murk_photon_history *photon;  /* [batches] */
    murk_arena arena;
} murk_recorder;

/* Creates a recorder that appends to `all`. Borrows desc, all and the record
 * buffers. The caller owns *out (murk_recorder_destroy()). */
murk_status murk_recorder_create(murk_recorder **out,
                                 const murk_histories_desc *desc,
                                 murk_histories *all,
                                 murk_record_buffers *buffers, murk_error *err);
void murk_recorder_destroy(murk_recorder *recorder); /* NULL is fine */

/* The sinks of the photon tracer; context is the recorder. */
void murk_recorder_event(void *context, uint64_t batch,
                         const murk_event *event);
void murk_recorder_segment(void *context, uint64_t batch,
                           const murk_trace_segment *segment);

/* Moves the contributions of the wave, up to and including photon `last`, to
 * `all`, and the records of the record buffers likewise; the records receive
 * the numbers of their contributions. */
murk_status murk_recorder_gather(murk_recorder *recorder, uint64_t last,
                                 murk_error *err);

#endif
