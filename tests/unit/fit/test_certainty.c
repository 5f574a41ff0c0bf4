/* Errors, correlation, and what is not determined: worked out by hand;
 * deterministic but for the last test, which says its chance. */
#include "base/rng.h"
#include "base/stats.h"
#include "check.h"
#include "fit/certainty.h"

#include <float.h>

static murk_certainty certainty_of(const double *jacobian, size_t rows,
                                   size_t n, const bool *is_fixed,
                                   const double *scale)
{
    murk_certainty c = {0};
    murk_error err = {0};
    CHECK(murk_certainty_create(&c, jacobian, rows, n, is_fixed, scale, 1,
                                &err) == MURK_OK);
    CHECK(c.n == n);
    return c;
}

/* Rows 10, 5 and (10, 5): information 200, 100, 50, determinant
 * 200 50 - 50^2 = 7500; covariance 50, 200 and -50 over it. */
static void test_covariance_by_hand(void)
{
    const double jacobian[] = {10, 0, 0, 5, 10, 5};
    for (int k = 0; k < 3; ++k) { /* scales do not matter to it */
        const double scale[] = {1, k == 0 ? 1 : k == 1 ? 7 : .3};
        murk_certainty c = certainty_of(jacobian, 3, 2, NULL, scale);
        CHECK_NEAR(c.covariance[0], 50 / 7500., 1e-15);
        CHECK_NEAR(c.covariance[3], 200 / 7500., 1e-15);
        CHECK_NEAR(c.covariance[1], -50 / 7500., 1e-15);
        CHECK(c.covariance[2] == c.covariance[1]);
        CHECK_NEAR(c.standard_error[0], sqrt(50 / 7500.), 1e-15);
        CHECK_NEAR(c.correlation[1], -.5, 1e-14);
        CHECK(c.correlation[0] == 1 && c.correlation[3] == 1);
        CHECK(c.directions == 2 && c.determined == 2);
        murk_certainty_release(&c);
    }
}

/* x + y alone is known, z for itself: (1, 1, 0) is determined to
 * 1 / sqrt(2) / 10, (1, -1, 0) not at all. */
static void test_what_is_confounded_is_named(void)
{
    const double jacobian[] = {10, 10, 0, 0, 0, 4}, scale[] = {1, 1, 1};
    murk_certainty c = certainty_of(jacobian, 2, 3, NULL, scale);
    CHECK(c.directions == 3 && c.determined == 2);
    CHECK_NEAR(c.direction_error[0], sqrt(.5) / 10, 1e-15);
    CHECK_NEAR(c.direction_error[1], .25, 1e-15);
    CHECK(isinf(c.direction_error[2]));
    CHECK_NEAR(c.direction[0], sqrt(.5), 1e-15);
    CHECK_NEAR(c.direction[1], sqrt(.5), 1e-15);
    CHECK_NEAR(c.direction[2], 0, 1e-15);
    CHECK_NEAR(fabs(c.direction[6]), sqrt(.5), 1e-15);
    CHECK_NEAR(c.direction[6] + c.direction[7], 0, 1e-15);
    CHECK_NEAR(c.direction[8], 0, 1e-15);
    CHECK(isnan(c.standard_error[0]) && isnan(c.standard_error[1]));
    CHECK(isnan(c.covariance[0]) && isnan(c.covariance[1]));
    CHECK(isnan(c.covariance[2]) && isnan(c.correlation[4]));
    CHECK_NEAR(c.standard_error[2], .25, 1e-15);
    CHECK_NEAR(c.covariance[8], .0625, 1e-15);
    murk_certainty_release(&c);
}

/* Nearly confounded: x - y to 5 scales, which is not determined; beside it z
 * reads a hundredth of x - y, and so comes to .05 and more, which it keeps. */
static void test_a_neighbour_keeps_its_whole_error(void)
{
    const double jacobian[] = {10, 10, 0, .2, -.2, 0, 1, -1, 100};
    const double scale[] = {1, 1, 1};
    murk_certainty c = certainty_of(jacobian, 3, 3, NULL, scale);
    CHECK(c.determined == 2);
    CHECK(isnan(c.standard_error[0]) && isnan(c.standard_error[1]));
    /* z = (noise - (x - y)) / 100, and x - y has an error of 1 / .2 */
    CHECK_NEAR(c.standard_error[2], sqrt(1 + 25) / 100, 1e-15);
    murk_certainty_release(&c);
}

/* Nothing tells of y alone, of which a millionth is in what is known of x: y
 * may be anything, but it goes no further than 1000 scales, by which x is off
 * by a thousandth. Of a tenth in it nothing of x would be left. */
