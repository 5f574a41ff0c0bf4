/* Evaluates the forward model: lit rows by re-weighting plus the linear effect
 * of world keys, transmittance along beams exactly, then factors of readings.
 * Also computes the noise of the last prediction. */
#include "calibrate/beams.h"
#include "calibrate/model_parts.h"
#include "calibrate/world_slopes.h"
#include "fit/whitening.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* If the slopes over a small step and over a wide one differ by more than this
 * factor, the small one is dominated by steps of the function. */
#define STEEP 10

static murk_status no_memory(murk_error *err)
{
    return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the fit's model");
}

void murk_sides_release(murk_sides *s, size_t n)
{
    for (size_t k = 0; k < n; ++k) {
        murk_optics_destroy(s->low ? s->low[k] : NULL);
        murk_optics_destroy(s->high ? s->high[k] : NULL);
    }
    free(s->side);
    free(s->low);
    free(s->high);
}

/* The optics of condition c with `instead` as the value of key k. */
static murk_status optics_with(murk_optics **out, const murk_model *m, size_t c,
                               const double *value, size_t k, double instead,
                               murk_error *err)
{
    double *moved = malloc(m->n * sizeof *moved);
    if (!moved) {
        return no_memory(err);
    }
    memcpy(moved, value, m->n * sizeof *moved);
    moved[k] = instead;
    const murk_status status =
        murk_free_optics(out, m->desc.keys, c, moved, err);
    free(moved);
    return status;
}

murk_status murk_model_look_around(murk_sides *out, const murk_model *m,
                                   size_t c, const double *value,
                                   murk_error *err)
{
    *out = (murk_sides){calloc(m->n, sizeof *out->side),
                        calloc(m->n, sizeof(murk_optics *)),
                        calloc(m->n, sizeof(murk_optics *))};
    if (!out->side || !out->low || !out->high) {
        return no_memory(err);
    }
    murk_status status = MURK_OK;
    for (size_t k = 0; k < m->n && !status; ++k) {
        if (!murk_model_reweighs(m, k, c)) {
            /* Keys without an effect by re-weighting keep NULL. */
            continue;
        }
        double low, high;
        /* The optics at both values. */
        murk_free_key_around(m->desc.keys, k, value[k], &low, &high);
        status = optics_with(&out->low[k], m, c, value, k, low, err);
        if (!status) {
            status = optics_with(&out->high[k], m, c, value, k, high, err);
        }
        out->side[k] =
            (murk_optics_sides){out->low[k], out->high[k], high - low};
    }
    return status;
}

/* Predicts the lit rows of one condition. */
static murk_status predict_light(murk_model *m, size_t c, const double *value,
                                 bool with_slopes, double *predicted,
                                 double *slope, murk_error *err)
{
    murk_model_world *w = &m->world[c];
    double *moved = malloc(m->n * sizeof *moved);
    murk_optics *at = NULL;
    murk_sides around = {0};
    murk_status status = moved ? MURK_OK : no_memory(err);
    /* World keys keep the traced value; their effect is added below. */
    for (size_t k = 0; k < m->n && !status; ++k) {
        moved[k] = murk_model_turns_world(m, k, c) ? m->traced[k] : value[k];
    }
    if (!status) {
        status = murk_free_optics(&at, m->desc.keys, c, moved, err);
    }
    /* Optics at these values and around them. */
    if (!status && with_slopes) {
        status = murk_model_look_around(&around, m, c, moved, err);
    }
    /* Re-weight. */
    if (!status) {
        status = murk_lit_read(&w->rows, &w->lit, m->desc.measured, at,
                               around.side, with_slopes ? m->n : 0, err);
    }
    /* Add the linear effect of world keys. */
    for (size_t i = 0; i < w->instruments.lit && !status; ++i) {
        const size_t row = w->instruments.lit_row[i];
        predicted[row] = w->rows.value[i];
        for (size_t k = 0; k < m->n; ++k) {
            const double by_world = w->world_slope[i * m->n + k];
            if (murk_model_turns_world(m, k, c)) {
                predicted[row] += by_world * (value[k] - m->traced[k]);
            }
            if (with_slopes) {
                slope[row * m->n + k] = by_world + w->rows.slope[i * m->n + k];
            }
        }
    }
    murk_sides_release(&around, around.side ? m->n : 0);
    murk_optics_destroy(at);
    free(moved);
    return status;
}

