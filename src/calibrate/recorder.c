/* Records photon histories: density path and number of scatterings by medium,
 * cosines if needed, and a contribution for each chord in a receiver and each
 * stored record. The density path is the optical depth in a medium of
 * extinction 1 (medium/alone.h), so overlapping and replaced media are treated
 * as in the photon tracer. */
#include "calibrate/recorder.h"

#include "medium/rescaled.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#define FIRST_ROOM 256 /* first capacity: 256 contributions */

/* ---- growing arrays ---- */

static bool regrow(void **array, size_t room, size_t size)
{
    const size_t bytes = room * size;
    void *grown = realloc(*array, bytes > 0 ? bytes : 1);
    if (grown) {
        *array = grown;
    }
    return grown != NULL;
}

static bool set_room(murk_recorded *r, size_t media, size_t room)
{
    const bool fits =
        regrow((void **)&r->contribution, room, sizeof *r->contribution) &&
        regrow((void **)&r->path_m, room * media, sizeof *r->path_m) &&
        regrow((void **)&r->chord_m, room * media, sizeof *r->chord_m) &&
        regrow((void **)&r->count, room * media, sizeof *r->count);
    r->room = fits ? room : r->room;
    return fits;
}

static bool set_turn_room(murk_recorded *r, size_t room)
{
    const bool fits =
        regrow((void **)&r->turn, room, sizeof *r->turn) &&
        regrow((void **)&r->turn_medium, room, sizeof *r->turn_medium);
    r->turn_room = fits ? room : r->turn_room;
    return fits;
}

/* Ensures capacity for `more` further contributions. */
static bool make_room(murk_recorded *r, size_t media, size_t more)
{
    const size_t min = r->n + more, grown = r->room + r->room / 2;
    return min <= r->room || set_room(r, media,
                                      min > grown          ? min
                                      : grown < FIRST_ROOM ? FIRST_ROOM
                                                           : grown);
}

static bool make_turn_room(murk_recorded *r, size_t more)
{
    const size_t min = r->turns + more, grown = r->turn_room * 3 / 2;
    return min <= r->turn_room ||
           set_turn_room(r, min > grown          ? min
                            : grown < FIRST_ROOM ? FIRST_ROOM
                                                 : grown);
}

static void release(murk_recorded *r)
{
    free(r->contribution);
    free(r->path_m);
    free(r->chord_m);
    free(r->count);
    free(r->turn);
    free(r->turn_medium);
}

double murk_recorded_bytes(size_t media, double n, double turns)
{
    const size_t each = sizeof(murk_contribution) +
                        media * (2 * sizeof(float) + sizeof(uint32_t));
    return n * (double)each + turns * (double)(sizeof(float) + 1);
}

void murk_recorded_fit(murk_recorded *r, size_t media)
{
    set_room(r, media, r->n);
    set_turn_room(r, r->turns);
}

/* ---- the history of a photon ---- */

static void begin_photon(murk_recorder *r, murk_photon_history *f)
{
    f->buffer.turns = f->needed; /* cosines after the last contribution are not
                                  * needed */
    f->first = f->needed;
    f->turns = 0;
    for (size_t m = 0; m < r->media; ++m) {
        f->path_m[m] = 0;
        f->count[m] = 0;
    }
}

/* Appends a contribution with the history so far; the caller fills path and
 * chord. NULL when out of memory. */
static murk_contribution *add(murk_recorder *r, murk_photon_history *f,
                              float **path, float **chord)
{
    murk_recorded *buffer = &f->buffer;
    if (f->is_short_of_memory || !make_room(buffer, r->media, 1)) {
        f->is_short_of_memory = true;
        return NULL;
    }
    const size_t i = buffer->n++;
    *path = buffer->path_m + i * r->media;
    *chord = buffer->chord_m + i * r->media;
    memcpy(buffer->count + i * r->media, f->count,
           r->media * sizeof *buffer->count);
    f->needed = buffer->turns;
    buffer->contribution[i] =
        (murk_contribution){.first = (uint32_t)f->first, .turns = f->turns};
    return &buffer->contribution[i];
}

