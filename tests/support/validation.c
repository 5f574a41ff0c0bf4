/* Traces a reference case in blocks of photons until every standard error is
 * small enough, and hands one row for each quantity to the report. Batch sums
 * are added up in batch order, so the result does not depend on threads. */
#include "validation_rows.h"

#include <assert.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/progress.h"

/* The first block, which tells how many photons the case needs. */
#define BLOCK_FIRST (UINT64_C(32) * MURK_BATCH_PHOTONS)
/* The largest: what its batches' sums take stays small. */
#define BLOCK_MAX (UINT64_C(1024) * MURK_BATCH_PHOTONS)

/* Errors are estimates, too: a little more than needed spares a last, tiny
 * block. */
#define PHOTONS_MARGIN 1.02

/* A twin that is so far off need not go on. */
#define SIGMAS_PLENTY 10

/* Channels (lights times bands) of a case. */
#define CHANNELS_MAX 64

/* A share of the emitted light that may be lost: far below every error. */
#define LOST_MAX 1e-6

/* Sums of one batch of photons; only the thread that traces it writes here. */
typedef struct batch_sums {
    bool is_begun;
    murk_event before;
    double photon[VALIDATION_QUANTITIES_MAX]; /* of the current photon */
    double sum[VALIDATION_QUANTITIES_MAX], square[VALIDATION_QUANTITIES_MAX];
    uint64_t scorers[VALIDATION_QUANTITIES_MAX];
} batch_sums;

typedef struct block {
    const validation_case *c;
    size_t scored;
    batch_sums *batch;
} block;

/* What a case has come to so far. */
typedef struct sums {
    const validation_case *c;
    size_t scored; /* quantities; the rest is in the tallies */
    murk_ledger *ledger;
    murk_tallies *tallies; /* NULL: none */
    uint64_t photons;
    double sum[VALIDATION_QUANTITIES_MAX], square[VALIDATION_QUANTITIES_MAX];
    uint64_t scorers[VALIDATION_QUANTITIES_MAX];
} sums;

static void close_photon(batch_sums *b, size_t quantities)
{
    for (size_t i = 0; i < quantities; ++i) {
        const double x = b->photon[i];
        if (x != 0) {
            b->sum[i] += x;
            b->square[i] += x * x;
            ++b->scorers[i];
            b->photon[i] = 0;
        }
    }
}

static void hear(void *context, uint64_t batch, const murk_event *event)
{
    const block *k = context;
    batch_sums *b = &k->batch[batch];
    if (event->kind == MURK_EVENT_EMITTED) {
        if (b->is_begun) {
            close_photon(b, k->scored);
        }
        b->is_begun = true;
    } else if (k->scored > 0) {
        k->c->score(k->c->context, &b->before, event, b->photon);
    }
    b->before = *event;
}

/* Of the run's seed and the case's name (FNV-1a), so that no two cases share
 * their numbers. */
static uint32_t seed_of(const validation *v, const validation_case *c)
{
    uint32_t hash = UINT32_C(2166136261) ^ v->settings.seed;
    const char *const part[] = {v->group, c->name, c->reference[0].quantity,
                                c->is_wrong ? c->is_wrong : ""};
    for (size_t i = 0; i < sizeof part / sizeof part[0]; ++i) {
        for (const char *p = part[i]; *p; ++p) {
            hash = (hash ^ (unsigned char)*p) * UINT32_C(16777619);
        }
    }
    return hash;
}

