/* The memory that a fit will take, foretold from a few photons before the
 * first trace. Private to this room.
 *
 * Of each condition, until the fit ends: contributions with what re-weights
 * them, their ratios and slopes, records in maps, sightlines, and sums by
 * batch. On top, one after the other: what arrays take beside themselves while
 * light is traced anew, a second light where slopes are of re-traced light,
 * and the covariance of rows. */
#ifndef MURK_CALIBRATE_FIT_FORECAST_H
#define MURK_CALIBRATE_FIT_FORECAST_H

#include "calibrate/model_parts.h"

/* Of each condition, to foretell from; all, where there are fewer. */
#define MURK_FIT_FORECAST_FROM 2048

typedef struct murk_fit_forecast {
    double contributions; /* of all conditions */
    double light_bytes;   /* contributions, maps, sightlines, and one reading's
                             ratios and slopes: in proportion to the photons */
    double bytes;         /* of all, at one time, at most */
} murk_fit_forecast;

/* The model's worlds are built, and dark: they stay so. What cannot be traced
 * with few photons counts for nothing here, since the trace itself says why;
 * only an interrupt fails. */
murk_status murk_model_forecast(murk_fit_forecast *out, const murk_model *model,
                                murk_error *err);

#endif
