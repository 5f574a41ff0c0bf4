/* Computes the likelihood ratio of each recorded path between two sets of
 * optics, with derivatives, in parallel over contributions, and the effective
 * sample size. */
#include "calibrate/reweigh.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "calibrate/change.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Contributions that a thread processes at a time: some 0.5 MB of histories. */
#define BATCH 8192

/* Below this |x|, the series of the slope of the mean is accurate to rounding;
 * above, the closed form loses about one more decimal digit at most. */
#define SERIES_BELOW 0.1

/* Limit of densities, so that logarithms are finite. */
#define MIN_DENSITY 1e-300

typedef struct job {
    const murk_histories *histories;
    const murk_changes *changes;
    murk_reweighed *out;
    double *slope;   /* [threads][keys]; sums for the present photon of a
                      * worker */
    size_t from, to; /* range of contributions that are re-weighted here */
} job;

/* ---- the mean of exp(-x t) over t from 0 to 1, and its slope by x ---- */

static double mean_along(double x)
{
    return x == 0 ? 1 : -expm1(-x) / x;
}

/* The derivative; mean is mean_along(x). */
static double mean_slope(double x, double mean)
{
    /* Series coefficients (-1)^n n / (n + 1)! of x^(n - 1). */
    static const double term[] = {
        -1. / 2,    2. / 6,      -3. / 24,     4. / 120,      -5. / 720,
        6. / 5040., -7. / 40320, 8. / 362880., -9. / 3628800, 10. / 39916800};
    if (fabs(x) >= SERIES_BELOW) {
        return (exp(-x) - mean) / x;
    }
    double sum = 0;
    for (size_t n = sizeof term / sizeof *term; n-- > 0;) {
        sum = sum * x + term[n];
    }
    return sum;
}

/* ---- scattering angles ---- */

/* The log ratio of phase functions over the scatterings of a photon so far. */
typedef struct turns {
    uint32_t photon, done;
    double log_ratio;
    double *slope; /* [keys]; derivatives of log_ratio */
} turns;

static double log_density(const murk_phase *phase, double mu)
{
    return log(fmax(murk_phase_density(phase, mu), MIN_DENSITY));
}

/* Adds one scattering. */
static void take_turn(const job *j, turns *t, size_t i, size_t band)
{
    const murk_histories *f = j->histories;
    const murk_changes *c = j->changes;
    const size_t m = f->turn_medium[i];
    const murk_medium_change *change = murk_change_of(c, m, band);
    const double mu = 1 - (double)f->turn[i];
    if (change->turns) {
        t->log_ratio +=
            log_density(change->at, mu) - log_density(change->traced, mu);
    }
    for (size_t k = 0; k < c->keys; ++k) {
        const murk_change_slope *s = murk_change_slope_of(c, k, m, band);
        if (s->turns) {
            t->slope[k] +=
                (log_density(s->high, mu) - log_density(s->low, mu)) /
                c->span[k];
        }
    }
}

/* Adds the scatterings up to this contribution of the same photon. */
static void follow_turns(const job *j, turns *t, const murk_contribution *of)
{
    if (!j->changes->any_turns || j->histories->turns == 0) {
        return; /* no phase function changes, or no cosine is stored: phase
                 * functions then change by less than a tolerance
                 * (murk_optics_turn_alike()), or no photon was scattered */
    }
    if (t->photon != of->photon) {
        t->photon = of->photon;
        t->done = 0;
        t->log_ratio = 0;
        memset(t->slope, 0, j->changes->keys * sizeof *t->slope);
    }
    for (; t->done < of->turns; ++t->done) {
        take_turn(j, t, (size_t)of->first + t->done, of->band);
    }
}

/* ---- one contribution ---- */

/* The parts of the ratio of one contribution, of which reweigh_one() makes the
 * ratio. A scattering in a medium whose scattering coefficient is 0 in the
 * wanted optics has the factor 0 and is only counted, because the derivative of
 * such a factor does not follow from a logarithm. */
typedef struct weight {
    double log_ratio; /* logarithm of all other factors, without that of the
                         chord */
    uint32_t zeros;   /* number of scatterings with the factor 0 */
    size_t zero;      /* index of the medium of one of these */
    double x;         /* optical depth added across the chord */
} weight;

static weight weigh(const job *j, const turns *t, size_t i, size_t band)
{
    const murk_histories *f = j->histories;
    weight w = {.log_ratio = t->log_ratio};
    for (size_t m = 0; m < f->media; ++m) {
        const murk_medium_change *change = murk_change_of(j->changes, m, band);
        const uint32_t n = f->count[i * f->media + m];
        w.log_ratio -= change->more_per_m * (double)f->path_m[i * f->media + m];
        w.x += change->more_per_m * (double)f->chord_m[i * f->media + m];
        if (n > 0 && change->scattering > 0) {
            w.log_ratio += n * change->log_scattering;
        } else if (n > 0) {
            w.zeros += n;
            w.zero = m;
        }
    }
    return w;
}

