/* Records photon histories: density path and number of scatterings by medium,
 * cosines if needed, and a contribution for each chord in a receiver and each
 * stored record. The density path is the optical depth in a medium of
 * extinction 1 (medium/rescaled.h), so overlapping and replaced media are
 * treated as in the photon tracer. */
#include "calibrate/recorder.h"

#include "lightmap/emission.h"
#include "medium/rescaled.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* ---- the history of a photon ---- */

static void begin_photon(const murk_recorder *r, murk_photon_history *f)
{
    f->buffer.turns = f->needed; /* cosines after the last contribution are not
                                  * needed */
    f->first = f->needed;
    f->turns = 0;
    memset(f->path_m, 0, r->all->media * sizeof *f->path_m);
    memset(f->count, 0, r->all->media * sizeof *f->count);
}

/* Appends a contribution with the scatterings and cosines so far. *path and
 * *chord then point to the [media] numbers of the contribution, which the
 * caller fills. False when out of memory. */
static bool add(murk_photon_history *f, murk_contribution made, float **path,
                float **chord)
{
    murk_histories *buffer = &f->buffer;
    const size_t media = buffer->media;
    if (f->is_short_of_memory || !murk_histories_reserve(buffer, 1, 0)) {
        f->is_short_of_memory = true;
        return false;
    }
    const size_t i = buffer->n++;
    *path = buffer->path_m + i * media;
    *chord = buffer->chord_m + i * media;
    memcpy(buffer->count + i * media, f->count, media * sizeof *buffer->count);
    f->needed = buffer->turns;
    made.first = (uint32_t)f->first;
    made.turns = f->turns;
    buffer->contribution[i] = made;
    return true;
}

/* Density path [m] of a recorded medium along a part of the segment; 0 in a
 * solid. */
static double path_along(const murk_recorder *r, size_t m,
                         const murk_trace_segment *segment, double from_m,
                         double to_m)
{
    return segment->is_in_solid
               ? 0
               : murk_media_optical_depth(
                     r->alone[m], segment->band, segment->inside,
                     murk_along(segment->from, from_m, segment->direction),
                     segment->direction, to_m - from_m);
}

/* The weight of a receiver for light on this segment: 1, or the cosine of
 * incidence; 0 if the receiver does not accept the light. */
static double taken(const murk_receiver *receiver,
                    const murk_trace_segment *segment)
{
    if (receiver->band >= 0 && receiver->band != segment->band) {
        return 0;
    }
    const murk_vec3 n = receiver->normal;
    if (n.x == 0 && n.y == 0 && n.z == 0) {
        return 1;
    }
    const double cosine = -murk_dot(n, segment->direction);
    return cosine > 0 && cosine >= receiver->min_cosine ? cosine : 0;
}

void murk_recorder_segment(void *context, uint64_t batch,
                           const murk_trace_segment *segment)
{
    murk_recorder *r = context;
    murk_photon_history *f = &r->photon[batch];
    /* A contribution for each receiver on the segment. */
    const size_t n =
        murk_receiver_tree_chords(r->tree, segment->from, segment->direction,
                                  segment->length_m, f->chord);
    for (size_t i = 0; i < n; ++i) {
        const murk_chord *c = &f->chord[i];
        const murk_contribution made = {
            .photon = (uint32_t)segment->photon,
            .receiver = c->receiver,
            .light = segment->light,
            .band = segment->band,
            .value = (float)((c->to_m - c->from_m) * segment->weight *
                             taken(&r->desc->receiver[c->receiver], segment))};
        float *path, *chord;
        if (!(made.value > 0) || !add(f, made, &path, &chord)) {
            continue;
        }
        for (size_t m = 0; m < r->all->media; ++m) {
            path[m] =
                (float)(f->path_m[m] + path_along(r, m, segment, 0, c->from_m));
            chord[m] = (float)path_along(r, m, segment, c->from_m, c->to_m);
        }
    }
    /* Add the segment to the density paths. */
    for (size_t m = 0; m < r->all->media; ++m) {
        f->path_m[m] += path_along(r, m, segment, 0, segment->length_m);
    }
}

/* Adds the contribution of a stored record. */
static void record(const murk_recorder *r, murk_photon_history *f,
                   const murk_event *event, double share)
{
    const bool is_volume = event->kind == MURK_EVENT_MEDIUM;
    const murk_contribution made = {
        .photon = (uint32_t)event->photon,
        .receiver = is_volume ? MURK_RECORD_OF_VOLUME : MURK_RECORD_OF_SURFACE,
        .light = event->light,
        .band = event->band,
        .medium = is_volume ? event->material_or_medium : 0,
        .value = (float)share};
    float *path, *chord;
    if (!add(f, made, &path, &chord)) {
        return;
    }
    for (size_t m = 0; m < r->all->media; ++m) {
        path[m] = (float)f->path_m[m];
        chord[m] = 0;
    }
    /* The count of a record in a medium includes the scattering at the record
     * itself, because the record has the power that leaves that scattering. */
    if (is_volume && r->index_of[made.medium] >= 0) {
        ++f->buffer.count[(f->buffer.n - 1) * r->all->media +
                          (size_t)r->index_of[made.medium]];
    }
}

