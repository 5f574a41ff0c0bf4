/* The fit: finds the parameters that make the forward model agree with the
 * data, with their uncertainty.
 *
 * Light is traced at the present parameters and re-weighted while Ceres varies
 * the parameters. Light is traced again when the effective sample size falls
 * below MURK_MIN_SHARE of the sample, or when a parameter that re-weighting
 * cannot vary has moved. A search ends when least squares end at a point where
 * the light is still valid, or at the limit on traces; a search may also be
 * abandoned (calibrate/search.h). Rows are whitened by the measurement errors
 * together with the covariance from photons. */
#ifndef MURK_CALIBRATE_CALIBRATE_H
#define MURK_CALIBRATE_CALIBRATE_H

#include "calibrate/calibration.h"

/* Runs the fit. The caller releases *out (murk_calibration_release()), also
 * after a failure. A start is one search from one set of values
 * (calibrate/search.h). The fit fails if the first start fails, or if any start
 * fails for lack of memory; any other failure of a later start is only recorded
 * in out->start[].why. If the fit is interrupted after at least one start has
 * ended, the status is MURK_INTERRUPTED, and out->best and the first
 * out->starts_done elements of out->start[] describe the ended starts. The
 * results that follow from the best start (value, row, covariance and all
 * others) are not computed then. */
murk_status murk_calibrate(murk_calibration *out,
                           const murk_calibration_desc *desc, murk_error *err);

/* Runs the starts of desc->shard, of at least two starts, and writes them to
 * the file `path`, a part of the fit (desc->part). Shard K of N runs start 0,
 * on which the others depend, and of the others every N-th from start K on; of
 * restarts as far as these starts are doubtful. Fails as murk_calibrate(), with
 * MURK_BAD_VALUE if there is no such shard, or if the file cannot be written.
 */
murk_status murk_calibrate_part(const murk_calibration_desc *desc,
                                const char *path, murk_error *err);

void murk_calibration_release(murk_calibration *calibration);

#endif
