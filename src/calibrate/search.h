/* The searches of a fit: the first starts at the values of the scene, further
 * ones at random values. For use inside src/calibrate only.
 *
 * A search with shares_light and has_light (members of murk_fit_search,
 * calibrate/search_state.h) first follows the light that an earlier search
 * traced last, without tracing. If the search comes to a point that this light
 * still describes, the search goes on at that point with this light. Otherwise
 * light is traced at that point if the cost of the point is below cost_to_beat
 * plus the number of parameters, and the search is abandoned (is_dropped) if
 * the cost is not below that sum. If the light at hand gives no residuals,
 * light is traced at the start. */
#ifndef MURK_CALIBRATE_SEARCH_H
#define MURK_CALIBRATE_SEARCH_H

#include "calibrate/search_state.h"

/* Runs search i: fills out->start[i], and out->best if it is the best so far.
 * After a search that neither failed nor was abandoned, the last prediction is
 * that at search->x, the end. A failure of a further start (i > 0) is recorded
 * in out->start[i].why and is no failure of the fit, except an interrupt and
 * lack of memory. */
murk_status murk_fit_start(murk_calibration *out, murk_fit_search *search,
                           size_t i, murk_error *err);

#endif
