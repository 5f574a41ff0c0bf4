/* Traces photons with a recorder (calibrate/recorder.h) as event sink, checks
 * after each wave of photons that the memory will suffice, and collects the
 * contributions and photon maps. */
#include "calibrate/histories.h"

#include "base/machine.h"
#include "base/progress.h"
#include "calibrate/history_exchange.h"
#include "lightmap/emission.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

typedef struct job {
    const murk_histories_desc *desc;
    murk_emission emission;
    murk_recorder *recorder;
    double max_bytes;
} job;

static const char *where_of(const murk_histories_desc *desc)
{
    return desc->stage->scene->photons.where;
}

/* Memory of `grow` times the present contributions and records, including the
 * growth of arrays and the photon maps. */
static double bytes_at(const job *j, double grow)
{
    const murk_histories *all = j->recorder->all;
    const murk_record_buffers *buffers = j->recorder->buffers;
    const double records =
        buffers ? grow * (double)(buffers->surface.n + buffers->volume.n) : 0;
    return MURK_WHILE_GROWING *
               (murk_histories_bytes(j->desc->media, grow * (double)all->n,
                                     grow * (double)all->turns) +
                sizeof(murk_photon) * records) +
           murk_photon_map_memory_for(records) - sizeof(murk_photon) * records;
}

/* After a wave: stores the contributions, and fails if the forecast for all
 * photons exceeds the memory. */
static murk_status gather(void *context, uint64_t last, murk_error *err)
{
    const job *j = context;
    const murk_status status = murk_recorder_gather(j->recorder, last, err);
    if (status) {
        return status;
    }
    const murk_emission *e = &j->emission;
    const murk_scene_photons *settings = &j->desc->stage->scene->photons;
    /* The ratio of all photons to those traced so far. */
    const murk_record_buffers *buffers = j->recorder->buffers;
    const double stored =
        buffers ? (double)(buffers->surface.n + buffers->volume.n) : 0;
    const double grow = e->emit      ? (double)e->emit / (double)e->emitted
                        : stored > 0 ? (double)settings->store / stored
                                     : 1;
    /* Forecast. */
    const double bytes = bytes_at(j, grow > 1 ? grow : 1);
    if (!(bytes <= j->max_bytes)) {
        return murk_fail(err, MURK_BAD_VALUE, where_of(j->desc),
                         "about %.3g contributions of light would be kept "
                         "(from %llu photons), which takes %.3g GB, must be "
                         "at most %.3g GB: fewer photons, receivers or "
                         "records",
                         grow * (double)j->recorder->all->n,
                         (unsigned long long)e->emitted, bytes / 1e9,
                         j->max_bytes / 1e9);
    }
    return MURK_OK;
}

/* Exchanges the histories of a wave between ranks. */
static murk_status exchange(void *context, const size_t *place, size_t n,
                            murk_status status, murk_error *err)
{
    const job *j = context;
    return murk_recorder_exchange(j->recorder, place, n, status, err);
}

static murk_histories *create(const murk_histories_desc *desc)
{
    murk_histories *f = calloc(1, sizeof *f);
    if (f) {
        f->channels = murk_sources_channels(desc->stage->lights);
        f->bands = desc->stage->world.bands;
        f->media = desc->media;
        f->receivers = desc->receivers;
        f->medium = calloc(desc->media + 1, sizeof *f->medium);
        f->emitted_in = calloc(f->channels, sizeof *f->emitted_in);
        f->packet_w = calloc(f->channels, sizeof *f->packet_w);
    }
    if (!f || !f->medium || !f->emitted_in || !f->packet_w) {
        murk_histories_destroy(f);
        return NULL;
    }
    for (size_t m = 0; m < desc->media; ++m) {
        f->medium[m] = desc->medium[m];
    }
    return f;
}

/* Builds the photon maps. */
static murk_status make_maps(murk_histories *f, const job *j, murk_error *err)
{
    murk_record_buffers *buffers = j->recorder->buffers;
    murk_record_buffers_to_watts(buffers, f->packet_w,
                                 j->desc->stage->scene->bands);
    const murk_status status = murk_record_list_map(
        &f->surface, &buffers->surface, j->desc->threads, err);
    return status ? status
                  : murk_record_list_map(&f->volume, &buffers->volume,
                                         j->desc->threads, err);
}

