/* Whitened noise is white: 36 sample covariances share a 1e-6 chance of a false
 * alarm per seed; seeds are fixed. */
#include "base/rng.h"
#include "base/stats.h"
#include "check.h"
#include "fit/whitening.h"

#include <stdlib.h>

#define ROWS    8
#define SAMPLES 20000

/* Three sources that rows share, and one of each row's own. */
#define SHARED 3
static const double mixing[ROWS][SHARED] = {
    {1, 0, 2},   {.5, -1, 0}, {3, 1, 1},  {0, 2, -2},
    {1, 1, 1.5}, {-2, 0, 1},  {.1, 4, 0}, {0, 0, 5},
};

static double own(size_t row)
{
    return .2 + .3 * (double)row;
}

static double normal(uint64_t sample, uint32_t source)
{
    const murk_random4 r = murk_random(1, MURK_TEST, sample, source, 0);
    return sqrt(-2 * log(r.u[0])) * cos(6.283185307179586 * r.u[1]);
}

static void draw(double *row, uint64_t sample)
{
    for (uint32_t i = 0; i < ROWS; ++i) {
        row[i] = own(i) * normal(sample, SHARED + i);
        for (uint32_t k = 0; k < SHARED; ++k) {
            row[i] += mixing[i][k] * normal(sample, k);
        }
    }
}

/* Where factor is 1, that of draw(). */
static void covariance_of_rows(double *covariance, double factor)
{
    for (size_t i = 0; i < ROWS; ++i) {
        for (size_t j = 0; j < ROWS; ++j) {
            double sum = i == j ? own(i) * own(i) : 0;
            for (size_t k = 0; k < SHARED; ++k) {
                sum += mixing[i][k] * mixing[j][k];
            }
            covariance[i * ROWS + j] = factor * sum;
        }
    }
}

/* The largest deviation of the sample covariances in standard errors: the
 * mean of N products of independent normals has a variance of 1 / N, that
 * of N squares has 2 / N. */
static double worst_off(double factor)
{
    /* Whitening by the covariance of the rows, times a factor. */
    double covariance[ROWS * ROWS], sum[ROWS * ROWS] = {0}, worst = 0;
    covariance_of_rows(covariance, factor);
    murk_whitening *whitening = NULL;
    murk_error err = {0};
    CHECK(murk_whitening_create(&whitening, covariance, ROWS, &err) == MURK_OK);
    if (!whitening) {
        return INFINITY;
    }
    /* Sample covariances of whitened rows. */
    for (uint64_t s = 0; s < SAMPLES; ++s) {
        double row[ROWS];
        draw(row, s);
        murk_whitening_apply(whitening, row, 1);
        for (size_t i = 0; i < ROWS; ++i) {
            for (size_t j = 0; j <= i; ++j) {
                sum[i * ROWS + j] += row[i] * row[j] / SAMPLES;
            }
        }
    }
    /* Covariances of white noise are 1 in the diagonal, otherwise 0. */
    for (size_t i = 0; i < ROWS; ++i) {
        for (size_t j = 0; j <= i; ++j) {
            const double off = sigmas_off(sum[i * ROWS + j], i == j,
                                          sqrt((i == j ? 2. : 1.) / SAMPLES));
            worst = off > worst ? off : worst;
        }
    }
    murk_whitening_destroy(whitening);
    return worst;
}

static void test_whitened_noise_is_white(void)
{
    CHECK(worst_off(1) <= murk_sidak_limit(1e-6, ROWS * (ROWS + 1) / 2.));
}

/* Teeth: a covariance that is a tenth too large. */
static void test_would_notice_a_wrong_covariance(void)
{
    CHECK(worst_off(1.1) > murk_sidak_limit(1e-6, ROWS * (ROWS + 1) / 2.));
}

