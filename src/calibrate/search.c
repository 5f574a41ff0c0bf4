/* One search: trace light, minimise over the re-weighted rows by bounded least
 * squares (Ceres), correct for photon noise in the slopes, and repeat with new
 * light while the effective sample size is too low or world keys have moved.
 * Also chooses the start values of each search, returns to the end of one, and
 * compares their ends. */
#include "calibrate/search.h"

#include "base/interrupt.h"
#include "base/rng.h"
#include "calibrate/search_steps.h"
#include "calibrate/slope_noise.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A world key that moved by less than WORLD_STILL standard errors, or by less
 * than WORLD_CLOSE of the larger of its absolute value and 1, does not need new
 * slopes. */
#define WORLD_STILL .2
#define WORLD_CLOSE 1e-3

/* Default limit on traces for each start: each costs a full run. */
#define TRACES_MAX 12

/* Values of further starts: within START_FACTOR of the value of the scene for
 * keys that are searched in logarithms, within the middle START_SHARE of the
 * range of other keys; without a finite range, at most the larger of 1 and the
 * absolute value of the scene away from that value. */
#define START_FACTOR 4.0
#define START_SHARE  .9

/* Costs that differ by less belong to the same minimum: light and the end of a
 * search are not known more precisely. The value is a tenth of the change of
 * cost at one standard error. */
#define SAME_MINIMUM .1

/* ---- factors of readings ---- */

/* The factor that fits the rows best, g = sum(m p / e^2) / sum(p^2 / e^2) over
 * the fitted rows, with measured m, error e and p predicted with factor 1: rows
 * that use a factor are proportional to it, and the slope of a row with respect
 * to a factor is the row with factor 1. */
static double best_gain(const murk_fit_search *s, size_t k)
{
    double with_measured = 0, with_itself = 0;
    for (size_t i = 0; i < s->n_fitted; ++i) {
        const size_t row = s->fitted[i];
        const double p = s->slope[row * s->n + k] / s->error[row];
        with_measured += p * (s->measured[row] / s->error[row]);
        with_itself += p * p;
    }
    return with_measured / with_itself;
}

static bool has_key_of(const murk_fit_search *s, murk_free_kind kind)
{
    for (size_t k = 0; k < s->n; ++k) {
        if (s->desc->keys->key[k].kind == kind) {
            return true;
        }
    }
    return false;
}

/* Sets the factors in x to their least squares values for the other values of
 * x, at which light must have been traced; a factor that no fitted row uses is
 * not changed. The counts of a meter may be any multiple of a watt, and a
 * search that starts with a factor wrong by a thousand would distort the medium
 * first. */
static murk_status set_gains(murk_fit_search *s, double *x, murk_error *err)
{
    const murk_free_keys *keys = s->desc->keys;
    if (!has_key_of(s, MURK_FREE_GAIN)) {
        return MURK_OK;
    }
    murk_fit_search_values(s, x, s->value);
    const murk_status status = murk_model_predict(
        s->model, s->value, s->predicted, s->slope, &s->share, err);
    for (size_t k = 0; k < s->n && !status; ++k) {
        const murk_free_key *key = &keys->key[k];
        const double gain = key->kind == MURK_FREE_GAIN ? best_gain(s, k) : NAN;
        if (gain > 0 && isfinite(gain)) {
            x[k] = fmin(fmax(gain, key->lower), key->upper);
        }
    }
    return status;
}

/* ---- the loop of a search ---- */

/* True if world keys have moved so far that their slopes must be computed
 * again. */
static bool has_world_moved(const murk_fit_search *s, const double *x)
{
    for (size_t k = 0; k < s->n; ++k) {
        double information = 0;
        for (size_t i = 0; i < s->n_light; ++i) {
            const double j = s->jacobian[i * s->n + k];
            information += j * j;
        }
        const double off = fabs(x[k] - s->traced[k]);
        if (s->desc->keys->key[k].kind == MURK_FREE_WORLD &&
            off * sqrt(information) > WORLD_STILL &&
            off > WORLD_CLOSE * fmax(1, fabs(x[k]))) {
            return true;
        }
    }
    return false;
}

/* Computes the offset of the rows against the correlated noise of values and
 * slopes, at the last prediction. */
static murk_status offset_rows(murk_fit_search *s, murk_error *err)
{
    murk_slope_noise noise;
    murk_status status = murk_slope_noise_find(&noise, s, err);
    status = status ? status
                    : murk_slope_noise_offset(s->offset, &noise, s->jacobian,
                                              s->n_fitted, s->n, err);
    murk_slope_noise_release(&noise);
    return status;
}

