#include "transport/trace.h"

#include <assert.h>
#include <string.h>

#include "base/crew.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "transport/walk.h"

typedef struct run {
    murk_course course;
    murk_ledger *ledger;
} run;

static void add_up(murk_ledger *ledger, const murk_sums *s)
{
    murk_tally *const account[MURK_FATES] = {ledger->absorbed_surfaces,
                                             ledger->absorbed_media,
                                             ledger->escaped, ledger->lost};
    int64_t photons = 0;
    for (size_t c = 0; c < ledger->channels; ++c) {
        if (s->emitted[c]) {
            murk_tally_add(&ledger->emitted[c], s->emitted[c] * MURK_PACKET);
            photons += s->emitted[c];
        }
        for (int f = 0; f < MURK_FATES; ++f) {
            if (s->ended[c][f]) {
                murk_tally_add(&account[f][c], s->ended[c][f]);
            }
        }
    }
    for (int l = 0; l < MURK_LOSSES; ++l) {
        murk_tally_add(&ledger->lost_photons[l], s->lost[l]);
    }
    murk_tally_add(&ledger->photons, photons);
    murk_tally_add(&ledger->collisions, (int64_t)s->collisions);
    murk_progress_add((uint64_t)photons);
}

static void trace_batch(void *context, uint64_t batch)
{
    const run *r = context;
    const uint64_t first = r->course.trace->first + batch * MURK_BATCH_PHOTONS;
    const uint64_t left = r->course.trace->last - first;
    const uint64_t n = left < MURK_BATCH_PHOTONS ? left : MURK_BATCH_PHOTONS;
    murk_sums s;
    memset(s.emitted, 0, r->ledger->channels * sizeof s.emitted[0]);
    memset(s.ended, 0, r->ledger->channels * sizeof s.ended[0]);
    memset(s.lost, 0, sizeof s.lost);
    s.collisions = 0;
    for (uint64_t i = 0; i < n && !murk_interrupted(); ++i) {
        murk_walk_photon(&r->course, &s, batch, first + i);
    }
    add_up(r->ledger, &s);
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
    assert(trace->first % MURK_BATCH_PHOTONS == 0);
    assert(trace->least_weight >= MURK_LEAST_WEIGHT_MIN &&
           trace->least_weight <= 1);
    assert(ledger->channels == murk_lights_channels(trace->world->lights));
    if (trace->last <= trace->first) {
        return;
    }
    run r = {murk_course_of(trace), ledger};
    const uint64_t photons = trace->last - trace->first;
    murk_crew_run(trace->threads,
                  (photons + MURK_BATCH_PHOTONS - 1) / MURK_BATCH_PHOTONS,
                  trace_batch, &r);
}
