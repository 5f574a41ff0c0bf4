#include "validation_rows.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/progress.h"

/* The first block, which tells how many photons the case needs. */
#define BLOCK_FIRST (UINT64_C(32) * MURK_BATCH_PHOTONS)
/* The largest: what its batches' sums take stays small. */
#define BLOCK_MOST (UINT64_C(1024) * MURK_BATCH_PHOTONS)

#define RELATIVE_ERROR 1e-3
#define ABSOLUTE_ERROR 3e-5
#define QUICK_FACTOR   3

/* Errors are estimates, too: a little more than needed spares a last, tiny
 * block. */
#define PHOTONS_MARGIN 1.02

/* A twin that is so far off need not go on. */
#define SIGMAS_PLENTY 10

/* A share of the emitted light that may be lost: far below every error. */
#define LOST_MOST 1e-6

/* Sums of one batch of photons; only the thread that traces it writes here. */
typedef struct batch_sums {
    bool is_begun;
    murk_event before;
    double photon[VALIDATION_QUANTITIES_MAX]; /* of the photon under way */
    double sum[VALIDATION_QUANTITIES_MAX], square[VALIDATION_QUANTITIES_MAX];
    uint64_t scorers[VALIDATION_QUANTITIES_MAX];
} batch_sums;

typedef struct block {
    const validation_case *c;
    batch_sums *batch;
} block;

