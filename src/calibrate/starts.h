/* The searches of a fit, from one start each: the scene's own values first,
 * then others around them. Inside this room only. */
#ifndef MURK_CALIBRATE_STARTS_H
#define MURK_CALIBRATE_STARTS_H

#include "calibrate/search.h"

/* Search i: fills out->start[i], and out->best where it is the best so far.
 * Leaves the search looking at x[n], where it ended. A further start that
 * cannot be is no failure of the others: its why says so. */
murk_status murk_fit_start(murk_calibration *out, murk_fit_search *search,
                           size_t i, double *x, murk_error *err);

#endif
