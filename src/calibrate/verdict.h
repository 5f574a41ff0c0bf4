/* What a finished fit may be used for, said once: whether chi-squared accepts
 * the model, and of each parameter whether the data determine it. Terminal,
 * fit.json, calibrated.yaml and the page all print these words. */
#ifndef MURK_CALIBRATE_VERDICT_H
#define MURK_CALIBRATE_VERDICT_H

#include "calibrate/calibrate.h"

/* A model under which so large a chi-squared has a smaller chance than this is
 * refused: of 10,000 fits of a right model with right errors, one. */
#define MURK_FIT_REFUSED 1e-4

/* The verdict of a refused model begins with this. */
#define MURK_VERDICT_REFUSED "No: "

/* Fills p_value, is_accepted and verdict from chi2, degrees_of_freedom,
 * converged, at_bound and standard_error; names are those of the keys. */
void murk_calibration_judge(murk_calibration *calibration,
                            const murk_free_keys *keys);

/* Of parameter k: "determined", "at its bound" or "not determined by these
 * data". Only the first has a standard error. */
const char *murk_calibration_status(const murk_calibration *calibration,
                                    size_t k);

/* True where parameter k has a standard error. */
bool murk_calibration_determines(const murk_calibration *calibration, size_t k);

#endif