/* Traces light at x for start `by`. */
static murk_status trace(murk_fit_search *s, size_t by, const double *x,
                         murk_error *err)
{
    memmove(s->lit, x, s->n * sizeof *x);
    murk_fit_search_values(s, x, s->value);
    s->lit_by = s->ended = SIZE_MAX;
    const murk_status status = murk_model_trace(s->model, s->value, err);
    s->lit_by = status ? SIZE_MAX : by;
    return status;
}

/* Traces light at x, unless the light at hand is valid there (is_valid), and
 * computes residuals, slopes, cost and offset. */
static murk_status trace_at(murk_fit_search *s, bool is_valid, double *x,
                            double *cost, murk_error *err)
{
    murk_status status = MURK_OK;
    /* Trace; the first trace determines the factors of readings. */
    if (!is_valid) {
        ++s->traces;
        status = trace(s, s->start, x, err);
        if (!status && s->traces == 1) {
            status = set_gains(s, x, err);
        }
    }
    /* Predict: residuals, cost and offset. */
    status = status ? status : murk_fit_search_evaluate(s, x, err);
    if (status) {
        return status;
    }
    murk_fit_search_residuals(s, s->residual, s->jacobian);
    *cost = murk_fit_cost(s, s->residual);
    return isfinite(*cost)
               ? offset_rows(s, err)
               : murk_fail(err, MURK_RUN_FAILED, s->desc->measured->path,
                           "a prediction is not finite at the present "
                           "parameters: start nearer to what was measured");
}

/* Records how least squares ended. True if light must be traced again at x. */
static bool has_ended_away(murk_fit_search *s, const double *x,
                           const murk_least_squares_found *found,
                           murk_calibration_start *to)
{
    const bool has_failed = found->end == MURK_LEAST_SQUARES_FAILED;
    to->converged = found->end == MURK_LEAST_SQUARES_CONVERGED;
    snprintf(to->why, sizeof to->why, "%.250s",
             has_failed && s->err.code ? s->err.text : found->why);
    return to->converged && has_world_moved(s, x);
}

/* Follows the light of start 0 from x: least squares on the re-weighted rows
 * for any effective share, with the whitening at the end of start 0. No light
 * is traced. x becomes the end, and *is_valid tells whether the light describes
 * that point well enough for the search to continue there. Slopes of world keys
 * hold at the traced values only, so *is_valid is false if there are such
 * keys. */
