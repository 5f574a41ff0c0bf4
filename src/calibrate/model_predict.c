/* Evaluates the forward model: rows that need light by re-weighting plus the
 * linear effect of world keys, transmittance along beams and extinction
 * exactly, then factors of readings. Also computes, for the last prediction,
 * the covariance of the rows that need light and the contributions of the runs
 * of photons to them. */
#include "calibrate/beams.h"
#include "calibrate/model_parts.h"
#include "calibrate/world_slopes.h"
#include "fit/whitening.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* If the slopes over a narrow and over a wide interval of a key differ by more
 * than this factor, the slope over the narrow one is dominated by jumps of the
 * function. */
#define STEEP 10

murk_status murk_model_no_memory(murk_error *err)
{
    return murk_no_memory(err, "", "for the fit's model");
}

bool murk_model_changes_world(const murk_model *m, size_t k, size_t c)
{
    const murk_free_key *key = &m->desc.keys->key[k];
    return key->kind == MURK_FREE_WORLD && key->is_in[c];
}

/* True if key k changes only the optics of media or the power of light sources
 * in condition c, so that the traced light is re-weighted. */
static bool reweighs(const murk_model *m, size_t k, size_t c)
{
    const murk_free_key *key = &m->desc.keys->key[k];
    return (key->kind == MURK_FREE_MEDIUM || key->kind == MURK_FREE_LIGHT) &&
           key->is_in[c];
}

void murk_model_sides_release(murk_optics_sides *sides, size_t n)
{
    for (size_t k = 0; sides && k < n; ++k) {
        murk_optics_destroy(sides[k].low);
        murk_optics_destroy(sides[k].high);
    }
    free(sides);
}

murk_status murk_model_sides(murk_optics_sides **sides, const murk_model *m,
                             size_t c, const double *value, murk_error *err)
{
    const murk_free_keys *keys = m->desc.keys;
    double *beside = m->beside;
    *sides = calloc(m->n, sizeof **sides);
    murk_status status = *sides ? MURK_OK : murk_model_no_memory(err);
    memcpy(beside, value, m->n * sizeof *beside);
    for (size_t k = 0; k < m->n && !status; ++k) {
        murk_optics_sides *side = &(*sides)[k];
        double low, high;
        if (!reweighs(m, k, c)) {
            continue;
        }
        murk_free_key_around(keys, k, value[k], &low, &high);
        side->span = high - low;
        beside[k] = low;
        status = murk_free_optics(&side->low, keys, c, beside, err);
        beside[k] = high;
        status = status ? status
                        : murk_free_optics(&side->high, keys, c, beside, err);
        beside[k] = value[k];
    }
    return status;
}

/* Predicts the light rows of one condition. */
static murk_status predict_light(murk_model *m, size_t c, const double *value,
                                 double *predicted, double *slope,
                                 murk_error *err)
{
    murk_model_world *w = &m->world[c];
    murk_optics *at = NULL;
    murk_optics_sides *sides = NULL;
    /* World keys keep the traced value; their effect is added below. */
    for (size_t k = 0; k < m->n; ++k) {
        m->moved[k] =
            murk_model_changes_world(m, k, c) ? m->traced[k] : value[k];
    }
    /* Optics at these values and around them; re-weight. */
    murk_status status = murk_free_optics(&at, m->desc.keys, c, m->moved, err);
    if (!status && slope) {
        status = murk_model_sides(&sides, m, c, m->moved, err);
    }
    status = status
                 ? status
                 : murk_lighting_read(&w->rows, &w->lighting, m->desc.measured,
                                      at, sides, slope ? m->n : 0, err);
    /* Add the linear effect of world keys. */
    for (size_t i = 0; i < w->instruments.lights && !status; ++i) {
        const size_t row = w->instruments.light_row[i];
        predicted[row] = w->rows.value[i];
        for (size_t k = 0; k < m->n; ++k) {
            const double by_world = w->world_slope[i * m->n + k];
            if (murk_model_changes_world(m, k, c)) {
                predicted[row] += by_world * (value[k] - m->traced[k]);
            }
            if (slope) {
                slope[row * m->n + k] = by_world + w->rows.slope[i * m->n + k];
            }
        }
    }
    murk_model_sides_release(sides, m->n);
    murk_optics_destroy(at);
    return status;
}

/* Transmittances and extinctions at the given values, in the units of the rows.
 * Beams use the scene of these values, world keys included. */
