/* Evaluates receivers on re-weighted light: track-length estimates of fluence
 * rate and irradiance, averaged over the sphere (Spanier and Gelbard, Monte
 * Carlo Principles and Neutron Transport Problems, 1969), by batch, with slopes
 * by run. */
#include "base/interrupt.h"
#include "base/pool.h"
#include "calibrate/reweigh.h"

#include <assert.h>
#include <string.h>

/* Arguments of murk_receivers_read(). */
typedef struct job {
    const murk_row_sums *out;
    const murk_receiver *receiver;
    const murk_spectrum *per_watt;
    const murk_histories *histories;
    const murk_reweighed *reweighed;
    size_t first_run; /* of this rank */
} job;

/* The value of a contribution in the unit of its receiver, before
 * re-weighting. */
static double worth_of(const job *j, const murk_contribution *c)
{
    const murk_histories *f = j->histories;
    const size_t lights = f->channels / (size_t)f->bands;
    const double radius = j->receiver[c->receiver].radius_m;
    const double volume = 4. / 3 * MURK_PI * radius * radius * radius;
    return (double)c->value *
           f->packet_w[c->light * (size_t)f->bands + c->band] *
           j->per_watt[c->receiver * lights + c->light].band[c->band] / volume;
}

/* Sums the contributions of one run; batches belong to one run each. */
static void read_run(void *context, uint64_t number)
{
    const job *j = context;
    const size_t run = j->first_run + (size_t)number;
    const murk_row_sums *out = j->out;
    const murk_histories *f = j->histories;
    const size_t keys = j->reweighed->keys;
    const size_t last = murk_histories_first(f, out->runs, run + 1);
    for (size_t i = murk_histories_first(f, out->runs, run); i < last; ++i) {
        const murk_contribution *c = &f->contribution[i];
        if (murk_contribution_is_record(c)) {
            continue;
        }
        const double worth = worth_of(j, c);
        const size_t b =
            (size_t)(c->photon * (uint64_t)out->batches / f->emitted);
        out->batch[b * out->rows + c->receiver] +=
            worth * j->reweighed->ratio[i];
        double *slope = out->run + (run * out->rows + c->receiver) * keys;
        for (size_t k = 0; k < keys; ++k) {
            slope[k] += worth * j->reweighed->slope[k * f->n + i];
        }
    }
}

/* Completes the sums by batch and run, of which ranks have those of their
 * runs. */
static murk_status exchange(const murk_row_sums *out, size_t keys,
                            murk_status status, murk_error *err)
{
    const size_t each = out->batches / out->runs;
    status = murk_ranks_join(out->batch, out->runs,
                             each * out->rows * sizeof(double), status, err);
    return murk_ranks_join(out->run, out->runs,
                           out->rows * keys * sizeof(double), status, err);
}

murk_status murk_receivers_read(const murk_row_sums *out,
                                const murk_receiver *receiver,
                                const murk_spectrum *per_watt, size_t receivers,
                                const murk_histories *histories,
                                const murk_reweighed *reweighed,
                                unsigned threads, murk_error *err)
{
    const size_t keys = reweighed->keys, slopes = receivers * keys;
    const size_t first = murk_reweighed_first_run(reweighed, out->runs);
    const size_t end = murk_reweighed_end_run(reweighed, out->runs);
    job j = {out, receiver, per_watt, histories, reweighed, first};
    assert(out->batches % out->runs == 0);
    /* Clear the sums, then process the runs in parallel. */
    memset(out->value, 0, receivers * sizeof(double));
    memset(out->slope, 0, slopes * sizeof(double));
    for (size_t b = 0; b < out->batches; ++b) {
        memset(out->batch + b * out->rows, 0, receivers * sizeof(double));
    }
    for (size_t run = 0; run < out->runs; ++run) {
        memset(out->run + run * out->rows * keys, 0, slopes * sizeof(double));
    }
    murk_pool_run(threads, end - first, read_run, &j);
    murk_status status = murk_interrupt_check(err);
    if (reweighed->is_divided) {
        status = exchange(out, keys, status, err);
    }
    /* Totals. */
    for (size_t b = 0; b < out->batches; ++b) {
        for (size_t r = 0; r < receivers; ++r) {
            out->value[r] += out->batch[b * out->rows + r];
        }
    }
    for (size_t run = 0; run < out->runs; ++run) {
        for (size_t i = 0; i < slopes; ++i) {
            out->slope[i] += out->run[run * out->rows * keys + i];
        }
    }
    return status;
}
