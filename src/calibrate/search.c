/* One search: trace light, minimise over the re-weighted rows by bounded least
 * squares (Ceres), correct for photon noise in the slopes, and repeat with new
 * light while the effective sample size is too low or world keys have moved. */
#include "calibrate/search_steps.h"

#include "base/interrupt.h"
#include "calibrate/first_gains.h"
#include "calibrate/slope_noise.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A world key that moved by less than WORLD_STILL standard errors, or by less
 * than WORLD_CLOSE of its value, does not need new slopes. */
#define WORLD_STILL .2
#define WORLD_CLOSE 1e-3

/* Default limit on traces for each start: each costs a full run. */
#define TRACES_MAX 12

static murk_status no_memory(murk_error *err)
{
    return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the search");
}

/* Lists the fitted rows: those that need light first. */
static void list_rows(murk_fit_search *s)
{
    const murk_measurements *measured = s->desc->measured;
    for (size_t pass = 0; pass < 2; ++pass) {
        for (size_t i = 0; i < s->rows; ++i) {
            const murk_reading *reading =
                &measured->reading[measured->row[i].first];
            const bool is_lit = reading->kind != MURK_READ_TRANSMITTANCE;
            s->measured[i] = reading->value;
            s->error[i] = reading->standard_error;
            if (!reading->is_held_out && is_lit == (pass == 0)) {
                s->fitted[s->n_fitted++] = i;
                s->n_lit += is_lit;
            }
        }
    }
}

murk_status murk_fit_search_create(murk_fit_search *out,
                                   const murk_calibration_desc *desc,
                                   murk_model *model, murk_error *err)
{
    const size_t n = desc->keys->n, rows = desc->measured->rows;
    *out =
        (murk_fit_search){.desc = desc,
                          .model = model,
                          .n = n,
                          .rows = rows,
                          .fitted = calloc(rows + 1, sizeof *out->fitted),
                          .measured = calloc(rows + 1, sizeof *out->measured),
                          .error = calloc(rows + 1, sizeof *out->error),
                          .value = calloc(n + 1, sizeof *out->value),
                          .predicted = calloc(rows + 1, sizeof *out->predicted),
                          .offset = calloc(rows + 1, sizeof *out->offset),
                          .slope = calloc(rows * n + 1, sizeof *out->slope)};
    if (!out->fitted || !out->measured || !out->error || !out->value ||
        !out->predicted || !out->offset || !out->slope) {
        return no_memory(err);
    }
    list_rows(out);
    return MURK_OK;
}

void murk_fit_search_release(murk_fit_search *s)
{
    murk_whitening_destroy(s->whitening);
    free(s->fitted);
    free(s->measured);
    free(s->error);
    free(s->value);
    free(s->predicted);
    free(s->offset);
    free(s->slope);
    *s = (murk_fit_search){0};
}

void murk_fit_search_values(const murk_fit_search *s, const double *x,
                            double *value)
{
    for (size_t k = 0; k < s->n; ++k) {
        const murk_free_key *key = &s->desc->keys->key[k];
        const double v = key->is_log ? exp(x[k]) : x[k];
        value[k] = fmin(fmax(v, key->lower), key->upper);
    }
}

void murk_fit_search_coordinates(const murk_fit_search *s, const double *value,
                                 double *x)
{
    for (size_t k = 0; k < s->n; ++k) {
        x[k] = s->desc->keys->key[k].is_log ? log(value[k]) : value[k];
    }
}

/* Whitens the fitted rows that need light by their covariance: photons plus
 * measurement errors. */
static murk_status whiten(murk_fit_search *s, murk_error *err)
{
    murk_whitening_destroy(s->whitening);
    s->whitening = NULL;
    if (s->n_lit == 0) {
        return MURK_OK;
    }
    const size_t *lit;
    size_t n;
    double *all, *covariance = calloc(s->n_lit * s->n_lit, sizeof *covariance);
    murk_status status = murk_model_noise(s->model, &lit, &n, &all, err);
    if (!status && !covariance) {
        status = no_memory(err);
    }
    /* Copy the covariance of the fitted rows; both lists rise. */
    for (size_t i = 0, a = 0; i < s->n_lit && !status; ++i, ++a) {
        for (; lit[a] != s->fitted[i]; ++a) {
        }
        for (size_t j = 0, b = 0; j < s->n_lit; ++j, ++b) {
            for (; lit[b] != s->fitted[j]; ++b) {
            }
            covariance[i * s->n_lit + j] = all[a * n + b];
        }
        const double error = s->error[s->fitted[i]];
        covariance[i * s->n_lit + i] += error * error;
    }
    /* Factorise. */
    if (!status) {
        status =
            murk_whitening_create(&s->whitening, covariance, s->n_lit, err);
    }
    free(covariance);
    free(all);
    return status;
}

