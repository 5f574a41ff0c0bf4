/* Runs the searches of a fit and summarises the best one: values, covariance
 * and confidence intervals, residuals of the rows, and held-out error. Photon
 * noise of the slopes is removed from the information (calibrate/slope_noise.h)
 * before the covariance is computed (fit/certainty.h). */
#include "calibrate/calibrate.h"

#include "base/interrupt.h"
#include "base/ranks.h"
#include "base/stats.h"
#include "calibrate/search.h"
#include "calibrate/slope_noise.h"
#include "calibrate/start_parts.h"
#include "calibrate/verdict.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A value is at a bound if it is not farther from the bound than this share of
 * the value, for keys that are searched in logarithms and for factors of
 * readings, whose size is arbitrary; else this share of the larger of the
 * absolute value and 1. */
#define AT_BOUND 1e-6

/* 97.5 % quantile of the standard normal distribution */
#define NORMAL_95 1.959963984540054

/* Allocates the result for n parameters, rows and starts. */
static murk_status allocate(murk_calibration *out, size_t n, size_t rows,
                            size_t starts, murk_error *err)
{
    murk_arena *arena = &out->arena;
    double **const of_n[] = {&out->value, &out->lower, &out->upper,
                             &out->standard_error, &out->scale};
    double **const of_pairs[] = {&out->covariance, &out->correlation,
                                 &out->information, &out->jacobian};
    for (size_t i = 0; i < sizeof of_n / sizeof *of_n; ++i) {
        *of_n[i] = murk_arena_array(arena, n, sizeof(double));
    }
    for (size_t i = 0; i < sizeof of_pairs / sizeof *of_pairs; ++i) {
        *of_pairs[i] = murk_arena_array(arena, n * n, sizeof(double));
    }
    /* Other arrays; each start has some of its own. */
    out->n = n;
    out->fitted = n;
    out->starts = starts;
    out->at_bound = murk_arena_array(arena, n, sizeof *out->at_bound);
    out->row = murk_arena_array(arena, rows, sizeof *out->row);
    out->start = murk_arena_array(arena, starts, sizeof *out->start);
    for (size_t i = 0; i < starts && out->start; ++i) {
        murk_calibration_start *start = &out->start[i];
        double **const of_start[] = {&start->from, &start->to, &start->x,
                                     &start->lit, &start->before};
        for (size_t k = 0; k < sizeof of_start / sizeof *of_start; ++k) {
            *of_start[k] = murk_arena_array(arena, n, sizeof(double));
        }
        start->chi2 = NAN;
    }
    return arena->is_short ? murk_no_memory(err, "", "for the fit") : MURK_OK;
}

