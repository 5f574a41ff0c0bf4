/* Bounded linear problems against a simple twin: coordinates in turn, each to
 * its best within its bounds, until nothing moves. Deterministic. */
#include "base/rng.h"
#include "check.h"
#include "fit/least_squares.h"

#include <float.h>

#define N          4
#define ROWS       6
#define PROBLEMS   300
#define SWEEPS_MAX 100000

typedef struct linear {
    double slope[ROWS * N], target[ROWS], lower[N], upper[N];
} linear;

static bool residuals(void *context, const double *x, double *residual,
                      double *jacobian)
{
    const linear *p = context;
    for (size_t i = 0; i < ROWS; ++i) {
        residual[i] = -p->target[i];
        for (size_t j = 0; j < N; ++j) {
            residual[i] += p->slope[i * N + j] * x[j];
        }
    }
    if (jacobian) {
        memcpy(jacobian, p->slope, sizeof p->slope);
    }
    return true;
}

static double cost_at(const linear *p, const double *x)
{
    double residual[ROWS], sum = 0;
    (void)residuals((void *)p, x, residual, NULL);
    for (size_t i = 0; i < ROWS; ++i) {
        sum += residual[i] * residual[i] / 2;
    }
    return sum;
}

/* All columns lie within .2 of one, so parameters are hard to tell apart. */
static linear draw(uint64_t number)
{
    linear p;
    for (uint32_t i = 0; i < ROWS; ++i) {
        const murk_random4 a = murk_random(1, MURK_TEST, number, i, 0);
        const murk_random4 b = murk_random(1, MURK_TEST, number, i, 1);
        for (size_t j = 0; j < N; ++j) {
            p.slope[i * N + j] = b.u[0] + .2 * a.u[j];
        }
        p.target[i] = 4 * b.u[1] - 2;
    }
    for (uint32_t j = 0; j < N; ++j) {
        const murk_random4 c = murk_random(1, MURK_TEST, number, j, 2);
        p.lower[j] = c.u[0] < .2 ? -INFINITY : -2 * c.u[1];
        p.upper[j] = c.u[0] > .8 ? INFINITY : 2 * c.u[2];
    }
    return p;
}

static double twin(const linear *p)
{
    double x[N] = {0};
    for (int sweep = 0; sweep < SWEEPS_MAX; ++sweep) {
        double moved = 0;
        for (size_t j = 0; j < N; ++j) {
            double residual[ROWS], slope = 0, curvature = 0;
            (void)residuals((void *)p, x, residual, NULL);
            for (size_t i = 0; i < ROWS; ++i) {
                slope += residual[i] * p->slope[i * N + j];
                curvature += p->slope[i * N + j] * p->slope[i * N + j];
            }
            const double to =
                fmin(fmax(x[j] - slope / curvature, p->lower[j]), p->upper[j]);
            moved = fmax(moved, fabs(to - x[j]));
            x[j] = to;
        }
        if (moved < DBL_EPSILON) {
            break;
        }
    }
    return cost_at(p, x);
}

/* To the tolerance that is the default. */
static void test_nobody_finds_less(void)
{
    size_t at_bounds = 0;
    for (uint64_t number = 0; number < PROBLEMS; ++number) {
        linear l = draw(number);
        const murk_least_squares p = {.n = N,
                                      .rows = ROWS,
                                      .lower = l.lower,
                                      .upper = l.upper,
                                      .residuals = residuals,
                                      .context = &l};
        murk_least_squares_found found;
        double x[N] = {0};
        CHECK(murk_least_squares_solve(&found, x, &p, NULL) == MURK_OK);
        CHECK(found.end == MURK_LEAST_SQUARES_CONVERGED);
        const double min = twin(&l);
        CHECK(found.cost <= min * (1 + 1e-10));
        CHECK_NEAR(found.cost, cost_at(&l, x), 1e-12);
        for (size_t j = 0; j < N; ++j) {
            CHECK(x[j] >= l.lower[j] && x[j] <= l.upper[j]);
            at_bounds += x[j] == l.lower[j] || x[j] == l.upper[j];
        }
    }
    CHECK(at_bounds > PROBLEMS); /* or it would be no test of bounds */
}

int main(void)
{
    test_nobody_finds_less();
    return check_done();
}
