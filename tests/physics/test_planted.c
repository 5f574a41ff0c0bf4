/* Fits of planted readings find what was planted, as nearly as they say: fog
 * (extinction and mean cosine), a smoke grid (scale and albedo) and water
 * (extinction and albedo in three bands), each with noise and light of many
 * seeds; and coverage alone finds a visibility, from wherever it starts.
 *
 *   test_planted [SEEDS]     of each case; 100 is the nightly form. The quick
 *                            one has a quarter of them in water, which is slow
 *
 * Counts: of a normal error .954 lie within two standard errors and .683 within
 * one; limits are those that a binomial count passes with a chance of 1e-4 over
 * all of them, and with 100 seeds at most 82 and 45 to 87. Squares: an error in
 * the metric of what is said to be known is chi-squared, so their sum over
 * seeds is (Wilson & Hilferty's normal form, PNAS 17 (1931) 684,
 * doi:10.1073/pnas.17.12.684). Seeds are fixed, so a verdict repeats. */
#include "planted.h"

#include "base/log.h"
#include "base/stats.h"
#include "check.h"

#include <stdlib.h>

#define THREADS 2
#define BUDGET  1e-4

/* Keys of the three cases, each with three limits; and two sums of squares of
 * each case with one above all, and how far all are drawn. */
#define COUNTS 30
#define SUMS   8

#define WITHIN_1 .682689492137
#define WITHIN_2 .954499736104

#define SEEDS_QUICK   8
#define SEEDS_NIGHTLY 100

/* Lights that make the truth, for each of a fit's photons: what they are off by
 * is the same in all fits. */
#define TRUTH_QUICK   10
#define TRUTH_NIGHTLY 100

/* ---- limits ---- */

static double binomial(unsigned n, unsigned k, double p)
{
    return exp(lgamma(n + 1.) - lgamma(k + 1.) - lgamma(n - k + 1.) +
               k * log(p) + (n - k) * log1p(-p));
}

/* Fewer come with a chance of less than `chance`. */
static unsigned min_of(unsigned n, double p, double chance)
{
    unsigned k = 0;
    for (double below = binomial(n, 0, p); below <= chance;) {
        below += binomial(n, ++k, p);
    }
    return k;
}

static unsigned max_of(unsigned n, double p, double chance)
{
    return n - min_of(n, 1 - p, chance);
}

typedef struct limits {
    unsigned within_2, within_1, within_1_max;
    double sigma; /* of sums of squares */
} limits;

static limits limits_of(unsigned n)
{
    const double chance = BUDGET / (COUNTS + SUMS);
    limits l = {.within_2 = min_of(n, WITHIN_2, chance),
                .within_1 = min_of(n, WITHIN_1, chance),
                .within_1_max = max_of(n, WITHIN_1, chance),
                .sigma = murk_normal_upper(chance / 2)};
    if (n == SEEDS_NIGHTLY) { /* required of it */
        l.within_2 = l.within_2 > 82 ? l.within_2 : 82;
        l.within_1 = l.within_1 > 45 ? l.within_1 : 45;
        l.within_1_max = l.within_1_max < 87 ? l.within_1_max : 87;
    }
    return l;
}

static double normal_of_chi2(double chi2, double freedom)
{
    const double v = 2 / (9 * freedom);
    return (cbrt(chi2 / freedom) - (1 - v)) / sqrt(v);
}

/* ---- many fits ---- */

typedef struct tried {
    const planted_case *of;
    unsigned n;
    double sigma[SEEDS_NIGHTLY][PLANTED_KEYS_MAX];
    double square;             /* sum over seeds */
    double along, plain_along; /* likewise, of those that know all */
    unsigned known;
    double residuals, freedom; /* of the rows */
    double max_slope_noise;
} tried;

static bool try_all(tried *t, const planted_case *of, unsigned seeds)
{
    /* Trace the true readings once, with more photons in the nightly form. */
    const bool is_quick = seeds < SEEDS_NIGHTLY;
    planted_field field;
    *t = (tried){.of = of, .n = seeds};
    bool is_well =
        planted_open(&field, of) &&
        planted_light(&field, 5,
                      of->emit / 5 * (is_quick ? TRUTH_QUICK : TRUTH_NIGHTLY),
                      THREADS);
    /* Fit once for each seed; every fit converges with enough effective
     * photons. */
    for (unsigned i = 0; i < seeds && is_well; ++i) {
        planted_fit fit;
        is_well = planted_fit_once(&fit, &field, i + 1, THREADS);
        if (!is_well) {
            break;
        }
        CHECK(fit.converged);
        CHECK(fit.effective_share >= MURK_MIN_SHARE);
        /* Keep the deviation of each key in units of the standard error. */
        for (size_t k = 0; k < of->n; ++k) {
            t->sigma[i][k] = fit.off.sigma[k];
        }
        /* Add up over seeds: squares of deviations, deviations along the
         * direction into which noise in slopes draws a plain fit (if all
         * keys are known), and residuals of the rows. */
        t->square += fit.off.square;
        if (isfinite(fit.off.along)) {
            t->along += fit.off.along;
            t->plain_along += fit.plain.along;
            ++t->known;
        }
        t->residuals += fit.chi2;
        t->freedom += (double)fit.degrees_of_freedom;
        t->max_slope_noise = fmax(t->max_slope_noise, fit.slope_noise);
    }
    planted_close(&field);
    return is_well;
}