static murk_status beams_at(double *out, const murk_model *m, size_t c,
                            const double *value, murk_error *err)
{
    const murk_model_world *w = &m->world[c];
    murk_optics *optics = NULL;
    murk_beams *beams = NULL;
    murk_status status = murk_free_optics(&optics, m->desc.keys, c, value, err);
    status = status ? status
                    : murk_beams_create(&beams, w->lighting.stage, optics, err);
    for (size_t i = 0; i < w->instruments.beams && !status; ++i) {
        /* Evaluate each beam. */
        const murk_reading *reading =
            murk_reading_of_row(m->desc.measured, w->instruments.beam_row[i]);
        status = murk_beam_read(&out[i], beams, reading, err);
    }
    murk_beams_destroy(beams);
    murk_optics_destroy(optics);
    return status;
}

/* Difference quotients of the beams over [low, high] of key k; below[beams] is
 * a workspace. */
static murk_status beam_differences(double *out, double *below,
                                    const murk_model *m, size_t c,
                                    const double *value, size_t k, double low,
                                    double high, murk_error *err)
{
    memcpy(m->beside, value, m->n * sizeof *value);
    m->beside[k] = low;
    murk_status status = beams_at(below, m, c, m->beside, err);
    m->beside[k] = high;
    status = status ? status : beams_at(out, m, c, m->beside, err);
    for (size_t i = 0; i < m->world[c].instruments.beams && !status; ++i) {
        out[i] = (out[i] - below[i]) / (high - low);
    }
    return status;
}

/* True if the slopes over a narrow and a wide interval of a key differ much. If
 * a grid moves, a level beam changes only when it crosses a layer of voxels:
 * the transmittance is constant between the layers and jumps at each. The
 * caller uses the slopes over the wide interval in this case. */
static bool are_of_steps(const double *slope, const double *wide, size_t n)
{
    double of_slopes = 0, of_wide = 0;
    for (size_t i = 0; i < n; ++i) {
        of_slopes += slope[i] * slope[i];
        of_wide += wide[i] * wide[i];
    }
    return of_slopes > STEEP * STEEP * of_wide ||
           of_wide > STEEP * STEEP * of_slopes;
}

/* Slopes of the beams with respect to key k; scratch[3 * beams] is a scratch
 * buffer. */
static murk_status beam_slopes(const murk_model *m, size_t c,
                               const double *value, size_t k, double *scratch,
                               double *slope, murk_error *err)
{
    const murk_instruments *instruments = &m->world[c].instruments;
    const size_t beams = instruments->beams;
    const murk_free_key *key = &m->desc.keys->key[k];
    double *narrow = scratch, *wide = scratch + beams,
           *below = scratch + 2 * beams, low, high;
    murk_free_key_around(m->desc.keys, k, value[k], &low, &high);
    murk_status status =
        beam_differences(narrow, below, m, c, value, k, low, high, err);
    if (!status && key->kind == MURK_FREE_WORLD) {
        murk_world_span(key, value[k], .5, &low, &high);
        status = beam_differences(wide, below, m, c, value, k, low, high, err);
    }
    const bool takes_wide = !status && key->kind == MURK_FREE_WORLD &&
                            are_of_steps(narrow, wide, beams);
    for (size_t i = 0; i < beams && !status; ++i) {
        slope[instruments->beam_row[i] * m->n + k] =
            takes_wide ? wide[i] : narrow[i];
    }
    return status;
}

/* Predicts the beams of one condition. */
static murk_status predict_beams(const murk_model *m, size_t c,
                                 const double *value, double *predicted,
                                 double *slope, murk_error *err)
{
    const murk_instruments *instruments = &m->world[c].instruments;
    const murk_free_keys *keys = m->desc.keys;
    double *scratch = malloc(3 * instruments->beams * sizeof *scratch);
    murk_status status = scratch ? beams_at(scratch, m, c, value, err)
                                 : murk_model_no_memory(err);
    for (size_t i = 0; i < instruments->beams && !status; ++i) {
        predicted[instruments->beam_row[i]] = scratch[i];
    }
    for (size_t k = 0; slope && k < m->n && !status; ++k) {
        if (keys->key[k].kind != MURK_FREE_GAIN && keys->key[k].is_in[c]) {
            status = beam_slopes(m, c, value, k, scratch, slope, err);
        }
    }
    free(scratch);
    return status;
}

/* The key of the free factor of a row; n: none. */
static size_t gain_of(const murk_model *m, size_t row)
{
    const murk_reading *reading = murk_reading_of_row(m->desc.measured, row);
    const murk_free_keys *keys = m->desc.keys;
    for (size_t k = 0; k < m->n && reading->gain != SIZE_MAX; ++k) {
        const murk_free_key *key = &keys->key[k];
        if (key->kind == MURK_FREE_GAIN && key->gain == reading->gain &&
            (key->condition == SIZE_MAX ||
             keys->condition[key->condition] == reading->condition)) {
            return k;
        }
    }
    return m->n;
}

