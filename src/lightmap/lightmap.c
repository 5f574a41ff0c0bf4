/* Traces the light of a scene: a pilot run forecasts records and memory, the
 * emission (lightmap/emission.h) traces the photons in waves, and the records
 * become two kd-trees. */
#include "lightmap/lightmap.h"

#include "base/block.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/machine.h"
#include "base/progress.h"
#include "base/ranks.h"
#include "base/scratch_file.h"
#include "lightmap/checkpoint.h"
#include "lightmap/emission.h"
#include "lightmap/store_check.h"
#include "lightmap/watching.h"
#include "world/scene_tallies.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One batch, the smallest unit of tracing */
#define PILOT_PHOTONS MURK_BATCH_PHOTONS

/* Memory for records that is reserved, as a share of the forecast: the pilot is
 * wrong by a few per cent. */
#define RESERVE 1.1

/* In a closed room most of the light is absorbed. A share above one half is
 * worth a warning. */
#define ESCAPE_SHARE_MAX 0.5

/* Share of the emitted power that escaped. Each channel counts by its power,
 * because a channel is traced by a number of photons that only approximates its
 * share. */
static double escaped_share(const murk_stage *stage, const murk_ledger *ledger)
{
    double escaped_w = 0, emitted_w = 0;
    for (size_t c = 0; c < ledger->channels; ++c) {
        const int64_t emitted = murk_tally_read(&ledger->emitted[c]);
        const int64_t escaped = murk_tally_read(&ledger->escaped[c]);
        const double power_w = murk_sources_channel_power_w(stage->lights, c);
        if (emitted > 0) {
            emitted_w += power_w;
            escaped_w += power_w * ((double)escaped / (double)emitted);
        }
    }
    return emitted_w > 0 ? escaped_w / emitted_w : 0;
}

void murk_warn_of_escape(const murk_stage *stage, double share)
{
    const murk_scene_desc *scene = stage->scene;
    bool is_outdoors = !(murk_surfaces_describe(stage->surfaces).area_m2 > 0);
    for (size_t i = 0; i < scene->n_lights; ++i) {
        is_outdoors |= murk_scene_light_is_distant(&scene->lights[i]);
    }
    if (!is_outdoors && share > ESCAPE_SHARE_MAX) {
        murk_warn(scene->where[0] ? scene->where : scene->path,
                  "%.0f %% of the lamps' light escapes through the domain's "
                  "sides: where this is a room, look for walls that are "
                  "missing, open or outside the domain",
                  100 * share);
    }
}

/* ---- forecast ---- */

