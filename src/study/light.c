#include "study/light.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "study/ending.h"
#include "study/harvest.h"
#include "study/machine.h"
#include "study/tallies.h"

#include <stdlib.h>
#include <string.h>

#define PILOT_PHOTONS MURK_BATCH_PHOTONS
#define STORE_EMISSIONS                                  \
    UINT64_C(1000) /* emissions a stored photon, at most \
                    */
#define FIRST_RECORDS 256

static murk_trace trace_of(const murk_stage *stage, uint32_t stream,
                           unsigned threads, uint64_t first, uint64_t last)
{
    murk_trace trace = murk_stage_trace(stage);
    trace.stream = stream;
    trace.first = first;
    trace.last = last;
    trace.threads = threads;
    return trace;
}

/* ---- forecast ---- */

murk_status murk_light_forecast(murk_forecast *out, const murk_stage *stage,
                                uint32_t stream, unsigned threads,
                                murk_error *err)
{
    const murk_scene_photons *wish = &stage->scene->photons;
    const bool is_dark = murk_lights_lit(stage->lights) == 0;
    const uint64_t n = is_dark ? 0
                       : wish->emit && wish->emit < PILOT_PHOTONS
                           ? wish->emit
                           : PILOT_PHOTONS;
    murk_ledger *ledger = NULL;
    murk_harvest *h = NULL;
    murk_status status = murk_ending_check(stage, stream, err);
    if (status) {
        return status;
    }
    h = murk_harvest_create(wish);
    if (!h) {
        return murk_fail(err, MURK_NO_MEMORY, wish->where,
                         "no memory to trace");
    }
    status = murk_ledger_create(&ledger, &stage->world, err);
    if (status) {
        goto done;
    }
    murk_trace trace = trace_of(stage, stream, threads, 0, n);
    trace.sink = murk_harvest_event;
    trace.context = h;
    murk_progress_begin("pilot", n, "photons");
    murk_trace_run(&trace, ledger);
    murk_progress_end();
    if (murk_interrupted()) {
        status = murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
        goto done;
    }
    double surface = 0, volume = 0;
    for (size_t i = 0; i < h->pile[0].n; ++i) {
        if (murk_photon_is_volume(&h->pile[0].photon[i])) {
            ++volume;
        } else {
            ++surface;
        }
    }
    const double all = surface + volume;
    const double grow = is_dark      ? 0
                        : wish->emit ? (double)wish->emit / (double)n
                        : all > 0    ? (double)wish->store / all
                                     : 0;
    /* growing arrays hold up to 1.5 times what is in them, and twice that
     * while they move; the trees are built from what is left of it */
    const double records = all * grow;
    *out =
        (murk_forecast){.pilot_photons = n,
                        .surface = surface * grow,
                        .volume = volume * grow,
                        .emitted = wish->emit && !is_dark ? (double)wish->emit
                                                          : (double)n * grow,
                        .memory_bytes = 2.5 * sizeof(murk_photon) * records +
                                        murk_photon_map_memory_for(records) -
                                        sizeof(murk_photon) * records};
done:
    murk_harvest_destroy(h);
    murk_ledger_destroy(ledger);
    return status;
}

static murk_status check_forecast(const murk_forecast *forecast,
                                  const murk_scene_photons *wish,
                                  murk_error *err)
{
    const double records = forecast->surface + forecast->volume;
    if (records > (double)wish->max_stored) {
        return murk_fail(err, MURK_BAD_VALUE, wish->where,
                         "about %.3g photons would be stored (from a pilot of "
                         "%llu), max_stored allows %llu",
                         records, (unsigned long long)forecast->pilot_photons,
                         (unsigned long long)wish->max_stored);
    }
    const double have = murk_machine_memory_bytes();
    if (forecast->memory_bytes > have) {
        return murk_fail(err, MURK_BAD_VALUE, wish->where,
                         "about %.3g photons would be stored, which takes "
                         "%.3g GB; this machine has %.3g GB free",
                         records, forecast->memory_bytes / 1e9, have / 1e9);
    }
    return MURK_OK;
}

/* ---- tracing ---- */

/* A tracing under way. */
typedef struct job {
    const murk_stage *stage;
    const murk_scene_photons *wish;
    murk_harvest *harvest;
    murk_traced *traced;
    unsigned threads;
} job;

static uint64_t stored(const job *j)
{
    return j->harvest->surface.n + j->harvest->volume.n;
}

