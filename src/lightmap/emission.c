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
#include "lightmap/checkpoint.h"
#include "lightmap/rank_exchange.h"

#include <math.h>
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

/* True if the ranks divide the batches of each wave: those whose events can be
 * exchanged. */
static bool is_divided(const murk_emission *e)
{
    return murk_ranks_count() > 1 &&
           (e->sink ? e->exchange != NULL : e->buffers != NULL);
}

size_t murk_emission_wave_batches(void)
{
    const size_t batches = (size_t)MURK_WAVE_BATCHES * murk_ranks_count();
    return batches < MURK_WAVE_BATCHES_MAX ? batches : MURK_WAVE_BATCHES_MAX;
}

/* Number of photons of the next wave: MURK_WAVE_BATCHES batches for each rank
 * that divides the wave, but never more than the remaining photons.
 * With `store`, a wave has only the batches that should produce the missing
 * records plus 2 %. The first wave is one batch with `store`, because the
 * number of records for each photon is not yet known, and if is_first_small is
 * set. */
static uint64_t wave_photons(const murk_emission *e)
{
    const uint64_t done = e->emitted;
    const uint64_t left = photons_max(e) - done;
    double batches = is_divided(e) ? (double)murk_emission_wave_batches()
                                   : MURK_WAVE_BATCHES;
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

/* Sorts the records of each batch by photon, if the trace gave them in any
 * order. */
static void sort_records(const murk_emission *e, const murk_trace *trace)
{
    if (trace->takes_any_order) {
        murk_record_buffers_sort(e->buffers, trace->threads);
    }
}

/* Fills the record buffers of a wave: takes batches from parts, traces those of
 * the others that are dealt to this rank, and receives the rest from the other
 * ranks. Buffer b of the wave has the records of batch first + b. *is_due
 * becomes that of rank 0. */
static murk_status fill_wave(const murk_emission *e, murk_trace *trace,
                             bool *is_due, murk_error *err)
{
    const uint64_t first = trace->first / MURK_BATCH_PHOTONS;
    const uint64_t end =
        (trace->last + MURK_BATCH_PHOTONS - 1) / MURK_BATCH_PHOTONS;
    size_t missing[MURK_WAVE_BATCHES_MAX] = {0};
    uint64_t own[MURK_WAVE_BATCHES_MAX] = {0};
    size_t n = 0;
    for (uint64_t b = first; b < end; ++b) {
        if (!e->parts || !murk_light_parts_batch(e->parts, b, NULL, NULL)) {
            missing[n++] = (size_t)(b - first);
        }
    }
    /* Trace this rank's share of the missing batches. */
    const size_t share = (size_t)murk_ranks_share(n);
    for (size_t k = 0; k < share; ++k) {
        own[k] = first + missing[murk_ranks_item(k)];
    }
    trace->batch = own;
    trace->batches = share;
    murk_trace_run(trace, e->ledger);
    murk_status status = murk_interrupt_check(err);
    if (e->buffers) {
        /* Own batch k lies in buffer k, which is at or before its own place. */
        for (size_t k = share; k-- > 0;) {
            murk_record_buffers_swap(e->buffers, k, (size_t)(own[k] - first));
        }
        sort_records(e, trace);
        status = murk_ranks_exchange_records(e->buffers, missing, n, is_due,
                                             status, err);
    }
    if (e->exchange) {
        status = e->exchange(e->gather_context, missing, n, status, err);
    }
    murk_progress_add((n - share) * MURK_BATCH_PHOTONS);
    /* The batches of parts. */
    for (uint64_t b = first; b < end && !status; ++b) {
        const murk_photon *records;
        size_t count;
        if (e->parts && murk_light_parts_batch(e->parts, b, &records, &count)) {
            murk_record_buffers_fill(e->buffers, (size_t)(b - first), records,
                                     count);
        }
    }
    return status;
}

/* Removes the batches of parts behind the last wave. */
static murk_status take_back_parts(const murk_emission *e, murk_error *err)
{
    if (is_divided(e) && murk_ranks_number() > 0) {
        return MURK_OK; /* rank 0 has the sums of the parts */
    }
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

/* Writes a checkpoint behind a wave, unless the parts have later batches, whose
 * sums are in ledger and tallies already. */
static murk_status write_checkpoint(const murk_emission *e, murk_status status,
                                    murk_error *err)
{
    const uint64_t batches = e->emitted / MURK_BATCH_PHOTONS;
    murk_light_sums sums;
    if (e->parts && murk_light_parts_end(e->parts) > batches) {
        return status;
    }
    status = murk_light_sums_read(&sums, e->ledger, e->tallies, is_divided(e),
                                  status, err);
    if (!status && murk_ranks_number() == 0) {
        murk_checkpoint_write(e->checkpoint, e->stage, e->buffers, &sums,
                              batches);
    }
    murk_light_sums_release(&sums);
    return status;
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
        trace.takes_any_order = e->takes_any_order;
    } else {
        murk_record_buffers_receive(e->buffers, &trace);
    }
    bool is_due = murk_checkpoint_is_due(e->checkpoint);
    if (is_divided(e) || e->parts) {
        const murk_status status = fill_wave(e, &trace, &is_due, err);
        if (status) {
            return status;
        }
    } else {
        murk_trace_run(&trace, e->ledger);
        sort_records(e, &trace);
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
    murk_status status =
        e->gather ? e->gather(e->gather_context, end - 1, err)
                  : murk_record_buffers_gather(e->buffers, end - 1, err);
    if (e->sink && is_divided(e)) {
        status = murk_ranks_share_failure(status, err); /* a fit may go on */
    }
    if (e->checkpoint && is_due && !*is_done) {
        status = write_checkpoint(e, status, err);
    }
    return status;
}

murk_status murk_emission_check(const murk_emission *e, murk_error *err)
{
    const size_t channels = murk_sources_dealt(e->stage->lights);
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
    const char *key = e->stage->light_key;
    murk_status status =
        is_divided(e) ? murk_ranks_check_same("scene, or another file of it,",
                                              key, strlen(key), MURK_OK, err)
                      : MURK_OK;
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
    if (!status) {
        status = take_back_parts(e, err);
    }
    if (status && e->sink) {
        return status; /* all ranks have failed, and a fit may go on */
    }
    return is_divided(e)
               ? murk_ranks_add_sums(e->ledger, e->tallies, status, err)
               : status;
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