/* Transmittances at the given values, in the units of the rows. Beams use the
 * scene of these values, world keys included. */
static murk_status beams_at(double *out, const murk_model *m, size_t c,
                            const double *value, murk_error *err)
{
    const murk_model_world *w = &m->world[c];
    const murk_measurements *measured = m->desc.measured;
    murk_optics *optics = NULL;
    murk_beams *beams = NULL;
    murk_status status = murk_free_optics(&optics, m->desc.keys, c, value, err);
    if (!status) {
        status = murk_beams_create(&beams, w->lit.stage, optics, err);
    }
    for (size_t i = 0; i < w->instruments.beams && !status; ++i) {
        /* Evaluate each beam. */
        const murk_reading *reading =
            &measured->reading[measured->row[w->instruments.beam_row[i]].first];
        double transmittance, unused;
        status = murk_beam_transmittance(&transmittance, beams, reading, err);
        out[i] = murk_reading_in_unit(
            reading->unit, transmittance,
            murk_length(murk_sub(reading->to, reading->position)), &unused);
    }
    murk_beams_destroy(beams);
    murk_optics_destroy(optics);
    return status;
}

/* Difference quotients of the beams over [low, high] of key k. */
static murk_status beam_differences(double *out, const murk_model *m, size_t c,
                                    const double *value, size_t k, double low,
                                    double high, murk_error *err)
{
    const size_t beams = m->world[c].instruments.beams;
    double *moved = malloc((m->n + beams) * sizeof *moved);
    if (!moved) {
        return no_memory(err);
    }
    double *below = moved + m->n;
    memcpy(moved, value, m->n * sizeof *moved);
    moved[k] = low;
    murk_status status = beams_at(below, m, c, moved, err);
    moved[k] = high;
    if (!status) {
        status = beams_at(out, m, c, moved, err);
    }
    for (size_t i = 0; i < beams && !status; ++i) {
        out[i] = (out[i] - below[i]) / (high - low);
    }
    free(moved);
    return status;
}

/* True if the slopes over a small and a wide step differ much. If a grid moves,
 * a level beam changes only when it crosses a layer of voxels: it is constant
 * almost everywhere, and then jumps. The slopes over the wide step are then
 * used. */
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