/* Photons that may be emitted at most. */
static uint64_t emissions_max(const murk_scene_photons *wish)
{
    return wish->emit ? wish->emit
           : wish->store < UINT32_MAX / STORE_EMISSIONS
               ? wish->store * STORE_EMISSIONS
               : UINT32_MAX;
}

/* The next wave: all that is left, or as many as should bring what is left to
 * store, in whole batches (but for the last). */
static uint64_t wave_photons(const job *j)
{
    const uint64_t done = j->traced->emitted;
    const uint64_t left = emissions_max(j->wish) - done;
    double batches = MURK_WAVE_BATCHES;
    if (j->wish->store && done == 0) {
        batches = 1;
    } else if (j->wish->store && stored(j) > 0) {
        const double wanted = (double)(j->wish->store - stored(j)) *
                              (double)done / (double)stored(j);
        batches = fmin(batches, floor(1.02 * wanted / MURK_BATCH_PHOTONS) + 1);
    }
    const uint64_t photons = (uint64_t)batches * MURK_BATCH_PHOTONS;
    return photons < left ? photons : left;
}

/* Takes photons [first, last) back from the ledger and the tallies. */
static void take_back(const job *j, uint64_t first, uint64_t last)
{
    murk_trace trace =
        trace_of(j->stage, j->traced->stream, j->threads, first, last);
    trace.tallies = j->traced->tallies;
    trace.takes_back = true;
    murk_trace_run(&trace, j->traced->ledger);
}

/* One wave. Sets *is_done when all are emitted, or `store` is reached: the
 * photon that reaches it is the last, and is kept whole. */