static murk_status predict(murk_fit_search *s, const double *x,
                           bool with_slopes, murk_error *err)
{
    ++s->evaluations;
    murk_fit_search_values(s, x, s->value);
    return murk_model_predict(s->model, s->value, s->predicted,
                              with_slopes ? s->slope : NULL, &s->share, err);
}

murk_status murk_fit_search_look(murk_fit_search *s, const double *x,
                                 murk_error *err)
{
    const murk_status status = predict(s, x, true, err);
    return status ? status : whiten(s, err);
}

void murk_fit_search_residuals(const murk_fit_search *s, double *residual,
                               double *jacobian)
{
    /* Residuals and slopes; rows without photons are divided by their error. */
    for (size_t i = 0; i < s->n_fitted; ++i) {
        const size_t row = s->fitted[i];
        const double scale = i < s->n_lit ? 1 : 1 / s->error[row];
        residual[i] = scale * (s->measured[row] - s->predicted[row]);
        for (size_t k = 0; jacobian && k < s->n; ++k) {
            const double by_x = s->desc->keys->key[k].is_log ? s->value[k] : 1;
            jacobian[i * s->n + k] = -scale * s->slope[row * s->n + k] * by_x;
        }
    }
    /* Whiten the rows that need light. */
    if (s->whitening) {
        murk_whitening_apply(s->whitening, residual, 1);
        if (jacobian) {
            murk_whitening_apply(s->whitening, jacobian, s->n);
        }
    }
}

/* The residuals for the solver, with the offset against slope noise. */
static bool evaluate(void *context, const double *x, double *residual,
                     double *jacobian)
{
    murk_fit_search *s = context;
    s->err = (murk_error){0};
    if (predict(s, x, jacobian != NULL, &s->err)) {
        return false;
    }
    murk_fit_search_residuals(s, residual, jacobian);
    for (size_t i = 0; i < s->n_fitted; ++i) {
        residual[i] += s->offset[i];
    }
    return true;
}

/* Called after each step of the solver: reports progress, and ends the solver
 * if the light is no longer valid. */
static bool watch(void *context, const murk_least_squares_step *step)
{
    murk_fit_search *s = context;
    ++s->iterations;
    /* Report. */
    if (s->desc->watch && step->is_successful) {
        double *value = malloc((s->n + 1) * sizeof *value);
        if (value) {
            murk_fit_search_values(s, step->x, value);
            s->desc->watch(s->desc->context, s->start, s->traces,
                           step->iteration, 2 * step->cost, value);
        }
        free(value);
    }
    if (s->is_scouting) {
        return !murk_interrupted();
    }
    /* Stop when the effective share falls below the limit. */
    s->is_undersampled = step->is_successful && s->share < MURK_MIN_SHARE;
    return !s->is_undersampled && !murk_interrupted();
}

murk_least_squares murk_fit_problem(murk_fit_search *s, const double *lower,
                                    const double *upper)
{
    return (murk_least_squares){.n = s->n,
                                .rows = s->n_fitted,
                                .lower = lower,
                                .upper = upper,
                                .residuals = evaluate,
                                .watch = watch,
                                .context = s,
                                .loss = s->desc->loss,
                                .loss_width = s->desc->loss_width};
}

/* True if world keys have moved so far that their slopes must be computed
 * again. */
static bool world_moved(const murk_fit_search *s, const double *from,
                        const double *x, const double *jacobian)
{
    for (size_t k = 0; k < s->n; ++k) {
        double information = 0;
        for (size_t i = 0; i < s->n_lit; ++i) {
            const double j = jacobian[i * s->n + k];
            information += j * j;
        }
        const double off = fabs(x[k] - from[k]);
        if (s->desc->keys->key[k].kind == MURK_FREE_WORLD &&
            off * sqrt(information) > WORLD_STILL &&
            off > WORLD_CLOSE * fmax(1, fabs(x[k]))) {
            return true;
        }
    }
    return false;
}

static double sum_of_squares(const double *a, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; ++i) {
        sum += a[i] * a[i];
    }
    return sum;
}

/* Computes the offset of the rows against the correlated noise of values and
 * slopes, at the last prediction. */
