/* Fits with a known answer: light of many photons at the planted values gives
 * exact readings, each seed adds noise to them, and the fit is compared with
 * the planted values and with plain least squares. */
#include "planted.h"

#include "base/rng.h"
#include "calibrate/slope_noise.h"
#include "world/stage_build.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Seeds of the truth's light: beyond those of fits. */
#define TRUTH_SEED 1000000u

/* Newton steps of the plain fit, which starts a fraction of an error away. */
#define PLAIN_STEPS 4

const planted_case planted_fog = {
    .name = "fog",
    .scene = "scenes/calibrate-fog.yaml",
    .data = "scenes/calibrate/fog.csv",
    .n = 2,
    .key = {"media.fog.extinction_per_m", "media.fog.phase.hg"},
    .truth = {.22, .87},
    .emit = 20000};

const planted_case planted_smoke = {
    .name = "smoke",
    .scene = "scenes/calibrate-smoke.yaml",
    .data = "scenes/calibrate/smoke.csv",
    .n = 2,
    .key = {"media.smoke.extinction_per_m", "media.smoke.albedo"},
    .truth = {3, .6},
    .emit = 40000};

const planted_case planted_water = {
    .name = "water",
    .scene = "scenes/calibrate-water.yaml",
    .data = "scenes/calibrate/water.csv",
    .n = 6,
    .key = {"media.sea.extinction_per_m.0", "media.sea.extinction_per_m.1",
            "media.sea.extinction_per_m.2", "media.sea.albedo.0",
            "media.sea.albedo.1", "media.sea.albedo.2"},
    .truth = {.12, .14, .34, .8, .75, .3},
    .emit = 100000};

const planted_case planted_coverage = {.name = "coverage",
                                       .scene =
                                           "scenes/calibrate-coverage.yaml",
                                       .data = "scenes/calibrate/coverage.csv",
                                       .n = 1,
                                       .key = {"media.fog.visibility_m"},
                                       .truth = {30},
                                       .emit = 3000};

static bool held(murk_status status, const murk_error *err)
{
    if (status) {
        printf("%s: %s\n", err->where, err->text);
    }
    return !status;
}

bool planted_open(planted_field *f, const planted_case *of)
{
    *f = (planted_field){.of = of};
    murk_error err = {0};
    murk_status status =
        murk_scene_desc_read(&f->scene, of->scene, NULL, 0, &err);
    if (!status) {
        status = murk_imported_stages_import(&f->imported, f->scene, &err);
    }
    if (!status) {
        status = murk_stage_import_beside(&f->stage, f->scene,
                                          f->imported.stage[0], &err);
    }
    if (!status) {
        status = murk_stage_build(f->stage, &err);
    }
    if (!status) {
        status = murk_readings_read(&f->measured, of->data, f->scene,
                                    &f->stage->world.domain, &err);
    }
    if (!status) {
        f->truth = calloc(f->measured->rows, sizeof *f->truth);
    }
    return held(status, &err) && f->truth;
}

void planted_close(planted_field *f)
{
    free(f->truth);
    murk_readings_destroy(f->measured);
    murk_stage_destroy(f->stage); /* borrows of the imported stages */
    murk_imported_stages_release(&f->imported);
    murk_scene_desc_destroy(f->scene);
    *f = (planted_field){0};
}

murk_free_keys *planted_keys(planted_field *f, unsigned emit, uint32_t seed)
{
    snprintf(f->text[0], sizeof f->text[0], "seed=%u", seed);
    snprintf(f->text[1], sizeof f->text[1], "photons.emit=%u", emit);
    for (size_t i = 0; i < 2; ++i) {
        f->override[i] = (murk_override){.text = f->text[i]};
    }
    const murk_free_desc desc = {.scene_path = f->of->scene,
                                 .overrides = f->override,
                                 .n_overrides = 2,
                                 .asked = f->of->key,
                                 .n_asked = f->of->n,
                                 .measured = f->measured,
                                 .domain = &f->stage->world.domain,
                                 .imported = &f->imported};
    murk_free_keys *keys = NULL;
    murk_error err = {0};
    return held(murk_free_keys_create(&keys, &desc, &err), &err) ? keys : NULL;
}