murk_status murk_lightmap_forecast(murk_forecast *out, const murk_stage *stage,
                                   uint32_t stream, unsigned threads,
                                   murk_error *err)
{
    const murk_scene_photons *settings = &stage->scene->photons;
    const bool is_dark = murk_sources_lit(stage->lights) == 0;
    /* The pilot has one batch, fewer photons if the run has fewer, or none if
     * no light source emits. */
    const uint64_t n = is_dark ? 0
                       : settings->emit && settings->emit < PILOT_PHOTONS
                           ? settings->emit
                           : PILOT_PHOTONS;
    murk_ledger *ledger = NULL;
    murk_record_buffers *h = NULL;
    murk_status status = murk_ending_check(stage, stream, err);
    if (status) {
        return status;
    }
    h = murk_record_buffers_create(settings);
    if (!h) {
        return murk_no_memory(err, settings->where, "to trace");
    }
    status = murk_ledger_create(&ledger, &stage->world, err);
    if (status) {
        goto done;
    }
    /* Trace the pilot. */
    murk_trace trace = murk_stage_trace(stage);
    trace.stream = stream;
    trace.last = n;
    trace.threads = threads;
    trace.sink = murk_record_buffers_event;
    trace.takes_any_order = true;
    trace.context = h;
    murk_progress_begin("pilot", n, "photons");
    const double begun_s = murk_clock_s();
    murk_trace_run(&trace, ledger);
    const double pilot_s = murk_clock_s() - begun_s;
    murk_progress_end();
    status = murk_interrupt_check(err);
    if (status) {
        goto done;
    }
    /* Count the records of each map. */
    double surface = 0, volume = 0;
    for (size_t i = 0; i < h->buffer[0].n; ++i) {
        if (murk_photon_is_volume(&h->buffer[0].photon[i])) {
            ++volume;
        } else {
            ++surface;
        }
    }
    /* Scale to the full run. */
    const double all = surface + volume;
    const double grow = is_dark          ? 0
                        : settings->emit ? (double)settings->emit / (double)n
                        : all > 0        ? (double)settings->store / all
                                         : 0;
    /* A growing array holds up to 1.5 times the memory of its content, and both
     * the old and the new array exist while the array moves: 2.5 times. The
     * kd-trees need more memory beside the content;
     * murk_photon_map_memory_for() includes the content, which is subtracted
     * because it is counted already. Records that need more than blocks may
     * take lie in a scratch file. */
    const double records = all * grow;
    const double tree =
        murk_photon_map_memory_for(records) - sizeof(murk_photon) * records;
    const double memory = 2.5 * sizeof(murk_photon) * records + tree;
    const bool is_in_file = memory > murk_block_memory_bytes();
    *out = (murk_forecast){
        .pilot_photons = n,
        .pilot_s = pilot_s,
        .escaped_share = escaped_share(stage, ledger),
        .surface = surface * grow,
        .volume = volume * grow,
        .emitted = settings->emit && !is_dark ? (double)settings->emit
                                              : (double)n * grow,
        .memory_bytes = is_in_file ? tree : memory,
        .scratch_bytes = is_in_file ? 1.5 * sizeof(murk_photon) * records : 0};
done:
    murk_record_buffers_destroy(h);
    murk_ledger_destroy(ledger);
    return status;
}

/* Fails with MURK_BAD_VALUE if the forecast exceeds max_stored, or the free
 * memory and, beyond it, the space and the addresses for a scratch file. */
static murk_status check_forecast(const murk_forecast *forecast,
                                  const murk_scene_photons *settings,
                                  murk_error *err)
{
    const double records = forecast->surface + forecast->volume;
    if (records > (double)settings->max_stored) {
        return murk_fail(err, MURK_BAD_VALUE, settings->where,
                         "about %.3g photons would be stored (from a pilot of "
                         "%llu), max_stored allows %llu",
                         records, (unsigned long long)forecast->pilot_photons,
                         (unsigned long long)settings->max_stored);
    }
    /* A mapped file that grows is mapped twice for a moment. */
    const double addresses = murk_machine_address_bytes();
    if (2 * forecast->scratch_bytes > addresses) {
        return murk_fail(err, MURK_BAD_VALUE, settings->where,
                         "about %.3g photons would be stored, which takes %.3g "
                         "GB of addresses; this process has %.3g GB free "
                         "(ulimit -v)",
                         records, 2 * forecast->scratch_bytes / 1e9,
                         addresses / 1e9);
    }
    /* Memory, and the disk if the records lie in a scratch file. */
    const double have = murk_machine_memory_bytes();
    const double disk = murk_scratch_free_bytes();
    if (forecast->memory_bytes > have || forecast->scratch_bytes > disk) {
        return murk_fail(
            err, MURK_BAD_VALUE, settings->where,
            "about %.3g photons would be stored, which takes %.3g GB of memory "
            "and %.3g GB of disk space; this machine has %.3g GB and, in %s, "
            "%.3g GB free",
            records, forecast->memory_bytes / 1e9,
            forecast->scratch_bytes / 1e9, have / 1e9, murk_scratch_folder(),
            disk / 1e9);
    }
    return MURK_OK;
}

/* ---- tracing ---- */

/* Sets the power of the photon packets of each channel. */
static murk_status set_packet_powers(murk_traced *traced,
                                     const murk_emission *emission,
                                     murk_error *err)
{
    uint64_t *count = calloc(traced->channels, sizeof *count);
    if (!count) {
        return murk_no_memory(err, emission->stage->scene->path,
                              "for the lights");
    }
    murk_emission_packet_powers(emission, count, traced->packet_w);
    free(count);
    return MURK_OK;
}

