/* The loss function of a fit as text: "none", "huber", "cauchy:2". */
#ifndef MURK_CALIBRATE_LOSS_H
#define MURK_CALIBRATE_LOSS_H

#include "base/status.h"
#include "fit/least_squares.h"

/* Reads the name of a loss function and the width in standard errors, which is
 * that of 95 % efficiency on normal residuals if the text has no width (1, and
 * not used, for "none"). Fails with MURK_BAD_VALUE at "loss". */
murk_status murk_loss_read(murk_loss_function *loss, double *width,
                           const char *text, murk_error *err);

#endif
