/* The searches of a fit: the first starts at the values of the scene, further
 * ones at random values around them. Internal to this room. */
#ifndef MURK_CALIBRATE_STARTS_H
#define MURK_CALIBRATE_STARTS_H

/* Runs search i: fills out->start[i], and out->best if it is the best so far.
 * Afterwards the last prediction of the search is that at x[n], the end. A
 * failure of a further start is recorded in out->start[i].why and is no failure
 * of the fit. */
#include "calibrate/search.h"

/* Search i: fills out->start[i], and out->best where it is the best so far.
 * Leaves the search looking at x[n], where it ended. A further start that
 * cannot be is no failure of the others: its why says so. */
murk_status murk_fit_start(murk_calibration *out, murk_fit_search *search,
                           size_t i, double *x, murk_error *err);

#endif
