/* The verdict of a finished fit: whether chi-squared accepts the model, and for
 * each parameter whether the data determine it. The terminal, fit.json,
 * calibrated.yaml and the page print these words. */
#ifndef MURK_CALIBRATE_VERDICT_H
#define MURK_CALIBRATE_VERDICT_H

#include "calibrate/calibration.h"

/* A model is rejected if the probability of a chi-squared at least as large is
 * below this: of 10,000 fits of a correct model with correct errors, one is
 * rejected. */
#define MURK_FIT_REFUSED 1e-4

/* The verdict of a rejected model begins with this. */
#define MURK_VERDICT_REFUSED "No: "

/* Fills p_value, is_accepted and verdict from chi2, degrees_of_freedom,
 * converged, at_bound and standard_error, with the names of the keys. */
void murk_calibration_judge(murk_calibration *calibration,
                            const murk_free_keys *keys);

/* The status of parameter k: "determined", "at its bound" or "not determined by
 * these data". Only a determined parameter has a standard error. */
const char *murk_calibration_status(const murk_calibration *calibration,
                                    size_t k);

/* True if parameter k has a standard error. */
bool murk_calibration_determines(const murk_calibration *calibration, size_t k);

#endif
