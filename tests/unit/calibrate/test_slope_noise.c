/* What noise in slopes does to least squares, and that it is undone: on linear
 * problems of plain numbers, whose noise is known. The Monte Carlo check has a
 * chance of 1e-6 of a false alarm; the rest is exact. */
#include "base/rng.h"
#include "base/stats.h"
#include "base/vector.h"
#include "calibrate/slope_noise.h"
#include "check.h"

#include <stdlib.h>

#define ROWS 400
#define N    2

static double normal(uint32_t seed, uint64_t i, uint32_t j)
{
    const murk_random4 u = murk_random(seed, MURK_TEST, i, j, 0);
    return sqrt(-2 * log(u.u[0])) * cos(2 * MURK_PI * u.u[1]);
}

/* Slopes of rows, about alike in size along both parameters. */
static void make_jacobian(double *jacobian)
{
    for (size_t i = 0; i < ROWS; ++i) {
        jacobian[i * N] = 1 + .5 * sin((double)i);
        jacobian[i * N + 1] = cos(2.3 * (double)i);
    }
}

static void square(double *out, const double *rows, size_t n_rows)
{
    for (size_t k = 0; k < N * N; ++k) {
        out[k] = 0;
        for (size_t i = 0; i < n_rows; ++i) {
            out[k] += rows[i * N + k / N] * rows[i * N + k % N];
        }
    }
}

/* a b of [N][N]. */
static void multiply(double *out, const double *a, const double *b)
{
    for (size_t k = 0; k < N * N; ++k) {
        out[k] = 0;
        for (size_t j = 0; j < N; ++j) {
            out[k] += a[k / N * N + j] * b[j * N + k % N];
        }
    }
}

static void invert(double *out, const double *a)
{
    const double det = a[0] * a[3] - a[1] * a[2];
    out[0] = a[3] / det;
    out[1] = -a[1] / det;
    out[2] = -a[2] / det;
    out[3] = a[0] / det;
}

static murk_slope_noise noise_of(double *bias, double *noise, double share)
{
    return (murk_slope_noise){.bias = bias, .noise = noise, .share = share};
}

/* Two rows, one parameter, by hand. The run is off by f = 1 and 3, its slopes
 * by 2 and -1; slopes of residuals are 10 and 20. Noise that values share with
 * slopes draws by sum f J = 2 - 3, weights of the same photons by
 * (sum slope f) (sum f^2) = 70 * 10; slopes' own noise is 4 + 1. */
static void test_bias_of_a_run(void)
{
    const double off[] = {1, 2, 3, -1}, jacobian[] = {10, 20};
    double bias[] = {0}, noise[] = {0};
    murk_slope_noise sum = noise_of(bias, noise, 0);
    murk_slope_noise_add(&sum, off, jacobian, 2, 1);
    CHECK_NEAR(bias[0], 700 - 1, 1e-12);
    CHECK_NEAR(noise[0], 5, 1e-14);
    CHECK_NEAR(sum.share, 10, 1e-14);
    murk_slope_noise_add(&sum, off, jacobian, 2, 1); /* runs add up */
    CHECK_NEAR(bias[0], 2 * 699, 1e-12);
    CHECK_NEAR(noise[0], 10, 1e-14);
}

static void test_offset_moves_rows_by_the_bias(void)
{
    double jacobian[ROWS * N], offset[ROWS] = {0}, bias[N] = {.7, -.3};
    double none[N * N] = {0};
    make_jacobian(jacobian);
    const murk_slope_noise noise = noise_of(bias, none, 0);
    murk_error err = {0};
    CHECK(!murk_slope_noise_offset(offset, &noise, jacobian, ROWS, N, &err));
    for (size_t k = 0; k < N; ++k) {
        double sum = 0;
        for (size_t i = 0; i < ROWS; ++i) {
            sum += jacobian[i * N + k] * offset[i];
        }
        CHECK_NEAR(sum, -bias[k], 1e-12);
    }
}

/* The search ends where J^T (residual + offset) = 0. There no step of the
 * corrected equations is left, so both corrections have one sign: residuals
 * that are minus the offset are such an end. */