/* Traces photons [done, done + n) and adds to *s, batch by batch in order. */
static void trace_block(const validation *v, batch_sums *batch, uint64_t n,
                        sums *s)
{
    const validation_case *c = s->c;
    const size_t batches =
        (size_t)((n + MURK_BATCH_PHOTONS - 1) / MURK_BATCH_PHOTONS);
    memset(batch, 0, batches * sizeof *batch);
    block k = {c, s->scored, batch};
    /* The photons of the block, with the settings of the case. */
    murk_trace trace = murk_trace_defaults();
    trace.world = c->world;
    trace.seed = seed_of(v, c);
    trace.threads = v->settings.threads;
    trace.first = s->photons;
    trace.last = s->photons + n;
    trace.sink = s->scored > 0 ? hear : NULL;
    trace.tallies = s->tallies;
    trace.context = &k;
    if (c->least_weight > 0) {
        trace.least_weight = c->least_weight;
    }
    if (c->events_max > 0) {
        trace.events_max = c->events_max;
    }
    murk_trace_run(&trace, s->ledger);
    s->photons += n;
    /* Add the sums in batch order, so that threads change no bit. */
    for (size_t i = 0; i < batches; ++i) {
        batch_sums *b = &batch[i];
        close_photon(b, s->scored);
        for (size_t q = 0; q < s->scored; ++q) {
            s->sum[q] += b->sum[q];
            s->square[q] += b->square[q];
            s->scorers[q] += b->scorers[q];
        }
    }
}

/* In the units of the lights' power, of which a photon is a share. */
static murk_estimate tallied(const sums *s, const validation_cell *cell)
{
    double packet_w[CHANNELS_MAX];
    for (size_t i = 0; i < s->ledger->channels; ++i) {
        const double packets =
            (double)murk_tally_read(&s->ledger->emitted[i]) / MURK_PACKET;
        packet_w[i] =
            packets > 0
                ? murk_sources_channel_power_w(s->c->world->lights, i) / packets
                : 0;
    }
    const double scale = cell->scale != 0 ? cell->scale : 1;
    murk_estimate e = murk_tallies_read(s->tallies, cell->tally, 0, cell->cell,
                                        s->ledger->emitted, packet_w);
    e.value *= scale;
    e.standard_error *= fabs(scale);
    return e;
}

static murk_estimate estimate_of(const sums *s, size_t q)
{
    if (q >= s->scored) {
        return tallied(s, &s->c->cell[q - s->scored]);
    }
    const double n = (double)s->photons;
    const double mean = s->sum[q] / n;
    const double variance = (s->square[q] / n - mean * mean) / (n - 1);
    return (murk_estimate){mean, sqrt(fmax(variance, 0))};
}

/* Photons that scored to a quantity. A tally does not count them: those are
 * said that would bring its mean and error if all brought the same. */
static double scorers_of(const sums *s, size_t q, murk_estimate e)
{
    if (q < s->scored) {
        return (double)s->scorers[q];
    }
    const double n = (double)s->photons, ratio = e.standard_error / e.value;
    return e.value > 0 ? n / (1 + n * ratio * ratio) : 0;
}

/* Photons that a quantity needs in all, as far as can be seen now. */
static double photons_needed(const validation *v, const sums *s, size_t q)
{
    const validation_case *c = s->c;
    const double n = (double)s->photons;
    const double wanted =
        validation_error_wanted(v, c->reference[q].value, c->error_scale) /
        (c->exactness > 0 ? c->exactness : 1);
    const murk_estimate e = estimate_of(s, q);
    const double over = e.standard_error / wanted;
    const double scorers = fmax(1, scorers_of(s, q, e));
    const double for_scorers =
        scorers < VALIDATION_SCORERS ? n * VALIDATION_SCORERS / scorers : 0;
    return fmax(n * over * over, for_scorers);
}

static bool is_plainly_off(const sums *s)
{
    const validation_case *c = s->c;
    bool any = false;
    for (size_t q = 0; q < c->quantities; ++q) {
        const murk_estimate e = estimate_of(s, q);
        const validation_row row = {.reference = c->reference[q].value,
                                    .uncertainty = c->reference[q].uncertainty,
                                    .murk = e};
        any |= scorers_of(s, q, e) >= VALIDATION_SCORERS &&
               fabs(validation_sigmas(&row)) > SIGMAS_PLENTY;
    }
    return any;
}

static double lost_share(const murk_ledger *ledger)
{
    double lost = 0, emitted = 0;
    for (size_t i = 0; i < ledger->channels; ++i) {
        lost += (double)murk_tally_read(&ledger->lost[i]);
        emitted += (double)murk_tally_read(&ledger->emitted[i]);
    }
    return lost / emitted;
}

/* A case as it goes on, on standard error: it tells the time, which no result
 * may. */
