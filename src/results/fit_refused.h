/* Files of a fit whose model the data refuse: how such a file says so, and the
 * warning of those who use its values. */
#ifndef MURK_RESULTS_FIT_REFUSED_H
#define MURK_RESULTS_FIT_REFUSED_H

#include "calibrate/verdict.h"

/* A line of calibrated.yaml begins with this, and the verdict follows. */
#define MURK_CALIBRATED_VERDICT "# Does it fit? "

/* Whether the text of a file for --set @FILE is that of a refused fit. */
bool murk_fit_refused_values(const char *text);

/* Warns that the file holds values of a refused fit; like the refusal itself,
 * this is no matter of --quiet. */
void murk_fit_warn_refused(const char *file);

#endif
