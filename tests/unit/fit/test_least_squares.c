/* Least squares: bounds, losses, the watch, refusals.
 * Answers are worked out by hand; deterministic, no false alarms. */
#include "check.h"
#include "fit/least_squares.h"
#include "unbounded.h"

#include <string.h>

/* How far x may be off where the cost may be too high by `tolerance` of it. */
static double slack(double tolerance, double cost, double curvature)
{
    return sqrt(2 * tolerance * cost / curvature);
}

/* A long valley across the bounds: 1000 (x - y), x + y - 4. */
static bool valley(void *context, const double *x, double *residual,
                   double *jacobian)
{
    (void)context;
    residual[0] = 1000 * (x[0] - x[1]);
    residual[1] = x[0] + x[1] - 4;
    if (jacobian) {
        const double slope[] = {1000, -1000, 1, 1};
        memcpy(jacobian, slope, sizeof slope);
    }
    return true;
}

/* With x = 1 at its bound, 1e6 (1 - y)^2 + (y - 3)^2 is least at
 * (1e6 + 3) / (1e6 + 1). */
static void test_bound_is_active(void)
{
    const double upper[] = {1, 50};
    const murk_least_squares p = {.n = 2,
                                  .rows = 2,
                                  .lower = none_below,
                                  .upper = upper,
                                  .residuals = valley};
    double x[] = {-40, 7};
    const murk_least_squares_found found = solve(x, &p);
    CHECK(found.end == MURK_LEAST_SQUARES_CONVERGED);
    CHECK(x[0] == 1);
    CHECK_NEAR(x[1], (1e6 + 3) / (1e6 + 1), slack(1e-10, found.cost, 1e6 + 1));
}

/* x - y, y + 1 from (1, 5): x presses against 1 at first, and ends at 0 with
 * y = -1/2, where y^2 + (y + 1)^2 is least. */
static bool turning(void *context, const double *x, double *residual,
                    double *jacobian)
{
    (void)context;
    residual[0] = x[0] - x[1];
    residual[1] = x[1] + 1;
    if (jacobian) {
        const double slope[] = {1, -1, 0, 1};
        memcpy(jacobian, slope, sizeof slope);
    }
    return true;
}

static void test_bound_is_left_again(void)
{
    const double lower[] = {0, -10}, upper[] = {1, 10};
    const murk_least_squares p = {.n = 2,
                                  .rows = 2,
                                  .lower = lower,
                                  .upper = upper,
                                  .residuals = turning};
    double x[] = {1, 5};
    const murk_least_squares_found found = solve(x, &p);
    CHECK(found.end == MURK_LEAST_SQUARES_CONVERGED);
    CHECK(x[0] == 0);
    CHECK_NEAR(x[1], -.5, slack(1e-10, found.cost, 2));
    CHECK_NEAR(found.initial_cost, (16. + 36) / 2, 0);
    CHECK_NEAR(found.cost, .25, 1e-10);
}

static void test_fixed_stays(void)
{
    const double lower[] = {-INFINITY, .3}, upper[] = {INFINITY, .3};
    const murk_least_squares p = {.n = 2,
                                  .rows = 2,
                                  .lower = lower,
                                  .upper = upper,
                                  .residuals = turning};
    double x[] = {100, .3};
    const murk_least_squares_found one = solve(x, &p);
    CHECK(one.end == MURK_LEAST_SQUARES_CONVERGED);
    CHECK(x[1] == .3);
    CHECK_NEAR(x[0], .3, slack(1e-10, one.cost, 1));

    double fixed[] = {.1, .3};
    const double here[] = {.1, .3};
    const murk_least_squares all = {
        .n = 2, .rows = 2, .lower = here, .upper = here, .residuals = turning};
    const murk_least_squares_found found = solve(fixed, &all);
    CHECK(found.end == MURK_LEAST_SQUARES_CONVERGED);
    CHECK_TEXT(found.why, "every parameter is fixed or held by a bound");
    CHECK_NEAR(found.cost, (.04 + 1.69) / 2, 1e-15);
}

/* Where a value lies, with one wild reading. */
#define READINGS 6
static const double readings[READINGS] = {0, .1, -.1, .05, -.05, 100};

