/* Where free factors begin: a meter's counts may be any number of a watt, and
 * from a factor that is off by a thousand the search would bend the fog first.
 * Inside this room only. */
#ifndef MURK_CALIBRATE_FIRST_GAINS_H
#define MURK_CALIBRATE_FIRST_GAINS_H

#include "calibrate/search.h"

/* Sets the factors in x[n] to what suits the readings best at the other values
 * of x, where light has been traced: g = sum(m p / e^2) / sum(p^2 / e^2), of
 * measured m, predicted p and errors e of the fitted rows. Within bounds; one
 * that the rows say nothing of stays. */
murk_status murk_fit_first_gains(murk_fit_search *search, double *x,
                                 murk_error *err);

#endif
