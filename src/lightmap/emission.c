/* Traces photons in waves of up to MURK_WAVE_BATCHES batches. The waves exist
 * for two reasons: the number of stored records is known only after tracing,
 * and the record buffers of one wave are emptied in the order of batches, so
 * that the order of records does not depend on threads.
 *
 * With `store`, the photon whose record reaches the number becomes the last
 * photon, and the photons after it are traced once more with negative sign,
 * which removes them from the ledger and the tallies. Both are sums of
 * integers, so the removal is exact. */
#include "lightmap/emission.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "base/ranks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const murk_scene_photons *settings_of(const murk_emission *e)
{
    return &e->stage->scene->photons;
}

/* Records to store in all; 0 if the number of photons is given. */
static uint64_t wanted(const murk_emission *e)
{
    return e->emit ? 0 : settings_of(e)->store;
}

static uint64_t stored(const murk_emission *e)
{
    return e->buffers->stored;
}

static murk_trace trace_of(const murk_emission *e, uint64_t first,
                           uint64_t last)
{
    murk_trace trace = murk_stage_trace(e->stage);
    trace.stream = e->stream;
    trace.first = first;
    trace.last = last;
    trace.threads = e->threads;
    trace.tallies = e->tallies;
    return trace;
}

/* Upper limit of the number of photons. */
static uint64_t photons_max(const murk_emission *e)
{
    return e->emit ? e->emit : murk_light_photons_max(settings_of(e));
}

/* Number of photons of the next wave: MURK_WAVE_BATCHES batches, but never more
 * than the remaining photons. With `store`, a wave has only the batches that
 * should produce the missing records plus 2 %. The first wave is one batch with
 * `store`, because the number of records for each photon is not yet known, and
 * if is_first_small is set. */
static uint64_t wave_photons(const murk_emission *e)
{
    const uint64_t done = e->emitted;
    const uint64_t left = photons_max(e) - done;
    double batches = MURK_WAVE_BATCHES;
    if (done == 0 && (wanted(e) || e->is_first_small)) {
        batches = 1;
    } else if (wanted(e) && stored(e) > 0) {
        const double more =
            (double)(wanted(e) - stored(e)) * (double)done / (double)stored(e);
        batches = fmin(batches, floor(1.02 * more / MURK_BATCH_PHOTONS) + 1);
    }
    const uint64_t photons = (uint64_t)batches * MURK_BATCH_PHOTONS;
    return photons < left ? photons : left;
}

/* Removes the contributions of photons [first, last) from the ledger and the
 * tallies. */
static void take_back(const murk_emission *e, uint64_t first, uint64_t last)
{
    murk_trace trace = trace_of(e, first, last);
    trace.takes_back = true;
    murk_trace_run(&trace, e->ledger);
}

/* The number of the first batch of a wave, and the number behind the last. */
static uint64_t first_batch(const murk_trace *wave)
{
    return wave->first / MURK_BATCH_PHOTONS;
}

static uint64_t end_batch(const murk_trace *wave)
{
    return (wave->last + MURK_BATCH_PHOTONS - 1) / MURK_BATCH_PHOTONS;
}

/* Takes the batches of a wave from parts, and traces the others. Buffer b of
 * the wave has the records of batch first + b. */
static void trace_missing(const murk_emission *e, murk_trace *trace)
{
    const uint64_t first = first_batch(trace), end = end_batch(trace);
    uint64_t missing[MURK_WAVE_BATCHES] = {0};
    size_t n = 0;
    for (uint64_t b = first; b < end; ++b) {
        if (!murk_light_parts_batch(e->parts, b, NULL, NULL)) {
            missing[n++] = b;
        }
    }
    trace->batch = missing;
    trace->batches = n;
    murk_trace_run(trace, e->ledger);
    /* Missing batch k lies in buffer k, which is at or before its own place. */
    for (size_t k = n; k-- > 0;) {
        murk_record_buffers_swap(e->buffers, k, (size_t)(missing[k] - first));
    }
    for (uint64_t b = first; b < end; ++b) {
        const murk_photon *records;
        size_t count;
        if (murk_light_parts_batch(e->parts, b, &records, &count)) {
            murk_record_buffers_fill(e->buffers, (size_t)(b - first), records,
                                     count);
        }
    }
}

/* True if the ranks divide the batches of each wave. Records alone can be
 * exchanged, so emissions with sinks of their own are traced by every rank. */
static bool is_divided(const murk_emission *e)
{
    return murk_ranks_count() > 1 && e->buffers && !e->sink && !e->parts;
}

/* Packs the records of the batches first, first + step, ... of this wave: the
 * number of records of each batch, then the records. *bytes: for free(). */