static bool location(void *context, const double *x, double *residual,
                     double *jacobian)
{
    (void)context;
    for (size_t i = 0; i < READINGS; ++i) {
        residual[i] = x[0] - readings[i];
        if (jacobian) {
            jacobian[i] = 1;
        }
    }
    return true;
}

static murk_least_squares location_problem(murk_loss_function loss)
{
    return (murk_least_squares){.n = 1,
                                .rows = READINGS,
                                .lower = none_below,
                                .upper = none_above,
                                .residuals = location,
                                .loss = loss,
                                .loss_width = 1,
                                .tolerance = 1e-15};
}

/* Plain: the mean. Huber: the wild one pulls with 1, so 5 x = 1. Cauchy: the
 * pulls r / (1 + r^2) cancel. A loss over all rows together, in place of each
 * apart, would leave the mean where it is. */
static void test_losses_act_on_each_row(void)
{
    double x = 50;
    murk_least_squares p = location_problem(MURK_LOSS_FUNCTION_NONE);
    murk_least_squares_found found = solve(&x, &p);
    CHECK_NEAR(x, 100. / 6, slack(p.tolerance, found.cost, READINGS));
    x = 50;
    p = location_problem(MURK_LOSS_FUNCTION_HUBER);
    found = solve(&x, &p);
    CHECK_NEAR(x, .2, slack(p.tolerance, found.cost, READINGS - 1));
    /* 1/2 sum of r^2, and of 2 r - 1 */
    CHECK_NEAR(found.cost, (.04 + .01 + .09 + .0225 + .0625 + 198.6) / 2, 1e-9);
    x = 1;
    p = location_problem(MURK_LOSS_FUNCTION_CAUCHY);
    found = solve(&x, &p);
    double pull = 0, cost = 0;
    for (size_t i = 0; i < READINGS; ++i) {
        const double r = x - readings[i];
        pull += r / (1 + r * r);
        cost += log(1 + r * r) / 2;
    }
    CHECK(fabs(x) < .05);
    CHECK_NEAR(pull, 0, 5 * slack(p.tolerance, cost, 5));
    CHECK_NEAR(found.cost, cost, 1e-12);
}

typedef struct story {
    int calls, stop_at;
    bool is_in_order, has_fallen;
    double cost, x;
} story;

static bool listen(void *context, const murk_least_squares_step *step)
{
    story *s = context;
    s->is_in_order = s->is_in_order && step->iteration == s->calls;
    s->has_fallen = s->has_fallen && step->cost <= s->cost;
    s->cost = step->cost;
    s->x = step->x[0];
    return s->calls++ < s->stop_at;
}

/* exp(x) - 2: from 10 down by some 1 a step. */
static bool steep(void *context, const double *x, double *residual,
                  double *jacobian)
{
    (void)context;
    residual[0] = exp(x[0]) - 2;
    if (jacobian) {
        jacobian[0] = exp(x[0]);
    }
    return true;
}

static void test_watch_is_called_and_stops(void)
{
    for (int stop = 0; stop < 4; ++stop) {
        story s = {.stop_at = stop,
                   .is_in_order = true,
                   .has_fallen = true,
                   .cost = INFINITY};
        const murk_least_squares p = {.n = 1,
                                      .rows = 1,
                                      .lower = none_below,
                                      .upper = none_above,
                                      .residuals = steep,
                                      .watch = listen,
                                      .context = &s};
        double x = 10;
        const murk_least_squares_found found = solve(&x, &p);
        CHECK(found.end == MURK_LEAST_SQUARES_STOPPED);
        CHECK_TEXT(found.why, "stopped by its watch");
        CHECK(s.calls == stop + 1 && found.iterations == stop);
        CHECK(s.is_in_order && s.has_fallen);
        CHECK(x == s.x && found.cost == s.cost);
    }
}