/* Density path [m] of a recorded medium along a part of the segment. */
static double path_along(const murk_recorder *r, size_t m,
                         const murk_trace_leg *leg, double from_m, double to_m)
{
    return leg->is_in_solid ? 0
                            : murk_media_optical_depth(
                                  r->alone[m], leg->band, leg->inside,
                                  murk_along(leg->from, from_m, leg->direction),
                                  leg->direction, to_m - from_m);
}

/* The weight of a receiver for light on this segment: 1, or the cosine of
 * incidence; 0 if the receiver does not accept the light. */
static double taken(const murk_receiver *receiver, const murk_trace_leg *leg)
{
    if (receiver->band >= 0 && receiver->band != leg->band) {
        return 0;
    }
    const murk_vec3 n = receiver->normal;
    if (n.x == 0 && n.y == 0 && n.z == 0) {
        return 1;
    }
    const double cosine = -murk_dot(n, leg->direction);
    return cosine > 0 && cosine >= receiver->min_cosine ? cosine : 0;
}

void murk_recorder_leg(void *context, uint64_t batch, const murk_trace_leg *leg)
{
    murk_recorder *r = context;
    murk_photon_history *f = &r->follower[batch];
    /* A contribution for each receiver on the segment. */
    const size_t n = murk_chords_of(r->chords, leg->from, leg->direction,
                                    leg->length_m, f->chord);
    for (size_t i = 0; i < n; ++i) {
        const murk_chord *c = &f->chord[i];
        const float value =
            (float)((c->to_m - c->from_m) * leg->weight *
                    taken(&r->desc->receiver[c->receiver], leg));
        float *path, *chord;
        murk_contribution *made = value > 0 ? add(r, f, &path, &chord) : NULL;
        if (!made) {
            continue;
        }
        made->photon = (uint32_t)leg->photon;
        made->receiver = c->receiver;
        made->light = leg->light;
        made->band = leg->band;
        made->value = value;
        for (size_t m = 0; m < r->media; ++m) {
            path[m] =
                (float)(f->path_m[m] + path_along(r, m, leg, 0, c->from_m));
            chord[m] = (float)path_along(r, m, leg, c->from_m, c->to_m);
        }
    }
    /* Add the segment to the density paths. */
    for (size_t m = 0; m < r->media; ++m) {
        f->path_m[m] += path_along(r, m, leg, 0, leg->length_m);
    }
}

/* Adds the contribution of a stored record. */
static void record(murk_recorder *r, murk_photon_history *f,
                   const murk_event *event, double share)
{
    const bool is_volume = event->kind == MURK_EVENT_MEDIUM;
    float *path, *chord;
    murk_contribution *made = add(r, f, &path, &chord);
    if (!made) {
        return;
    }
    made->photon = (uint32_t)event->photon;
    made->receiver = is_volume ? MURK_RECORD_OF_VOLUME : MURK_RECORD_OF_SURFACE;
    made->light = event->light;
    made->band = event->band;
    made->medium = is_volume ? event->material_or_medium : 0;
    made->value = (float)share;
    for (size_t m = 0; m < r->media; ++m) {
        path[m] = (float)f->path_m[m];
        chord[m] = 0;
    }
    /* A record in a medium includes its own scattering, since the power leaves
     * it. */
    if (is_volume && r->index_of[made->medium] >= 0) {
        ++f->buffer.count[(f->buffer.n - 1) * r->media +
                          (size_t)r->index_of[made->medium]];
    }
}

