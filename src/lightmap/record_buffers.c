/* Record buffers of the photon tracer: events become 32-byte records
 * (photonmap/photon.h), in one buffer for each batch of a wave; the buffers are
 * then moved, batch by batch, to one list of surface records and one of volume
 * records. */
#include "lightmap/record_buffers.h"

#include <math.h>
#include <stdlib.h>

#include "base/machine.h"
#include "base/pool.h"

#define FIRST_CAPACITY 256 /* first capacity of a list: 8 kB */

static murk_photon record_of(const murk_event *event, double share)
{
    const bool is_volume = event->kind == MURK_EVENT_MEDIUM;
    return murk_photon_make(
        &(murk_photon_values){.position_m = event->position,
                              .direction = event->direction_in,
                              .normal = event->normal,
                              .power_w = share,
                              .emitted = (uint32_t)event->photon,
                              .band = event->band,
                              .light = (uint8_t)event->light,
                              .material = event->material_or_medium,
                              .is_volume = is_volume,
                              .event_class = (int)event->event_class});
}

static murk_status no_memory(const murk_record_list *list, murk_error *err)
{
    return murk_no_memory(err, "", "for more than %.3g stored photons",
                          (double)list->n);
}

/* Gives a list memory for more records. */
static murk_status grow(murk_record_list *list, murk_error *err)
{
    const size_t capacity =
        list->capacity ? list->capacity + list->capacity / 2 : FIRST_CAPACITY;
    const double max = list->memory_max > 0 ? list->memory_max : INFINITY;
    const murk_status status = murk_block_resize(
        &list->block, capacity * sizeof(murk_photon), max, err);
    if (!status) {
        list->photon = list->block.bytes;
        list->capacity = capacity;
    }
    return status;
}

void murk_record_list_reserve(murk_record_list *list, double records)
{
    const double max = list->memory_max > 0 ? list->memory_max : INFINITY;
    const size_t size = (size_t)records * sizeof *list->photon;
    if (list->capacity == 0 && size > 0 &&
        !murk_block_resize(&list->block, size, max, NULL)) {
        list->photon = list->block.bytes;
        list->capacity = (size_t)records;
        if (list->block.place == MURK_BLOCK_ON_HEAP) {
            murk_machine_use_huge_pages(list->photon, size);
        }
    }
}

/* The place of one more record, which the list then counts. Fails, with the
 * list unchanged, if it cannot grow. */
static inline murk_status next_record(murk_record_list *list,
                                      murk_photon **place, murk_error *err)
{
    const murk_status status =
        list->n == list->capacity ? grow(list, err) : MURK_OK;
    if (!status) {
        *place = &list->photon[list->n++];
    }
    return status;
}

murk_status murk_record_list_put(murk_record_list *list,
                                 const murk_photon *photon, murk_error *err)
{
    murk_photon *record = NULL;
    const murk_status status = next_record(list, &record, err);
    if (!status) {
        *record = *photon;
    }
    return status;
}

void murk_record_list_release(murk_record_list *list)
{
    murk_block_release(&list->block);
    *list = (murk_record_list){.block = list->block};
}

murk_record_buffers *
murk_record_buffers_create(const murk_scene_photons *settings)
{
    murk_record_buffers *h = calloc(1, sizeof *h);
    if (h) {
        h->settings = settings;
        h->keeps_surface = settings->maps == MURK_SCENE_MAPS_BOTH ||
                           settings->maps == MURK_SCENE_MAPS_SURFACE;
        h->keeps_volume = settings->maps == MURK_SCENE_MAPS_BOTH ||
                          settings->maps == MURK_SCENE_MAPS_VOLUME;
    }
    return h;
}

void murk_record_buffers_destroy(murk_record_buffers *h)
{
    if (h) {
        for (size_t i = 0; i < MURK_WAVE_BATCHES_MAX; ++i) {
            murk_record_list_release(&h->buffer[i]);
        }
        murk_record_list_release(&h->surface);
        murk_record_list_release(&h->volume);
        free(h);
    }
}

double murk_record_buffers_share(const murk_record_buffers *h,
                                 const murk_event *event)
{
    if (event->kind == MURK_EVENT_SURFACE && h->keeps_surface) {
        return h->settings->store_hits ? event->weight * event->reflectance
               : event->outcome == MURK_DIFFUSE ? event->leaving
                                                : 0;
    }
    if (event->kind == MURK_EVENT_MEDIUM && h->keeps_volume) {
        return h->settings->store_hits ? event->weight * event->reflectance
               : event->outcome == MURK_SCATTERED ? event->leaving
                                                  : 0;
    }
    return 0;
}

