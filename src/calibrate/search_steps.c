/* Extrapolation of a search by the linearised model within a trust region, and
 * Newton steps on the bias-corrected equations (calibrate/slope_noise.h). */
#include "calibrate/search_steps.h"

#include "calibrate/slope_noise.h"

#include <stdlib.h>
#include <string.h>

/* Trust region of one extrapolation beyond the valid range of the light: a
 * factor for keys in logarithms, a share of the width of the bounds for others.
 * */
#define LEAP_FACTOR 3.0
#define LEAP_SHARE  .5 /* of the width of bounds */

/* The correction has converged if a step is shorter than this many standard
 * errors; SETTLE_MAX limits the steps. */
#define SETTLED    .02
#define SETTLE_MAX 8

static murk_status no_memory(murk_error *err)
{
    return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the search");
}

double murk_fit_cost(const murk_fit_search *s, const double *residual)
{
    double sum = 0, slope;
    for (size_t i = 0; i < s->n_fitted; ++i) {
        sum += murk_loss_at(s->desc->loss, s->desc->loss_width,
                            residual[i] * residual[i], &slope);
    }
    return sum;
}

/* The linearised model. */
typedef struct linear {
    size_t n, rows;
    const double *from, *residual, *offset, *jacobian;
} linear;

static bool evaluate_linear(void *context, const double *x, double *residual,
                            double *jacobian)
{
    const linear *l = context;
    for (size_t i = 0; i < l->rows; ++i) {
        residual[i] = l->residual[i] + l->offset[i];
        for (size_t k = 0; k < l->n; ++k) {
            residual[i] += l->jacobian[i * l->n + k] * (x[k] - l->from[k]);
        }
    }
    if (jacobian) {
        memcpy(jacobian, l->jacobian, l->rows * l->n * sizeof *jacobian);
    }
    return true;
}

/* The trust region about `from`, within bounds. */
static void reach_of(const murk_fit_search *s, const double *from,
                     double *lower, double *upper)
{
    for (size_t k = 0; k < s->n; ++k) {
        const murk_free_key *key = &s->desc->keys->key[k];
        const double low = murk_free_lowest(key), high = murk_free_highest(key);
        const double reach = /* infinite if a bound is */
            key->is_log ? log(LEAP_FACTOR) : LEAP_SHARE * (high - low);
        lower[k] = fmax(low, from[k] - reach);
        upper[k] = fmin(high, from[k] + reach);
    }
}

murk_status murk_fit_leap(murk_fit_search *s, double *x, const double *residual,
                          const double *jacobian, murk_error *err)
{
    double *room = malloc(3 * (s->n + 1) * sizeof *room);
    if (!room) {
        return no_memory(err);
    }
    /* The trust region about x. */
    double *lower = room, *upper = room + s->n, *from = room + 2 * s->n;
    memcpy(from, x, s->n * sizeof *from);
    reach_of(s, from, lower, upper);
    /* Minimise the linearised model. */
    linear l = {s->n, s->n_fitted, from, residual, s->offset, jacobian};
    murk_least_squares problem = murk_fit_problem(s, lower, upper);
    problem.residuals = evaluate_linear;
    problem.watch = NULL;
    problem.context = &l;
    murk_least_squares_found found;
    const murk_status status =
        murk_least_squares_solve(&found, x, &problem, err);
    free(room);
    return status;
}

/* The square root of the weight that the robust loss gives a residual. */
static double root_weight(const murk_fit_search *s, double residual)
{
    double slope;
    (void)murk_loss_at(s->desc->loss, s->desc->loss_width, residual * residual,
                       &slope);
    return sqrt(slope);
}

/* One step from x towards the solution of the bias-corrected equations. */
static murk_status settle_step(murk_fit_search *s, const murk_fit_workspace *d,
                               double *x, double *room, double *length,
                               murk_error *err)
{
    const size_t n = s->n, rows = s->n_fitted;
    double *residual = room, *jacobian = room + rows,
           *step = room + rows * (n + 1);
    murk_slope_noise noise = {0};
    /* Predict and find the noise. */
    murk_status status = murk_fit_search_look(s, x, err);
    if (!status) {
        status = murk_slope_noise_find(&noise, s, err);
    }
    if (!status) {
        /* Weights of the robust loss: Jacobian first, then residuals. */
        murk_fit_search_residuals(s, residual, jacobian);
        for (size_t i = 0; i < rows * (n + 1); ++i) {
            const size_t row = i < rows ? i : (i - rows) / n;
            room[i] *= i < rows ? 1 : root_weight(s, residual[row]);
        }
        for (size_t i = 0; i < rows; ++i) {
            residual[i] *= root_weight(s, residual[i]);
        }
        status = murk_slope_noise_step(step, length, &noise, residual, jacobian,
                                       rows, n, err);
    }
    /* Apply the step within bounds. */
    for (size_t k = 0; k < n && !status; ++k) {
        x[k] = fmin(fmax(x[k] + step[k], d->lower[k]), d->upper[k]);
    }
    murk_slope_noise_release(&noise);
    return status;
}

murk_status murk_fit_settle(murk_fit_search *s, const murk_fit_workspace *d,
                            double *x, murk_error *err)
{
    const size_t n = s->n;
    double *room = calloc(s->n_fitted * (n + 1) + 2 * n + 1, sizeof *room);
    murk_status status = room ? MURK_OK : no_memory(err);
    double length = INFINITY;
    for (int i = 0; i < SETTLE_MAX && !status && length > SETTLED; ++i) {
        double *before = room + s->n_fitted * (n + 1) + n;
        memcpy(before, x, n * sizeof *x);
        status = settle_step(s, d, x, room, &length, err);
        if (!status && s->share < MURK_MIN_SHARE) {
            s->is_undersampled = true; /* light is not valid there */
            memcpy(x, before, n * sizeof *x);
            break;
        }
    }
    free(room);
    return status;
}
