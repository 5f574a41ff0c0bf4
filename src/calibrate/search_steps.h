/* Steps of a search besides least squares: extrapolation to the point of the
 * next trace, and correction for photon noise in the slopes. For
 * use inside src/calibrate only. */
#ifndef MURK_CALIBRATE_SEARCH_STEPS_H
#define MURK_CALIBRATE_SEARCH_STEPS_H

#include "calibrate/search_state.h"

/* Minimises the model linearised about x, with search->residual and jacobian,
 * within a trust region about x and the bounds, and moves x to the point found,
 * at which light is traced next. */
murk_status murk_fit_leap(murk_fit_search *search, double *x, murk_error *err);

/* From the end of least squares, moves x to the solution without the bias from
 * photon noise in the slopes. Stops when a step is short or after a number of
 * steps (SETTLED and SETTLE_MAX in search_steps.c). Also stops, and sets
 * search->is_undersampled, at the first point at which the effective share of
 * the light is below MURK_MIN_SHARE. */
murk_status murk_fit_settle(murk_fit_search *search, double *x,
                            murk_error *err);

#endif
