/* The searches of a fit: the first starts at the values of the scene, further
 * ones at random values. For use inside src/calibrate only.
 *
 * A search with shares_light (a member of murk_fit_search,
 * calibrate/search_state.h) follows the light that start 0 traced last, which
 * must be at hand. First it moves to the end of least squares on that light. If
 * the light still describes that point, the search goes on there. The search is
 * abandoned (is_dropped) if the light does not, and the cost of the point is
 * not below cost_to_beat plus the number of parameters. At the first point at
 * which light would have to be traced, the search waits, so that the light of
 * start 0 stays at hand for other searches; murk_fit_resume() goes on. */
#ifndef MURK_CALIBRATE_SEARCH_H
#define MURK_CALIBRATE_SEARCH_H

#include "calibrate/search_state.h"

/* Runs search i, to its end or until it waits: fills out->start[i]. After a
 * search that ended and neither failed nor was abandoned, the last prediction
 * is that at search->x, the end. A failure of a further start (i > 0) is
 * recorded in out->start[i].why and is no failure of the fit, except an
 * interrupt and lack of memory. */
murk_status murk_fit_start(murk_calibration *out, murk_fit_search *search,
                           size_t i, murk_error *err);

/* Goes on with search i, which waits, and traces light for it: shares_light
 * must be false. */
murk_status murk_fit_resume(murk_calibration *out, murk_fit_search *search,
                            size_t i, murk_error *err);

/* Fills `from` and `to` of search i, which another process has run. */
void murk_fit_complete(murk_calibration *out, const murk_fit_search *search,
                       size_t i);

/* Evaluates the rows at the end of search i, which has one, with the light that
 * the search ended with; traces that light again if it is not at hand. Light is
 * a function of the values and the seed, so the bits are those of the search.
 */
murk_status murk_fit_return(const murk_calibration *out,
                            murk_fit_search *search, size_t i, murk_error *err);

/* Traces light at the end of search i, which has one, and evaluates the rows.
 */
murk_status murk_fit_trace_end(const murk_calibration *out,
                               murk_fit_search *search, size_t i,
                               murk_error *err);

/* Number of the search that traced the light that search i ended with. */
size_t murk_fit_lit_by(const murk_calibration *out, size_t i);

/* Number of the best of the searches before n that have ended. Search 0 must
 * have ended. */
size_t murk_fit_best(const murk_calibration *out, size_t n);

#endif
