/* Each kind of phase function: the density integrates to 1, the sampled cosine
 * follows it, the mean is the one that is told. Tables: test_phase_table.c.
 *
 * The random tests of this file share a 1e-6 chance of a false alarm per seed
 * (Sidak). The seed is fixed, so the verdict repeats; give another as the
 * first argument. */
#include "base/rng.h"
#include "base/stats.h"
#include "base/vector.h"
#include "check.h"
#include "medium/phase.h"
#include "turns.h"

#include <stdlib.h>

#define SAMPLES     100000
#define CHI_SAMPLES 1000000
#define CHECKS      (11 + 11 * 10 + 2 * 7)

static double limit(void)
{
    return murk_sidak_limit(1e-6, CHECKS);
}

static double cosine(double g, uint32_t seed, uint64_t i)
{
    return murk_hg_sample(g, murk_random(seed, MURK_TEST, i, 0, 0).u[0]);
}

static double mean_cosine(double g, uint32_t seed)
{
    double sum = 0;
    for (uint64_t i = 0; i < SAMPLES; ++i) {
        sum += cosine(g, seed, i);
    }
    return sum / SAMPLES;
}

static double standard_error(double g)
{
    return sqrt((1 - g * g) / 3 / SAMPLES); /* exact variance, phase.h */
}

static void test_mean_cosine_is_g(uint32_t seed)
{
    for (int k = -5; k <= 5; ++k) {
        const double g = 0.19 * k;
        CHECK_WITHIN(limit(), mean_cosine(g, seed), g, standard_error(g));
    }
}

/* Teeth: a phase function off by 0.02 in g must not get through. */
static void test_would_notice_a_wrong_g(uint32_t seed)
{
    const double off =
        sigmas_off(mean_cosine(0.82, seed), 0.80, standard_error(0.80));
    CHECK(off > 2 * limit());
}

/* P(cosine < mu) from the density, by the midpoint rule. */
static double share_below(double g, double mu)
{
    const int n = 20000;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        sum += murk_hg_density(g, -1 + (i + 0.5) * (mu + 1) / n);
    }
    return sum * (mu + 1) / n * 2 * MURK_PI;
}

static void test_shares_follow_the_density(uint32_t seed)
{
    for (int k = -5; k <= 5; ++k) {
        const double g = 0.19 * k;
        for (int j = 1; j <= 10; ++j) {
            const double mu = -1 + 0.18 * j;
            const double want = share_below(g, mu);
            int below = 0;
            for (uint64_t i = 0; i < SAMPLES / 10; ++i) {
                below += cosine(g, seed, i) < mu;
            }
            CHECK_WITHIN(limit(), below, SAMPLES / 10.0 * want,
                         sqrt(SAMPLES / 10.0 * want * (1 - want)) + 1e-9);
        }
    }
}

static void test_density_integrates_to_one(void)
{
    CHECK_NEAR(share_below(0.8, 1), 1, 1e-6);
    CHECK_NEAR(share_below(-0.3, 1), 1, 1e-6);
    CHECK_NEAR(share_below(0, 1), 1, 1e-12);
}

static void test_cosines_stay_in_range(void)
{
    const double g[] = {-0.999999, -0.5, -1e-7, 0, 1e-9, 1e-7, 0.5, 0.999999};
    const double u[] = {0x1p-33, 1e-6, 0.5, 1 - 1e-6, 1 - 0x1p-33};
    for (size_t i = 0; i < sizeof g / sizeof *g; ++i) {
        for (size_t j = 0; j < sizeof u / sizeof *u; ++j) {
            const double mu = murk_hg_sample(g[i], u[j]);
            CHECK(mu >= -1 && mu <= 1);
            CHECK(j == 0 || mu >= murk_hg_sample(g[i], u[j - 1]));
        }
    }
}

/* ---- all kinds ---- */

static double phase_density(const void *context, double mu)
{
    return murk_phase_density(context, mu);
}

static double phase_sample(const void *context, double u)
{
    return murk_phase_sample(context, u);
}

/* A kind and one that is slightly wrong. */
typedef struct kind {
    murk_phase right, wrong;
    double mean;
} kind;

static void test_kind(const kind *k, uint32_t seed)
{
    CHECK_NEAR(turn_share(phase_density, &k->right, 0, MURK_PI), 1, 1e-9);
    CHECK_NEAR(murk_phase_mean_cosine(&k->right), k->mean, 1e-15);
    double sum = 0, squares = 0;
    for (uint64_t i = 0; i < CHI_SAMPLES; ++i) {
        const double mu = murk_phase_sample(
            &k->right, murk_random(seed, MURK_TEST, i, 1, 0).u[0]);
        sum += mu;
        squares += mu * mu;
    }
    const double mean = sum / CHI_SAMPLES;
    CHECK_WITHIN(limit(), mean, k->mean,
                 sqrt((squares / CHI_SAMPLES - mean * mean) / CHI_SAMPLES));
    CHECK(fabs(turn_misfit(phase_sample, &k->right, phase_density, &k->right,
                           CHI_SAMPLES, seed)) < limit());
    CHECK(turn_misfit(phase_sample, &k->right, phase_density, &k->wrong,
                      CHI_SAMPLES, seed) > 2 * limit()); /* teeth */
}