/* The derivatives of log_ratio and x with respect to a key. */
static void weigh_slope(const job *j, size_t k, size_t i, size_t band,
                        double *log_slope, double *x_slope)
{
    const murk_histories *f = j->histories;
    for (size_t m = 0; m < f->media; ++m) {
        const murk_change_slope *s =
            murk_change_slope_of(j->changes, k, m, band);
        const double scattering =
            murk_change_of(j->changes, m, band)->scattering;
        const uint32_t n = f->count[i * f->media + m];
        *log_slope -= s->more_per_m * (double)f->path_m[i * f->media + m];
        *x_slope += s->more_per_m * (double)f->chord_m[i * f->media + m];
        if (n > 0 && scattering > 0) {
            *log_slope += n * s->scattering / scattering;
        }
    }
}

static void reweigh_one(const job *j, turns *t, size_t i)
{
    const murk_changes *c = j->changes;
    /* The ratio: path, chord and power. */
    const murk_contribution *of = &j->histories->contribution[i];
    const size_t band = of->band, n = j->histories->n;
    const size_t channel = of->light * (size_t)c->bands + band;
    follow_turns(j, t, of);
    const weight w = weigh(j, t, i, band);
    const double power = c->power[channel];
    const double before = exp(w.log_ratio), mean = mean_along(w.x);
    const double path = before * mean; /* without the scatterings that are no
                                        * longer possible */
    const double bend = c->keys ? before * mean_slope(w.x, mean) : 0;
    const bool is_cut = !(path * power <= MURK_RATIO_MAX);
    j->out->ratio[i] = is_cut ? MURK_RATIO_MAX : w.zeros > 0 ? 0 : path * power;
    /* Derivatives: 0 if more than one scattering is impossible; with one, the
     * derivative of the factor of that scattering times all other factors. */
    for (size_t k = 0; k < c->keys; ++k) {
        double *slope = &j->out->slope[k * n + i];
        *slope = 0;
        if (!(c->span[k] > 0) || is_cut || w.zeros > 1) {
            continue;
        }
        if (w.zeros == 1) {
            *slope = path * power *
                     murk_change_slope_of(c, k, w.zero, band)->scattering;
            continue;
        }
        double log_slope = t->slope[k], x_slope = 0;
        weigh_slope(j, k, i, band, &log_slope, &x_slope);
        *slope =
            power * (path * log_slope + (x_slope != 0 ? bend * x_slope : 0)) +
            path * c->power_slope[k * c->channels + channel];
    }
}

static void reweigh_batch(void *context, unsigned worker, uint64_t batch)
{
    const job *j = context;
    const size_t from = j->from + (size_t)batch * BATCH;
    const size_t to = j->to - from < BATCH ? j->to : from + BATCH;
    turns t = {.photon = UINT32_MAX, /* no photon has this number */
               .slope = j->slope + worker * j->changes->keys};
    memset(t.slope, 0, j->changes->keys * sizeof *t.slope);
    for (size_t i = from; i < to; ++i) {
        reweigh_one(j, &t, i);
    }
}

/* ---- all ---- */

/* Sums over the contributions of a receiver or a map, weighted by their traced
 * values. */
typedef struct worth {
    double sum, ratio, squares;
} worth;

static double share_of(const worth *w)
{
    return w->sum > 0 ? w->ratio * w->ratio / (w->sum * w->squares) : 1;
}

/* The number of ranges of contributions that are summed separately, so that the
 * result does not depend on the number of threads. */
#define STRETCHES 64

typedef struct share_job {
    const murk_histories *histories;
    const double *ratio;
    worth *sums; /* [STRETCHES][kinds]; receivers, then the two maps */
    size_t kinds;
    size_t first; /* stretch of this rank */
} share_job;

/* The first contribution of a stretch. */
static size_t stretch_begin(const murk_histories *f, size_t stretch)
{
    return stretch * f->n / STRETCHES;
}

static void add_stretch(void *context, uint64_t number)
{
    const share_job *j = context;
    const murk_histories *f = j->histories;
    const size_t stretch = j->first + (size_t)number;
    worth *sums = j->sums + stretch * j->kinds;
    const size_t last = stretch_begin(f, stretch + 1);
    for (size_t i = stretch_begin(f, stretch); i < last; ++i) {
        const murk_contribution *c = &f->contribution[i];
        worth *w = c->receiver == MURK_RECORD_OF_SURFACE  ? &sums[j->kinds - 2]
                   : c->receiver == MURK_RECORD_OF_VOLUME ? &sums[j->kinds - 1]
                                                          : &sums[c->receiver];
        const double value = (double)c->value *
                             f->packet_w[c->light * (size_t)f->bands + c->band];
        w->sum += value;
        w->ratio += value * j->ratio[i];
        w->squares += value * j->ratio[i] * j->ratio[i];
    }
}