static void test_no_step_is_left_at_the_offset(void)
{
    double jacobian[ROWS * N], offset[ROWS] = {0}, residual[ROWS];
    double bias[N] = {.7, -.3}, none[N * N] = {0}, step[N], length;
    make_jacobian(jacobian);
    const murk_slope_noise noise = noise_of(bias, none, 0);
    murk_error err = {0};
    CHECK(!murk_slope_noise_offset(offset, &noise, jacobian, ROWS, N, &err));
    for (size_t i = 0; i < ROWS; ++i) {
        residual[i] = -offset[i];
    }
    CHECK(!murk_slope_noise_step(step, &length, &noise, residual, jacobian,
                                 ROWS, N, &err));
    CHECK_NEAR(length, 0, 1e-12);
    /* the offset of the other sign would leave a step of this length */
    CHECK(!murk_slope_noise_step(step, &length, &noise, offset, jacobian, ROWS,
                                 N, &err));
    CHECK(length > .01);
}

/* A^-1 (A + (1 + phi) N) A^-1, with A = J^T J - N: written out. */
static void test_information_is_the_sandwich(void)
{
    double jacobian[ROWS * N], bias[N] = {0};
    double noisy[N * N] = {60, 20, 20, 50};
    const double share = .4;
    make_jacobian(jacobian);
    const murk_slope_noise noise = noise_of(bias, noisy, share);
    double rows[N * N], max, said[N * N];
    murk_error err = {0};
    CHECK(!murk_slope_noise_information(rows, &max, &noise, jacobian, ROWS, N,
                                        &err));
    square(said, rows, N);
    double a[N * N], middle[N * N], inverse[N * N], left[N * N], wanted[N * N];
    square(a, jacobian, ROWS);
    for (size_t k = 0; k < N * N; ++k) {
        a[k] -= noisy[k];
        middle[k] = a[k] + (1 + share) * noisy[k];
    }
    invert(inverse, a);
    multiply(left, inverse, middle);
    multiply(wanted, left, inverse);
    double covariance[N * N];
    invert(covariance, said);
    for (size_t k = 0; k < N * N; ++k) {
        CHECK_NEAR(covariance[k], wanted[k], 1e-13);
    }
    CHECK(max > 0 && max < 1);
    /* without noise: J^T J */
    double none[N * N] = {0}, plain[N * N];
    const murk_slope_noise no_noise = noise_of(bias, none, share);
    CHECK(!murk_slope_noise_information(rows, &max, &no_noise, jacobian, ROWS,
                                        N, &err));
    square(said, rows, N);
    square(plain, jacobian, ROWS);
    for (size_t k = 0; k < N * N; ++k) {
        CHECK_NEAR(said[k], plain[k], 1e-12 * plain[0]);
    }
    CHECK(max == 0);
}

/* Where all that a direction tells is noise, nothing is known along it, and no
 * step goes there; the other stays. */
static void test_noise_alone_tells_nothing(void)
{
    double jacobian[ROWS * N], bias[N] = {0}, squares[N * N];
    make_jacobian(jacobian);
    square(squares, jacobian, ROWS);
    double noisy[N * N] = {0, 0, 0, 0};
    for (size_t i = 0; i < ROWS; ++i) {
        jacobian[i * N + 1] *= .01;
    }
    noisy[3] = 2 * squares[3] * 1e-4;
    const murk_slope_noise noise = noise_of(bias, noisy, 0);
    double rows[N * N], max, residual[ROWS], step[N], length;
    murk_error err = {0};
    CHECK(!murk_slope_noise_information(rows, &max, &noise, jacobian, ROWS, N,
                                        &err));
    CHECK(max > 1);
    double said[N * N];
    square(said, rows, N);
    CHECK(said[0] > .9 * squares[0]);
    CHECK_NEAR(said[0] * said[3] - said[1] * said[2], 0, 1e-9 * squares[0]);
    for (size_t i = 0; i < ROWS; ++i) {
        residual[i] = -jacobian[i * N];
    }
    CHECK(!murk_slope_noise_step(step, &length, &noise, residual, jacobian,
                                 ROWS, N, &err));
    CHECK_NEAR(step[0], 1, .05);
    CHECK(fabs(step[1]) < 1); /* plain least squares would allow any */
}

