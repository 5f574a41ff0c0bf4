/* Steps of a search besides least squares: extrapolation to the point of the
 * next trace, and correction for photon noise in the slopes. For
 * use inside src/calibrate only. */
#ifndef MURK_CALIBRATE_SEARCH_STEPS_H
#define MURK_CALIBRATE_SEARCH_STEPS_H

#include "calibrate/search_state.h"

/* Minimises the model linearised about x, with search->residual and jacobian,
 * and moves x to the point of the next trace. */
murk_status murk_fit_leap(murk_fit_search *search, double *x, murk_error *err);

/* From the end of least squares, moves x to the solution without the bias from
 * photon noise in the slopes. Stops and sets search->is_undersampled if the
 * effective share of the light falls below MURK_MIN_SHARE on the way. */
murk_status murk_fit_settle(murk_fit_search *search, double *x,
                            murk_error *err);

#endif