static void test_iterations_run_out(void)
{
    const murk_least_squares p = {.n = 1,
                                  .rows = 1,
                                  .lower = none_below,
                                  .upper = none_above,
                                  .residuals = steep,
                                  .iterations_max = 3};
    double x = 10;
    const murk_least_squares_found found = solve(&x, &p);
    CHECK(found.end == MURK_LEAST_SQUARES_ITERATIONS);
    CHECK(found.iterations == 3);
    CHECK_MENTIONS(found.why, "out of iterations");
    CHECK(x < 8 && x > 6);
}

/* x + y alone is known, and z has no say at all. */
static bool confounded(void *context, const double *x, double *residual,
                       double *jacobian)
{
    (void)context;
    residual[0] = x[0] + x[1] - 2;
    if (jacobian) {
        jacobian[0] = jacobian[1] = 1;
        jacobian[2] = 0;
    }
    return true;
}

static void test_singular_is_no_failure(void)
{
    const murk_least_squares p = {.n = 3,
                                  .rows = 1,
                                  .lower = none_below,
                                  .upper = none_above,
                                  .residuals = confounded};
    double x[] = {5, 4, 3};
    const murk_least_squares_found found = solve(x, &p);
    CHECK(found.end == MURK_LEAST_SQUARES_CONVERGED);
    CHECK_NEAR(x[0] + x[1], 2, 1e-9);
    CHECK(x[2] == 3);
}

static int calls, calls_alone;

static bool counted(void *context, const double *x, double *residual,
                    double *jacobian)
{
    ++calls;
    calls_alone += jacobian == NULL;
    return location(context, x, residual, jacobian);
}

/* Where the Jacobian is free nobody asks for residuals alone, and the answer
 * has the same bits. */
static void test_a_free_jacobian_saves_calls(void)
{
    double x[2] = {50, 50};
    int number[2];
    for (int is_free = 0; is_free < 2; ++is_free) {
        murk_least_squares p = location_problem(MURK_LOSS_FUNCTION_HUBER);
        p.residuals = counted;
        p.is_jacobian_free = is_free;
        calls = calls_alone = 0;
        const murk_least_squares_found found = solve(&x[is_free], &p);
        CHECK(found.evaluations == calls);
        CHECK((calls_alone == 0) == is_free);
        number[is_free] = calls;
    }
    CHECK(number[1] < number[0]);
    CHECK(x[0] == x[1]);
}

static void test_the_same_bits_again(void)
{
    double x[2] = {50, 50};
    const murk_least_squares p = location_problem(MURK_LOSS_FUNCTION_CAUCHY);
    const murk_least_squares_found a = solve(&x[0], &p), b = solve(&x[1], &p);
    CHECK(x[0] == x[1] && a.cost == b.cost && a.evaluations == b.evaluations);
    CHECK_TEXT(a.why, b.why);
}

static void refuse(double start, double lower, double upper, size_t rows,
                   double width, const char *text)
{
    const murk_least_squares p = {.n = 1,
                                  .rows = rows,
                                  .lower = &lower,
                                  .upper = &upper,
                                  .residuals = location,
                                  .loss = MURK_LOSS_FUNCTION_HUBER,
                                  .loss_width = width};
    murk_least_squares_found found;
    murk_error err = {0};
    CHECK(murk_least_squares_solve(&found, &start, &p, &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, text);
}

static void test_refusals(void)
{
    refuse(3, 0, 2, 1, 1, "parameter 0 starts at 3, must be 0..2");
    refuse(NAN, 0, 2, 1, 1, "parameter 0 starts at nan, must be 0..2");
    refuse(1, 2, 0, 1, 1, "bounds of parameter 0 are 2..0");
    refuse(1, NAN, 2, 1, 1, "bounds of parameter 0 are nan..2");
    refuse(1, 0, 2, 0, 1, "0 rows of 1 parameters");
    refuse(1, 0, 2, 1, 0, "the width of the loss is 0");
    refuse(1, 0, 2, 1, NAN, "the width of the loss is nan");
}

int main(void)
{
    test_bound_is_active();
    test_bound_is_left_again();
    test_fixed_stays();
    test_losses_act_on_each_row();
    test_watch_is_called_and_stops();
    test_iterations_run_out();
    test_singular_is_no_failure();
    test_a_free_jacobian_saves_calls();
    test_the_same_bits_again();
    test_refusals();
    return check_done();
}