/* Adds a scattering to the history. */
static void turn(murk_recorder *r, murk_photon_history *f,
                 const murk_event *event)
{
    const int m = r->index_of[event->material_or_medium];
    if (m < 0) {
        return;
    }
    /* Count it. */
    ++f->count[m];
    ++f->turns;
    if (!r->desc->keeps_cosines) {
        return;
    }
    /* Store the cosine. */
    murk_recorded *buffer = &f->buffer;
    if (f->is_short_of_memory || !make_turn_room(buffer, 1)) {
        f->is_short_of_memory = true;
        return;
    }
    const double s = 1 - murk_dot(event->direction_in, event->direction_out);
    buffer->turn[buffer->turns] = (float)(s < 0 ? 0 : s > 2 ? 2 : s);
    buffer->turn_medium[buffer->turns++] = (uint8_t)m;
}

void murk_recorder_event(void *context, uint64_t batch, const murk_event *event)
{
    murk_recorder *r = context;
    murk_photon_history *f = &r->follower[batch];
    if (event->kind == MURK_EVENT_EMITTED) {
        begin_photon(r, f);
        return;
    }
    if (r->buffers) {
        murk_record_buffers_event(r->buffers, batch, event);
        const double share = murk_record_buffers_share(r->buffers, event);
        if (share > 0 && r->desc->keeps_records) {
            record(r, f, event, share);
        }
    }
    if (event->kind == MURK_EVENT_MEDIUM && event->outcome == MURK_SCATTERED) {
        turn(r, f, event);
    }
}

/* ---- waves of photons ---- */

/* Moves the contributions of a buffer, up to and including photon `last`, to
 * the end of `all`. */
static bool move(murk_recorder *r, murk_photon_history *f, uint64_t last)
{
    murk_recorded *buffer = &f->buffer, *all = &r->all;
    const size_t media = r->media;
    /* Contributions and cosines up to the last photon. */
    size_t n = 0, turns = 0;
    while (n < buffer->n && buffer->contribution[n].photon <= last) {
        const murk_contribution *c = &buffer->contribution[n++];
        turns = (size_t)c->first + c->turns;
    }
    turns = r->desc->keeps_cosines ? turns : 0;
    if (f->is_short_of_memory || all->n + n > UINT32_MAX ||
        all->turns + turns > UINT32_MAX || !make_room(all, media, n) ||
        !make_turn_room(all, turns)) {
        return false;
    }
    /* Cosines are numbered from the start of all cosines. */
    for (size_t i = 0; i < n; ++i) {
        all->contribution[all->n + i] = buffer->contribution[i];
        all->contribution[all->n + i].first += (uint32_t)all->turns;
    }
    /* Paths and counts. */
    if (n > 0 && media > 0) {
        const size_t to = all->n * media, many = n * media;
        memcpy(all->path_m + to, buffer->path_m, many * sizeof *all->path_m);
        memcpy(all->chord_m + to, buffer->chord_m, many * sizeof *all->chord_m);
        memcpy(all->count + to, buffer->count, many * sizeof *all->count);
    }
    if (turns > 0) {
        memcpy(all->turn + all->turns, buffer->turn, turns * sizeof *all->turn);
        memcpy(all->turn_medium + all->turns, buffer->turn_medium, turns);
    }
    all->n += n;
    all->turns += turns;
    /* The buffer is empty now. */
    buffer->n = buffer->turns = f->needed = 0;
    return true;
}

/* Gives the new records the numbers of their contributions. Records and
 * contributions come from the same events in the same order. */
static void number_records(murk_recorder *r, size_t first, size_t surface,
                           size_t volume)
{
    for (size_t i = first; i < r->all.n; ++i) {
        const uint32_t receiver = r->all.contribution[i].receiver;
        if (receiver == MURK_RECORD_OF_SURFACE) {
            murk_photon_set_emitted(&r->buffers->surface.photon[surface++],
                                    (uint32_t)i);
        } else if (receiver == MURK_RECORD_OF_VOLUME) {
            murk_photon_set_emitted(&r->buffers->volume.photon[volume++],
                                    (uint32_t)i);
        }
    }
    assert(!r->desc->keeps_records || (surface == r->buffers->surface.n &&
                                       volume == r->buffers->volume.n));
}