static murk_status offset_rows(murk_fit_search *s, const double *jacobian,
                               murk_error *err)
{
    murk_slope_noise noise;
    murk_status status = murk_slope_noise_find(&noise, s, err);
    if (!status) {
        status = murk_slope_noise_offset(s->offset, &noise, jacobian,
                                         s->n_fitted, s->n, err);
    }
    murk_slope_noise_release(&noise);
    return status;
}

/* Traces light at x, unless the light at hand is valid there (is_lit), and
 * computes residuals, slopes, cost and offset. */
static murk_status trace_at(murk_fit_search *s, const murk_fit_workspace *d,
                            bool is_lit, double *x, double *cost,
                            murk_error *err)
{
    murk_status status = MURK_OK;
    /* Trace. */
    if (!is_lit) {
        murk_fit_search_values(s, x, s->value);
        ++s->traces;
        status = murk_model_trace(s->model, s->value, err);
    }
    /* The first trace determines the factors of readings. */
    if (!status && !is_lit && s->traces == 1) {
        status = murk_fit_first_gains(s, x, err);
    }
    /* Predict. */
    if (!status) {
        status = murk_fit_search_look(s, x, err);
    }
    /* Cost and offset. */
    if (!status) {
        murk_fit_search_residuals(s, d->residual, d->jacobian);
        *cost = murk_fit_cost(s, d->residual);
        if (isfinite(*cost)) {
            status = offset_rows(s, d->jacobian, err);
        } else {
            status = murk_fail(err, MURK_RUN_FAILED, s->desc->measured->path,
                               "a prediction is not finite at the present "
                               "parameters: start nearer to what was measured");
        }
    }
    return status;
}

/* Records how least squares ended. True if light must be traced again at x. */
static bool ended(murk_fit_search *s, const murk_fit_workspace *d, double *x,
                  const murk_least_squares_found *found,
                  murk_calibration_start *to)
{
    to->converged = found->end == MURK_LEAST_SQUARES_CONVERGED;
    snprintf(to->why, sizeof to->why, "%s", found->why);
    if (found->end == MURK_LEAST_SQUARES_FAILED && s->err.status) {
        snprintf(to->why, sizeof to->why, "%.250s", s->err.text);
    }
    return to->converged && world_moved(s, d->traced, x, d->jacobian);
}

static bool has_world_key(const murk_fit_search *s)
{
    for (size_t k = 0; k < s->n; ++k) {
        if (s->desc->keys->key[k].kind == MURK_FREE_WORLD) {
            return true;
        }
    }
    return false;
}

/* Follows the light at hand from x: least squares on the re-weighted rows for
 * any effective share, with the whitening of the last prediction. No light is
 * traced. x becomes the end, and *is_lit tells whether the light describes that
 * point well enough for the search to continue there. Slopes of world keys hold
 * at the traced values only, so with such keys light is traced in any case. */
