/* Extrapolation of a search by the linearised model within a trust region, and
 * Newton steps on the bias-corrected equations (calibrate/slope_noise.h). */
#include "calibrate/search_steps.h"

#include "calibrate/slope_noise.h"

#include <math.h>
#include <string.h>

/* Trust region of one extrapolation beyond the valid range of the light: a
 * factor for keys in logarithms, a share of the width of the bounds for others.
 */
#define LEAP_FACTOR 3.0
#define LEAP_SHARE  .5 /* of the width of bounds */

/* The correction has converged if a step is shorter than this many standard
 * errors; SETTLE_MAX limits the steps. */
#define SETTLED    .02
#define SETTLE_MAX 8

/* The model linearised about a point. */
typedef struct linear {
    const murk_fit_search *search;
    const double *from;
} linear;

static bool evaluate_linear(void *context, const double *x, double *residual,
                            double *jacobian)
{
    const linear *l = context;
    const murk_fit_search *s = l->search;
    for (size_t i = 0; i < s->n_fitted; ++i) {
        residual[i] = s->residual[i] + s->offset[i];
        for (size_t k = 0; k < s->n; ++k) {
            residual[i] += s->jacobian[i * s->n + k] * (x[k] - l->from[k]);
        }
    }
    if (jacobian) {
        memcpy(jacobian, s->jacobian, s->n_fitted * s->n * sizeof *jacobian);
    }
    return true;
}

murk_status murk_fit_leap(murk_fit_search *s, double *x, murk_error *err)
{
    murk_arena arena = {0};
    double *from = murk_arena_array(&arena, s->n, sizeof *from);
    double *lower = murk_arena_array(&arena, s->n, sizeof *lower);
    double *upper = murk_arena_array(&arena, s->n, sizeof *upper);
    murk_status status =
        arena.is_short ? murk_no_memory(err, "", "for the search") : MURK_OK;
    /* The trust region about x. */
    for (size_t k = 0; k < s->n && !status; ++k) {
        const double reach = /* infinite if a bound is infinite */
            s->desc->keys->key[k].is_log
                ? log(LEAP_FACTOR)
                : LEAP_SHARE * (s->upper[k] - s->lower[k]);
        from[k] = x[k];
        lower[k] = fmax(s->lower[k], x[k] - reach);
        upper[k] = fmin(s->upper[k], x[k] + reach);
    }
    /* Minimise the linearised model. */
    if (!status) {
        linear l = {s, from};
        murk_least_squares problem = murk_fit_problem(s);
        problem.lower = lower;
        problem.upper = upper;
        problem.residuals = evaluate_linear;
        problem.watch = NULL;
        problem.context = &l;
        murk_least_squares_found found;
        status = murk_least_squares_solve(&found, x, &problem, err);
    }
    murk_arena_release(&arena);
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

/* One step from x towards the solution of the bias-corrected equations;
 * scratch[n_fitted * (n + 1) + n] is a scratch buffer. */
static murk_status settle_step(murk_fit_search *s, double *x, double *scratch,
                               double *length, murk_error *err)
{
    const size_t n = s->n, rows = s->n_fitted;
    double *residual = scratch, *jacobian = scratch + rows,
           *step = scratch + rows * (n + 1);
    murk_slope_noise noise = {0};
    /* Predict and find the noise. */
    murk_status status = murk_fit_search_evaluate(s, x, err);
    status = status ? status : murk_slope_noise_find(&noise, s, err);
    if (!status) {
        /* Weights of the robust loss. */
        murk_fit_search_residuals(s, residual, jacobian);
        for (size_t i = 0; i < rows; ++i) {
            const double weight = root_weight(s, residual[i]);
            residual[i] *= weight;
            for (size_t k = 0; k < n; ++k) {
                jacobian[i * n + k] *= weight;
            }
        }
        status = murk_slope_noise_step(step, length, &noise, residual, jacobian,
                                       rows, n, err);
    }
    /* Apply the step within bounds. */
    for (size_t k = 0; k < n && !status; ++k) {
        x[k] = fmin(fmax(x[k] + step[k], s->lower[k]), s->upper[k]);
    }
    murk_slope_noise_release(&noise);
    return status;
}

murk_status murk_fit_settle(murk_fit_search *s, double *x, murk_error *err)
{
    const size_t n = s->n;
    murk_arena arena = {0};
    double *before = murk_arena_array(&arena, n, sizeof *before);
    double *scratch =
        murk_arena_array(&arena, s->n_fitted * (n + 1) + n, sizeof *scratch);
    murk_status status =
        arena.is_short ? murk_no_memory(err, "", "for the search") : MURK_OK;
    double length = INFINITY;
    for (int i = 0; i < SETTLE_MAX && !status && length > SETTLED; ++i) {
        memcpy(before, x, n * sizeof *x);
        status = settle_step(s, x, scratch, &length, err);
        if (!status && s->share < MURK_MIN_SHARE) {
            s->is_undersampled = true; /* light is not valid there */
            memcpy(x, before, n * sizeof *x);
            break;
        }
    }
    murk_arena_release(&arena);
    return status;
}