static void test_noise_without_end_is_refused(void)
{
    double jacobian[ROWS * N], bias[N] = {0};
    double noisy[N * N] = {1, 0, 0, INFINITY};
    make_jacobian(jacobian);
    const murk_slope_noise noise = noise_of(bias, noisy, 0);
    double rows[N * N], max;
    murk_error err = {0};
    CHECK(murk_slope_noise_information(rows, &max, &noise, jacobian, ROWS, N,
                                       &err) == MURK_RUN_FAILED);
    CHECK_MENTIONS(err.text, "not finite");
}

/* ---- many problems ---- */

#define TRIES  500
#define SPREAD .5 /* of slopes, in errors of rows */

/* Rows y = J x + e with x = 0 and unit errors, of which photons' noise is the
 * part `common`: it is also in the slopes that are seen. */
typedef struct estimates {
    double plain[TRIES], undone[TRIES], squares;
} estimates;

static void solve_one(estimates *out, uint32_t t)
{
    const double common = .6;
    double truth[ROWS * N], seen[ROWS * N], residual[ROWS];
    make_jacobian(truth);
    for (uint32_t i = 0; i < ROWS; ++i) {
        const double photons = normal(3, t, i * 4);
        /* residual: what was measured less what is predicted; slopes are of
         * residuals, the other way round */
        residual[i] = .8 * normal(3, t, i * 4 + 1) - common * photons;
        for (uint32_t k = 0; k < N; ++k) {
            seen[i * N + k] =
                truth[i * N + k] -
                SPREAD * (k == 0 ? photons : normal(3, t, i * 4 + 2));
        }
    }
    double bias[N] = {ROWS * common * SPREAD, 0};
    double noisy[N * N] = {ROWS * SPREAD * SPREAD, 0, 0,
                           ROWS * SPREAD * SPREAD};
    const murk_slope_noise noise = noise_of(bias, noisy, common * common);
    double none[N] = {0}, nothing[N * N] = {0}, length;
    const murk_slope_noise no_noise = noise_of(none, nothing, 0);
    double step[N], plain[N], rows[N * N], max;
    murk_error err = {0};
    CHECK(!murk_slope_noise_step(step, &length, &noise, residual, seen, ROWS, N,
                                 &err));
    CHECK(!murk_slope_noise_step(plain, &length, &no_noise, residual, seen,
                                 ROWS, N, &err));
    CHECK(
        !murk_slope_noise_information(rows, &max, &noise, seen, ROWS, N, &err));
    out->plain[t] = plain[0];
    out->undone[t] = step[0];
    for (size_t q = 0; q < N; ++q) {
        const double along = rows[q * N] * step[0] + rows[q * N + 1] * step[1];
        out->squares += along * along;
    }
}

static void test_bias_is_undone(void)
{
    static estimates e;
    for (uint32_t t = 0; t < TRIES; ++t) {
        solve_one(&e, t);
    }
    const murk_estimate undone = murk_mean_estimate(e.undone, TRIES);
    const murk_estimate plain = murk_mean_estimate(e.plain, TRIES);
    printf("mean of the fits %.4f +- %.4f, taking slopes for exact %.4f; "
           "chi2 %.3f of %d\n",
           undone.value, undone.standard_error, plain.value, e.squares / TRIES,
           N);
    CHECK(sigmas_off(undone.value, 0, undone.standard_error) <
          sigmas_off(plain.value, 0, plain.standard_error) / 10);
    CHECK(fabs(undone.value) < .1 * fabs(plain.value));
    CHECK(sigmas_off(plain.value, 0, plain.standard_error) >
          2 * murk_sidak_limit(1e-6, 1));
    /* errors are as said, to what the bound on joint noise may add */
    CHECK(e.squares / TRIES > .7 * N && e.squares / TRIES < 1.1 * N);
}

int main(void)
{
    test_bias_of_a_run();
    test_offset_moves_rows_by_the_bias();
    test_no_step_is_left_at_the_offset();
    test_information_is_the_sandwich();
    test_noise_alone_tells_nothing();
    test_noise_without_end_is_refused();
    test_bias_is_undone();
    return check_done();
}