static murk_status scout(murk_fit_search *s, double *x, bool *is_valid,
                         murk_error *err)
{
    murk_whitening *const own = s->whitening;
    s->whitening = s->scouting;
    memcpy(s->before, x, s->n * sizeof *x);
    /* Minimise. */
    memset(s->offset, 0, s->n_fitted * sizeof *s->offset);
    murk_error failure = {0};
    murk_status status = set_gains(s, x, &failure);
    if (!status) {
        const murk_least_squares problem = murk_fit_problem(s);
        murk_least_squares_found found;
        s->is_scouting = true;
        status = murk_least_squares_solve(&found, x, &problem, &failure);
        s->is_scouting = false;
        if (!status && found.end == MURK_LEAST_SQUARES_FAILED) {
            status = MURK_RUN_FAILED;
        }
    }
    /* Evaluate the end. */
    if (!status && !murk_interrupted()) {
        status = murk_fit_search_predict(s, x, false, &failure);
    }
    *is_valid = !status && s->share >= MURK_MIN_SHARE &&
                !has_key_of(s, MURK_FREE_WORLD);
    if (!status && !*is_valid) { /* decide whether a trace there is worthwhile
                                  */
        murk_fit_search_residuals(s, s->residual, NULL);
        s->is_dropped =
            !(murk_fit_cost(s, s->residual) < s->cost_to_beat + (double)s->n);
    }
    s->whitening = own;
    /* Interrupt and lack of memory are errors. */
    if (murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    if (status == MURK_NO_MEMORY) {
        return murk_fail(err, status, failure.where, "%s", failure.text);
    }
    if (status) { /* the light at hand leads nowhere: start at the original
                   * point */
        memcpy(x, s->before, s->n * sizeof *x);
    }
    return MURK_OK;
}

/* The loop of a search. best: the cost at s->before, INFINITY at the beginning
 * of a search. */
static murk_status search(murk_fit_search *s, murk_calibration_start *to,
                          double best, murk_error *err)
{
    double *x = s->x;
    const size_t max = s->desc->traces_max ? s->desc->traces_max : TRACES_MAX;
    const size_t bytes = s->n * sizeof *x;
    bool is_valid = false;
    /* Follow the light of start 0. */
    if (s->shares_light) {
        const murk_status status = scout(s, x, &is_valid, err);
        if (status || s->is_dropped) {
            snprintf(to->why, sizeof to->why,
                     "the light of the first start leads to no better place");
            return status;
        }
    }
    for (;;) {
        /* Keep the light of start 0 for the other starts. */
        if (s->shares_light && !is_valid) {
            to->is_waiting = true;
            to->lowest = best;
            memcpy(to->x, x, bytes);
            memcpy(to->before, s->before, bytes);
            return MURK_OK;
        }
        /* Trace and evaluate; a failure after a step means that the step was
         * too long. */
        double cost;
        murk_error failure = {0};
        murk_status status = trace_at(s, is_valid, x, &cost, &failure);
        is_valid = false;
        const bool is_nowhere = status && status != MURK_NO_MEMORY &&
                                status != MURK_INTERRUPTED && isfinite(best) &&
                                s->traces < max;
        if (status && !is_nowhere) {
            return murk_fail(err, status, failure.where, "%s", failure.text);
        }
        /* Go back half the step after a failure or a large increase of the
         * cost. */
        if (is_nowhere ||
            (cost > 2 * best + (double)s->n_fitted && s->traces < max)) {
            for (size_t k = 0; k < s->n; ++k) { /* the step was too long */
                x[k] = .5 * (x[k] + s->before[k]);
            }
            continue;
        }
        /* Minimise over the re-weighted rows. */
        best = cost;
        memcpy(s->traced, x, bytes);
        memcpy(s->before, x, bytes);
        murk_least_squares_found found;
        const murk_least_squares problem = murk_fit_problem(s);
        bool settled_away = false;
        s->is_undersampled = false;
        status = murk_least_squares_solve(&found, x, &problem, err);
        status = status ? status : murk_interrupt_check(err);
        if (status) {
            return status;
        }
        /* Correct for photon noise in the slopes. */
        if (!s->is_undersampled && s->n_light &&
            found.end == MURK_LEAST_SQUARES_CONVERGED) {
            status = murk_fit_settle(s, x, err);
            if (status) {
                return status;
            }
            settled_away = s->is_undersampled;
        }
        /* End, or trace again. */
        if (!s->is_undersampled && !has_ended_away(s, x, &found, to)) {
            return murk_fit_search_evaluate(s, x, err);
        }
        if (s->traces >= max) {
            to->converged = false;
            snprintf(to->why, sizeof to->why,
                     "light was traced %zu times and still had to be traced "
                     "anew: start nearer, or free fewer keys",
                     s->traces);
            if (!s->is_undersampled) { /* without light of that world */
                memcpy(x, s->traced, bytes);
            }
            return murk_fit_search_evaluate(s, x, err);
        }
        /* Extrapolate to the point of the next trace. */
        if (s->is_undersampled && !settled_away) {
            memcpy(x, s->traced, bytes);
            status = murk_fit_leap(s, x, err);
            if (status) {
                return status;
            }
        }
    }
}

/* ---- starts ---- */

/* The value of key number k in start i: that of the scene if i is 0, else a
 * random one. */
static double start_of(const murk_free_key *key, uint32_t seed, size_t i,
                       size_t k)
{
    if (i == 0) {
        return key->start;
    }
    const double u =
        2 * murk_random(seed, MURK_FIT_START, i, (uint32_t)k, 0).u[0] - 1;
    double v;
    if (key->is_log) {
        v = key->start * pow(START_FACTOR, u);
    } else if (isfinite(key->lower) && isfinite(key->upper)) {
        v = .5 * (key->lower + key->upper +
                  START_SHARE * u * (key->upper - key->lower));
    } else {
        v = key->start + u * fmax(fabs(key->start), 1);
    }
    return fmin(fmax(v, key->lower), key->upper);
}

/* True if start a is better than b. A start that converged wins unless the
 * other is lower by more than the errors of n parameters explain; within one
 * minimum the earlier start is kept. */
static bool is_better(const murk_calibration_start *a,
                      const murk_calibration_start *b, size_t n)
{
    if (isnan(b->chi2) || a->converged == b->converged) {
        return isnan(b->chi2) || a->cost < b->cost - SAME_MINIMUM;
    }
    const double lead = (double)n;
    return a->cost < b->cost + (a->converged ? lead : -lead);
}

/* Adds advice to a message: not every value of an unbounded world key gives a
 * valid scene. */
static void advise_bounds(murk_error *failure, const murk_free_keys *keys,
                          murk_status status)
{
    const size_t length = strlen(failure->text);
    for (size_t k = 0; status == MURK_BAD_VALUE && k < keys->n; ++k) {
        const murk_free_key *key = &keys->key[k];
        if (key->kind == MURK_FREE_WORLD &&
            !(isfinite(key->lower) && isfinite(key->upper))) {
            snprintf(failure->text + length, sizeof failure->text - length,
                     "; bounds of %.80s keep the search inside", key->name);
            return;
        }
    }
}

/* Records the end of search `to`, at which the last prediction is. */
static void record_end(murk_calibration_start *to, murk_fit_search *s)
{
    s->ended = s->start;
    memcpy(to->x, s->x, s->n * sizeof *s->x);
    murk_fit_search_values(s, s->x, to->to);
    murk_fit_search_residuals(s, s->residual, NULL);
    to->chi2 = 0;
    for (size_t i = 0; i < s->n_fitted; ++i) {
        to->chi2 += s->residual[i] * s->residual[i];
    }
    to->cost = murk_fit_cost(s, s->residual);
}

/* Runs search i from s->x. best: as in search(). */
static murk_status run(murk_calibration *out, murk_fit_search *s, size_t i,
                       double best, murk_error *err)
{
    murk_calibration_start *to = &out->start[i];
    const size_t lights = murk_model_facts_of(s->model)->traces;
    const size_t evaluations = s->evaluations;
    const int iterations = s->iterations;
    s->start = i;
    s->traces = 0;
    s->ended = SIZE_MAX;
    s->is_dropped = to->is_waiting = false;
    to->chi2 = NAN;
    murk_error failure = {0};
    const murk_status status = search(s, to, best, &failure);
    /* Count. */
    to->traces = s->traces;
    to->lights += murk_model_facts_of(s->model)->traces - lights;
    to->evaluations += s->evaluations - evaluations;
    to->iterations += s->iterations - iterations;
    memcpy(to->lit, s->lit, s->n * sizeof *s->lit);
    /* A failure of a further start does not fail the fit, except an interrupt
     * and lack of memory. */
    if (status) {
        advise_bounds(&failure, s->desc->keys, status);
        snprintf(to->why, sizeof to->why, "%.250s", failure.text);
        if (i == 0 || status == MURK_INTERRUPTED || status == MURK_NO_MEMORY) {
            return murk_fail(err, status, failure.where, "%s", failure.text);
        }
    } else if (!s->is_dropped && !to->is_waiting) {
        record_end(to, s);
    }
    to->has_ended = !to->is_waiting;
    return MURK_OK;
}

/* Fills the values from which start i begins. */
static void set_start(murk_calibration *out, const murk_fit_search *s, size_t i)
{
    for (size_t k = 0; k < out->n; ++k) {
        out->start[i].from[k] =
            start_of(&s->desc->keys->key[k], s->desc->seed, i, k);
    }
}

murk_status murk_fit_start(murk_calibration *out, murk_fit_search *s, size_t i,
                           murk_error *err)
{
    set_start(out, s, i);
    murk_fit_search_coordinates(s, out->start[i].from, s->x);
    return run(out, s, i, INFINITY, err);
}

murk_status murk_fit_resume(murk_calibration *out, murk_fit_search *s, size_t i,
                            murk_error *err)
{
    const murk_calibration_start *start = &out->start[i];
    memcpy(s->x, start->x, s->n * sizeof *s->x);
    memcpy(s->before, start->before, s->n * sizeof *s->before);
    return run(out, s, i, start->lowest, err);
}

void murk_fit_complete(murk_calibration *out, const murk_fit_search *s,
                       size_t i)
{
    set_start(out, s, i);
    murk_fit_search_values(s, out->start[i].x, out->start[i].to);
}

murk_status murk_fit_return(const murk_calibration *out, murk_fit_search *s,
                            size_t i, murk_error *err)
{
    const murk_calibration_start *start = &out->start[i];
    const size_t lit_by = murk_fit_lit_by(out, i);
    murk_status status = MURK_OK;
    if (s->ended == i) {
        return MURK_OK;
    }
    if (s->lit_by != lit_by) {
        status = trace(s, lit_by, out->start[lit_by].lit, err);
    }
    memcpy(s->x, start->x, s->n * sizeof *s->x);
    status = status ? status : murk_fit_search_evaluate(s, s->x, err);
    s->ended = status ? SIZE_MAX : i;
    return status;
}

murk_status murk_fit_trace_end(const murk_calibration *out, murk_fit_search *s,
                               size_t i, murk_error *err)
{
    murk_fit_search_coordinates(s, out->start[i].to, s->x);
    const murk_status status = trace(s, SIZE_MAX, s->x, err);
    return status ? status : murk_fit_search_evaluate(s, s->x, err);
}

size_t murk_fit_lit_by(const murk_calibration *out, size_t i)
{
    return out->start[i].traces > 0 ? i : 0;
}

size_t murk_fit_best(const murk_calibration *out, size_t n)
{
    size_t best = 0;
    for (size_t i = 1; i < n; ++i) {
        const murk_calibration_start *start = &out->start[i];
        if (start->has_ended && !isnan(start->chi2) &&
            is_better(start, &out->start[best], out->n)) {
            best = i;
        }
    }
    return best;
}