void murk_record_buffers_event(void *context, uint64_t batch,
                               const murk_event *event)
{
    murk_record_buffers *h = context;
    const double share = murk_record_buffers_share(h, event);
    if (share > 0) {
        murk_record_list *buffer = &h->buffer[batch];
        murk_photon *record;
        if (next_record(buffer, &record, NULL)) {
            buffer->is_short_of_memory = true;
        } else {
            *record = record_of(event, share);
        }
    }
}

void murk_record_buffers_receive(murk_record_buffers *h, murk_trace *trace)
{
    if (h->keeps_surface || h->keeps_volume) {
        trace->sink = murk_record_buffers_event;
        trace->takes_any_order = true;
        trace->skips_surfaces = !h->keeps_surface;
        trace->skips_media = !h->keeps_volume;
        trace->skips_ends = !h->settings->store_hits;
        trace->context = h;
    }
}

void murk_record_buffers_swap(murk_record_buffers *h, size_t a, size_t b)
{
    const murk_record_list list = h->buffer[a];
    h->buffer[a] = h->buffer[b];
    h->buffer[b] = list;
}

void murk_record_buffers_fill(murk_record_buffers *h, size_t batch,
                              const murk_photon *records, size_t n)
{
    murk_record_list *buffer = &h->buffer[batch];
    buffer->n = 0;
    for (size_t i = 0; i < n; ++i) {
        buffer->is_short_of_memory |=
            murk_record_list_put(buffer, &records[i], NULL) != MURK_OK;
    }
}

/* Sorts the records of a batch by photon; the records of one photon stay in
 * order. A counting sort: a batch has few photons, with successive numbers. */
static void sort_batch(void *context, uint64_t batch)
{
    murk_record_buffers *h = context;
    murk_record_list *buffer = &h->buffer[batch];
    const size_t n = buffer->n;
    /* The first photon, and whether the records are in order as they are. */
    uint32_t first = UINT32_MAX, last = 0;
    bool is_sorted = true;
    for (size_t i = 0; i < n; ++i) {
        const uint32_t emitted = murk_photon_emitted(&buffer->photon[i]);
        first = emitted < first ? emitted : first;
        is_sorted = is_sorted && emitted >= last;
        last = emitted;
    }
    if (is_sorted) {
        return;
    }
    murk_photon *sorted = malloc(buffer->capacity * sizeof *sorted);
    if (!sorted) {
        buffer->is_short_of_memory = true;
        return;
    }
    /* The place of the first record of each photon, then all records. */
    uint32_t place[MURK_BATCH_PHOTONS + 1] = {0};
    for (size_t i = 0; i < n; ++i) {
        ++place[murk_photon_emitted(&buffer->photon[i]) - first + 1];
    }
    for (size_t k = 0; k < MURK_BATCH_PHOTONS; ++k) {
        place[k + 1] += place[k];
    }
    for (size_t i = 0; i < n; ++i) {
        const murk_photon *photon = &buffer->photon[i];
        sorted[place[murk_photon_emitted(photon) - first]++] = *photon;
    }
    murk_block_release(&buffer->block);
    buffer->block = murk_block_of(sorted, buffer->capacity * sizeof *sorted);
    buffer->photon = sorted;
}

void murk_record_buffers_sort(murk_record_buffers *h, unsigned threads)
{
    murk_pool_run(threads, MURK_WAVE_BATCHES_MAX, sort_batch, h);
}

uint64_t murk_record_buffers_photon_of(const murk_record_buffers *h,
                                       uint64_t wanted)
{
    uint64_t before = 0;
    for (size_t b = 0; b < MURK_WAVE_BATCHES_MAX; ++b) {
        const murk_record_list *buffer = &h->buffer[b];
        if (before + buffer->n >= wanted) {
            return murk_photon_emitted(&buffer->photon[wanted - before - 1]);
        }
        before += buffer->n;
    }
    return UINT64_MAX;
}

/* Appends the records of a batch, up to those of photon `last`, to the lists of
 * their maps, and empties the buffer. */