static murk_calibration_desc
desc_of(const planted_field *f, const murk_free_keys *keys, unsigned threads)
{
    return (murk_calibration_desc){.keys = keys,
                                   .measured = f->measured,
                                   .imported = &f->imported,
                                   .loss_width = 1,
                                   .starts = f->starts ? f->starts : 1,
                                   .threads = threads,
                                   .seed = 1};
}

bool planted_light(planted_field *f, unsigned lights, unsigned emit,
                   unsigned threads)
{
    const size_t rows = f->measured->rows;
    memset(f->truth, 0, rows * sizeof *f->truth);
    bool is_well = true;
    for (unsigned i = 0; i < lights && is_well; ++i) {
        /* Light of one seed at the planted values. */
        murk_free_keys *keys = planted_keys(f, emit, TRUTH_SEED + i);
        if (!keys) {
            return false;
        }
        for (size_t k = 0; k < keys->n; ++k) {
            keys->key[k].start = f->of->truth[k];
        }
        /* Predict all readings and add to the mean over seeds. */
        murk_calibration_desc desc = desc_of(f, keys, threads);
        desc.only_predicts = true;
        murk_calibration seen;
        murk_error err = {0};
        is_well = held(murk_calibrate(&seen, &desc, &err), &err);
        for (size_t r = 0; r < rows && is_well; ++r) {
            f->truth[r] += seen.row[r].predicted / lights;
        }
        murk_calibration_release(&seen);
        murk_free_keys_destroy(keys);
    }
    return is_well;
}

/* Normal noise by Box and Muller. */
void planted_read(planted_field *f, uint32_t seed)
{
    const murk_readings *m = f->measured;
    for (size_t r = 0; r < m->rows; ++r) {
        const murk_random4 u = murk_random(seed, MURK_TEST, r, 0, 0);
        const double noise = sqrt(-2 * log(u.u[0])) * cos(2 * MURK_PI * u.u[1]);
        for (size_t i = 0; i < m->row[r].n; ++i) {
            murk_reading *reading = &m->reading[m->row[r].first + i];
            reading->value = f->truth[r] + noise * reading->standard_error;
        }
    }
}

/* Of x, by what is said to be known, in coordinates: of certainty, the standard
 * errors and covariance; information[n][n]. */
static planted_off off_of(const double *x, const double *truth, size_t n,
                          const murk_certainty *certainty,
                          const double *information, const double *bias)
{
    planted_off off = {.square = 0};
    double along = 0, variance = 0;
    for (size_t k = 0; k < n; ++k) {
        off.sigma[k] = (x[k] - truth[k]) / certainty->standard_error[k];
        along += bias[k] * (x[k] - truth[k]);
        for (size_t j = 0; j < n; ++j) {
            off.square +=
                (x[k] - truth[k]) * information[k * n + j] * (x[j] - truth[j]);
            variance += bias[k] * certainty->covariance[k * n + j] * bias[j];
        }
    }
    off.along = along / sqrt(variance);
    return off;
}

/* One step of plain least squares from x, and how sure they say they are;
 * release certainty, also after a failure. */
static bool plain_step(double *x, murk_certainty *certainty,
                       double *information, murk_fit_search *s,
                       const double *scale)
{
    const size_t n = s->n, rows = s->n_fitted;
    double *residual = calloc(rows * (n + 1), sizeof *residual);
    double *jacobian = residual + rows;
    murk_error err = {0};
    bool is_well = residual && held(murk_fit_search_evaluate(s, x, &err), &err);
    /* Residuals, slopes and the covariance at x. */
    if (is_well) {
        murk_fit_search_residuals(s, residual, jacobian);
        murk_certainty_release(certainty);
        is_well = held(murk_certainty_create(certainty, jacobian, rows, n, NULL,
                                             scale, INFINITY, &err),
                       &err);
    }
    /* The Gauss-Newton step: minus covariance times gradient. */
    for (size_t k = 0; k < n * n && is_well; ++k) {
        information[k] = 0;
        for (size_t i = 0; i < rows; ++i) {
            const double j = jacobian[i * n + k % n];
            x[k / n] -= certainty->covariance[k] * j * residual[i];
            information[k] += jacobian[i * n + k / n] * j;
        }
    }
    free(residual);
    return is_well;
}

