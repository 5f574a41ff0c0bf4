/* Traces photons in batches on all threads. Each batch has sums of its own,
 * which are added to the ledger at the end of the batch; absorption by material
 * and medium is added to the ledger at once. All sums are integers, so that the
 * result does not depend on the threads. */
#include "transport/trace.h"

#include <assert.h>
#include <string.h>

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "transport/lanes.h"

typedef struct run {
    murk_walk_setup setup;
    const murk_lane_steps *lanes; /* NULL: photons are traced one by one */
    murk_ledger *ledger;
} run;

/* Adds the sums of a batch to the ledger; with sign -1 subtracts them instead.
 * Adds the photons of the batch to the progress. */
static void add_up(murk_ledger *ledger, const murk_sums *s, int sign)
{
    murk_tally *const account[MURK_FATES] = {ledger->absorbed_surfaces,
                                             ledger->absorbed_media,
                                             ledger->escaped, ledger->lost};
    int64_t photons = 0;
    for (size_t c = 0; c < ledger->channels; ++c) {
        if (s->emitted[c]) {
            murk_tally_add(&ledger->emitted[c],
                           sign * s->emitted[c] * MURK_PACKET);
            photons += s->emitted[c];
        }
        for (int f = 0; f < MURK_FATES; ++f) {
            if (s->ended[c][f]) {
                murk_tally_add(&account[f][c], sign * s->ended[c][f]);
            }
        }
    }
    for (int l = 0; l < MURK_LOSSES; ++l) {
        murk_tally_add(&ledger->lost_photons[l], sign * s->lost[l]);
    }
    murk_tally_add(&ledger->photons, sign * photons);
    murk_tally_add(&ledger->collisions, sign * (int64_t)s->collisions);
    murk_progress_add((uint64_t)photons);
}

static void trace_batch(void *context, unsigned worker, uint64_t batch)
{
    const run *r = context;
    const murk_trace *trace = r->setup.trace;
    const murk_ledger *ledger = r->ledger;
    const uint64_t first = trace->batch
                               ? trace->batch[batch] * MURK_BATCH_PHOTONS
                               : trace->first + batch * MURK_BATCH_PHOTONS;
    const uint64_t left = trace->last - first;
    const uint64_t n = left < MURK_BATCH_PHOTONS ? left : MURK_BATCH_PHOTONS;
    /* Empty sums. */
    murk_sums s;
    memset(s.emitted, 0, ledger->channels * sizeof s.emitted[0]);
    memset(s.ended, 0, ledger->channels * sizeof s.ended[0]);
    memset(s.lost, 0, sizeof s.lost);
    s.collisions = 0;
    s.materials = ledger->materials;
    s.absorbers = ledger->materials + ledger->media;
    s.absorber = ledger->absorber +
                 worker % ledger->lanes * ledger->channels * s.absorbers;
    s.scorer =
        trace->tallies ? murk_tallies_scorer(trace->tallies, worker) : NULL;
    /* Trace the photons side by side, or one by one. */
    if (r->lanes) {
        murk_photon_lanes_trace(r->lanes, &r->setup, &s, batch, first,
                                first + n);
    }
    for (uint64_t i = 0; !r->lanes && i < n && !murk_interrupted(); ++i) {
        murk_walk_photon(&r->setup, &s, batch, first + i);
    }
    add_up(r->ledger, &s, trace->takes_back ? -1 : 1);
}

murk_trace murk_trace_defaults(void)
{
    return (murk_trace){.threads = 1,
                        .events_max = 100000,
                        .wraps_max = 10000,
                        .least_weight = 1};
}

void murk_trace_run(const murk_trace *trace, murk_ledger *ledger)
{
    assert(
        !trace->tallies ||
        (trace->events_max <= MURK_TALLY_SEGMENTS_MAX &&
         murk_tallies_fit(trace->tallies, ledger->channels, trace->threads)));
    assert(trace->least_weight >= MURK_MIN_WEIGHT_MIN &&
           trace->least_weight <= 1);
    assert(ledger->channels == murk_sources_channels(trace->world->lights));
    if (trace->last <= trace->first ||
        murk_sources_lit(trace->world->lights) == 0) {
        return;
    }
    run r = {.setup = murk_walk_setup_of(trace), .ledger = ledger};
    r.lanes = murk_photon_lanes_for(&r.setup);
    const uint64_t photons = trace->last - trace->first;
    const uint64_t batches =
        trace->batch ? trace->batches
                     : (photons + MURK_BATCH_PHOTONS - 1) / MURK_BATCH_PHOTONS;
    murk_pool_run_workers(trace->threads, batches, trace_batch, &r);
}
