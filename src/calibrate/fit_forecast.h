/* Forecast of the memory of a fit, from a few photons before the first trace.
 * Internal to this room.
 *
 * Each condition keeps until the end of the fit: contributions with the data
 * for re-weighting, ratios and slopes, records in maps, sightlines, and sums by
 * batch. On top of that come, one after the other: the growth of arrays while
 * light is traced again, a second light if slopes come from light that is
 * traced again, and the covariance of the rows. */
#ifndef MURK_CALIBRATE_FIT_FORECAST_H
#define MURK_CALIBRATE_FIT_FORECAST_H

#include "calibrate/model_parts.h"

/* Photons of each condition that the forecast is made from; all, if there are
 * fewer. From 2048 photons the memory is right within a few percent (300,000
 * photons in water). */
#define MURK_FIT_FORECAST_FROM 2048

typedef struct murk_fit_forecast {
    double contributions; /* of all conditions */
    double light_bytes;   /* contributions, maps, sightlines, and ratios and
                           * slopes of one evaluation: in proportion to the
                           * photons */
    double bytes;         /* largest memory at any time */
} murk_fit_forecast;

/* Forecasts the memory of a fit. The worlds of the model must be built and stay
 * without light. A condition that cannot be traced with few photons counts as
 * nothing, because the trace itself reports the reason. Fails only when
 * interrupted. */
murk_status murk_model_forecast(murk_fit_forecast *out, const murk_model *model,
                                murk_error *err);

#endif