/* Slopes of the beams with respect to key k; room[2 * beams] is a workspace. */
static murk_status beam_slopes(const murk_model *m, size_t c,
                               const double *value, size_t k, double *room,
                               double *slope, murk_error *err)
{
    const murk_instruments *instruments = &m->world[c].instruments;
    const murk_free_key *key = &m->desc.keys->key[k];
    double *wide = room + instruments->beams, low, high;
    murk_free_key_around(m->desc.keys, k, value[k], &low, &high);
    murk_status status = beam_differences(room, m, c, value, k, low, high, err);
    if (!status && key->kind == MURK_FREE_WORLD) {
        murk_world_span(key, value[k], .5, &low, &high);
        status = beam_differences(wide, m, c, value, k, low, high, err);
    }
    const bool takes_wide = !status && key->kind == MURK_FREE_WORLD &&
                            are_of_steps(room, wide, instruments->beams);
    for (size_t i = 0; i < instruments->beams && !status; ++i) {
        slope[instruments->beam_row[i] * m->n + k] =
            takes_wide ? wide[i] : room[i];
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
    double *room = malloc(2 * (instruments->beams + 1) * sizeof *room);
    murk_status status = room ? MURK_OK : no_memory(err);
    if (!status) {
        status = beams_at(room, m, c, value, err);
    }
    for (size_t i = 0; i < instruments->beams && !status; ++i) {
        predicted[instruments->beam_row[i]] = room[i];
    }
    for (size_t k = 0; slope && k < m->n && !status; ++k) {
        if (keys->key[k].kind != MURK_FREE_GAIN &&
            murk_free_key_is_in(keys, k, c)) {
            status = beam_slopes(m, c, value, k, room, slope, err);
        }
    }
    free(room);
    return status;
}

/* The key of the free factor of a row; n: none. */
static size_t gain_of(const murk_model *m, size_t row)
{
    const murk_measurements *measured = m->desc.measured;
    const murk_reading *reading = &measured->reading[measured->row[row].first];
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
    /* Each condition: lit rows, then beams. */
    for (size_t c = 0; c < m->worlds && !status; ++c) {
        murk_model_world *w = &m->world[c];
        if (w->instruments.lit) {
            status = predict_light(m, c, value, slope != NULL, predicted, slope,
                                   err);
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

murk_status murk_model_noise(const murk_model *m, const size_t **lit, size_t *n,
                             double **covariance, murk_error *err)
{
    *lit = m->lit;
    *n = m->lits;
    *covariance = NULL;
    if (m->lits == 0) {
        return MURK_OK;
    }
    double *batch = calloc(m->batches * m->lits, sizeof *batch);
    *covariance = calloc(m->lits * m->lits, sizeof **covariance);
    if (!batch || !*covariance) {
        free(batch);
        free(*covariance);
        *covariance = NULL;
        return no_memory(err);
    }
    /* Collect the batches of all conditions, with factors. */
    for (size_t c = 0; c < m->worlds; ++c) {
        const murk_model_world *w = &m->world[c];
        for (size_t i = 0; i < w->instruments.lit; ++i) {
            const size_t row = w->instruments.lit_row[i], to = m->place[row];
            for (size_t b = 0; b < m->batches; ++b) {
                batch[b * m->lits + to] =
                    m->factor[row] * w->rows.batch[b * w->instruments.lit + i];
            }
        }
    }
    murk_covariance_of_batches(*covariance, batch, m->batches, m->lits);
    free(batch);
    return MURK_OK;
}

const size_t *murk_model_lit(const murk_model *m, size_t *n)
{
    *n = m->lits;
    return m->lit;
}

/* Writes the contribution of a run to one row. */
static void add_part(double *to, const murk_model *m, const murk_model_world *w,
                     size_t i, size_t run, double value)
{
    const size_t row = w->instruments.lit_row[i], gain = m->gain_key[row];
    const double factor = m->factor[row];
    const double *slope = w->rows.run + (run * w->instruments.lit + i) * m->n;
    to[0] = factor * value;
    for (size_t k = 0; k < m->n; ++k) {
        to[1 + k] = factor * slope[k];
    }
    if (gain < m->n) {
        to[1 + gain] = value;
    }
}

murk_status murk_model_parts(const murk_model *m, size_t *runs, double **part,
                             murk_error *err)
{
    *runs = m->runs;
    *part = NULL;
    if (m->lits == 0) {
        return MURK_OK;
    }
    const size_t width = m->n + 1, each = m->batches / m->runs;
    double *all = calloc(m->runs * m->lits * width, sizeof *all);
    if (!all) {
        return no_memory(err);
    }
    /* Values of a run: sum of the batches of that run. Slopes are stored by
     * run. */
    for (size_t c = 0; c < m->worlds; ++c) {
        const murk_model_world *w = &m->world[c];
        for (size_t j = 0; j < m->runs * w->instruments.lit; ++j) {
            const size_t run = j / w->instruments.lit,
                         i = j % w->instruments.lit;
            double value = 0;
            for (size_t b = run * each; b < (run + 1) * each; ++b) {
                value += w->rows.batch[b * w->instruments.lit + i];
            }
            const size_t to =
                run * m->lits + m->place[w->instruments.lit_row[i]];
            add_part(all + to * width, m, w, i, run, value);
        }
    }
    *part = all;
    return MURK_OK;
}