/* Applies the factors; the slope with respect to a factor is the row without
 * the factor. */
static void apply_gains(murk_model *m, const double *value, double *predicted,
                        double *slope)
{
    for (size_t i = 0; i < m->rows; ++i) {
        const size_t gain = gain_of(m, i);
        m->gain_key[i] = gain;
        m->factor[i] = gain < m->n ? value[gain] : 1;
        for (size_t k = 0; slope && k < m->n; ++k) {
            slope[i * m->n + k] *= m->factor[i];
        }
        if (slope && gain < m->n) {
            slope[i * m->n + gain] = predicted[i];
        }
        predicted[i] *= m->factor[i];
    }
}

murk_status murk_model_predict(murk_model *m, const double *value,
                               double *predicted, double *slope,
                               double *effective_share, murk_error *err)
{
    murk_status status = MURK_OK;
    *effective_share = 1;
    if (slope) {
        memset(slope, 0, m->rows * m->n * sizeof *slope);
    }
    /* Each condition: light rows, then beams. */
    for (size_t c = 0; c < m->worlds && !status; ++c) {
        const murk_model_world *w = &m->world[c];
        if (w->instruments.lights) {
            status = predict_light(m, c, value, predicted, slope, err);
            *effective_share = fmin(*effective_share, w->rows.share);
        }
        if (!status && w->instruments.beams) {
            status = predict_beams(m, c, value, predicted, slope, err);
        }
    }
    if (!status) {
        apply_gains(m, value, predicted, slope);
    }
    return status;
}

murk_status murk_model_noise(const murk_model *m, double **covariance,
                             murk_error *err)
{
    *covariance = NULL;
    if (m->facts.lights == 0) {
        return MURK_OK;
    }
    double *batch = calloc(m->facts.batches * m->facts.lights, sizeof *batch);
    double *out = calloc(m->facts.lights * m->facts.lights, sizeof *out);
    if (!batch || !out) {
        free(batch);
        free(out);
        return murk_model_no_memory(err);
    }
    /* Collect the batches of all conditions, with factors. */
    for (size_t c = 0; c < m->worlds; ++c) {
        const murk_model_world *w = &m->world[c];
        for (size_t i = 0; i < w->instruments.lights; ++i) {
            const size_t row = w->instruments.light_row[i], to = m->place[row];
            for (size_t b = 0; b < m->facts.batches; ++b) {
                batch[b * m->facts.lights + to] =
                    m->factor[row] *
                    w->rows.batch[b * w->instruments.lights + i];
            }
        }
    }
    murk_covariance_of_batches(out, batch, m->facts.batches, m->facts.lights);
    free(batch);
    *covariance = out;
    return MURK_OK;
}

/* Writes the contribution of a run to one row. */
static void add_part(double *to, const murk_model *m, const murk_model_world *w,
                     size_t i, size_t run, double value)
{
    const size_t row = w->instruments.light_row[i], gain = m->gain_key[row];
    const double factor = m->factor[row];
    const double *slope =
        w->rows.run + (run * w->instruments.lights + i) * m->n;
    to[0] = factor * value;
    for (size_t k = 0; k < m->n; ++k) {
        to[1 + k] = factor * slope[k];
    }
    if (gain < m->n) {
        to[1 + gain] = value;
    }
}

murk_status murk_model_parts(const murk_model *m, double **part,
                             murk_error *err)
{
    *part = NULL;
    if (m->facts.lights == 0) {
        return MURK_OK;
    }
    const size_t width = m->n + 1, each = m->facts.batches / m->facts.runs;
    double *all = calloc(m->facts.runs * m->facts.lights * width, sizeof *all);
    if (!all) {
        return murk_model_no_memory(err);
    }
    /* Values of a run: sum of the batches of that run. Slopes are stored by
     * run. */
    for (size_t c = 0; c < m->worlds; ++c) {
        const murk_model_world *w = &m->world[c];
        const size_t lights = w->instruments.lights;
        for (size_t j = 0; j < m->facts.runs * lights; ++j) {
            const size_t run = j / lights, i = j % lights;
            double value = 0;
            for (size_t b = run * each; b < (run + 1) * each; ++b) {
                value += w->rows.batch[b * lights + i];
            }
            const size_t to =
                run * m->facts.lights + m->place[w->instruments.light_row[i]];
            add_part(all + to * width, m, w, i, run, value);
        }
    }
    *part = all;
    return MURK_OK;
}
