/* Evaluates receivers on re-weighted light: track-length estimates of fluence
 * rate and irradiance, averaged over the sphere (Spanier and Gelbard, Monte
 * Carlo Principles and Neutron Transport Problems, 1969), by batch, with slopes
 * by run. */
#include "base/pool.h"
#include "calibrate/reweigh.h"

#include <assert.h>
#include <string.h>

/* Arguments of murk_receivers_read(). */
typedef struct job {
    double *batch, *slope_batch; /* as murk_receivers_read() says */
    size_t batches, runs, receivers;
    const murk_receiver *receiver;
    const murk_spectrum *per_watt;
    const murk_followed *followed;
    const murk_reweighed *reweighed;
} job;

/* The first contribution of a run; contributions are sorted by photon. */
static size_t first_of_run(const job *j, uint64_t run)
{
    const murk_followed *f = j->followed;
    size_t low = 0, high = f->n;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        const uint64_t photon = f->contribution[middle].photon;
        if (photon * j->runs / f->emitted < run) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

/* The value of a contribution with ratio 1. */
static double worth_of(const job *j, const murk_contribution *c)
{
    const murk_followed *f = j->followed;
    const size_t lights = f->channels / (size_t)f->bands;
    const double radius = j->receiver[c->receiver].radius_m;
    const double volume = 4. / 3 * MURK_PI * radius * radius * radius;
    return (double)c->value *
           f->packet_w[c->light * (size_t)f->bands + c->band] *
           j->per_watt[c->receiver * lights + c->light].band[c->band] / volume;
}

/* Sums the contributions of one run; batches belong to one run each. */
static void read_run(void *context, uint64_t run)
{
    const job *j = context;
    const murk_followed *f = j->followed;
    const size_t keys = j->reweighed->keys;
    const size_t last = first_of_run(j, run + 1);
    for (size_t i = first_of_run(j, run); i < last; ++i) {
        const murk_contribution *c = &f->contribution[i];
        if (murk_contribution_is_record(c)) {
            continue;
        }
        const double worth = worth_of(j, c);
        const size_t b =
            (size_t)(c->photon * (uint64_t)j->batches / f->emitted);
        j->batch[b * j->receivers + c->receiver] +=
            worth * j->reweighed->ratio[i];
        double *slope =
            j->slope_batch + (run * j->receivers + c->receiver) * keys;
        for (size_t k = 0; k < keys; ++k) {
            slope[k] += worth * j->reweighed->slope[k * f->n + i];
        }
    }
}

void murk_receivers_read(double *value, double *slope, double *batch,
                         size_t batches, double *slope_batch, size_t runs,
                         const murk_receiver *receiver,
                         const murk_spectrum *per_watt, size_t receivers,
                         const murk_followed *followed,
                         const murk_reweighed *reweighed, unsigned threads)
{
    const size_t keys = reweighed->keys, slopes = receivers * keys;
    job j = {batch,    slope_batch, batches,  runs,     receivers,
             receiver, per_watt,    followed, reweighed};
    if (!slope_batch) { /* a single run */
        j.slope_batch = slope;
        j.runs = 1;
    }
    assert(batches % j.runs == 0);
    /* Clear the sums, then process the runs in parallel. */
    memset(value, 0, receivers * sizeof *value);
    memset(slope, 0, slopes * sizeof *slope);
    memset(batch, 0, batches * receivers * sizeof *batch);
    memset(j.slope_batch, 0, j.runs * slopes * sizeof *j.slope_batch);
    murk_pool_run(threads, j.runs, read_run, &j);
    /* Totals. */
    for (size_t b = 0; b < batches; ++b) {
        for (size_t r = 0; r < receivers; ++r) {
            value[r] += batch[b * receivers + r];
        }
    }
    for (size_t i = 0; slope_batch && i < runs * slopes; ++i) {
        slope[i % slopes] += slope_batch[i];
    }
}