murk_status murk_recorder_gather(murk_recorder *r, uint64_t last,
                                 murk_error *err)
{
    const size_t first = r->all.n;
    const size_t surface = r->buffers ? r->buffers->surface.n : 0;
    const size_t volume = r->buffers ? r->buffers->volume.n : 0;
    for (size_t b = 0; b < MURK_WAVE_BATCHES; ++b) {
        if (!move(r, &r->follower[b], last)) {
            return murk_fail(err, MURK_NO_MEMORY, "fit",
                             "no memory for more than %.3g contributions and "
                             "%.3g cosines",
                             (double)r->all.n, (double)r->all.turns);
        }
    }
    if (r->buffers) {
        const murk_status status =
            murk_record_buffers_gather(r->buffers, last, err);
        if (status) {
            return status;
        }
        number_records(r, first, surface, volume);
    }
    return MURK_OK;
}

/* ---- creation ---- */

/* Creates the media by themselves and the index from media to recorded media.
 */
static murk_status make_alone(murk_recorder *r, murk_error *err)
{
    for (int i = 0; i < MURK_MEDIA_MAX; ++i) {
        r->index_of[i] = -1;
    }
    murk_status status = MURK_OK;
    for (size_t m = 0; m < r->media && !status; ++m) {
        const size_t medium = r->desc->medium[m];
        assert(medium < murk_media_count(r->world) && r->index_of[medium] < 0);
        r->index_of[medium] = (int)m;
        status = murk_media_single(&r->alone[m], r->world, medium, err);
    }
    return status;
}

static bool make_followers(murk_recorder *r)
{
    const size_t receivers = r->desc->receivers;
    bool fits = true;
    for (size_t b = 0; b < MURK_WAVE_BATCHES; ++b) {
        murk_photon_history *f = &r->follower[b];
        f->path_m = calloc(r->media + 1, sizeof *f->path_m);
        f->count = calloc(r->media + 1, sizeof *f->count);
        f->chord = calloc(receivers + 1, sizeof *f->chord);
        fits = fits && f->path_m && f->count && f->chord;
    }
    return fits;
}

murk_status murk_recorder_create(murk_recorder **out,
                                 const murk_followed_desc *desc,
                                 murk_record_buffers *buffers, murk_error *err)
{
    /* Allocate. */
    murk_status status = MURK_OK;
    murk_recorder *r = calloc(1, sizeof *r);
    if (r) {
        r->desc = desc;
        r->world = desc->stage->media;
        r->media = desc->media;
        r->buffers = buffers;
        r->alone = calloc(desc->media + 1, sizeof(murk_media *));
    }
    if (!r || !r->alone || !make_followers(r)) {
        status =
            murk_fail(err, MURK_NO_MEMORY, "fit", "no memory to follow light");
        goto done;
        /* Media by themselves, and the receivers. */
    }
    status = make_alone(r, err);
    if (!status) {
        status = murk_chords_create(&r->chords, desc->receiver, desc->receivers,
                                    err);
    }
    if (!status) {
        *out = r;
        r = NULL;
    }
done:
    murk_recorder_destroy(r);
    return status;
}

void murk_recorder_destroy(murk_recorder *r)
{
    if (!r) {
        return;
    }
    for (size_t b = 0; b < MURK_WAVE_BATCHES; ++b) {
        release(&r->follower[b].buffer);
        free(r->follower[b].path_m);
        free(r->follower[b].count);
        free(r->follower[b].chord);
    }
    for (size_t m = 0; r->alone && m < r->media; ++m) {
        murk_media_destroy(r->alone[m]);
    }
    free(r->alone);
    murk_chords_destroy(r->chords);
    release(&r->all);
    free(r);
}