static void test_what_has_no_end_is_bounded_in_others(void)
{
    const double scale[] = {1, 1};
    const double little[] = {50, 50e-6}, much[] = {50, 5};
    murk_certainty c = certainty_of(little, 1, 2, NULL, scale);
    CHECK(c.determined == 1 && isinf(c.direction_error[1]));
    CHECK_NEAR(c.standard_error[0], sqrt(4e-4 + 1e-6), 1e-9);
    CHECK(isnan(c.standard_error[1]));
    murk_certainty_release(&c);
    c = certainty_of(much, 1, 2, NULL, scale);
    CHECK(isnan(c.standard_error[0]) && isnan(c.standard_error[1]));
    murk_certainty_release(&c);
}

/* What is held at a bound is taken as known. */
static void test_fixed_is_left_out(void)
{
    const double jacobian[] = {10, 0, 0, 5, 10, 5}, scale[] = {1, 1};
    const bool is_fixed[] = {false, true}, are_fixed[] = {true, true};
    murk_certainty c = certainty_of(jacobian, 3, 2, is_fixed, scale);
    CHECK(c.directions == 1 && c.determined == 1);
    CHECK_NEAR(c.standard_error[0], sqrt(1 / 200.), 1e-15);
    CHECK(isnan(c.standard_error[1]) && isnan(c.covariance[1]));
    CHECK(c.direction[0] == 1 && c.direction[1] == 0);
    murk_certainty_release(&c);
    c = certainty_of(jacobian, 3, 2, are_fixed, scale);
    CHECK(c.directions == 0 && c.determined == 0);
    CHECK(isnan(c.standard_error[0]) && isnan(c.standard_error[1]));
    murk_certainty_release(&c);
}

/* The same where the fixed parameter comes first, so that free ones have other
 * numbers among the free than among all: x fixed, rows (5, 2) and (0, 4) of y
 * and z; information 25, 10, 20, determinant 400. Scales differ. */
static void test_fixed_before_free(void)
{
    const double jacobian[] = {10, 5, 2, 7, 0, 4}, scale[] = {3, .5, .7};
    const bool is_fixed[] = {true, false, false};
    murk_certainty c = certainty_of(jacobian, 2, 3, is_fixed, scale);
    CHECK(c.directions == 2 && c.determined == 2);
    CHECK(isnan(c.standard_error[0]) && isnan(c.covariance[1]));
    CHECK_NEAR(c.standard_error[1], sqrt(20 / 400.), 1e-15);
    CHECK_NEAR(c.standard_error[2], sqrt(25 / 400.), 1e-15);
    CHECK_NEAR(c.covariance[5], -10 / 400., 1e-15);
    CHECK_NEAR(c.correlation[5], -10 / sqrt(20 * 25.), 1e-14);
    CHECK(c.direction[0] == 0 && c.direction[3] == 0);
    CHECK_NEAR(hypot(c.direction[1], c.direction[2]), 1, 1e-15);
    murk_certainty_release(&c);
}

/* Fewer rows than parameters, and rows that depend on nothing. */
static void test_too_few_rows(void)
{
    const double jacobian[] = {0, 3, 4, 0, 0, 0}, scale[] = {1, 1, 1};
    murk_certainty c = certainty_of(jacobian, 1, 3, NULL, scale);
    CHECK(c.determined == 1);
    CHECK_NEAR(c.direction_error[0], .2, 1e-15);
    CHECK_NEAR(c.direction[1], .6, 1e-15);
    CHECK_NEAR(c.direction[2], .8, 1e-15);
    CHECK(isinf(c.direction_error[1]) && isinf(c.direction_error[2]));
    CHECK(isnan(c.standard_error[0]) && isnan(c.standard_error[2]));
    murk_certainty_release(&c);
    c = certainty_of(jacobian + 3, 1, 3, NULL, scale);
    CHECK(c.determined == 0 && isinf(c.direction_error[0]));
    CHECK(isnan(c.standard_error[1]));
    murk_certainty_release(&c);
}

/* 1 / error decides: 1 / .99 is above the scale, 1 / 1.01 below. */
static void test_undetermined_is_by_scale(void)
{
    const double jacobian[] = {.99, 0, 0, 1.01}, scale[] = {1, 1};
    murk_certainty c = certainty_of(jacobian, 2, 2, NULL, scale);
    CHECK(c.determined == 1);
    CHECK(isnan(c.standard_error[0]));
    CHECK_NEAR(c.standard_error[1], 1 / 1.01, 1e-15);
    murk_certainty_release(&c);
    const double larger[] = {1.1, 1};
    c = certainty_of(jacobian, 2, 2, NULL, larger);
    CHECK(c.determined == 2);
    CHECK_NEAR(c.standard_error[0], 1 / .99, 1e-15);
    murk_certainty_release(&c);
}

