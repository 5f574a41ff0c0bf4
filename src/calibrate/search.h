/* The searches of a fit: the first starts at the values of the scene, further
 * ones at random values around them. Internal to this room.
 *
 * A search with shares_light and has_light first follows the light at hand
 * without tracing. Light is traced only if that leads to a point that the light
 * no longer describes and whose cost is below cost_to_beat; otherwise the
 * search is abandoned (is_dropped). */
#ifndef MURK_CALIBRATE_SEARCH_H
#define MURK_CALIBRATE_SEARCH_H

#include "calibrate/search_state.h"

/* Runs search i: fills out->start[i], and out->best if it is the best so far.
 * Afterwards the last prediction of the search is that at search->x, the end. A
 * failure of a further start is recorded in out->start[i].why and is no failure
 * of the fit. */
murk_status murk_fit_start(murk_calibration *out, murk_fit_search *search,
                           size_t i, murk_error *err);

#endif