void murk_calibration_release(murk_calibration *c)
{
    murk_certainty_release(&c->certainty);
    murk_model_destroy(c->model);
    murk_arena_release(&c->arena);
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
static void convert_errors(murk_calibration *out, const murk_free_keys *keys)
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

/* Adds the error of the slopes of world keys, which are differences of light
 * that is traced at two values of the key. Photons and the size of the step
 * cause this error, which adds to J^T J and so looks like information, as the
 * photon noise of other slopes does. */
static void add_world_noise(murk_slope_noise *noise, const murk_fit_search *s,
                            const double *jacobian)
{
    const size_t n = s->n;
    for (size_t k = 0; k < n; ++k) {
        const double off = murk_model_slope_error(s->model, k);
        for (size_t i = 0; i < s->n_light && off > 0; ++i) {
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
    murk_slope_noise noise;
    murk_fit_search_residuals(s, s->residual, s->jacobian);
    murk_status status = murk_slope_noise_find(&noise, s, err);
    if (!status) {
        add_world_noise(&noise, s, s->jacobian);
        status = murk_slope_noise_information(out->jacobian, &out->slope_noise,
                                              &noise, s->jacobian, s->n_fitted,
                                              s->n, err);
        out->slope_noise = fmin(out->slope_noise, 1); /* all of it is noise */
    }
    murk_slope_noise_release(&noise);
    return status;
}

/* Computes the uncertainty of the parameters. */
static murk_status find_errors(murk_calibration *out, const murk_fit_search *s,
                               murk_error *err)
{
    const size_t n = s->n;
    const murk_free_keys *keys = s->desc->keys;
    murk_status status = inform(out, s, err);
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
    status = status ? status
                    : murk_certainty_create(&out->certainty, out->jacobian,
                                            out->fitted, n, out->at_bound,
                                            out->scale, MURK_UNDETERMINED, err);
    if (!status) {
        convert_errors(out, keys);
    }
    return status;
}

/* Fills the predicted values, photon errors and residuals of all rows. */
static murk_status fill_rows(murk_calibration *out, const murk_fit_search *s,
                             murk_error *err)
{
    const murk_model_facts *facts = murk_model_facts_of(s->model);
    const size_t *light = facts->light, n = facts->lights;
    double *noise;
    const murk_status status = murk_model_noise(s->model, &noise, err);
    if (status) {
        return status;
    }
    for (size_t i = 0; i < n; ++i) {
        out->row[light[i]].photon_error = sqrt(noise[i * n + i]);
    }
    for (size_t i = 0; i < s->rows; ++i) {
        murk_calibrated_row *row = &out->row[i];
        row->predicted = s->predicted[i];
        row->residual = (s->measured[i] - row->predicted) /
                        hypot(s->error[i], row->photon_error);
    }
    free(noise);
    return MURK_OK;
}

/* Computes the root mean square residual of the held-out rows. */
static void judge_held_out(murk_calibration *out, const murk_fit_search *s)
{
    double squares = 0, sigmas = 0;
    bool is_one_unit = true;
    const murk_reading *first = NULL;
    for (size_t i = 0; i < s->rows; ++i) {
        const murk_reading *reading = murk_reading_of_row(s->desc->measured, i);
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
static murk_status fill_result(murk_calibration *out, const murk_fit_search *s,
                               murk_error *err)
{
    const murk_calibration_start *best = &out->start[out->best];
    memcpy(out->value, best->to, out->n * sizeof *out->value);
    out->chi2 = best->chi2;
    out->converged = best->converged;
    snprintf(out->why, sizeof out->why, "%s", best->why);
    out->effective_share = s->share;
    murk_status status = fill_rows(out, s, err);
    if (!status) {
        judge_held_out(out, s);
        status = find_errors(out, s, err);
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
static murk_status trace_and_evaluate(murk_fit_search *s, const double *value,
                                      murk_error *err)
{
    murk_fit_search_coordinates(s, value, s->x);
    const murk_status status = murk_model_trace(s->model, value, err);
    return status ? status : murk_fit_search_evaluate(s, s->x, err);
}

/* Evaluates the start values only. */
static murk_status only_predict(murk_calibration *out, murk_fit_search *s,
                                murk_error *err)
{
    for (size_t k = 0; k < out->n; ++k) {
        out->value[k] = s->desc->keys->key[k].start;
    }
    murk_status status = trace_and_evaluate(s, out->value, err);
    status = status ? status : fill_rows(out, s, err);
    if (!status) {
        judge_held_out(out, s);
        out->traces = murk_model_facts_of(s->model)->traces;
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

/* True if the end of start `number` may be a false minimum: for a correct model
 * a cost of at least this size has a probability below MURK_FIT_REFUSED, or a
 * value ended at a bound. The cost includes the robust loss, because outliers
 * that the user asked to tolerate are no reason to search again. */
static bool is_doubtful(const murk_calibration *out, const murk_fit_search *s,
                        size_t number)
{
    const murk_calibration_start *best = &out->start[number];
    size_t at_bound = 0;
    for (size_t k = 0; k < out->n; ++k) {
        at_bound += is_at_bound(&s->desc->keys->key[k], best->to[k]);
    }
    const double freedom = (double)s->n_fitted - (double)(out->n - at_bound);
    return at_bound > 0 ||
           murk_chi2_upper(best->cost, freedom) < MURK_FIT_REFUSED;
}

/* The starts that are run here: those of the shard, or of this rank. */
static murk_shard share_of(const murk_fit_search *s)
{
    return murk_ranks_count() > 1
               ? (murk_shard){murk_ranks_number() + 1, murk_ranks_count()}
               : s->desc->shard;
}

/* True if start i is to be run here: it is one of the shard, and in no part. */
static bool is_due(const murk_calibration *out, murk_shard shard, size_t i)
{
    const bool is_mine =
        i == 0 || !shard.count || (i - 1) % shard.count == shard.number - 1;
    return is_mine && !out->start[i].has_ended;
}

/* Lets further starts follow the light of start 0. */
static murk_status share_light(murk_calibration *out, murk_fit_search *s,
                               murk_error *err)
{
    const murk_status status = murk_fit_return(out, s, 0, err);
    s->scouting = s->whitening;
    s->whitening = NULL;
    s->cost_to_beat = out->start[0].cost;
    s->shares_light = true;
    return status;
}

/* After ranks have run starts by themselves, their light and last prediction
 * differ. All must do the same from here on, so a rank forgets which prediction
 * it has, and its light as well if any start traced another one. */
static void agree_on_light(const murk_calibration *out, murk_fit_search *s)
{
    for (size_t i = 1; i < starts_asked(s->desc); ++i) {
        if (out->start[i].traces > 0) {
            s->lit_by = SIZE_MAX;
        }
    }
    s->ended = SIZE_MAX;
}

/* Runs the requested starts. Start 0 traces light. Each other one follows that
 * light and depends on nothing else, so the starts may run in any order. Those
 * that have to trace light do so when all have followed the light of start
 * 0. */
static murk_status run_starts(murk_calibration *out, murk_fit_search *s,
                              murk_error *err)
{
    const size_t asked = starts_asked(s->desc);
    const murk_shard share = share_of(s);
    murk_status status =
        is_due(out, share, 0) ? murk_fit_start(out, s, 0, err) : MURK_OK;
    /* Ranks run the further starts alone, and exchange them afterwards. */
    const murk_ranks *ranks = murk_ranks_leave();
    for (size_t i = 1; i < asked && !status; ++i) {
        if (!is_due(out, share, i)) {
            continue;
        }
        status = s->shares_light ? MURK_OK : share_light(out, s, err);
        status = status ? status : murk_fit_start(out, s, i, err);
    }
    s->shares_light = false;
    for (size_t i = 1; i < asked && !status; ++i) {
        if (out->start[i].is_waiting) {
            status = murk_fit_resume(out, s, i, err);
        }
    }
    murk_ranks_return(ranks);
    if (murk_ranks_count() > 1) {
        status = murk_starts_exchange(out, s, status, err);
        agree_on_light(out, s);
    }
    return status;
}

/* Runs restarts with light of their own, while the best start is doubtful.
 * *done: number of starts and restarts. */
static murk_status run_restarts(murk_calibration *out, murk_fit_search *s,
                                size_t *done, murk_error *err)
{
    murk_status status = MURK_OK;
    *done = starts_asked(s->desc);
    while (*done < out->starts && !status &&
           is_doubtful(out, s, murk_fit_best(out, *done))) {
        status = is_due(out, s->desc->shard, *done)
                     ? murk_fit_start(out, s, *done, err)
                     : MURK_OK;
        *done += !status;
    }
    return status;
}

/* Number of starts that have ended, of which none is left out. */
static size_t starts_ended(const murk_calibration *out)
{
    size_t n = 0;
    while (n < out->starts && out->start[n].has_ended) {
        ++n;
    }
    return n;
}

/* Sums the counts of the starts that were done. *last, *lit: numbers of the
 * start that ended last, and of the one that traced light last; starts that
 * trace no light end before those that do. */
static void count_work(murk_calibration *out, size_t *last, size_t *lit)
{
    *last = out->starts_done - 1;
    *lit = 0;
    for (size_t i = 0; i < out->starts_done; ++i) {
        const murk_calibration_start *start = &out->start[i];
        out->traces += start->lights;
        out->evaluations += start->evaluations;
        out->iterations += start->iterations;
        if (i > 0 && start->traces > 0) {
            *last = *lit = i;
        }
    }
}

/* Evaluates the end of the best start, unless that start ended last. If another
 * start has traced light since, light is traced at that end. */
static murk_status return_to_best(murk_calibration *out, murk_fit_search *s,
                                  murk_error *err)
{
    size_t last, lit;
    count_work(out, &last, &lit);
    out->evaluations += out->best != last;
    if (murk_fit_lit_by(out, out->best) == lit) {
        return murk_fit_return(out, s, out->best, err);
    }
    const size_t traces = murk_model_facts_of(s->model)->traces;
    const murk_status status = murk_fit_trace_end(out, s, out->best, err);
    out->traces += murk_model_facts_of(s->model)->traces - traces;
    return status;
}

/* Runs the starts and restarts, and returns to the best. */
static murk_status run(murk_calibration *out, murk_fit_search *s,
                       murk_error *err)
{
    size_t done = 0;
    murk_status status = run_starts(out, s, err);
    if (!status) {
        status = run_restarts(out, s, &done, err);
    }
    if (status) {
        /* The ended starts are known, and the values of the best of them. */
        out->starts_done = starts_ended(out);
        out->best = murk_fit_best(out, out->starts_done);
        return status;
    }
    out->starts_done = done;
    out->best = murk_fit_best(out, done);
    if (s->desc->shard.count) {
        return MURK_OK; /* the starts of a part alone */
    }
    status = return_to_best(out, s, err);
    return status ? status : fill_result(out, s, err);
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
        allocate(out, desc->keys->n, desc->measured->rows, starts, err);
    if (status || (status = murk_model_create(&out->model, &model_desc, err)) ||
        (status = murk_fit_search_create(&search, desc, out->model, err))) {
        goto done;
    }
    if (desc->parts > 0) {
        status = murk_start_parts_read(out, &search, err);
    }
    if (!status) {
        status = desc->only_predicts ? only_predict(out, &search, err)
                                     : run(out, &search, err);
    }
done:
    if (out->model) {
        const murk_model_facts *facts = murk_model_facts_of(out->model);
        out->photons = facts->photons;
        out->trace_s = facts->trace_s;
    }
    murk_fit_search_release(&search);
    return status;
}

murk_status murk_calibrate_part(const murk_calibration_desc *desc,
                                const char *path, murk_error *err)
{
    murk_calibration found = {0};
    murk_status status = murk_shard_check(desc->shard, err);
    if (!status && (desc->only_predicts || desc->starts == 1)) {
        status = murk_fail(err, MURK_BAD_VALUE, "shard",
                           "divides the starts of a fit, and %s",
                           desc->only_predicts ? "a prediction has none"
                                               : "there is only one");
    }
    status = status ? status : murk_calibrate(&found, desc, err);
    status = status ? status : murk_start_part_write(&found, desc, path, err);
    murk_calibration_release(&found);
    return status;
}