/* How far the fit is off, and where least squares end that know nothing of
 * noise in slopes. */
static bool judge(planted_fit *out, const murk_calibration *found,
                  const murk_calibration_desc *desc, double *x,
                  const double *truth)
{
    murk_fit_search s = {0};
    murk_slope_noise noise = {0};
    murk_certainty certainty = {0};
    murk_error err = {0};
    double information[PLANTED_KEYS_MAX * PLANTED_KEYS_MAX];
    /* The state of the search at the found values, with the noise of its
     * slopes. */
    bool is_well =
        held(murk_fit_search_create(&s, desc, found->model, &err), &err) &&
        held(murk_fit_search_evaluate(&s, x, &err), &err) &&
        held(murk_slope_noise_find(&noise, &s, &err), &err);
    if (is_well) {
        out->off = off_of(x, truth, found->n, &found->certainty,
                          found->information, noise.bias);
    }
    /* Plain least squares from there. */
    for (int i = 0; i < PLAIN_STEPS && is_well; ++i) {
        is_well = plain_step(x, &certainty, information, &s, found->scale);
    }
    if (is_well) {
        out->plain =
            off_of(x, truth, found->n, &certainty, information, noise.bias);
    }
    murk_certainty_release(&certainty);
    murk_slope_noise_release(&noise);
    murk_fit_search_release(&s);
    return is_well;
}

static bool tell(planted_fit *out, const murk_calibration *found,
                 const murk_calibration_desc *desc, const double *truth_value,
                 bool fits_only)
{
    const size_t n = found->n;
    double x[PLANTED_KEYS_MAX], truth[PLANTED_KEYS_MAX];
    /* Values in the scale in which they were fitted. */
    for (size_t k = 0; k < n; ++k) {
        const bool is_log = desc->keys->key[k].is_log;
        x[k] = is_log ? log(found->value[k]) : found->value[k];
        truth[k] = is_log ? log(truth_value[k]) : truth_value[k];
        out->value[k] = found->value[k];
        out->standard_error[k] = found->standard_error[k];
    }
    /* The verdict of the fit. */
    out->slope_noise = found->slope_noise;
    out->chi2 = found->chi2;
    out->effective_share = found->effective_share;
    out->degrees_of_freedom = found->degrees_of_freedom;
    out->traces = found->traces;
    out->evaluations = found->evaluations;
    out->converged = found->converged;
    out->is_accepted = found->is_accepted;
    /* Distance from the planted values, in standard errors. */
    for (size_t k = 0; k < n; ++k) {
        out->off.sigma[k] =
            (x[k] - truth[k]) / found->certainty.standard_error[k];
    }
    return fits_only || judge(out, found, desc, x, truth);
}

bool planted_fit_once(planted_fit *out, planted_field *f, uint32_t seed,
                      unsigned threads)
{
    murk_free_keys *keys = planted_keys(f, f->of->emit, seed);
    if (!keys) {
        return false;
    }
    for (size_t k = 0; k < keys->n && f->start; ++k) {
        keys->key[k].start = f->start[k];
    }
    planted_read(f, seed);
    const murk_calibration_desc desc = desc_of(f, keys, threads);
    murk_calibration found;
    murk_error err = {0};
    *out = (planted_fit){.converged = false};
    bool is_well = held(murk_calibrate(&found, &desc, &err), &err);
    if (is_well) {
        is_well = tell(out, &found, &desc, f->of->truth, f->of->fits_only);
    }
    murk_calibration_release(&found);
    murk_free_keys_destroy(keys);
    return is_well;
}

murk_model *planted_model(const planted_field *field,
                          const murk_free_keys *keys)
{
    const murk_model_desc desc = {.keys = keys,
                                  .measured = field->measured,
                                  .threads = 2,
                                  .imported = &field->imported};
    murk_model *model = NULL;
    murk_error err = {0};
    if (murk_model_create(&model, &desc, &err)) {
        printf("%s: %s\n", err.where, err.text);
    }
    return model;
}

bool planted_held(murk_status status, const murk_error *err)
{
    if (status) {
        printf("%s: %s\n", err->where, err->text);
    }
    return !status;
}