murk_status murk_traced_set_powers(murk_traced *traced, const murk_stage *stage,
                                   murk_error *err)
{
    const murk_emission all = {.stage = stage, .emitted = traced->emitted};
    return set_packet_powers(traced, &all, err);
}

/* A sink of batches between the record buffers and the sink of the caller. */
typedef struct streaming {
    murk_record_batch_sink each;
    void *context;
    const double *packet_w; /* NULL: records keep their share of a packet */
    int bands;
    bool passes;       /* no record is kept */
    double bytes_each; /* memory of the sink for each record, with `passes` */
} streaming;

/* A murk_record_batch_sink. */
static murk_status stream_batch(void *context, const murk_record_batch *batch,
                                murk_error *err)
{
    const streaming *s = context;
    if (s->packet_w) {
        murk_records_to_watts(batch->surface, batch->n_surface, s->packet_w,
                              s->bands);
        murk_records_to_watts(batch->volume, batch->n_volume, s->packet_w,
                              s->bands);
    }
    return s->each(s->context, batch, err);
}

/* Checks the losses, sets the power of the packets, turns shares of a packet
 * into watts unless stream_batch() has done that, and builds the maps. */
static murk_status finish(murk_traced *traced, const murk_emission *emission,
                          const streaming *s, murk_status status,
                          murk_error *err)
{
    murk_record_buffers *buffers = emission->buffers;
    if (!status) {
        status = murk_emission_check_losses(emission, err);
    }
    if (!status) {
        status = set_packet_powers(traced, emission, err);
    }
    status = murk_ranks_agree(status, err);
    if (status) {
        return status;
    }
    /* Watts, then the maps. */
    const double begun_s = murk_clock_s();
    murk_progress_begin("maps", 2, "maps");
    if (!s->packet_w) {
        murk_record_buffers_to_watts(buffers, traced->packet_w, s->bands);
    }
    status = murk_record_list_map_shared(&traced->surface, &buffers->surface,
                                         emission->threads, status, err);
    murk_progress_add(!status);
    status = murk_record_list_map_shared(&traced->volume, &buffers->volume,
                                         emission->threads, status, err);
    murk_progress_add(!status);
    murk_progress_end();
    traced->map_s = murk_clock_s() - begun_s;
    return status;
}

/* Connects the record buffers with the sink of batches, if there is one. The
 * power of packets follows from the number of photons, if that is given. */
static murk_status prepare_stream(streaming *s, murk_emission *e,
                                  murk_traced *traced, murk_error *err)
{
    if (!s->each) {
        return MURK_OK;
    }
    e->buffers->each = stream_batch;
    e->buffers->passes |= s->passes;
    e->buffers->each_context = s;
    if (!e->emit) {
        return MURK_OK;
    }
    murk_emission all = *e;
    all.emitted = e->emit;
    s->packet_w = traced->packet_w;
    return set_packet_powers(traced, &all, err);
}

/* The largest size of a list in memory, if the other one has `other` records as
 * forecast and half of that as unused memory. */
static double list_max(double memory, double other)
{
    return fmax(1, memory - 1.5 * sizeof(murk_photon) * other);
}

/* Where the lists of records lie: both in scratch files if the forecast says
 * so, else in memory, as long as both fit there. Of the ranks of a machine the
 * first has them, which shares their memory with the others. */
static void place_records(murk_record_buffers *buffers,
                          const murk_forecast *forecast, bool keeps)
{
    const double memory =
        forecast->scratch_bytes > 0 ? 0 : murk_block_memory_bytes();
    buffers->surface.memory_max = list_max(memory, forecast->volume);
    buffers->volume.memory_max = list_max(memory, forecast->surface);
    buffers->surface.block.is_for_ranks = buffers->volume.block.is_for_ranks =
        murk_ranks_on_machine().count > 1;
    buffers->passes = !murk_ranks_keeps_shared();
    if (keeps) {
        murk_record_list_reserve(&buffers->surface,
                                 RESERVE * forecast->surface);
        murk_record_list_reserve(&buffers->volume, RESERVE * forecast->volume);
    }
}