/* Adds a scattering to the history, if the medium is recorded. */
static void add_turn(const murk_recorder *r, murk_photon_history *f,
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
    /* Store 1 minus the cosine, which keeps the precision of small angles. */
    murk_histories *buffer = &f->buffer;
    if (f->is_short_of_memory || !murk_histories_reserve(buffer, 0, 1)) {
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
    murk_photon_history *f = &r->photon[batch];
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
        add_turn(r, f, event);
    }
}

/* ---- waves of photons ---- */

/* Moves the contributions of a buffer, up to and including photon `last`, to
 * the end of `all`; contributions of later photons are dropped. False when out
 * of memory or of 32-bit indices. */
static bool move(murk_recorder *r, murk_photon_history *f, uint64_t last)
{
    murk_histories *buffer = &f->buffer, *all = r->all;
    const size_t media = all->media;
    /* Contributions and cosines up to the last photon. */
    size_t n = 0, turns = 0;
    while (n < buffer->n && buffer->contribution[n].photon <= last) {
        const murk_contribution *c = &buffer->contribution[n++];
        turns = (size_t)c->first + c->turns;
    }
    turns = r->desc->keeps_cosines ? turns : 0;
    if (f->is_short_of_memory || all->n + n > UINT32_MAX ||
        all->turns + turns > UINT32_MAX ||
        !murk_histories_reserve(all, n, turns)) {
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
    for (size_t i = first; i < r->all->n; ++i) {
        const uint32_t receiver = r->all->contribution[i].receiver;
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
    const size_t first = r->all->n;
    const size_t surface = r->buffers ? r->buffers->surface.n : 0;
    const size_t volume = r->buffers ? r->buffers->volume.n : 0;
    for (size_t b = 0; b < r->batches; ++b) {
        if (!move(r, &r->photon[b], last)) {
            return murk_no_memory(
                err, "fit", "for more than %.3g contributions and %.3g cosines",
                (double)r->all->n, (double)r->all->turns);
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

/* Creates, for each recorded medium, a copy of the media in which this medium
 * alone has an extinction (murk_media_single()), and fills index_of[]. */
static murk_status make_alone(murk_recorder *r, murk_error *err)
{
    for (int i = 0; i < MURK_MEDIA_MAX; ++i) {
        r->index_of[i] = -1;
    }
    murk_status status = MURK_OK;
    for (size_t m = 0; m < r->all->media && !status; ++m) {
        const size_t medium = r->desc->medium[m];
        assert(medium < murk_media_count(r->world) && r->index_of[medium] < 0);
        r->index_of[medium] = (int)m;
        status = murk_media_single(&r->alone[m], r->world, medium, err);
    }
    return status;
}

murk_status murk_recorder_create(murk_recorder **out,
                                 const murk_histories_desc *desc,
                                 murk_histories *all,
                                 murk_record_buffers *buffers, murk_error *err)
{
    murk_recorder *r = calloc(1, sizeof *r);
    if (!r) {
        return murk_no_memory(err, "fit", "to trace");
    }
    r->desc = desc;
    r->all = all;
    r->world = desc->stage->media;
    r->buffers = buffers;
    /* Workspaces of the batches. */
    const size_t media = desc->media;
    r->alone = murk_arena_array(&r->arena, media, sizeof *r->alone);
    r->photon = murk_arena_array(&r->arena, murk_emission_wave_batches(),
                                 sizeof *r->photon);
    r->batches = r->photon ? murk_emission_wave_batches() : 0;
    for (size_t b = 0; b < r->batches; ++b) {
        murk_photon_history *f = &r->photon[b];
        f->buffer.media = media;
        f->path_m = murk_arena_array(&r->arena, media, sizeof *f->path_m);
        f->count = murk_arena_array(&r->arena, media, sizeof *f->count);
        f->chord =
            murk_arena_array(&r->arena, desc->receivers, sizeof *f->chord);
    }
    /* The copies of the media for density paths, and the receivers. */
    murk_status status = r->arena.is_short
                             ? murk_no_memory(err, "fit", "to trace")
                             : make_alone(r, err);
    status = status ? status
                    : murk_receiver_tree_create(&r->tree, desc->receiver,
                                                desc->receivers, err);
    if (status) {
        murk_recorder_destroy(r);
        return status;
    }
    *out = r;
    return MURK_OK;
}

void murk_recorder_destroy(murk_recorder *r)
{
    if (!r) {
        return;
    }
    for (size_t b = 0; b < r->batches; ++b) {
        murk_histories_release(&r->photon[b].buffer);
    }
    for (size_t m = 0; r->alone && m < r->all->media; ++m) {
        murk_media_destroy(r->alone[m]);
    }
    murk_receiver_tree_destroy(r->tree);
    murk_arena_release(&r->arena);
    free(r);
}
