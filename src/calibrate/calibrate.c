/* Runs the searches of a fit and summarises the best one: values, covariance
 * and confidence intervals, residuals of the rows, and held-out error. Photon
 * noise of the slopes is removed from the information (calibrate/slope_noise.h)
 * before the covariance is computed (fit/certainty.h). */
#include "calibrate/calibrate.h"

#include "base/interrupt.h"
#include "base/stats.h"
#include "calibrate/search_steps.h"
#include "calibrate/slope_noise.h"
#include "calibrate/starts.h"
#include "calibrate/verdict.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A value is at a bound if it is closer than this share of itself or of 1; for
 * a factor of readings, whose size is arbitrary, of itself. */
#define AT_BOUND 1e-6

/* 97.5 % quantile of the standard normal distribution */
#define NORMAL_95 1.959963984540054

static murk_status no_memory(murk_error *err)
{
    return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the fit");
}

/* Allocates the result for n parameters, rows and starts. */
static murk_status set_aside(murk_calibration *out, size_t n, size_t rows,
                             size_t starts, murk_error *err)
{
    out->n = n;
    out->value = calloc(n + 1, sizeof *out->value);
    out->lower = calloc(n + 1, sizeof *out->lower);
    out->upper = calloc(n + 1, sizeof *out->upper);
    out->standard_error = calloc(n + 1, sizeof *out->standard_error);
    out->at_bound = calloc(n + 1, sizeof *out->at_bound);
    out->covariance = calloc(n * n + 1, sizeof *out->covariance);
    out->correlation = calloc(n * n + 1, sizeof *out->correlation);
    out->information = calloc(n * n + 1, sizeof *out->information);
    out->row = calloc(rows + 1, sizeof *out->row);
    out->start = calloc(starts + 1, sizeof *out->start);
    /* The starts have arrays of their own. */
    bool has_memory = out->value && out->lower && out->upper &&
                      out->standard_error && out->at_bound && out->covariance &&
                      out->correlation && out->information && out->row &&
                      out->start;
    for (size_t i = 0; has_memory && i < starts; ++i) {
        out->start[i].from = calloc(n + 1, sizeof(double));
        out->start[i].to = calloc(n + 1, sizeof(double));
        out->start[i].chi2 = NAN;
        has_memory = out->start[i].from && out->start[i].to;
        out->starts = i + 1;
    }
    return has_memory ? MURK_OK : no_memory(err);
}

void murk_calibration_release(murk_calibration *c)
{
    for (size_t i = 0; i < c->starts; ++i) {
        free(c->start[i].from);
        free(c->start[i].to);
    }
    murk_certainty_release(&c->certainty);
    murk_model_destroy(c->model);
    free(c->start);
    free(c->value);
    free(c->lower);
    free(c->upper);
    free(c->standard_error);
    free(c->at_bound);
    free(c->covariance);
    free(c->correlation);
    free(c->information);
    free(c->jacobian);
    free(c->scale);
    free(c->row);
    *c = (murk_calibration){0};
}

/* ---- result ---- */

/* The size of a large change of a parameter in search coordinates. */
static double scale_of(const murk_free_key *key, double value)
{
    if (key->is_log) {
        return 1;
    }
    if (key->kind == MURK_FREE_GAIN && value > 0) {
        return value; /* a factor of readings may have any size */
    }
    return isfinite(key->lower) && isfinite(key->upper)
               ? key->upper - key->lower
               : fmax(fabs(value), 1);
}

static bool is_at_bound(const murk_free_key *key, double value)
{
    const double at = key->is_log ? log(value) : value;
    const double size = key->is_log                   ? 1
                        : key->kind == MURK_FREE_GAIN ? fabs(value)
                                                      : fmax(1, fabs(value));
    const double near = AT_BOUND * size;
    return at - murk_free_lowest(key) <= near ||
           murk_free_highest(key) - at <= near;
}

/* Computes standard errors, intervals, covariance and correlation of the values
 * from those in search coordinates. */