/* `watched`: the box whose cells on the paths of photons are noted; NULL:
 * none. */
static murk_status trace_light(murk_traced **out, const murk_stage *stage,
                               uint32_t stream, unsigned threads, streaming *s,
                               const murk_light_parts *parts,
                               murk_checkpoint *checkpoint,
                               const murk_box *watched, murk_error *err)
{
    const murk_scene_photons *settings = &stage->scene->photons;
    murk_forecast forecast = {.emitted = (double)settings->emit};
    const bool keeps = murk_ranks_keeps_shared() && !s->passes;
    murk_emission e = {.stage = stage,
                       .stream = stream,
                       .threads = threads,
                       .emit = settings->emit,
                       .parts = parts,
                       .checkpoint = checkpoint};
    murk_traced *traced = NULL;
    /* Check before tracing: number of photons, end of light, forecast. */
    murk_status status = murk_emission_check(&e, err);
    if (!status && settings->maps == MURK_SCENE_MAPS_NONE) {
        status = murk_ending_check(stage, stream, err);
    } else if (!status) {
        status = murk_lightmap_forecast(&forecast, stage, stream, threads, err);
        if (!keeps) {
            forecast.memory_bytes =
                s->bytes_each * (forecast.surface + forecast.volume);
            forecast.scratch_bytes = 0;
        }
        if (!status) {
            status = check_forecast(&forecast, settings, err);
        }
    }
    if (status) {
        return status;
    }
    /* Allocate; tallies belong to stream 0 alone. */
    traced = murk_traced_create(stage, stream, err);
    e.buffers = murk_record_buffers_create(settings);
    if (!traced || !e.buffers) {
        status = murk_no_memory(err, settings->where, "to trace");
        goto done;
    }
    e.ledger = traced->ledger;
    if (stream == 0) {
        status = murk_tallies_of_stage(
            &traced->tallies, stage, threads,
            murk_machine_memory_bytes() - forecast.memory_bytes, err);
    }
    if (status) {
        goto done;
    }
    e.tallies = traced->tallies;
    place_records(e.buffers, &forecast, keeps);
    murk_watching watching = {e.buffers, NULL, &stage->world.domain};
    if (watched && murk_can_watch(stage)) {
        status = murk_path_cells_create(&traced->cells, watched, settings->emit,
                                        err);
        watching.cells = traced->cells;
        e.sink = murk_watch_event;
        e.context = &watching;
        e.takes_any_order = true;
    }
    if (status) {
        goto done;
    }
    status = prepare_stream(s, &e, traced, err);
    if (status) {
        goto done;
    }
    /* Trace what no part has. */
    if (parts && murk_ranks_number() == 0) {
        murk_light_parts_add(parts, e.ledger, e.tallies);
    }
    const double begun_s = murk_clock_s();
    murk_progress_begin("trace", (uint64_t)forecast.emitted, "photons");
    status = murk_emission_run(&e, err);
    murk_progress_end();
    traced->emitted = e.emitted;
    traced->trace_s = murk_clock_s() - begun_s;
    /* Build the maps and hand over. */
    status = finish(traced, &e, s, status, err);
    if (!status) {
        if (stream == 0) { /* for the first map only, so that the warning
                            * appears once */
            murk_warn_of_escape(stage, escaped_share(stage, traced->ledger));
        }
        *out = traced;
        traced = NULL;
    }
done:
    murk_record_buffers_destroy(e.buffers);
    murk_traced_destroy(traced);
    return status;
}

murk_status murk_lightmap_trace(murk_traced **out, const murk_stage *stage,
                                uint32_t stream, unsigned threads,
                                murk_error *err)
{
    streaming none = {.bands = stage->scene->bands};
    return trace_light(out, stage, stream, threads, &none, NULL, NULL, NULL,
                       err);
}

murk_status murk_lightmap_trace_watched(murk_traced **out,
                                        const murk_stage *stage,
                                        const murk_box *watched,
                                        unsigned threads, murk_error *err)
{
    streaming none = {.bands = stage->scene->bands};
    return trace_light(out, stage, 0, threads, &none, NULL, NULL, watched, err);
}

