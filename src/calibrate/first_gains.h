/* Initial values of the free factors of readings. The counts of a meter may be
 * any multiple of a watt, and a search that starts with a factor wrong by a
 * thousand would distort the medium first. Internal to this room. */
#ifndef MURK_CALIBRATE_FIRST_GAINS_H
#define MURK_CALIBRATE_FIRST_GAINS_H

#include "calibrate/search.h"

/* Sets the factors in x[n] to their least squares values for the other values
 * of x, at which light must have been traced: g = sum(m p / e^2) / sum(p^2 /
 * e^2) over the fitted rows, with measured m, predicted p and error e. Factors
 * stay within bounds; a factor that no fitted row uses is not changed. */
murk_status murk_fit_first_gains(murk_fit_search *search, double *x,
                                 murk_error *err);

#endif
