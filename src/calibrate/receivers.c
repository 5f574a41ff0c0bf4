/* What receivers read of re-weighted light. */
#include "calibrate/reweigh.h"

#include <string.h>

void murk_receivers_read(double *value, double *slope, double *batch,
                         size_t batches, double *slope_batch, size_t runs,
                         const murk_receiver *receiver,
                         const murk_spectrum *per_watt, size_t receivers,
                         const murk_followed *followed,
                         const murk_reweighed *reweighed)
{
    const murk_followed *f = followed;
    const size_t keys = reweighed->keys;
    const size_t lights = f->channels / (size_t)f->bands;
    memset(value, 0, receivers * sizeof *value);
    memset(slope, 0, receivers * keys * sizeof *slope);
    memset(batch, 0, batches * receivers * sizeof *batch);
    if (slope_batch) {
        memset(slope_batch, 0, runs * receivers * keys * sizeof *slope_batch);
    }
    for (size_t i = 0; i < f->n; ++i) {
        const murk_contribution *c = &f->contribution[i];
        const size_t r = c->receiver;
        if (murk_contribution_is_record(c)) {
            continue;
        }
        const double radius = receiver[r].radius_m;
        const double volume = 4. / 3 * MURK_PI * radius * radius * radius;
        const double worth =
            (double)c->value *
            f->packet_w[c->light * (size_t)f->bands + c->band] *
            per_watt[r * lights + c->light].band[c->band] / volume;
        const size_t b = (size_t)(c->photon * (uint64_t)batches / f->emitted);
        batch[b * receivers + r] += worth * reweighed->ratio[i];
        const size_t run = (size_t)(c->photon * (uint64_t)runs / f->emitted);
        for (size_t k = 0; k < keys; ++k) {
            const double part = worth * reweighed->slope[k * f->n + i];
            slope[r * keys + k] += part;
            if (slope_batch) {
                slope_batch[(run * receivers + r) * keys + k] += part;
            }
        }
    }
    for (size_t b = 0; b < batches; ++b) {
        for (size_t r = 0; r < receivers; ++r) {
            value[r] += batch[b * receivers + r];
        }
    }
}