/* Computes the smallest effective share of any receiver or map. */
static murk_status find_effective_share(murk_reweighed *out,
                                        const murk_histories *f,
                                        unsigned threads, murk_error *err)
{
    const size_t kinds = f->receivers + 2;
    const size_t first =
        out->is_divided ? (size_t)murk_ranks_begin(STRETCHES) : 0;
    const size_t end =
        out->is_divided ? (size_t)murk_ranks_end(STRETCHES) : STRETCHES;
    share_job j = {f, out->ratio, calloc(STRETCHES * kinds, sizeof *j.sums),
                   kinds, first};
    murk_status status =
        j.sums ? MURK_OK : murk_no_memory(err, "fit", "for sums");
    if (!status) {
        murk_pool_run(threads, end - first, add_stretch, &j);
        status = murk_interrupt_check(err);
    }
    if (out->is_divided) {
        status = murk_ranks_join(j.sums, STRETCHES, kinds * sizeof *j.sums,
                                 status, err);
    }
    out->effective_share = 1;
    for (size_t i = 0; i < kinds && !status; ++i) {
        worth all = j.sums[i];
        for (size_t s = 1; s < STRETCHES; ++s) {
            const worth *more = &j.sums[s * kinds + i];
            all.sum += more->sum;
            all.ratio += more->ratio;
            all.squares += more->squares;
        }
        /* If all ratios of a receiver or map are 0, the share is not a number
         * and counts as 0. */
        const double share = share_of(&all);
        out->effective_share =
            share > 0 ? fmin(out->effective_share, share) : 0;
    }
    free(j.sums);
    return status;
}

/* The contributions that are re-weighted here: all, or those of the runs and of
 * the stretches of this rank. */
static void find_range(job *j)
{
    const murk_histories *f = j->histories;
    murk_reweighed *out = j->out;
    j->from = 0;
    j->to = f->n;
    out->is_divided = out->runs && murk_ranks_count() > 1;
    if (out->is_divided) {
        const size_t runs = out->runs;
        const size_t first =
            murk_histories_first(f, runs, (size_t)murk_ranks_begin(runs));
        const size_t last =
            murk_histories_first(f, runs, (size_t)murk_ranks_end(runs));
        j->from = stretch_begin(f, (size_t)murk_ranks_begin(STRETCHES));
        j->to = stretch_begin(f, (size_t)murk_ranks_end(STRETCHES));
        j->from = first < j->from ? first : j->from;
        j->to = last > j->to ? last : j->to;
    }
}

/* Allocates n ratios and n * keys slopes, unless the arrays of the last call
 * fit. */
static bool reserve(murk_reweighed *r, size_t n, size_t keys)
{
    if (!r->ratio || r->n != n || r->capacity < keys * n) {
        const size_t runs = r->runs;
        murk_reweighed_release(r);
        r->runs = runs;
        r->ratio = malloc((n + 1) * sizeof *r->ratio);
        r->slope = malloc((keys * n + 1) * sizeof *r->slope);
        r->capacity = keys * n;
    }
    r->n = n;
    r->keys = keys;
    return r->ratio && r->slope;
}

murk_status murk_reweigh(murk_reweighed *out, const murk_histories *histories,
                         const murk_optics *traced, const murk_optics *at,
                         const murk_optics_sides *sides, size_t keys,
                         unsigned threads, murk_error *err)
{
    assert(out && threads >= 1);
    const size_t n = histories->n;
    double *slope = NULL;
    murk_changes changes;
    murk_status status =
        murk_changes_create(&changes, histories, traced, at, sides, keys, err);
    if (status) {
        goto done;
    }
    /* Allocate; then re-weight in parallel. */
    slope = malloc((threads * keys + 1) * sizeof *slope);
    if (!slope || !reserve(out, n, keys)) {
        status = murk_no_memory(
            err, "fit",
            "for %zu contributions and their slopes by %zu parameters", n,
            keys);
        goto done;
    }
    job j = {.histories = histories,
             .changes = &changes,
             .out = out,
             .slope = slope};
    find_range(&j);
    murk_pool_run_workers(threads, (j.to - j.from + BATCH - 1) / BATCH,
                          reweigh_batch, &j);
    status = find_effective_share(out, histories, threads, err);
done:
    free(slope);
    murk_changes_release(&changes);
    return status;
}

void murk_reweighed_release(murk_reweighed *reweighed)
{
    free(reweighed->ratio);
    free(reweighed->slope);
    *reweighed = (murk_reweighed){0};
}