/* Errors within `width` of what is said; NaN is not. */
static unsigned within(const tried *t, size_t key, double width)
{
    unsigned n = 0;
    for (unsigned i = 0; i < t->n; ++i) {
        n += fabs(t->sigma[i][key]) < width;
    }
    return n;
}

static void check_counts(const tried *t, const limits *l)
{
    bool halved_passes = true;
    for (size_t k = 0; k < t->of->n; ++k) {
        const unsigned one = within(t, k, 1), two = within(t, k, 2);
        printf("%-28s of %u: %u within one standard error, %u within two\n",
               t->of->key[k], t->n, one, two);
        CHECK(two >= l->within_2);
        CHECK(one >= l->within_1 && one <= l->within_1_max);
        halved_passes = halved_passes && one >= l->within_2 &&
                        within(t, k, .5) >= l->within_1;
    }
    if (t->n == SEEDS_NIGHTLY) { /* teeth: errors said to be half as large */
        CHECK(!halved_passes);
    }
}

static void check_squares(const tried *t, const limits *l)
{
    const double freedom = (double)(t->n * t->of->n);
    const double off = normal_of_chi2(t->square, freedom);
    const double rows = normal_of_chi2(t->residuals, t->freedom);
    printf(
        "%s: chi2 of parameters %.1f of %.0f (%+.1f sigma), of rows %.1f of "
        "%.0f (%+.1f); noise of slopes up to %.2f draws them by %+.1f sigma, "
        "taking slopes for exact by %+.1f\n",
        t->of->name, t->square, freedom, off, t->residuals, t->freedom, rows,
        t->max_slope_noise, t->along / sqrt(t->known),
        t->plain_along / sqrt(t->known));
    CHECK_WITHIN(l->sigma, off, 0, 1);
    CHECK_WITHIN(l->sigma, rows, 0, 1);
}

static void test_planted_parameters(unsigned seeds)
{
    static const planted_case *const cases[] = {&planted_fog, &planted_smoke,
                                                &planted_water};
    double square = 0, freedom = 0, along = 0, plain_along = 0, known = 0;
    for (size_t c = 0; c < sizeof cases / sizeof *cases; ++c) {
        static tried t;
        const bool is_slow = seeds < SEEDS_NIGHTLY && cases[c]->n > 2;
        const bool is_well =
            try_all(&t, cases[c], is_slow ? (seeds + 3) / 4 : seeds);
        CHECK(is_well);
        if (is_well) {
            const limits l = limits_of(t.n);
            check_counts(&t, &l);
            check_squares(&t, &l);
            square += t.square;
            along += t.along;
            plain_along += t.plain_along;
            known += t.known;
            freedom += (double)(t.n * t.of->n);
        }
    }
    const double max = limits_of(seeds).sigma;
    const double off = normal_of_chi2(square, freedom);
    const double drawn = along / sqrt(known);
    const double plain_drawn = plain_along / sqrt(known);
    printf("all: chi2 %.1f of %.0f (%+.1f sigma); drawn by noise of slopes "
           "%+.1f sigma, taking them for exact %+.1f\n",
           square, freedom, off, drawn, plain_drawn);
    CHECK_WITHIN(max, off, 0, 1);
    CHECK_WITHIN(max, drawn, 0, 1);
    /* teeth: errors said to be half, and twice, as large */
    CHECK(fabs(normal_of_chi2(4 * square, freedom)) > max);
    CHECK(fabs(normal_of_chi2(square / 4, freedom)) > max);
}

/* ---- coverage alone ---- */

#define STARTS 4

/* Forty readings, good to 2 %, through fog of unknown visibility. */
static void test_coverage_tells_visibility(void)
{
    static const double start_m[STARTS] = {12, 25, 60, 150};
    planted_field field;
    bool is_well =
        planted_open(&field, &planted_coverage) &&
        planted_light(&field, 5, planted_coverage.emit / 5 * TRUTH_QUICK,
                      THREADS);
    CHECK(is_well);
    for (size_t i = 0; i < STARTS && is_well; ++i) {
        planted_fit fit;
        field.start = &start_m[i];
        is_well = planted_fit_once(&fit, &field, (uint32_t)i + 1, THREADS);
        CHECK(is_well && fit.converged);
        if (is_well) {
            const double truth = planted_coverage.truth[0];
            printf("from %g m: visibility %.2f +- %.2f m, light traced %zu "
                   "times\n",
                   start_m[i], fit.value[0], fit.standard_error[0], fit.traces);
            CHECK_NEAR(fit.value[0], truth, .05 * truth);
            CHECK_WITHIN(murk_sidak_limit(BUDGET, STARTS), fit.value[0], truth,
                         fit.standard_error[0]);
            CHECK(fit.standard_error[0] < .02 * truth);
        }
    }
    /* teeth: readings of another fog are not taken for this one's */
    for (size_t r = 0; r < field.measured->rows && is_well; ++r) {
        field.truth[r] *= .9;
    }
    planted_fit fit;
    if (is_well && planted_fit_once(&fit, &field, 1, THREADS)) {
        CHECK(fabs(fit.value[0] / planted_coverage.truth[0] - 1) > .05);
    }
    planted_close(&field);
}

int main(int argc, char **argv)
{
    const unsigned long asked =
        argc > 1 ? strtoul(argv[1], NULL, 10) : SEEDS_QUICK;
    const unsigned seeds =
        asked < SEEDS_NIGHTLY ? (unsigned)asked : SEEDS_NIGHTLY;
    (void)murk_warn_to(NULL);
    test_planted_parameters(seeds);
    test_coverage_tells_visibility();
    return check_done();
}