/* Fails with MURK_BAD_FILE if the energies of merged parts cannot be those of a
 * run. */
static murk_status check_merged(const murk_traced *traced,
                                const murk_stage *stage, murk_error *err)
{
    const murk_ledger *ledger = traced->ledger;
    int64_t *cell = malloc(murk_ledger_cells(ledger) * sizeof *cell);
    if (!cell) {
        return murk_no_memory(err, "", "for the ledger");
    }
    murk_ledger_read(ledger, cell);
    const murk_status status = murk_lightmap_check_ledger(
        cell, traced->emitted, traced->packet_w, stage, "parts", err);
    free(cell);
    return status;
}

murk_status murk_lightmap_merge(murk_traced **out, const murk_stage *stage,
                                const murk_light_parts *parts, unsigned threads,
                                murk_error *err)
{
    streaming none = {.bands = stage->scene->bands};
    murk_traced *traced = NULL;
    murk_status status =
        trace_light(&traced, stage, 0, threads, &none, parts, NULL, NULL, err);
    if (!status) {
        status = check_merged(traced, stage, err);
    }
    if (status) {
        murk_traced_destroy(traced);
        return status;
    }
    *out = traced;
    return MURK_OK;
}

murk_status murk_lightmap_resume(murk_traced **out, const murk_stage *stage,
                                 unsigned threads, const char *path,
                                 double every_s, murk_error *err)
{
    streaming none = {.bands = stage->scene->bands};
    murk_checkpoint checkpoint = {path, every_s, murk_clock_s()};
    murk_light_parts *parts = NULL;
    murk_traced *traced = NULL;
    murk_status status = murk_checkpoint_read(&parts, path, stage, err);
    if (!status) {
        status = trace_light(&traced, stage, 0, threads, &none, parts,
                             every_s > 0 ? &checkpoint : NULL, NULL, err);
    }
    if (!status && parts) {
        status = check_merged(traced, stage, err);
    }
    murk_light_parts_destroy(parts);
    if (status) {
        murk_traced_destroy(traced);
        return status;
    }
    *out = traced;
    return MURK_OK;
}

murk_status murk_lightmap_stream(murk_traced **out, const murk_stage *stage,
                                 unsigned threads, murk_record_batch_sink each,
                                 void *context, murk_error *err)
{
    streaming s = {
        .each = each, .context = context, .bands = stage->scene->bands};
    return trace_light(out, stage, 0, threads, &s, NULL, NULL, NULL, err);
}

murk_status murk_lightmap_pass(murk_traced **out, const murk_stage *stage,
                               uint32_t stream, unsigned threads,
                               double bytes_each, murk_record_batch_sink each,
                               void *context, const murk_box *watched,
                               murk_error *err)
{
    streaming s = {.each = each,
                   .context = context,
                   .bands = stage->scene->bands,
                   .passes = true,
                   .bytes_each = bytes_each};
    return trace_light(out, stage, stream, threads, &s, NULL, NULL, watched,
                       err);
}

murk_traced *murk_traced_create(const murk_stage *stage, uint32_t stream,
                                murk_error *err)
{
    murk_traced *traced = calloc(1, sizeof *traced);
    if (traced) {
        traced->seed = stage->scene->seed;
        traced->stream = stream;
        traced->channels = murk_sources_channels(stage->lights);
        traced->packet_w = calloc(traced->channels, sizeof *traced->packet_w);
    }
    if (!traced || !traced->packet_w ||
        murk_ledger_create(&traced->ledger, &stage->world, err)) {
        murk_no_memory(err, stage->scene->path, "to trace");
        murk_traced_destroy(traced);
        return NULL;
    }
    return traced;
}

void murk_traced_destroy(murk_traced *traced)
{
    if (traced) {
        murk_photon_map_destroy(traced->surface);
        murk_photon_map_destroy(traced->volume);
        murk_ledger_destroy(traced->ledger);
        murk_tallies_destroy(traced->tallies);
        murk_path_cells_destroy(traced->cells);
        free(traced->packet_w);
        free(traced);
    }
}