typedef struct sums {
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
            close_photon(b, k->c->quantities);
        }
        b->is_begun = true;
    } else {
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
static void trace_block(const validation *v, const validation_case *c,
                        batch_sums *batch, murk_ledger *ledger, uint64_t n,
                        sums *s)
{
    const size_t batches =
        (size_t)((n + MURK_BATCH_PHOTONS - 1) / MURK_BATCH_PHOTONS);
    memset(batch, 0, batches * sizeof *batch);
    block k = {c, batch};
    murk_trace trace = murk_trace_defaults();
    trace.world = c->world;
    trace.seed = seed_of(v, c);
    trace.threads = v->settings.threads;
    trace.first = s->photons;
    trace.last = s->photons + n;
    trace.sink = hear;
    trace.context = &k;
    if (c->least_weight > 0) {
        trace.least_weight = c->least_weight;
    }
    if (c->events_max > 0) {
        trace.events_max = c->events_max;
    }
    murk_trace_run(&trace, ledger);
    s->photons += n;
    for (size_t i = 0; i < batches; ++i) {
        batch_sums *b = &batch[i];
        close_photon(b, c->quantities);
        for (size_t q = 0; q < c->quantities; ++q) {
            s->sum[q] += b->sum[q];
            s->square[q] += b->square[q];
            s->scorers[q] += b->scorers[q];
        }
    }
}

static murk_estimate estimate_of(const sums *s, size_t q)
{
    const double n = (double)s->photons;
    const double mean = s->sum[q] / n;
    const double variance = (s->square[q] / n - mean * mean) / (n - 1);
    return (murk_estimate){mean, sqrt(fmax(variance, 0))};
}

/* Photons that the case needs in all, as far as can be seen now. */
static double photons_needed(const validation *v, const validation_case *c,
                             const sums *s)
{
    const double n = (double)s->photons;
    double most = 0;
    for (size_t q = 0; q < c->quantities; ++q) {
        const double wanted =
            validation_error_wanted(v, c->reference[q].value, c->error_scale);
        const double over = estimate_of(s, q).standard_error / wanted;
        const double scorers = fmax(1, (double)s->scorers[q]);
        most = fmax(most, n * over * over);
        if (scorers < VALIDATION_SCORERS) {
            most = fmax(most, n * VALIDATION_SCORERS / scorers);
        }
    }
    return most;
}

static bool is_plainly_off(const validation_case *c, const sums *s)
{
    bool any = false;
    for (size_t q = 0; q < c->quantities; ++q) {
        const validation_row row = {.reference = c->reference[q].value,
                                    .uncertainty = c->reference[q].uncertainty,
                                    .murk = estimate_of(s, q)};
        any |= s->scorers[q] >= VALIDATION_SCORERS &&
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

static validation_row *new_row(validation *v, const char *name,
                               const char *source, const char *is_wrong,
                               const validation_reference *reference)
{
    if (v->rows == v->room) {
        v->room = v->room ? 2 * v->room : 256;
        validation_row *grown = realloc(v->row, v->room * sizeof *grown);
        if (!grown) {
            fprintf(stderr, "no memory for %zu rows\n", v->room);
            exit(1);
        }
        v->row = grown;
    }
    validation_row *row = &v->row[v->rows++];
    *row = (validation_row){.reference = reference->value,
                            .uncertainty = reference->uncertainty};
    snprintf(row->group, sizeof row->group, "%s", v->group);
    snprintf(row->name, sizeof row->name, "%s", name);
    snprintf(row->quantity, sizeof row->quantity, "%s", reference->quantity);
    snprintf(row->source, sizeof row->source, "%s", source);
    snprintf(row->wrong, sizeof row->wrong, "%s", is_wrong ? is_wrong : "");
    return row;
}

/* A case as it goes on, on standard error: it tells the time, which no result
 * may. */
static void tell(const validation *v, const validation_case *c, const sums *s,
                 double seconds)
{
    fprintf(stderr, "%s/%s%s%s: %.3g photons, %.1f s\n", v->group, c->name,
            c->is_wrong ? ", but " : "", c->is_wrong ? c->is_wrong : "",
            (double)s->photons, seconds);
}

void validation_trace(validation *v, const validation_case *c)
{
    assert(c->quantities > 0 && c->quantities <= VALIDATION_QUANTITIES_MAX);
    if (!validation_wants(v, c->name)) {
        return;
    }
    const double begin = murk_clock_s();
    const double most =
        (double)(c->photons_most > 0 ? c->photons_most : UINT64_C(1) << 32);
    murk_error err = {0};
    murk_ledger *ledger = NULL;
    batch_sums *batch =
        malloc((size_t)(BLOCK_MOST / MURK_BATCH_PHOTONS) * sizeof *batch);
    sums s = {0};
    if (!batch || murk_ledger_create(&ledger, c->world, &err)) {
        fprintf(stderr, "no memory for the sums of %s\n", c->name);
        exit(1);
    }
    double needed = (double)BLOCK_FIRST;
    while ((double)s.photons < fmin(needed, most) &&
           !(c->is_wrong && s.photons > 0 && is_plainly_off(c, &s))) {
        const double left = fmin(needed, most) - (double)s.photons;
        const double batches = ceil(left / MURK_BATCH_PHOTONS);
        const double growth = fmax((double)BLOCK_FIRST, 3 * (double)s.photons);
        const double n = fmin(fmin(batches * MURK_BATCH_PHOTONS, growth),
                              (double)BLOCK_MOST);
        trace_block(v, c, batch, ledger, (uint64_t)n, &s);
        needed = photons_needed(v, c, &s);
        if (needed > (double)s.photons) {
            needed *= PHOTONS_MARGIN;
        }
    }
    for (size_t q = 0; q < c->quantities; ++q) {
        validation_row *row =
            new_row(v, c->name, c->source, c->is_wrong, &c->reference[q]);
        row->murk = estimate_of(&s, q);
        row->photons = s.photons;
        row->is_short = !c->is_wrong && needed > (double)s.photons;
    }
    if (murk_ledger_imbalance(ledger) != 0 ||
        !(lost_share(ledger) <= LOST_MOST)) {
        fprintf(stderr, "%s/%s: imbalance %lld, share lost %g\n", v->group,
                c->name, (long long)murk_ledger_imbalance(ledger),
                lost_share(ledger));
        ++v->unsound;
    }
    tell(v, c, &s, murk_clock_s() - begin);
    murk_ledger_destroy(ledger);
    free(batch);
}

void validation_check(validation *v, const char *name, const char *source,
                      const char *is_wrong,
                      const validation_reference *reference, murk_estimate murk,
                      uint64_t photons)
{
    if (validation_wants(v, name)) {
        validation_row *row = new_row(v, name, source, is_wrong, reference);
        row->murk = murk;
        row->photons = photons;
    }
}

bool validation_wants(const validation *v, const char *name)
{
    const size_t length = strlen(v->group);
    for (size_t i = 0; i < v->settings.n_wanted; ++i) {
        const char *wanted = v->settings.wanted[i];
        if (strncmp(wanted, v->group, length) == 0 &&
            (wanted[length] == '\0' ||
             (wanted[length] == '/' && strstr(name, wanted + length + 1)))) {
            return true;
        }
    }
    return v->settings.n_wanted == 0;
}

bool validation_is_quick(const validation *v)
{
    return v->settings.is_quick;
}

double validation_error_wanted(const validation *v, double reference,
                               double error_scale)
{
    const double scale = error_scale > 0 ? error_scale : 1;
    return (v->settings.is_quick ? QUICK_FACTOR : 1) *
           fmax(RELATIVE_ERROR * fabs(reference), ABSOLUTE_ERROR * scale);
}

uint32_t validation_seed(const validation *v)
{
    return v->settings.seed;
}

unsigned validation_threads(const validation *v)
{
    return v->settings.threads;
}

double validation_half_digit(int digits)
{
    return .5 * pow(10, -digits);
}

double validation_half_digit_of(const char *text)
{
    const char *point = strchr(text, '.');
    const char *exponent = strpbrk(text, "eE");
    const char *end = exponent ? exponent : text + strlen(text);
    const int digits = point && point < end ? (int)(end - point) - 1 : 0;
    return validation_half_digit(
        digits - (exponent ? (int)strtol(exponent + 1, NULL, 10) : 0));
}

validation *validation_create(const validation_settings *settings)
{
    validation *v = calloc(1, sizeof *v);
    if (!v) {
        fprintf(stderr, "no memory for a validation\n");
        exit(1);
    }
    v->settings = *settings;
    return v;
}

void validation_destroy(validation *v)
{
    if (v) {
        free(v->row);
        free(v);
    }
}

void validation_group(validation *v, const char *group)
{
    snprintf(v->group, sizeof v->group, "%s", group);
}