/* Checks the losses and completes the result, which has all contributions
 * already: powers of packets, exact sizes of arrays, photon maps. */
static murk_status finish(murk_histories *f, const job *j, murk_error *err)
{
    const murk_status status = murk_emission_check_losses(&j->emission, err);
    if (status) {
        return status;
    }
    f->emitted = j->emission.emitted;
    murk_emission_packet_powers(&j->emission, f->emitted_in, f->packet_w);
    murk_histories_fit(f);
    return j->desc->keeps_records ? make_maps(f, j, err) : MURK_OK;
}

/* Fails if nothing can be traced. */
static murk_status check(const murk_histories_desc *desc, uint64_t emit,
                         murk_error *err)
{
    if (murk_sources_lit(desc->stage->lights) == 0) {
        return murk_fail(err, MURK_BAD_VALUE, desc->stage->scene->path,
                         "all lights are dark, must be light to be followed");
    }
    if (emit > UINT32_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, where_of(desc),
                         "emit: %llu photons, must be at most %lu to be "
                         "followed",
                         (unsigned long long)emit, (unsigned long)UINT32_MAX);
    }
    return murk_ending_check(desc->stage, 0, err);
}

/* Creates record buffers if records are stored, or if their number ends the
 * run. */
static murk_status make_buffers(murk_record_buffers **out,
                                const murk_histories_desc *desc, uint64_t emit,
                                murk_error *err)
{
    if (!desc->keeps_records && emit) {
        *out = NULL;
        return MURK_OK;
    }
    *out = murk_record_buffers_create(&desc->stage->scene->photons);
    return *out ? MURK_OK : murk_no_memory(err, where_of(desc), "to trace");
}

murk_status murk_histories_trace(murk_histories **out,
                                 const murk_histories_desc *desc,
                                 murk_error *err)
{
    assert(out && desc && desc->stage && desc->threads >= 1);
    const murk_scene_photons *settings = &desc->stage->scene->photons;
    const uint64_t emit = desc->photons ? desc->photons : settings->emit;
    murk_ledger *ledger = NULL;
    murk_record_buffers *buffers = NULL;
    murk_histories *histories = NULL;
    /* Check, and create result, recorder and ledger. */
    job j = {.desc = desc,
             .max_bytes = desc->memory_max_bytes > 0
                              ? desc->memory_max_bytes
                              : murk_machine_memory_bytes()};
    murk_status status = check(desc, emit, err);
    status = status ? status : make_buffers(&buffers, desc, emit, err);
    if (!status) {
        histories = create(desc);
        status = histories ? MURK_OK
                           : murk_no_memory(err, where_of(desc), "to trace");
    }
    if (status ||
        (status = murk_recorder_create(&j.recorder, desc, histories, buffers,
                                       err)) ||
        (status = murk_ledger_create(&ledger, &desc->stage->world, err))) {
        goto done;
    }
    j.emission = (murk_emission){.stage = desc->stage,
                                 .threads = desc->threads,
                                 .emit = emit,
                                 .is_first_small = true,
                                 .buffers = buffers,
                                 .ledger = ledger,
                                 .sink = murk_recorder_event,
                                 .segment_sink = murk_recorder_segment,
                                 .context = j.recorder,
                                 .gather = gather,
                                 .exchange = exchange,
                                 .gather_context = &j};
    status = murk_emission_check(&j.emission, err);
    if (status) {
        goto done;
    }
    /* Trace. */
    const double begun_s = murk_clock_s();
    murk_progress_begin("trace", emit, "photons");
    status = murk_emission_run(&j.emission, err);
    murk_progress_end();
    histories->trace_s = murk_clock_s() - begun_s;
    status = status ? status : finish(histories, &j, err);
    if (!status) {
        *out = histories;
        histories = NULL;
    }
done:
    murk_recorder_destroy(j.recorder);
    murk_histories_destroy(histories);
    murk_record_buffers_destroy(buffers);
    murk_ledger_destroy(ledger);
    return status;
}
