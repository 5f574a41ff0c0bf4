/* The forward model of a fit: every row of the data as a function of the
 * parameters, with derivatives, from light that is traced seldom.
 *
 * Light is traced at one set of values (murk_model_trace()) and re-weighted to
 * others (calibrate/reweigh.h). Keys that change the world itself act on light
 * rows linearly, with slopes from differences of light that is traced at other
 * values with the same seed. Transmittance along beams and extinction at points
 * are computed without photons at any values, with the meshes of the world that
 * was built last. */
#ifndef MURK_CALIBRATE_MODEL_H
#define MURK_CALIBRATE_MODEL_H

#include "calibrate/free_keys.h"
#include "calibrate/imported_stages.h"

/* Limit on the rows that need photons: these rows share photons, and their full
 * covariance is stored. */
#define MURK_MODEL_LIGHT_ROWS_MAX 4000

typedef struct murk_model_desc {
    const murk_free_keys *keys;
    const murk_readings *measured;
    unsigned threads;
    const murk_imported_stages *imported; /* of the scene of the keys */
    /* Called by the first murk_model_trace(), in the thread of the caller,
     * before light is traced in full, with the forecast of memory and the free
     * memory in bytes (INFINITY: not known); may be NULL. */
    void (*forecast)(void *context, double bytes, double have_bytes);
    void *context;
} murk_model_desc;

typedef struct murk_model murk_model;

/* Facts about a model: the light rows and the batches of photons, which stay
 * the same; and counts, memory and time of the traces so far. */
typedef struct murk_model_facts {
    size_t *light; /* [lights]; rows that need photons, rising */
    size_t lights;
    size_t batches, runs; /* numbers of batches of photons, and of runs of
                           * consecutive batches */
    size_t traces;        /* so far, one for each condition with light rows,
                           * those for slopes of world keys included */
    uint64_t photons;     /* of one trace, of the condition that was traced
                             last */
    double memory_bytes;  /* of the fit, as forecast by the first trace; 0:
                           * not yet */
    double trace_s; /* time of all traces, the building of worlds included */
} murk_model_facts;

/* Creates a model; no world is built yet. The objects that desc points to must
 * outlive *out. The caller owns *out (murk_model_destroy()). */
murk_status murk_model_create(murk_model **out, const murk_model_desc *desc,
                              murk_error *err);
void murk_model_destroy(murk_model *model); /* NULL is fine */

const murk_model_facts *murk_model_facts_of(const murk_model *model);

/* The world of condition c (an index into keys->condition) that was built last,
 * valid until the next trace; NULL before the first one. */
const murk_stage *murk_model_stage(const murk_model *model, size_t c);

/* Builds the worlds at value[keys->n] and traces the light that rows need.
 * Fails if an instrument cannot be modelled at these values and, the first
 * time, before light is traced, if the forecast exceeds the free memory. Also
 * fails as building and tracing the worlds do, and when interrupted. */
murk_status murk_model_trace(murk_model *model, const double *value,
                             murk_error *err);

/* Predicts the rows at other values: predicted[rows] in the unit of each row,
 * factors included; slope[rows][keys->n] with respect to the values of the
 * keys, or NULL. *effective_share is the effective sample size of the
 * re-weighted light as a share of the sample, the smallest of any receiver or
 * map of any condition (1: no re-weighting; calibrate/reweigh.h). Only after a
 * trace. Fails if the scene does not accept the values, if the traced light
 * cannot be re-weighted to them, when out of memory, and when interrupted; the
 * results then have no meaning. */
murk_status murk_model_predict(murk_model *model, const double *value,
                               double *predicted, double *slope,
                               double *effective_share, murk_error *err);

/* The covariance [lights * lights] of the values of the light rows by photons
 * at the last prediction, to be freed with free(); NULL if no row needs light.
 * It is estimated from at least 100 batches of photons. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_model_noise(const murk_model *model, double **covariance,
                             murk_error *err);

/* The contributions of runs of consecutive photons to values and slopes of the
 * light rows at the last prediction, which must have been with slopes. Values
 * and slopes come from the same photons, so their errors are correlated
 * (slope_noise.h). part[runs][lights][1 + keys->n], to be freed with free():
 * value, then slopes. Over the runs each adds up to that of the row without the
 * linear effect of world keys, whose slopes are 0 here. NULL if no row needs
 * light. Fails with MURK_NO_MEMORY. */
murk_status murk_model_parts(const murk_model *model, double **part,
                             murk_error *err);

/* Relative error of the slopes of a world key at the traced values, by photons
 * and step size together, over the light rows of all conditions: the root of
 * sum(error^2) / sum(slope^2). NaN for other keys, before a trace, and if no
 * row changes. */
double murk_model_slope_error(const murk_model *model, size_t key);

#endif