static void tell_values(murk_calibration *out, const murk_free_keys *keys)
{
    const size_t n = out->n;
    for (size_t k = 0; k < n; ++k) {
        /* The standard error of a logarithm is a relative error. */
        const bool is_log = keys->key[k].is_log;
        const double v = out->value[k];
        const double error = out->certainty.standard_error[k];
        out->standard_error[k] = is_log ? v * error : error;
        const double reach = NORMAL_95 * error;
        /* Intervals end at the limits of a key; NaN stays NaN. */
        const double low = is_log ? v * exp(-reach) : v - reach;
        const double high = is_log ? v * exp(reach) : v + reach;
        out->lower[k] = low < keys->key[k].lower ? keys->key[k].lower : low;
        out->upper[k] = high > keys->key[k].upper ? keys->key[k].upper : high;
        /* Covariance by the chain rule; correlation does not change. */
        for (size_t j = 0; j < n; ++j) {
            out->covariance[k * n + j] =
                out->certainty.covariance[k * n + j] *
                ((is_log ? v : 1) * (keys->key[j].is_log ? out->value[j] : 1));
            out->correlation[k * n + j] = out->certainty.correlation[k * n + j];
        }
    }
}

/* Adds the noise of slopes that come from light traced at two values: such
 * noise, too, looks like information. */
static void add_world_noise(murk_slope_noise *noise, const murk_fit_search *s,
                            const double *jacobian)
{
    const size_t n = s->n;
    for (size_t k = 0; k < n; ++k) {
        const double off = murk_model_slope_error(s->model, k);
        for (size_t i = 0; i < s->n_lit && off > 0; ++i) {
            const double noisy = off * jacobian[i * n + k];
            noise->noise[k * n + k] += noisy * noisy;
        }
    }
}

/* Computes the rows that carry the information of the data without photon
 * noise. */
static murk_status inform(murk_calibration *out, const murk_fit_search *s,
                          murk_error *err)
{
    const size_t n = s->n, rows = s->n_fitted;
    double *room = calloc(rows * (n + 1) + 1, sizeof *room);
    out->jacobian = calloc(n * n + 1, sizeof *out->jacobian);
    out->fitted = n;
    if (!room || !out->jacobian) {
        free(room);
        return no_memory(err);
    }
    /* Residuals and Jacobian of the last evaluation. */
    murk_slope_noise noise;
    murk_fit_search_residuals(s, room, room + rows);
    murk_status status = murk_slope_noise_find(&noise, s, err);
    /* Remove the noise of the slopes. */
    if (!status) {
        add_world_noise(&noise, s, room + rows);
        status =
            murk_slope_noise_information(out->jacobian, &out->slope_noise,
                                         &noise, room + rows, rows, n, err);
        out->slope_noise = fmin(out->slope_noise, 1); /* all of it is noise */
    }
    murk_slope_noise_release(&noise);
    free(room);
    return status;
}

/* Computes the uncertainty of the parameters. */
static murk_status be_certain(murk_calibration *out, const murk_fit_search *s,
                              murk_error *err)
{
    const size_t n = s->n;
    const murk_free_keys *keys = s->desc->keys;
    out->scale = calloc(n + 1, sizeof *out->scale);
    murk_status status = out->scale ? inform(out, s, err) : no_memory(err);
    /* Scales, and parameters at a bound. */
    for (size_t k = 0; k < n && !status; ++k) {
        out->scale[k] = scale_of(&keys->key[k], out->value[k]);
        out->at_bound[k] = is_at_bound(&keys->key[k], out->value[k]);
    }
    /* The Fisher information. */
    for (size_t i = 0; i < out->fitted && !status; ++i) {
        for (size_t k = 0; k < n * n; ++k) {
            out->information[k] +=
                out->jacobian[i * n + k / n] * out->jacobian[i * n + k % n];
        }
    }
    /* Covariance and undetermined directions. */
    if (!status) {
        status = murk_certainty_create(&out->certainty, out->jacobian,
                                       out->fitted, n, out->at_bound,
                                       out->scale, MURK_UNDETERMINED, err);
    }
    if (!status) {
        tell_values(out, keys);
    }
    return status;
}

