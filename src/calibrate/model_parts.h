/* The internal structure of the forward model. For use inside src/calibrate
 * only. */
#ifndef MURK_CALIBRATE_MODEL_PARTS_H
#define MURK_CALIBRATE_MODEL_PARTS_H

#include "calibrate/lighting.h"
#include "calibrate/model.h"

/* One condition. */
typedef struct murk_model_world {
    murk_scene_desc *scene; /* at the start values */
    murk_instruments instruments;
    size_t *medium; /* [scene->n_media], of which the first desc.media are
                     * filled: numbers of the media that keys re-weight */
    murk_lighting_desc desc;
    murk_lighting lighting;
    murk_lighting_rows rows; /* at the last prediction */
    double *world_slope;     /* [light rows][keys]; slopes of world keys at the
                              * traced values */
    bool has_world_keys;     /* keys change the world of this condition */
} murk_model_world;

struct murk_model {
    murk_model_desc desc;
    murk_model_facts facts;
    size_t n, rows;          /* number of keys, and of rows of the data */
    murk_model_world *world; /* [worlds]; that of each keys->condition, as built
                              * last */
    size_t worlds;
    double *traced;     /* [n]; values at which light was traced */
    double *slope_off;  /* [n]; sum of squared errors of the slopes of a world
                         * key, at the traced values */
    double *slope_size; /* [n]; sum of squares of these slopes */
    double *factor;     /* [rows]; factor of readings at the last prediction */
    size_t *gain_key;   /* [rows]; the key of the factor; n: none */
    size_t *place;      /* [rows]; index in facts.light */
    double *moved, *beside; /* [n]; workspaces for values */
    bool was_built;
    murk_arena arena; /* of all arrays here and in world[] */
};

murk_status murk_model_no_memory(murk_error *err);

/* True if key k changes the world of condition c, so that light must be traced
 * again. */
bool murk_model_changes_world(const murk_model *model, size_t k, size_t c);

/* The optics of condition c at two values around value[k], for each key whose
 * effect in this condition is computed by re-weighting; low and high are NULL
 * for other keys. sides[n] belongs to the caller, who releases it also after a
 * failure. */
murk_status murk_model_sides(murk_optics_sides **sides, const murk_model *model,
                             size_t c, const double *value, murk_error *err);
void murk_model_sides_release(murk_optics_sides *sides, size_t n);

/* The memory of a fit. Each condition keeps until the end: contributions with
 * the data for re-weighting, records in maps, sightlines, and sums by batch. On
 * top of that comes the larger of two: while light is traced, the growth of
 * arrays, and a second light if slopes come from light that is traced again;
 * while rows are evaluated, ratios and slopes of all conditions, and the
 * covariance of the rows. */
typedef struct murk_fit_forecast {
    double contributions; /* of all conditions */
    double light_bytes;   /* contributions, maps, sightlines, and ratios and
                           * slopes of one evaluation: in proportion to the
                           * photons */
    double bytes;         /* largest memory at any time */
} murk_fit_forecast;

/* Photons of each condition that the forecast is made from; all, if there are
 * fewer. From 2048 photons the memory is right within a few percent (300,000
 * photons in water). */
#define MURK_FIT_FORECAST_FROM 2048

/* Forecasts the memory of a fit. The worlds of the model must be built and stay
 * without light. A condition that cannot be traced with few photons counts as
 * nothing, because the trace itself reports the reason. Fails only when
 * interrupted. */
murk_status murk_model_forecast(murk_fit_forecast *out, const murk_model *model,
                                murk_error *err);

#endif
