/* The sampled cosine has the mean and the spread that the phase function
 * promises.
 *
 * The z-tests of this file share a 1e-6 chance of a false alarm per seed
 * (Sidak). The seed is fixed, so the verdict repeats; give another as the
 * first argument. */
#include "base/rng.h"
#include "base/stats.h"
#include "base/vector.h"
#include "check.h"
#include "medium/phase.h"

#include <stdlib.h>

#define SAMPLES 100000
#define CHECKS  (11 + 11 * 10)

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

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_mean_cosine_is_g(seed);
    test_would_notice_a_wrong_g(seed);
    test_shares_follow_the_density(seed);
    test_density_integrates_to_one();
    test_cosines_stay_in_range();
    return check_done();
}