static void tell(const validation *v, const sums *s, double seconds)
{
    const validation_case *c = s->c;
    fprintf(stderr, "%s/%s%s%s: %.3g photons, %.1f s\n", v->group, c->name,
            c->is_wrong ? ", but " : "", c->is_wrong ? c->is_wrong : "",
            (double)s->photons, seconds);
}

static void start(sums *s, const validation *v, const validation_case *c)
{
    murk_error err = {0};
    *s = (sums){.c = c, .scored = c->quantities - c->cells};
    murk_status status = murk_ledger_create(&s->ledger, c->world, &err);
    if (!status && c->tallies > 0) {
        status = murk_tallies_create(&s->tallies, c->tally, c->tallies,
                                     &c->world->domain, s->ledger->channels,
                                     c->world->bands, v->settings.threads,
                                     INFINITY, &err);
    }
    if (status) {
        fprintf(stderr, "%s: %s: %s\n", c->name, err.where, err.text);
        exit(1);
    }
    assert(s->ledger->channels <= CHANNELS_MAX);
}

/* Photons until all errors are small enough, or the case's last. */
static void trace_all(const validation *v, sums *s)
{
    const validation_case *c = s->c;
    const double max =
        (double)(c->photons_max > 0 ? c->photons_max : UINT64_C(1) << 32);
    batch_sums *batch =
        malloc((size_t)(BLOCK_MAX / MURK_BATCH_PHOTONS) * sizeof *batch);
    if (!batch) {
        fprintf(stderr, "no memory for the sums of %s\n", c->name);
        exit(1);
    }
    /* Trace until the errors are small enough. A wrong twin ends as soon as
     * it is far off. */
    double needed = (double)BLOCK_FIRST;
    while ((double)s->photons < fmin(needed, max) &&
           !(c->is_wrong && s->photons > 0 && is_plainly_off(s))) {
        /* The next block: at most three times the photons traced so far. */
        const double left = fmin(needed, max) - (double)s->photons;
        const double batches = ceil(left / MURK_BATCH_PHOTONS);
        const double growth = fmax((double)BLOCK_FIRST, 3 * (double)s->photons);
        const double n =
            fmin(fmin(batches * MURK_BATCH_PHOTONS, growth), (double)BLOCK_MAX);
        trace_block(v, batch, (uint64_t)n, s);
        /* How many photons the worst quantity needs by the errors so far. */
        needed = 0;
        for (size_t q = 0; q < c->quantities; ++q) {
            needed = fmax(needed, photons_needed(v, s, q));
        }
        if (needed > (double)s->photons) {
            needed *= PHOTONS_MARGIN;
        }
    }
    free(batch);
}

static bool is_sound(const validation *v, const sums *s)
{
    const double lost = lost_share(s->ledger);
    const int64_t imbalance = murk_ledger_imbalance(s->ledger);
    const bool sound = imbalance == 0 && lost <= LOST_MAX;
    if (!sound) {
        fprintf(stderr, "%s/%s: imbalance %" PRId64 ", share lost %g\n",
                v->group, s->c->name, imbalance, lost);
    }
    return sound;
}

void validation_trace(validation *v, const validation_case *c)
{
    assert(c->quantities > 0 && c->quantities <= VALIDATION_QUANTITIES_MAX);
    assert(c->cells <= c->quantities);
    if (!validation_wants(v, c->name)) {
        return;
    }
    /* Trace the case and check its ledger. */
    const double begin = murk_clock_s();
    sums s;
    start(&s, v, c);
    trace_all(v, &s);
    const bool is_unsound = !is_sound(v, &s);
    /* One row for each quantity. */
    for (size_t q = 0; q < c->quantities; ++q) {
        validation_row *row = validation_add_row(v, c->name, c->source,
                                                 c->is_wrong, &c->reference[q]);
        row->murk = estimate_of(&s, q);
        row->photons = s.photons;
        row->is_unsound = is_unsound;
        if (!c->is_wrong && photons_needed(v, &s, q) > (double)s.photons) {
            validation_mark_short(v, c->why_short);
        }
    }
    tell(v, &s, murk_clock_s() - begin);
    murk_tallies_destroy(s.tallies);
    murk_ledger_destroy(s.ledger);
}