static murk_status append(murk_record_buffers *h, murk_record_list *buffer,
                          uint64_t last, murk_error *err)
{
    murk_status status =
        buffer->is_short_of_memory ? no_memory(buffer, err) : MURK_OK;
    for (size_t i = 0; i < buffer->n && !status; ++i) {
        const murk_photon *photon = &buffer->photon[i];
        if (murk_photon_emitted(photon) > last) {
            break;
        }
        status = murk_record_list_put(
            murk_photon_is_volume(photon) ? &h->volume : &h->surface, photon,
            err);
        h->stored += !status;
    }
    buffer->n = 0;
    return status;
}

/* Counts a batch, and passes to the sink of batches, if there is one, the
 * records that the batch added to the lists: those after the first n_surface
 * surface records and the first n_volume volume records. */
static murk_status hand_over(murk_record_buffers *h, size_t n_surface,
                             size_t n_volume, uint64_t last, murk_error *err)
{
    const uint64_t number = h->gathered, first = number * MURK_BATCH_PHOTONS;
    if (first > last) { /* the wave has fewer batches */
        return MURK_OK;
    }
    ++h->gathered;
    const uint64_t end = first + MURK_BATCH_PHOTONS - 1;
    const murk_record_batch batch = {
        .number = number,
        .first = first,
        .last = end < last ? end : last,
        .surface = h->surface.n ? h->surface.photon + n_surface : NULL,
        .volume = h->volume.n ? h->volume.photon + n_volume : NULL,
        .n_surface = h->surface.n - n_surface,
        .n_volume = h->volume.n - n_volume};
    const murk_status status =
        h->each ? h->each(h->each_context, &batch, err) : MURK_OK;
    if (h->passes) {
        h->surface.n = h->volume.n = 0;
    }
    return status;
}

murk_status murk_record_buffers_gather(murk_record_buffers *h, uint64_t last,
                                       murk_error *err)
{
    /* Append the records of each batch and hand the batch over. */
    for (size_t b = 0; b < MURK_WAVE_BATCHES_MAX; ++b) {
        const size_t n_surface = h->surface.n, n_volume = h->volume.n;
        murk_status status = append(h, &h->buffer[b], last, err);
        if (!status) {
            status = hand_over(h, n_surface, n_volume, last, err);
        }
        if (status) {
            return status;
        }
    }
    /* The scene limits the number of records. */
    if (h->stored > h->settings->max_stored) {
        return murk_fail(err, MURK_RUN_FAILED, h->settings->where,
                         "max_stored: more than %llu photons were stored",
                         (unsigned long long)h->settings->max_stored);
    }
    return MURK_OK;
}

void murk_records_to_watts(murk_photon *photon, size_t n,
                           const double *packet_w, int bands)
{
    for (size_t i = 0; i < n; ++i) {
        murk_photon *p = &photon[i];
        const size_t channel =
            (size_t)murk_photon_light(p) * (size_t)bands + murk_photon_band(p);
        murk_photon_set_power_w(p, murk_photon_power_w(p) * packet_w[channel]);
    }
}

void murk_record_buffers_to_watts(murk_record_buffers *h,
                                  const double *packet_w, int bands)
{
    murk_records_to_watts(h->surface.photon, h->surface.n, packet_w, bands);
    murk_records_to_watts(h->volume.photon, h->volume.n, packet_w, bands);
}

/* The records of a list in a block without unused memory; the list is then
 * empty. */
static murk_status take_block(murk_block *out, murk_record_list *list,
                              murk_error *err)
{
    const murk_status status = murk_block_resize(
        &list->block, list->n * sizeof *list->photon, INFINITY, err);
    *out = (murk_block){0};
    if (!status) {
        *out = list->block;
        list->block = (murk_block){0};
    }
    murk_record_list_release(list);
    return status;
}

murk_status murk_record_list_map(murk_photon_map **out, murk_record_list *list,
                                 unsigned threads, murk_error *err)
{
    murk_block block;
    const murk_status status = take_block(&block, list, err);
    return status ? status
                  : murk_photon_map_create_in(out, &block, threads, err);
}

murk_status murk_record_list_map_shared(murk_photon_map **out,
                                        murk_record_list *list,
                                        unsigned threads, murk_status status,
                                        murk_error *err)
{
    murk_block block = {0};
    if (!status) {
        status = take_block(&block, list, err);
    }
    return murk_photon_map_create_shared(out, &block, threads, status, err);
}