/* Units twelve orders apart, and two rows that differ by a ten-thousandth: in
 * plain units the information's condition is 1e32. */
static void test_steep_scales_keep_their_digits(void)
{
    const double jacobian[] = {1e6, 1e-6, 1e6, 1.0001e-6};
    const double scale[] = {1, 1e12};
    murk_certainty c = certainty_of(jacobian, 2, 2, NULL, scale);
    CHECK(c.determined == 2);
    /* the inverse of a square Jacobian, row by row */
    const double det = 1e6 * 1e-10;
    const double first = sqrt(1.0001 * 1.0001 + 1) * 1e-6 / det;
    const double second = sqrt(2) * 1e6 / det;
    CHECK_NEAR(c.standard_error[0] / first, 1, 1e-9);
    CHECK_NEAR(c.standard_error[1] / second, 1, 1e-9);
    murk_certainty_release(&c);
}

static void refuse(double slope, double scale, double undetermined,
                   const char *text)
{
    murk_certainty c = {0};
    murk_error err = {0};
    CHECK(murk_certainty_create(&c, &slope, 1, 1, NULL, &scale, undetermined,
                                &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, text);
    CHECK(c.covariance == NULL);
}

static void test_refusals(void)
{
    refuse(NAN, 1, 1, "row 1 depends on parameter 0 by nan, must be finite");
    refuse(INFINITY, 1, 1, "row 1 depends on parameter 0 by inf");
    refuse(1, 0, 1, "the scale of parameter 0 is 0, must be above 0");
    refuse(1, NAN, 1, "the scale of parameter 0 is nan");
    refuse(1, 1, 0, "undetermined is 0, must be above 0");
    refuse(1, 1, NAN, "undetermined is nan");
}

/* A line through twelve readings with an error of 1, fitted 4000 times: how
 * often its slope is within one and two standard errors of the true one. Two
 * counts with a binomial sigma share a 1e-6 chance of a false alarm. */
#define FITS     4000
#define READINGS 12

static void count_within(double factor, double sigmas[2])
{
    double jacobian[READINGS * 2];
    const double scale[] = {1, 1};
    for (size_t i = 0; i < READINGS; ++i) {
        jacobian[2 * i] = 1;
        jacobian[2 * i + 1] = (double)i;
    }
    murk_certainty c = certainty_of(jacobian, READINGS, 2, NULL, scale);
    int within[2] = {0};
    for (uint64_t fit = 0; fit < FITS; ++fit) {
        double sum[2] = {0}; /* J^T noise */
        for (uint32_t i = 0; i < READINGS; ++i) {
            const murk_random4 r = murk_random(3, MURK_TEST, fit, i, 0);
            const double noise =
                sqrt(-2 * log(r.u[0])) * cos(6.283185307179586 * r.u[1]);
            sum[0] += noise;
            sum[1] += noise * i;
        }
        const double off =
            fabs(c.covariance[2] * sum[0] + c.covariance[3] * sum[1]);
        within[0] += off < factor * c.standard_error[1];
        within[1] += off < 2 * factor * c.standard_error[1];
    }
    for (int k = 0; k < 2; ++k) {
        const double p = erf((k + 1) / sqrt(2));
        sigmas[k] = sigmas_off(within[k], FITS * p, sqrt(FITS * p * (1 - p)));
    }
    murk_certainty_release(&c);
}

static void test_errors_are_those_of_repeated_fits(void)
{
    const double limit = murk_sidak_limit(1e-6, 2);
    double off[2];
    count_within(1, off);
    CHECK(off[0] <= limit && off[1] <= limit);
    count_within(1.15, off); /* teeth */
    CHECK(off[0] > limit && off[1] > limit);
}

int main(void)
{
    test_covariance_by_hand();
    test_what_is_confounded_is_named();
    test_a_neighbour_keeps_its_whole_error();
    test_what_has_no_end_is_bounded_in_others();
    test_fixed_is_left_out();
    test_fixed_before_free();
    test_too_few_rows();
    test_undetermined_is_by_scale();
    test_steep_scales_keep_their_digits();
    test_refusals();
    test_errors_are_those_of_repeated_fits();
    return check_done();
}
