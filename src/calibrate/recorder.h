/* From a tracer's legs and events to contributions. Private to this room.
 *
 * Each batch of a wave has its own record buffer, written by one thread; record
 * buffers are emptied in batch order (as lightmap/record_buffers.h does, which
 * decides what is a record and keeps it). */
#ifndef MURK_CALIBRATE_RECORDER_H
#define MURK_CALIBRATE_RECORDER_H

#include "calibrate/chords.h"
#include "lightmap/record_buffers.h"

/* Contributions, and what goes with them; as murk_followed names them. */
typedef struct murk_recorded {
    murk_contribution *contribution;
    float *path_m, *chord_m;
    uint32_t *count;
    size_t n, room;
    float *turn;
    uint8_t *turn_medium;
    size_t turns, turn_room;
} murk_recorded;

/* What a batch's present photon has behind it. */
typedef struct murk_photon_history {
    murk_recorded buffer;
    bool is_short_of_memory;
    size_t first;      /* its first turn in the record buffer */
    size_t needed;     /* turns of the record buffer that contributions need */
    uint32_t turns;    /* its scatterings */
    double *path_m;    /* [media] */
    uint32_t *count;   /* [media] */
    murk_chord *chord; /* [receivers] room */
} murk_photon_history;

typedef struct murk_recorder {
    const murk_followed_desc *desc;
    const murk_media *world; /* whose media they are */
    size_t media;
    murk_media **alone;           /* [media] each by itself */
    int index_of[MURK_MEDIA_MAX]; /* in desc->medium; -1: not kept */
    murk_chords *chords;
    murk_record_buffers *buffers; /* NULL: nothing is stored or counted */
    murk_photon_history follower[MURK_WAVE_BATCHES];
    murk_recorded all; /* gathered */
} murk_recorder;

/* Borrows desc and set of record buffers. *out is the caller's:
 * murk_recorder_destroy(). */
murk_status murk_recorder_create(murk_recorder **out,
                                 const murk_followed_desc *desc,
                                 murk_record_buffers *buffers, murk_error *err);
void murk_recorder_destroy(murk_recorder *recorder); /* NULL is fine */

/* The tracer's callbacks; context is the recorder. */
void murk_recorder_event(void *context, uint64_t batch,
                         const murk_event *event);
void murk_recorder_leg(void *context, uint64_t batch,
                       const murk_trace_leg *leg);

/* Moves the wave's contributions, up to and with photon `last`, to `all`, and
 * the set of record buffers's records likewise, which get their contributions'
 * numbers. */
murk_status murk_recorder_gather(murk_recorder *recorder, uint64_t last,
                                 murk_error *err);

/* Growing arrays have room for up to 1.5 times what is in them. The old ones
 * are not held beside: arrays of such size move by their pages. */
#define MURK_WHILE_GROWING 1.5

/* Bytes that n contributions and so many turns take. */
double murk_recorded_bytes(size_t media, double n, double turns);

/* Gives back what the arrays have beyond what is in them. */
void murk_recorded_fit(murk_recorded *recorded, size_t media);

#endif