static murk_status trace_wave(job *j, bool *is_done, murk_error *err)
{
    const uint64_t first = j->traced->emitted;
    uint64_t end = first + wave_photons(j);
    murk_trace trace =
        trace_of(j->stage, j->traced->stream, j->threads, first, end);
    trace.tallies = j->traced->tallies;
    if (j->harvest->keeps_surface || j->harvest->keeps_volume) {
        trace.sink = murk_harvest_event;
        trace.context = j->harvest;
    }
    murk_trace_run(&trace, j->traced->ledger);

    uint64_t last = UINT64_MAX;
    if (j->wish->store && !murk_interrupted()) {
        last = murk_harvest_photon_of(j->harvest, j->wish->store - stored(j));
    }
    if (last != UINT64_MAX) {
        take_back(j, last + 1, end);
        end = last + 1;
    }
    if (murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    j->traced->emitted = end;
    *is_done = last != UINT64_MAX || end == j->wish->emit;
    return murk_harvest_gather(j->harvest, last, err);
}

static murk_status trace_all(job *j, murk_error *err)
{
    const murk_scene_photons *wish = j->wish;
    bool is_done = murk_lights_lit(j->stage->lights) == 0; /* all is dark */
    murk_status status = MURK_OK;
    while (!is_done && !status) {
        if (j->traced->emitted >= emissions_max(wish)) {
            return murk_fail(err, MURK_RUN_FAILED, wish->where,
                             "store: of %.6g photons emitted only %.6g of "
                             "%.6g are stored; more are not tried",
                             (double)j->traced->emitted, (double)stored(j),
                             (double)wish->store);
        }
        status = trace_wave(j, &is_done, err);
    }
    return status;
}

static murk_status price_packets(murk_traced *traced, const murk_stage *stage,
                                 murk_error *err)
{
    uint64_t *count = calloc(traced->channels, sizeof *count);
    if (!count) {
        return murk_fail(err, MURK_NO_MEMORY, stage->scene->path,
                         "no memory for the lights");
    }
    murk_lights_deal(stage->lights, traced->emitted, count);
    for (size_t c = 0; c < traced->channels; ++c) {
        traced->packet_w[c] =
            count[c] ? murk_lights_channel_power_w(stage->lights, c) /
                           (double)count[c]
                     : 0;
    }
    free(count);
    return MURK_OK;
}

static murk_status check_losses(const murk_traced *traced,
                                const murk_stage *stage, murk_error *err)
{
    double lost = 0;
    for (int i = 0; i < MURK_LOSSES; ++i) {
        lost += (double)murk_tally_read(&traced->ledger->lost_photons[i]);
    }
    const double share = lost > 0 ? lost / (double)traced->emitted : 0;
    if (share > MURK_LOST_SHARE_MAX) {
        return murk_fail(
            err, MURK_RUN_FAILED, stage->scene->path,
            "%.3g %% of the photons were lost (too many events: %lld, wraps: "
            "%lld, numerical: %lld), at most %g %% may be",
            100 * share,
            (long long)murk_tally_read(
                &traced->ledger->lost_photons[MURK_LOSS_EVENTS]),
            (long long)murk_tally_read(
                &traced->ledger->lost_photons[MURK_LOSS_WRAPS]),
            (long long)murk_tally_read(
                &traced->ledger->lost_photons[MURK_LOSS_NUMERICAL]),
            100 * MURK_LOST_SHARE_MAX);
    }
    return MURK_OK;
}

/* Hands the pile's records over to a new map. */
static murk_status build_map(murk_photon_map **out, murk_pile *pile,
                             unsigned threads, murk_error *err)
{
    murk_photon *photons = pile->photon;
    const size_t n = pile->n;
    if (n == 0) {
        free(photons);
        photons = NULL;
    } else if (n < pile->room) {
        murk_photon *fitted = realloc(photons, n * sizeof *fitted);
        if (fitted) {
            photons = fitted;
        }
    }
    *pile = (murk_pile){0};
    return murk_photon_map_create(out, photons, n, threads, err);
}

static murk_status check_emission(const murk_stage *stage, murk_error *err)
{
    const murk_scene_photons *wish = &stage->scene->photons;
    const size_t channels = murk_lights_lit(stage->lights);
    if (wish->emit && wish->emit < channels) {
        return murk_fail(err, MURK_BAD_VALUE, wish->where,
                         "emit: %llu, must be at least %zu: one photon for "
                         "each light and band",
                         (unsigned long long)wish->emit, channels);
    }
    return MURK_OK;
}

static murk_status finish(job *j, murk_error *err)
{
    murk_traced *traced = j->traced;
    murk_status status = check_losses(traced, j->stage, err);
    if (!status) {
        status = price_packets(traced, j->stage, err);
    }
    if (status) {
        return status;
    }
    const double begun_s = murk_clock_s();
    murk_harvest_price(j->harvest, traced->packet_w, j->stage->scene->bands);
    status = build_map(&traced->surface, &j->harvest->surface, j->threads, err);
    if (!status) {
        status =
            build_map(&traced->volume, &j->harvest->volume, j->threads, err);
    }
    traced->map_s = murk_clock_s() - begun_s;
    return status;
}

murk_status murk_light_trace(murk_traced **out, const murk_stage *stage,
                             uint32_t stream, unsigned threads, murk_error *err)
{
    const murk_scene_photons *wish = &stage->scene->photons;
    murk_forecast forecast = {.emitted = (double)wish->emit};
    murk_status status = check_emission(stage, err);
    if (!status && wish->maps == MURK_SCENE_MAPS_NONE) {
        status = murk_ending_check(stage, stream, err);
    } else if (!status) {
        status = murk_light_forecast(&forecast, stage, stream, threads, err);
        if (!status) {
            status = check_forecast(&forecast, wish, err);
        }
    }
    if (status) {
        return status;
    }
    job j = {.stage = stage, .wish = wish, .threads = threads};
    j.traced = murk_traced_create(stage, stream, err);
    j.harvest = murk_harvest_create(wish);
    if (!j.traced || !j.harvest) {
        status =
            murk_fail(err, MURK_NO_MEMORY, wish->where, "no memory to trace");
        goto done;
    }
    if (stream == 0) {
        status = murk_tallies_of_stage(
            &j.traced->tallies, stage, threads,
            murk_machine_memory_bytes() - forecast.memory_bytes, err);
    }
    if (status) {
        goto done;
    }
    const double begun_s = murk_clock_s();
    murk_progress_begin("trace", (uint64_t)forecast.emitted, "photons");
    status = trace_all(&j, err);
    murk_progress_end();
    j.traced->trace_s = murk_clock_s() - begun_s;
    if (!status) {
        status = finish(&j, err);
    }
    if (!status) {
        *out = j.traced;
        j.traced = NULL;
    }
done:
    murk_harvest_destroy(j.harvest);
    murk_traced_destroy(j.traced);
    return status;
}

murk_traced *murk_traced_create(const murk_stage *stage, uint32_t stream,
                                murk_error *err)
{
    murk_traced *traced = calloc(1, sizeof *traced);
    if (traced) {
        traced->seed = stage->scene->seed;
        traced->stream = stream;
        traced->channels = murk_lights_channels(stage->lights);
        traced->packet_w = calloc(traced->channels, sizeof *traced->packet_w);
    }
    if (!traced || !traced->packet_w ||
        murk_ledger_create(&traced->ledger, &stage->world, err)) {
        murk_fail(err, MURK_NO_MEMORY, stage->scene->path,
                  "no memory to trace");
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
        free(traced->packet_w);
        free(traced);
    }
}