/* Fills the predicted values, photon errors and residuals of all rows. */
static murk_status tell_rows(murk_calibration *out, const murk_fit_search *s,
                             murk_error *err)
{
    const size_t *lit;
    size_t n;
    double *noise;
    const murk_status status =
        murk_model_noise(s->model, &lit, &n, &noise, err);
    if (status) {
        return status;
    }
    for (size_t i = 0; i < s->rows; ++i) {
        out->row[i] = (murk_calibrated_row){.predicted = s->predicted[i]};
    }
    for (size_t i = 0; i < n; ++i) {
        out->row[lit[i]].photon_error = sqrt(noise[i * n + i]);
    }
    for (size_t i = 0; i < s->rows; ++i) {
        murk_calibrated_row *row = &out->row[i];
        row->residual = (s->measured[i] - row->predicted) /
                        hypot(s->error[i], row->photon_error);
    }
    free(noise);
    return MURK_OK;
}

/* Computes the root mean square residual of the held-out rows. */
static void judge_held_out(murk_calibration *out, const murk_fit_search *s)
{
    const murk_measurements *measured = s->desc->measured;
    double squares = 0, sigmas = 0;
    bool is_one_unit = true;
    const murk_reading *first = NULL;
    for (size_t i = 0; i < s->rows; ++i) {
        const murk_reading *reading =
            &measured->reading[measured->row[i].first];
        if (!reading->is_held_out) {
            continue;
        }
        first = first ? first : reading;
        is_one_unit = is_one_unit && reading->unit == first->unit &&
                      reading->kind == first->kind;
        const double off = s->measured[i] - s->predicted[i];
        squares += off * off;
        sigmas += out->row[i].residual * out->row[i].residual;
        ++out->held_out;
    }
    const double n = (double)out->held_out;
    out->held_out_rms = n > 0 && is_one_unit ? sqrt(squares / n) : NAN;
    out->held_out_rms_sigma = n > 0 ? sqrt(sigmas / n) : NAN;
}

/* Fills the result from the search, which has evaluated the end of the best
 * start. */
static murk_status tell(murk_calibration *out, const murk_fit_search *s,
                        murk_error *err)
{
    const murk_calibration_start *best = &out->start[out->best];
    memcpy(out->value, best->to, out->n * sizeof *out->value);
    out->chi2 = best->chi2;
    out->converged = best->converged;
    snprintf(out->why, sizeof out->why, "%s", best->why);
    out->effective_share = s->share;
    murk_status status = tell_rows(out, s, err);
    if (!status) {
        judge_held_out(out, s);
        status = be_certain(out, s, err);
    }
    /* Parameters at a bound are not free. */
    long free_ones = 0;
    for (size_t k = 0; k < out->n; ++k) {
        free_ones += !out->at_bound[k];
    }
    out->degrees_of_freedom = (long)s->n_fitted - free_ones;
    murk_calibration_judge(out, s->desc->keys);
    return status;
}

/* ---- starts ---- */

/* Traces light at the values and evaluates the rows there. */
static murk_status look_at(murk_fit_search *s, murk_model *model,
                           const double *value, double *x, murk_error *err)
{
    murk_fit_search_coordinates(s, value, x);
    murk_status status = murk_model_trace(model, value, err);
    return status ? status : murk_fit_search_look(s, x, err);
}

/* Evaluates the start values only. */
static murk_status only_predict(murk_calibration *out, murk_fit_search *s,
                                murk_model *model, double *x, murk_error *err)
{
    for (size_t k = 0; k < out->n; ++k) {
        out->value[k] = s->desc->keys->key[k].start;
    }
    murk_status status = look_at(s, model, out->value, x, err);
    if (!status) {
        status = tell_rows(out, s, err);
    }
    if (!status) {
        judge_held_out(out, s);
        out->effective_share = s->share;
        out->chi2 = NAN;
        snprintf(out->why, sizeof out->why, "nothing was fitted");
    }
    return status;
}