static murk_status pack_batches(char **bytes, size_t *size,
                                const murk_record_buffers *buffers,
                                size_t first, size_t step, size_t batches,
                                murk_error *err)
{
    uint64_t count[MURK_WAVE_BATCHES];
    size_t n = 0, records = 0;
    /* The numbers of records. */
    for (size_t b = first; b < batches; b += step) {
        if (buffers->buffer[b].is_short_of_memory) {
            return murk_no_memory(err, buffers->settings->where,
                                  "for the records of a wave");
        }
        count[n++] = buffers->buffer[b].n;
        records += buffers->buffer[b].n;
    }
    *size = n * sizeof *count + records * sizeof(murk_photon);
    char *at = *bytes = malloc(*size + 1);
    if (!at) {
        return murk_no_memory(err, buffers->settings->where,
                              "for the records of a wave");
    }
    memcpy(at, count, n * sizeof *count);
    at += n * sizeof *count;
    /* The records. */
    for (size_t b = first; b < batches; b += step) {
        const murk_record_list *list = &buffers->buffer[b];
        if (list->n) {
            memcpy(at, list->photon, list->n * sizeof *list->photon);
        }
        at += list->n * sizeof *list->photon;
    }
    return MURK_OK;
}

/* Fills the same batches with packed records. */
static void unpack_batches(murk_record_buffers *buffers, const char *bytes,
                           size_t first, size_t step, size_t batches)
{
    const char *counts = bytes, *at = bytes;
    for (size_t b = first; b < batches; b += step) {
        at += sizeof(uint64_t);
    }
    for (size_t b = first; b < batches; b += step) {
        uint64_t n;
        memcpy(&n, counts, sizeof n);
        counts += sizeof n;
        murk_record_buffers_fill(buffers, b, (const void *)at, n);
        at += n * sizeof(murk_photon);
    }
}

/* Traces every count-th batch of a wave, and exchanges the records with the
 * other ranks. */
static murk_status trace_share(const murk_emission *e, murk_trace *trace,
                               murk_error *err)
{
    const size_t number = murk_ranks_number(), count = murk_ranks_count();
    const uint64_t first = first_batch(trace), end = end_batch(trace);
    const size_t batches = (size_t)(end - first);
    uint64_t own[MURK_WAVE_BATCHES] = {0};
    size_t n = 0, size = 0;
    char *bytes = NULL;
    murk_gathered all = {NULL};
    for (uint64_t b = first + number; b < end; b += count) {
        own[n++] = b;
    }
    trace->batch = own;
    trace->batches = n;
    murk_trace_run(trace, e->ledger);
    /* Own batch k lies in buffer k, which is at or before its own place. */
    for (size_t k = n; k-- > 0;) {
        murk_record_buffers_swap(e->buffers, k, (size_t)(own[k] - first));
    }
    if (trace->takes_any_order) {
        murk_record_buffers_sort(e->buffers, trace->threads);
    }
    /* Exchange. */
    murk_status status = murk_interrupt_check(err);
    if (!status) {
        status = pack_batches(&bytes, &size, e->buffers, number, count, batches,
                              err);
    }
    status = murk_ranks_gather(&all, bytes, size, status, err);
    for (size_t r = 0; r < count && !status; ++r) {
        if (r != number) {
            unpack_batches(e->buffers, all.bytes + all.begin[r], r, count,
                           batches);
        }
    }
    murk_gathered_release(&all);
    free(bytes);
    return status;
}

/* Adds what the photons of the other ranks left in ledger and tallies: the sum
 * over all ranks without that of this rank. */
static murk_status add_ranks(const murk_emission *e, murk_error *err)
{
    const size_t cells = murk_ledger_cells(e->ledger);
    const size_t words = e->tallies ? murk_tallies_words(e->tallies) : 0;
    int64_t *own = calloc(2 * cells + 1, sizeof *own);
    uint64_t *sums = calloc(2 * words + 1, sizeof *sums);
    murk_status status = own && sums
                             ? MURK_OK
                             : murk_no_memory(err, e->stage->scene->path,
                                              "to add the sums of all ranks");
    /* Add copies of the sums. */
    if (!status) {
        murk_ledger_read(e->ledger, own);
        memcpy(own + cells, own, cells * sizeof *own);
    }
    if (!status && words) {
        murk_tallies_read_sums(e->tallies, sums);
        memcpy(sums + words, sums, words * sizeof *sums);
    }
    status = murk_ranks_sum((uint64_t *)own + cells, cells, false, status, err);
    status = murk_ranks_sum(sums + words, words, true, status, err);
    /* Add the differences, of numbers of 128 bits with a borrow. */
    if (!status) {
        for (size_t i = 0; i < cells; ++i) {
            own[i] = own[cells + i] - own[i];
        }
        murk_ledger_add(e->ledger, own);
    }
    if (!status && words) {
        for (size_t i = 0; i < words; i += 2) {
            const bool borrows = sums[words + i] < sums[i];
            sums[i] = sums[words + i] - sums[i];
            sums[i + 1] = sums[words + i + 1] - sums[i + 1] - borrows;
        }
        murk_tallies_add_sums(e->tallies, sums);
    }
    free(own);
    free(sums);
    return status;
}

