/* Creates a search, whitens its rows, and evaluates residuals for the solver.
 */
#include "calibrate/search_state.h"

#include "base/interrupt.h"
#include "base/ranks.h"

#include <math.h>
#include <stdlib.h>

/* A key that is searched in logarithms may change by at most this factor from
 * the start. At that limit the key is practically zero or infinite, and is
 * reported as being at a bound; logarithms have no limit of their own. */
#define MURK_FREE_REACH 1e9

double murk_free_lowest(const murk_free_key *key)
{
    return key->is_log ? log(fmax(key->lower, key->start / MURK_FREE_REACH))
                       : key->lower;
}

double murk_free_highest(const murk_free_key *key)
{
    return key->is_log ? log(fmin(key->upper, key->start * MURK_FREE_REACH))
                       : key->upper;
}

/* Lists the fitted rows: those that need light first, with their numbers among
 * all rows that need light. */
static void list_rows(murk_fit_search *s)
{
    for (size_t pass = 0; pass < 2; ++pass) {
        for (size_t i = 0, light = 0; i < s->rows; ++i) {
            const murk_reading *reading =
                murk_reading_of_row(s->desc->measured, i);
            const bool needs_light = murk_reading_needs_light(reading->kind);
            s->measured[i] = reading->value;
            s->error[i] = reading->standard_error;
            if (!reading->is_held_out && needs_light == (pass == 0)) {
                s->fitted[s->n_fitted++] = i;
                if (needs_light) {
                    s->place[s->n_light++] = light;
                }
            }
            light += needs_light;
        }
    }
}

murk_status murk_fit_search_create(murk_fit_search *out,
                                   const murk_calibration_desc *desc,
                                   murk_model *model, murk_error *err)
{
    const size_t n = desc->keys->n, rows = desc->measured->rows;
    *out = (murk_fit_search){.desc = desc,
                             .model = model,
                             .n = n,
                             .rows = rows,
                             .lit_by = SIZE_MAX,
                             .ended = SIZE_MAX};
    /* Arrays by key and by row. */
    murk_arena *arena = &out->arena;
    double **const of_n[] = {&out->x,   &out->lower,  &out->upper, &out->traced,
                             &out->lit, &out->before, &out->value};
    double **const of_rows[] = {&out->measured, &out->error, &out->predicted,
                                &out->offset, &out->residual};
    for (size_t i = 0; i < sizeof of_n / sizeof *of_n; ++i) {
        *of_n[i] = murk_arena_array(arena, n, sizeof(double));
    }
    for (size_t i = 0; i < sizeof of_rows / sizeof *of_rows; ++i) {
        *of_rows[i] = murk_arena_array(arena, rows, sizeof(double));
    }
    out->fitted = murk_arena_array(arena, rows, sizeof *out->fitted);
    out->place = murk_arena_array(arena, rows, sizeof *out->place);
    out->slope = murk_arena_array(arena, rows * n, sizeof(double));
    out->jacobian = murk_arena_array(arena, rows * n, sizeof(double));
    if (arena->is_short) {
        return murk_no_memory(err, "", "for the search");
    }
    list_rows(out);
    for (size_t k = 0; k < n; ++k) {
        out->lower[k] = murk_free_lowest(&desc->keys->key[k]);
        out->upper[k] = murk_free_highest(&desc->keys->key[k]);
    }
    return MURK_OK;
}

void murk_fit_search_release(murk_fit_search *s)
{
    murk_whitening_destroy(s->whitening);
    murk_whitening_destroy(s->scouting);
    murk_arena_release(&s->arena);
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

/* Computes the whitening of the fitted rows that need light, from their
 * covariance: photons plus measurement errors. */
static murk_status whiten(murk_fit_search *s, murk_error *err)
{
    murk_whitening_destroy(s->whitening);
    s->whitening = NULL;
    if (s->n_light == 0) {
        return MURK_OK;
    }
    const size_t lights = murk_model_facts_of(s->model)->lights;
    double *all, *covariance = calloc(s->n_light * s->n_light, sizeof(double));
    murk_status status = murk_model_noise(s->model, &all, err);
    if (!status && !covariance) {
        status = murk_no_memory(err, "", "for the search");
    }
    /* Copy the covariance of the fitted rows. */
    for (size_t i = 0; i < s->n_light && !status; ++i) {
        for (size_t j = 0; j < s->n_light; ++j) {
            covariance[i * s->n_light + j] =
                all[s->place[i] * lights + s->place[j]];
        }
        const double error = s->error[s->fitted[i]];
        covariance[i * s->n_light + i] += error * error;
    }
    status = status ? status
                    : murk_whitening_create(&s->whitening, covariance,
                                            s->n_light, err);
    free(covariance);
    free(all);
    return status;
}

murk_status murk_fit_search_predict(murk_fit_search *s, const double *x,
                                    bool with_slopes, murk_error *err)
{
    ++s->evaluations;
    murk_fit_search_values(s, x, s->value);
    /* Ranks search side by side, and divide an evaluation of one point. */
    const murk_status status = murk_ranks_check_same(
        "point of the search", x, s->n * sizeof *x, MURK_OK, err);
    if (status) {
        return murk_ranks_agree(status, err); /* final: it is not tolerated */
    }
    return murk_model_predict(s->model, s->value, s->predicted,
                              with_slopes ? s->slope : NULL, &s->share, err);
}

murk_status murk_fit_search_evaluate(murk_fit_search *s, const double *x,
                                     murk_error *err)
{
    const murk_status status = murk_fit_search_predict(s, x, true, err);
    return status ? status : whiten(s, err);
}

void murk_fit_search_residuals(const murk_fit_search *s, double *residual,
                               double *jacobian)
{
    /* Residuals and slopes; rows without photons are divided by their error. */
    for (size_t i = 0; i < s->n_fitted; ++i) {
        const size_t row = s->fitted[i];
        const double scale = i < s->n_light ? 1 : 1 / s->error[row];
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

double murk_fit_cost(const murk_fit_search *s, const double *residual)
{
    double sum = 0, slope;
    for (size_t i = 0; i < s->n_fitted; ++i) {
        sum += murk_loss_at(s->desc->loss, s->desc->loss_width,
                            residual[i] * residual[i], &slope);
    }
    return sum;
}

/* The residuals for the solver, with the offset against slope noise. */
static bool evaluate(void *context, const double *x, double *residual,
                     double *jacobian)
{
    murk_fit_search *s = context;
    s->err = (murk_error){0};
    const murk_status status =
        murk_fit_search_predict(s, x, jacobian != NULL, &s->err);
    if (status == MURK_NO_MEMORY || status == MURK_INTERRUPTED) {
        /* The solver goes on with a shorter step, and must not do so in one
         * rank alone. */
        (void)murk_ranks_agree(status, &s->err);
    }
    if (status) {
        return false;
    }
    murk_fit_search_residuals(s, residual, jacobian);
    for (size_t i = 0; i < s->n_fitted; ++i) {
        residual[i] += s->offset[i];
    }
    return true;
}

/* Called for the start and after each step of the solver: reports progress, and
 * ends the solver if the light is no longer valid or after an interrupt. */
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

murk_least_squares murk_fit_problem(murk_fit_search *s)
{
    return (murk_least_squares){.n = s->n,
                                .rows = s->n_fitted,
                                .lower = s->lower,
                                .upper = s->upper,
                                .residuals = evaluate,
                                .watch = watch,
                                .context = s,
                                .loss = s->desc->loss,
                                .loss_width = s->desc->loss_width};
}