static void test_kinds(uint32_t seed)
{
    const kind kinds[] = {
        {{0}, murk_phase_hg(.01), 0},
        {murk_phase_rayleigh(), murk_phase_hg(.01), 0},
        {murk_phase_hg(.85), murk_phase_hg(.84), .85},
        {murk_phase_two_hg(.9, -.4, .8), murk_phase_two_hg(.89, -.4, .8), .64},
        {murk_phase_two_hg(.9, -.4, .8), murk_phase_two_hg(.9, -.4, .79), .64},
        {murk_phase_two_hg(.5, .2, 1), murk_phase_two_hg(.49, .2, 1), .5},
        {murk_phase_two_hg(.5, .2, 0), murk_phase_two_hg(.5, .21, 0), .2}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; ++i) {
        test_kind(&kinds[i], seed);
    }
}

/* u that is the weight itself, and the ends. */
static void test_two_terms_at_their_seam(void)
{
    const murk_phase p = murk_phase_two_hg(.9, -.4, .5);
    const murk_phase all = murk_phase_two_hg(.9, -.4, 1);
    const double u[] = {0x1p-33, .5 - 0x1p-53, .5, 1 - 0x1p-33};
    for (int i = 0; i < 4; ++i) {
        const double mu = murk_phase_sample(&p, u[i]);
        CHECK(mu >= -1 && mu <= 1);
        CHECK(murk_phase_sample(&all, u[i]) == murk_hg_sample(.9, u[i]));
    }
}

static void test_rayleigh(void)
{
    const murk_phase p = murk_phase_rayleigh();
    CHECK_NEAR(murk_phase_density(&p, 1) / murk_phase_density(&p, 0), 2, 1e-15);
    for (int i = 1; i < 64; ++i) { /* the cdf at the sample is u */
        const double u = i / 64., mu = murk_phase_sample(&p, u);
        CHECK_NEAR((mu * mu * mu + 3 * mu + 4) / 8, u, 1e-15);
    }
}

#define STEPS 20000

/* Every closed form of the table: density, share, mean and sample belong to one
 * function. The midpoint rule is off by some 1 / STEPS^2 of the curvature. */
static void test_every_row_of_the_table(void)
{
    const double value[MURK_PHASE_NUMBERS_MAX] = {.5, -.2, .3};
    for (int k = 0; murk_phase_kinds[k].name; ++k) {
        const murk_phase_kind which = (murk_phase_kind)k;
        if (which == MURK_PHASE_TABLE || murk_phase_is_tabulated(which)) {
            continue;
        }
        const murk_phase p = murk_phase_of(which, value);
        murk_error err = {0};
        CHECK(murk_phase_check(&p, 0, "phase", &err) == MURK_OK);
        double share = 0, mean = 0; /* from straight on downwards */
        for (int i = 0; i < STEPS; ++i) {
            const double mu = 1 - (i + .5) * 2 / STEPS;
            const double part =
                2 * MURK_PI * murk_phase_density(&p, mu) * 2 / STEPS;
            share += part;
            mean += mu * part;
            if (i % 1000 == 499) {
                const double end = 1 - (i + 1) * 2. / STEPS;
                CHECK_NEAR(murk_phase_share_within(&p, acos(end)), share, 1e-6);
            }
        }
        CHECK_NEAR(share, 1, 1e-6);
        CHECK_NEAR(murk_phase_mean_cosine(&p), mean, 1e-6);
        for (double u = .05; u < 1; u += .1) {
            const double mu = murk_phase_sample(&p, u);
            CHECK(mu >= -1 && mu <= 1);
            /* a sum is sampled term by term: no inverse of the whole */
            CHECK(which == MURK_PHASE_TWO_HG ||
                  fabs(1 - u - murk_phase_share_within(&p, acos(mu))) < 1e-9);
        }
    }
}

static void test_bad_members_are_refused(void)
{
    /* Parameters out of range, and a missing table. */
    static const struct {
        murk_phase phase;
        const char *text;
    } bad[] = {
        {{.value = {1}},
         "mean cosine g is 1 (band 3), must be between -1 and 1, "
         "both excluded"},
        {{.value = {NAN}},
         "mean cosine g is nan (band 3), must be between -1 and 1, "
         "both excluded"},
        {{.kind = MURK_PHASE_TWO_HG, .value = {0, -1}},
         "mean cosine g is -1 (band 3), must be between -1 and 1, both "
         "excluded"},
        {{.kind = MURK_PHASE_TWO_HG, .value = {0, 0, 1.1}},
         "weight of g1 is 1.1 (band 3), must be 0..1"},
        {{.kind = MURK_PHASE_TABLE}, "phase function misses a table (band 3)"}};
    /* Each is refused with band and place. */
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        murk_error err = {0};
        CHECK(murk_phase_check(&bad[i].phase, 3, "haze", &err) ==
              MURK_BAD_VALUE);
        CHECK_TEXT(err.where, "haze");
        CHECK_TEXT(err.text, bad[i].text);
    }
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_mean_cosine_is_g(seed);
    test_would_notice_a_wrong_g(seed);
    test_shares_follow_the_density(seed);
    test_density_integrates_to_one();
    test_cosines_stay_in_range();
    test_kinds(seed);
    test_two_terms_at_their_seam();
    test_rayleigh();
    test_every_row_of_the_table();
    test_bad_members_are_refused();
    return check_done();
}
