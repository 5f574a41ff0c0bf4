/* The forward model of a fit: every row of the data as a function of the
 * parameters, with derivatives, from light that is traced seldom.
 *
 * Light is traced at one set of values (murk_model_trace) and re-weighted from
 * there (calibrate/reweigh.h). Keys that turn the world itself act on rows of
 * light by their slope at that point, from differences of re-traced light under
 * the same seed; beams are exact wherever the parameters are. */
#ifndef MURK_CALIBRATE_MODEL_H
#define MURK_CALIBRATE_MODEL_H

#include "calibrate/free_keys.h"
#include "calibrate/imported_stages.h"

/* Rows that need photons share them, and their covariance is kept whole. */
#define MURK_MODEL_LIT_ROWS_MAX 4000

typedef struct murk_model_desc {
    const murk_free_keys *keys;
    const murk_measurements *measured;
    unsigned threads;
    const murk_imported_stages *imported; /* of the keys' scene */
    /* Before light is first traced, on the caller's thread: the memory that it
     * all will take, and what there is [bytes]; may be NULL. */
    void (*forecast)(void *context, double bytes, double have_bytes);
    void *context;
} murk_model_desc;

typedef struct murk_model murk_model;

/* Builds nothing. What desc points to must outlive it. *out is the caller's:
 * murk_model_destroy(). */
murk_status murk_model_create(murk_model **out, const murk_model_desc *desc,
                              murk_error *err);
void murk_model_destroy(murk_model *model); /* NULL is fine */

/* Builds the worlds at these values and lights those that rows of light ask
 * for. value[keys->n]. Refuses what cannot be measured in them and, the first
 * time, before light is traced, what would take more memory than there is. */
murk_status murk_model_trace(murk_model *model, const double *value,
                             murk_error *err);

/* Memory that the fit takes, as foretold by the first trace [bytes]; 0 before.
 */
double murk_model_memory_bytes(const murk_model *model);

/* Rows at other values: predicted[rows] in each row's own unit, gain included;
 * slope[rows][keys->n] by the keys' values, or NULL. *effective_share: the
 * least of any receiver and map, of any condition (1: nothing was re-weighted).
 * Fails also where values are outside of what the scene allows. After a trace.
 */
murk_status murk_model_predict(murk_model *model, const double *value,
                               double *predicted, double *slope,
                               double *effective_share, murk_error *err);

/* Of the last prediction: the rows that need photons, lit[n] rising, and the
 * covariance of their values by photons, for free(), [n * n]; n 0: NULLs. From
 * at least 100 batches of photons. */
murk_status murk_model_noise(const murk_model *model, const size_t **lit,
                             size_t *n, double **covariance, murk_error *err);

/* Rows that need photons, rising. */
const size_t *murk_model_lit(const murk_model *model, size_t *n);

/* Of the last prediction, where it was with slopes: how the photons of runs of
 * consecutive photons make up the values and slopes of lit rows. Slopes are of
 * the same photons as values, so both are off together; see search.h. part
 * [runs][lit][1 + keys->n], for free(): value, then slopes; each adds up to the
 * row's own. NULL where no row is lit. */
murk_status murk_model_parts(const murk_model *model, size_t *runs,
                             double **part, murk_error *err);

/* Relative error of a world key's slopes at the traced point, by photons and
 * step together, over the rows of all conditions: the root of the sum of
 * error^2 over that of slope^2; NaN for the other keys, before a trace, and
 * where no row moves. */
double murk_model_slope_error(const murk_model *model, size_t key);

/* The world of condition c (an index into keys->condition) as built last. */
const murk_stage *murk_model_stage(const murk_model *model, size_t c);

/* Lights traced so far, also for slopes; photons of one; seconds. */
size_t murk_model_traces(const murk_model *model);
uint64_t murk_model_photons(const murk_model *model);
double murk_model_trace_s(const murk_model *model);

#endif