/* [[4, 2], [2, 10]] = L L^T with L = [[2, 0], [1, 3]]. */
static void test_columns_by_hand(void)
{
    const double covariance[] = {4, 2, 2, 10};
    double a[] = {2, 4, 8, 4, 8, 1}; /* three columns */
    const double want[] = {1, 2, 4, 1, 2, -1};
    murk_whitening *whitening = NULL;
    CHECK(murk_whitening_create(&whitening, covariance, 2, NULL) == MURK_OK);
    if (whitening) {
        murk_whitening_apply(whitening, a, 3);
    }
    for (size_t i = 0; i < 6; ++i) {
        CHECK_NEAR(a[i], want[i], 1e-15);
    }
    murk_whitening_destroy(whitening);
    murk_whitening_destroy(NULL);
}

static void refuse(double a, double b, double c, const char *text)
{
    const double covariance[] = {a, b, b, c};
    murk_whitening *whitening = NULL;
    murk_error err = {0};
    CHECK(murk_whitening_create(&whitening, covariance, 2, &err) ==
          MURK_RUN_FAILED);
    CHECK(whitening == NULL);
    CHECK_MENTIONS(err.text, text);
}

static void test_refusals(void)
{
    refuse(1, 0, 0, "row 2 has a variance of 0, must be above 0");
    refuse(NAN, 0, 1, "row 1 has a variance of nan");
    refuse(1, 0, INFINITY, "row 2 has a variance of inf");
    refuse(1, NAN, 1, "rows 1 and 2 have a covariance of nan");
    refuse(1, 1, 1, "is not positive definite");
    refuse(1, 2, 1, "is not positive definite");
    /* of three rows, each pair by itself */
    static const size_t pair[][2] = {{0, 1}, {0, 2}, {1, 2}};
    for (size_t k = 0; k < 3; ++k) {
        const size_t i = pair[k][0], j = pair[k][1];
        double covariance[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        covariance[3 * i + j] = covariance[3 * j + i] = INFINITY;
        murk_whitening *whitening = NULL;
        murk_error err = {0};
        char text[80];
        CHECK(murk_whitening_create(&whitening, covariance, 3, &err) ==
              MURK_RUN_FAILED);
        snprintf(text, sizeof text, "rows %zu and %zu have a covariance of inf",
                 i + 1, j + 1);
        CHECK_MENTIONS(err.text, text);
    }
}

/* Batches of two rows: (1, 10), (2, 14), (6, 12); means 3, 12; off by
 * (-2, -2), (-1, 2), (3, 0): sums of products 14, 2, 8, times 3/2. It adds to
 * what is there. */
static void test_batches_by_hand(void)
{
    const double batch[] = {1, 10, 2, 14, 6, 12};
    double covariance[] = {100, 200, 200, 300};
    murk_covariance_of_batches(covariance, batch, 3, 2);
    CHECK_NEAR(covariance[0], 100 + 21, 1e-12);
    CHECK_NEAR(covariance[1], 200 + 3, 1e-12);
    CHECK(covariance[2] == covariance[1]);
    CHECK_NEAR(covariance[3], 300 + 12, 1e-12);
}

/* Differences alone count: 1e8 beneath costs no more digits than the values
 * themselves have. */
static void test_batches_keep_their_digits(void)
{
    const double batch[] = {1e8 + 1,  1e8 + 10, 1e8 + 2,
                            1e8 + 14, 1e8 + 6,  1e8 + 12};
    double covariance[4] = {0};
    murk_covariance_of_batches(covariance, batch, 3, 2);
    CHECK_NEAR(covariance[0], 21, 1e-12);
    CHECK_NEAR(covariance[1], 3, 1e-12);
    CHECK_NEAR(covariance[3], 12, 1e-12);
}

int main(void)
{
    test_whitened_noise_is_white();
    test_would_notice_a_wrong_covariance();
    test_columns_by_hand();
    test_refusals();
    test_batches_by_hand();
    test_batches_keep_their_digits();
    return check_done();
}