/* Removes the batches of parts behind the last wave. */
static murk_status take_back_parts(const murk_emission *e, murk_error *err)
{
    uint64_t b = (e->reached + MURK_BATCH_PHOTONS - 1) / MURK_BATCH_PHOTONS;
    const uint64_t end = e->parts ? murk_light_parts_end(e->parts) : 0;
    while (b < end && !murk_interrupted()) {
        uint64_t batch[MURK_WAVE_BATCHES];
        size_t n = 0;
        for (; b < end && n < MURK_WAVE_BATCHES; ++b) {
            if (murk_light_parts_batch(e->parts, b, NULL, NULL)) {
                batch[n++] = b;
            }
        }
        murk_trace trace = trace_of(e, 0, photons_max(e));
        trace.batch = batch;
        trace.batches = n;
        trace.takes_back = true;
        murk_trace_run(&trace, e->ledger);
    }
    return murk_interrupt_check(err);
}

/* Traces one wave. Sets *is_done to whether all photons are emitted or `store`
 * is reached. */
static murk_status send_wave(murk_emission *e, bool *is_done, murk_error *err)
{
    const uint64_t first = e->emitted;
    uint64_t end = first + wave_photons(e);
    /* Trace, with the sinks of the emission. */
    murk_trace trace = trace_of(e, first, end);
    if (e->sink) {
        trace.sink = e->sink;
        trace.segment_sink = e->segment_sink;
        trace.context = e->context;
    } else {
        murk_record_buffers_receive(e->buffers, &trace);
    }
    if (is_divided(e)) {
        const murk_status status = trace_share(e, &trace, err);
        if (status) {
            return status;
        }
    } else if (e->parts) {
        trace_missing(e, &trace);
    } else {
        murk_trace_run(&trace, e->ledger);
    }
    if (trace.takes_any_order) {
        murk_record_buffers_sort(e->buffers, trace.threads);
    }
    /* Find the photon that reaches `store`, and remove those after it. */
    uint64_t last = UINT64_MAX;
    e->reached = end;
    if (wanted(e) && !murk_interrupted()) {
        last = murk_record_buffers_photon_of(e->buffers, wanted(e) - stored(e));
    }
    if (last != UINT64_MAX) {
        if (!is_divided(e) || murk_ranks_number() == 0) {
            take_back(e, last + 1, end); /* once, as ranks are added */
        }
        end = last + 1;
    }
    /* Count the photons, and keep the records. */
    if (murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    e->emitted = end;
    *is_done = last != UINT64_MAX || end == e->emit;
    return e->gather ? e->gather(e->gather_context, end - 1, err)
                     : murk_record_buffers_gather(e->buffers, end - 1, err);
}

murk_status murk_emission_check(const murk_emission *e, murk_error *err)
{
    const size_t channels = murk_sources_lit(e->stage->lights);
    if (e->emit && e->emit < channels) {
        return murk_fail(err, MURK_BAD_VALUE, settings_of(e)->where,
                         "emit: %llu, must be at least %zu: one photon for "
                         "each light and band",
                         (unsigned long long)e->emit, channels);
    }
    return MURK_OK;
}

murk_status murk_emission_run(murk_emission *e, murk_error *err)
{
    bool is_done = murk_sources_lit(e->stage->lights) == 0;
    murk_status status = MURK_OK;
    while (!is_done && !status) {
        if (e->emitted >= photons_max(e)) {
            return murk_fail(err, MURK_RUN_FAILED, settings_of(e)->where,
                             "store: of %.6g photons emitted only %.6g of "
                             "%.6g are stored; more are not tried",
                             (double)e->emitted, (double)stored(e),
                             (double)wanted(e));
        }
        status = send_wave(e, &is_done, err);
    }
    if (!status && is_divided(e)) {
        status = add_ranks(e, err);
    }
    return status ? status : take_back_parts(e, err);
}

murk_status murk_emission_check_losses(const murk_emission *e, murk_error *err)
{
    /* Sum the lost photons over the causes. */
    murk_tally *const lost_photons = e->ledger->lost_photons;
    double lost = 0;
    for (int i = 0; i < MURK_LOSSES; ++i) {
        lost += (double)murk_tally_read(&lost_photons[i]);
    }
    const double share = lost > 0 ? lost / (double)e->emitted : 0;
    if (share > MURK_LOST_SHARE_MAX) {
        return murk_fail(
            err, MURK_RUN_FAILED, e->stage->scene->path,
            "%.3g %% of the photons were lost (too many events: %lld, wraps: "
            "%lld, numerical: %lld), at most %g %% may be",
            100 * share,
            (long long)murk_tally_read(&lost_photons[MURK_LOSS_EVENTS]),
            (long long)murk_tally_read(&lost_photons[MURK_LOSS_WRAPS]),
            (long long)murk_tally_read(&lost_photons[MURK_LOSS_NUMERICAL]),
            100 * MURK_LOST_SHARE_MAX);
    }
    return MURK_OK;
}

void murk_emission_packet_powers(const murk_emission *e, uint64_t *emitted_in,
                                 double *packet_w)
{
    const murk_sources *lights = e->stage->lights;
    murk_sources_deal(lights, e->emitted, emitted_in);
    for (size_t c = 0; c < murk_sources_channels(lights); ++c) {
        packet_w[c] = emitted_in[c] ? murk_sources_channel_power_w(lights, c) /
                                          (double)emitted_in[c]
                                    : 0;
    }
}