static murk_status scout(murk_fit_search *s, const murk_fit_workspace *d,
                         double *x, bool *is_lit, murk_error *err)
{
    double *from = d->before;
    memcpy(from, x, s->n * sizeof *x);
    /* Minimise. */
    memset(s->offset, 0, s->n_fitted * sizeof *s->offset);
    murk_error told = {0};
    murk_status status = murk_fit_first_gains(s, x, &told);
    if (!status) {
        const murk_least_squares problem =
            murk_fit_problem(s, d->lower, d->upper);
        murk_least_squares_found found;
        s->is_scouting = true;
        status = murk_least_squares_solve(&found, x, &problem, &told);
        s->is_scouting = false;
        if (!status && found.end == MURK_LEAST_SQUARES_FAILED) {
            status = MURK_RUN_FAILED;
        }
    }
    /* Evaluate the end. */
    if (!status && !murk_interrupted()) {
        status = predict(s, x, false, &told);
    }
    /* Interrupt and lack of memory are errors. */
    if (murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    if (status == MURK_NO_MEMORY) {
        return murk_fail(err, status, told.where, "%s", told.text);
    }
    if (status) { /* the light at hand leads nowhere: start at the original
                   * point */
        memcpy(x, from, s->n * sizeof *x);
    }
    *is_lit = !status && s->share >= MURK_MIN_SHARE && !has_world_key(s);
    if (!status && !*is_lit) { /* decide whether a trace there is worthwhile */
        murk_fit_search_residuals(s, d->residual, NULL);
        s->is_dropped =
            !(murk_fit_cost(s, d->residual) < s->cost_to_beat + (double)s->n);
    }
    return MURK_OK;
}

/* The loop of a search. */
static murk_status search(murk_fit_search *s, const murk_fit_workspace *d,
                          double *x, murk_calibration_start *to,
                          murk_error *err)
{
    const size_t max = s->desc->traces_max ? s->desc->traces_max : TRACES_MAX;
    const size_t bytes = s->n * sizeof *x;
    double best = INFINITY;
    bool is_lit = false;
    /* Follow the light of earlier starts. */
    if (s->shares_light && s->has_light) {
        const murk_status status = scout(s, d, x, &is_lit, err);
        if (status || s->is_dropped) {
            snprintf(to->why, sizeof to->why,
                     "the light of the starts before leads to no better place");
            return status;
        }
    }
    for (;;) {
        /* Trace and evaluate; a failure after a step means that the step was
         * too long. */
        double cost;
        murk_error told = {0};
        murk_status status = trace_at(s, d, is_lit, x, &cost, &told);
        is_lit = false;
        const bool is_nowhere = status && status != MURK_NO_MEMORY &&
                                status != MURK_INTERRUPTED && isfinite(best) &&
                                s->traces < max;
        if (status && !is_nowhere) {
            return murk_fail(err, status, told.where, "%s", told.text);
        }
        /* Go back half the step after a failure or a large increase of the
         * cost. */
        if (is_nowhere ||
            (cost > 2 * best + (double)s->n_fitted && s->traces < max)) {
            for (size_t k = 0; k < s->n; ++k) { /* the step was too long */
                x[k] = .5 * (x[k] + d->before[k]);
            }
            continue;
        }
        /* Minimise over the re-weighted rows. */
        best = cost;
        memcpy(d->traced, x, bytes);
        memcpy(d->before, x, bytes);
        murk_least_squares_found found;
        const murk_least_squares problem =
            murk_fit_problem(s, d->lower, d->upper);
        bool settled_away = false;
        s->is_undersampled = false;
        status = murk_least_squares_solve(&found, x, &problem, err);
        if (status || murk_interrupted()) {
            return status ? status
                          : murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
        }
        /* Correct for photon noise in the slopes. */
        if (!s->is_undersampled && s->n_lit &&
            found.end == MURK_LEAST_SQUARES_CONVERGED) {
            status = murk_fit_settle(s, d, x, err);
            if (status) {
                return status;
            }
            settled_away = s->is_undersampled;
        }
        /* End, or trace again. */
        const bool goes_on = s->is_undersampled || ended(s, d, x, &found, to);
        if (!goes_on) {
            return murk_fit_search_look(s, x, err);
        }
        if (s->traces >= max) {
            to->converged = false;
            snprintf(to->why, sizeof to->why,
                     "light was traced %zu times and still had to be traced "
                     "anew: start nearer, or free fewer keys",
                     s->traces);
            if (!s->is_undersampled) { /* without light of that world */
                memcpy(x, d->traced, bytes);
            }
            return murk_fit_search_look(s, x, err);
        }
        /* Extrapolate to the point of the next trace. */
        if (s->is_undersampled && !settled_away) {
            memcpy(x, d->traced, bytes);
            status = murk_fit_leap(s, x, d->residual, d->jacobian, err);
            if (status) {
                return status;
            }
        }
    }
}

/* Allocates the workspace and runs the search. */
murk_status murk_fit_search_run(murk_fit_search *s, double *x,
                                murk_calibration_start *to, murk_error *err)
{
    const size_t n = s->n, rows = s->n_fitted;
    double *room = calloc(rows + rows * n + 4 * n + 1, sizeof *room);
    if (!room) {
        return no_memory(err);
    }
    /* Bounds in search coordinates. */
    const murk_fit_workspace d = {.residual = room,
                                  .jacobian = room + rows,
                                  .traced = room + rows + rows * n,
                                  .before = room + rows + rows * n + n,
                                  .lower = room + rows + rows * n + 2 * n,
                                  .upper = room + rows + rows * n + 3 * n};
    for (size_t k = 0; k < n; ++k) {
        d.lower[k] = murk_free_lowest(&s->desc->keys->key[k]);
        d.upper[k] = murk_free_highest(&s->desc->keys->key[k]);
    }
    s->traces = 0;
    s->is_dropped = false;
    /* Search, and record the end. */
    const murk_status status = search(s, &d, x, to, err);
    to->traces = s->traces;
    s->has_light = !status;
    if (!status && !s->is_dropped) {
        to->light = murk_model_traces(s->model);
        murk_fit_search_residuals(s, d.residual, NULL);
        to->chi2 = sum_of_squares(d.residual, rows);
        to->cost = murk_fit_cost(s, d.residual);
    }
    free(room);
    return status;
}
