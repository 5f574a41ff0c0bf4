/* Estimates and limits against figures worked out by hand or published. */
#include "base/stats.h"
#include "check.h"

/* x = 1 0 1, y = 1 1 2 of three units: C = 1/2, residuals 1/2 -1/2 0,
 * se^2 = 3/2 * 1/2 / 16. */
static void test_ratio(void)
{
    const double x[3] = {1, 0, 1}, y[3] = {1, 1, 2};
    const murk_estimate e = murk_ratio_estimate(x, y, 3, 3);
    CHECK(e.value == 0.5);
    CHECK_NEAR(e.standard_error, sqrt(0.75 / 16), 1e-15);
    const murk_estimate none = murk_ratio_estimate(x, y, 0, 3);
    CHECK(isnan(none.value));
    const murk_estimate one = murk_ratio_estimate(x, y, 1, 1);
    CHECK(one.value == 1 && isnan(one.standard_error));
    const double zero[2] = {0, 0};
    CHECK(isnan(murk_ratio_estimate(x, zero, 2, 2).value));
    /* two units, of which one is left out: it counts as nothing */
    const murk_estimate two = murk_ratio_estimate(x + 1, y + 1, 2, 2);
    CHECK_NEAR(two.value, 1. / 3, 1e-15);
    CHECK_NEAR(two.standard_error, sqrt(2. * 2 / 9) / 3, 1e-15);
}

static void test_mean(void)
{
    const double x[4] = {1, 2, 3, 4};
    const murk_estimate e = murk_mean_estimate(x, 4);
    CHECK(e.value == 2.5);
    CHECK_NEAR(e.standard_error, sqrt(5.0 / 12), 1e-15);
    const murk_estimate one = murk_mean_estimate(x + 2, 1);
    CHECK(one.value == 3 && isnan(one.standard_error));
    const murk_estimate two = murk_mean_estimate(x, 2);
    CHECK(two.value == 1.5 && two.standard_error == 0.5);
    CHECK(isnan(murk_mean_estimate(x, 0).value));
}

/* Two-sided 5 % is 1.959964; eleven checks within 1e-6 give 5.34 (style). */
static void test_limits(void)
{
    CHECK_NEAR(murk_normal_upper(0.025), 1.959963984540054, 1e-12);
    CHECK_NEAR(murk_normal_upper(0.5), 0, 1e-12);
    CHECK_NEAR(murk_sidak_limit(0.05, 1), 1.959963984540054, 1e-12);
    CHECK_NEAR(murk_sidak_limit(1e-6, 11), 5.34, 0.005);
}

/* Closed forms: with one degree of freedom erfc, with an even number a Poisson
 * sum (Abramowitz & Stegun 26.4.21); both branches, far tails, and arguments
 * that have no probability. */
static void test_chi2_upper(void)
{
    for (double x = .01; x < 1000; x *= 1.7) {
        const double one = erfc(sqrt(x / 2));
        CHECK_NEAR(murk_chi2_upper(x, 1), one, 1e-9 * one);
        double term = exp(-x / 2), sum = 0;
        for (int half = 1; half <= 40; ++half) {
            sum += term;
            term *= x / 2 / half;
            CHECK_NEAR(murk_chi2_upper(x, 2 * half), sum, 1e-9 * sum);
        }
    }
    /* the median of chi-squared is n (1 - 2 / (9 n))^3 to 1 / n^2 */
    CHECK_NEAR(murk_chi2_upper(1e4 * pow(1 - 2 / 9e4, 3), 1e4), .5, 1e-4);
    CHECK(murk_chi2_upper(0, 3) == 1);
    CHECK(murk_chi2_upper(INFINITY, 3) == 0);
    CHECK(isnan(murk_chi2_upper(1, 0)));
    CHECK(isnan(murk_chi2_upper(NAN, 3)));
    CHECK(isnan(murk_chi2_upper(-1, 3)));
}

int main(void)
{
    test_ratio();
    test_mean();
    test_limits();
    test_chi2_upper();
    return check_done();
}