static size_t starts_asked(const murk_calibration_desc *desc)
{
    return desc->starts ? desc->starts : MURK_FIT_STARTS;
}

/* True if the best start so far may be a false minimum: the cost is impossible
 * for a correct model, or a value ended at a bound. The cost includes the
 * robust loss, because outliers that the user asked to tolerate are no reason
 * to search again. */
static bool is_doubtful(const murk_calibration *out, const murk_fit_search *s)
{
    const murk_calibration_start *best = &out->start[out->best];
    size_t at_bound = 0;
    for (size_t k = 0; k < out->n; ++k) {
        at_bound += is_at_bound(&s->desc->keys->key[k], best->to[k]);
    }
    const double freedom = (double)s->n_fitted - (double)(out->n - at_bound);
    return at_bound > 0 ||
           murk_chi2_upper(best->cost, freedom) < MURK_FIT_REFUSED;
}

/* Runs the starts, then restarts, and returns to the best. */
static murk_status run(murk_calibration *out, murk_fit_search *s,
                       murk_model *model, murk_error *err)
{
    const murk_calibration_desc *desc = s->desc;
    double *x = calloc(out->n + 1, sizeof *x);
    murk_status status = x ? MURK_OK : no_memory(err);
    if (!status && desc->only_predicts) {
        status = only_predict(out, s, model, x, err);
        free(x);
        return status;
    }
    /* The requested starts: the first traces light, the others use that light
     * as far as it is valid. */
    const size_t asked = starts_asked(desc);
    size_t done = 0;
    for (; done < asked && !status; ++done) {
        s->shares_light = done > 0;
        status = murk_fit_start(out, s, done, x, err);
    }
    /* Restarts with light of their own, while the best start is doubtful. */
    s->shares_light = false;
    for (; done < out->starts && !status && is_doubtful(out, s); ++done) {
        status = murk_fit_start(out, s, done, x, err);
    }
    const bool is_cut = status == MURK_INTERRUPTED && done > 1;
    out->starts_done = is_cut ? done - 1 : done;
    if (is_cut) {
        free(x);
        return status; /* the values of the best start; nothing else is known */
    }
    /* Evaluate the best start again, with the light at hand if that light was
     * traced for it. */
    const murk_calibration_start *best = &out->start[out->best];
    if (!status && out->best + 1 != done) {
        const bool is_lit =
            s->has_light && best->light == murk_model_traces(model);
        murk_fit_search_coordinates(s, best->to, x);
        status = is_lit ? murk_fit_search_look(s, x, err)
                        : look_at(s, model, best->to, x, err);
    }
    if (!status) {
        status = tell(out, s, err);
    }
    free(x);
    return status;
}

murk_status murk_calibrate(murk_calibration *out,
                           const murk_calibration_desc *desc, murk_error *err)
{
    *out = (murk_calibration){.held_out_rms = NAN, .held_out_rms_sigma = NAN};
    const murk_model_desc model_desc = {.keys = desc->keys,
                                        .measured = desc->measured,
                                        .imported = desc->imported,
                                        .threads = desc->threads,
                                        .forecast = desc->forecast,
                                        .context = desc->context};
    murk_fit_search search = {0};
    /* As many restarts as there are starts beside the first. */
    const size_t starts = desc->only_predicts ? 0 : 2 * starts_asked(desc) - 1;
    murk_status status =
        set_aside(out, desc->keys->n, desc->measured->rows, starts, err);
    if (!status) {
        status = murk_model_create(&out->model, &model_desc, err);
    }
    if (!status) {
        status = murk_fit_search_create(&search, desc, out->model, err);
    }
    if (!status) {
        status = run(out, &search, out->model, err);
    }
    const murk_model *model = out->model;
    if (model) {
        out->evaluations = search.evaluations;
        out->iterations = search.iterations;
        out->traces = murk_model_traces(model);
        out->photons = murk_model_photons(model);
        out->trace_s = murk_model_trace_s(model);
    }
    murk_fit_search_release(&search);
    return status;
}
