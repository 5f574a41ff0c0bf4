/* Traces the batches of a shard and writes them as a part of the light of a
 * scene (lightmap/light_part.h), in waves like an undivided run
 * (lightmap/emission.h). The file has the container format of light.murk
 * (photonmap/map_file.h). */
#include "lightmap/light_part_trace.h"

#include "base/block.h"
#include "base/interrupt.h"
#include "base/machine.h"
#include "base/progress.h"
#include "lightmap/emission.h"
#include "lightmap/light_part.h"
#include "lightmap/rank_exchange.h"
#include "world/scene_tallies.h"

#include <math.h>
#include <stdlib.h>

/* A part that is traced. */
typedef struct tracing {
    const murk_stage *stage;
    murk_shard shard;
    unsigned threads;
    murk_ledger *ledger;
    murk_tallies *tallies;
    murk_record_buffers *buffers; /* of one wave */
    murk_record_list records;     /* of all batches so far */
    uint32_t *count;              /* [batches] records of each batch */
    uint64_t batches, capacity;
} tracing;

/* The number of photons of the whole run, at most. */
static uint64_t photons_max(const tracing *t)
{
    return murk_light_photons_max(&t->stage->scene->photons);
}

/* The number of records that end the part: its share of photons.store; 0 if the
 * number of photons is given. */
static uint64_t records_wanted(const tracing *t)
{
    const murk_scene_photons *settings = &t->stage->scene->photons;
    return settings->emit
               ? 0
               : (settings->store + t->shard.count - 1) / t->shard.count;
}

/* Number of batches of the next wave, 0 at the end of the part. With
 * photons.store one at first, then only as many as should give the records that
 * are missing. */
static size_t wave_batches(const tracing *t)
{
    const uint64_t own = murk_light_part_batches(photons_max(t), t->shard);
    const uint64_t wanted = records_wanted(t), stored = t->records.n;
    uint64_t n = own - t->batches;
    if (wanted > 0 && stored >= wanted) {
        n = 0;
    } else if (wanted > 0) {
        const double missing = (double)(wanted - stored);
        const double due = stored > 0
                               ? missing * (double)t->batches / (double)stored
                           : t->batches > 0 ? MURK_WAVE_BATCHES
                                            : 0;
        n = n < (uint64_t)due + 1 ? n : (uint64_t)due + 1;
    }
    return (size_t)(n < MURK_WAVE_BATCHES ? n : MURK_WAVE_BATCHES);
}

/* Appends the records of a wave of n batches. */
static murk_status append_wave(tracing *t, size_t n, murk_error *err)
{
    if (t->batches + n > t->capacity) {
        const uint64_t capacity = 2 * t->capacity + MURK_WAVE_BATCHES;
        uint32_t *count = realloc(t->count, capacity * sizeof *count);
        if (!count) {
            return murk_no_memory(err, "", "for the batches");
        }
        t->count = count;
        t->capacity = capacity;
    }
    /* The records of each batch, and their number. */
    for (size_t b = 0; b < n; ++b) {
        murk_record_list *buffer = &t->buffers->buffer[b];
        murk_status status = buffer->is_short_of_memory
                                 ? murk_no_memory(err, "", "for a batch")
                                 : MURK_OK;
        for (size_t i = 0; i < buffer->n && !status; ++i) {
            status = murk_record_list_put(&t->records, &buffer->photon[i], err);
        }
        if (status) {
            return status;
        }
        t->count[t->batches++] = (uint32_t)buffer->n;
        buffer->n = 0;
    }
    return MURK_OK;
}

static murk_status trace_wave(tracing *t, size_t n, murk_error *err)
{
    const murk_scene_photons *settings = &t->stage->scene->photons;
    uint64_t batch[MURK_WAVE_BATCHES];
    for (size_t b = 0; b < n; ++b) {
        batch[b] = t->shard.number - 1 + (t->batches + b) * t->shard.count;
    }
    /* Trace the batches, and sort their records by photon. */
    murk_trace trace = murk_stage_trace(t->stage);
    trace.last = photons_max(t);
    trace.batch = batch;
    trace.batches = n;
    trace.threads = t->threads;
    trace.tallies = t->tallies;
    murk_record_buffers_receive(t->buffers, &trace);
    murk_trace_run(&trace, t->ledger);
    murk_record_buffers_sort(t->buffers, t->threads);
    if (murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    /* Keep the records. */
    const murk_status status = append_wave(t, n, err);
    if (status) {
        return status;
    }
    /* With photons.store the last batch may have too many, which merging cuts
     * off. */
    return settings->store > 0 || t->records.n <= settings->max_stored
               ? MURK_OK
               : murk_fail(err, MURK_RUN_FAILED, settings->where,
                           "max_stored: more than %llu photons were stored",
                           (unsigned long long)settings->max_stored);
}

static murk_status write_part(const tracing *t, const char *path,
                              murk_error *err)
{
    murk_light_sums sums;
    murk_status status =
        murk_light_sums_read(&sums, t->ledger, t->tallies, false, MURK_OK, err);
    if (!status) {
        const murk_light_part_content content = {.shard = t->shard,
                                                 .batches = t->batches,
                                                 .count = t->count,
                                                 .record = t->records.photon,
                                                 .records = t->records.n,
                                                 .sums = &sums};
        status = murk_light_part_write(path, &content, t->stage, err);
    }
    murk_light_sums_release(&sums);
    return status;
}

murk_status murk_light_part_trace(const murk_stage *stage, murk_shard shard,
                                  unsigned threads, const char *path,
                                  murk_error *err)
{
    tracing t = {.stage = stage,
                 .shard = shard,
                 .threads = threads,
                 .records = {.memory_max = fmax(1, murk_block_memory_bytes())}};
    const murk_emission all = {.stage = stage,
                               .emit = stage->scene->photons.emit};
    /* Check before tracing, and allocate. */
    murk_status status = murk_emission_check(&all, err);
    if (!status) {
        status = murk_ending_check(stage, 0, err);
    }
    if (!status) {
        status = murk_ledger_create(&t.ledger, &stage->world, err);
    }
    if (!status) {
        status = murk_tallies_of_stage(&t.tallies, stage, threads,
                                       murk_machine_memory_bytes(), err);
    }
    if (!status) {
        t.buffers = murk_record_buffers_create(&stage->scene->photons);
        status = t.buffers ? MURK_OK
                           : murk_no_memory(err, stage->scene->photons.where,
                                            "to trace");
    }
    /* Trace waves of batches; nothing if no light source emits. */
    if (!status) {
        const uint64_t emit = stage->scene->photons.emit;
        murk_progress_begin("trace", emit / shard.count, "photons");
        const bool is_dark = murk_sources_lit(stage->lights) == 0;
        for (size_t n; !status && !is_dark && (n = wave_batches(&t)) > 0;) {
            status = trace_wave(&t, n, err);
        }
        murk_progress_end();
    }
    if (!status) {
        status = write_part(&t, path, err);
    }
    murk_record_buffers_destroy(t.buffers);
    murk_ledger_destroy(t.ledger);
    murk_tallies_destroy(t.tallies);
    murk_record_list_release(&t.records);
    free(t.count);
    return status;
}
