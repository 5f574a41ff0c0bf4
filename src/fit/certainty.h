/* How sure a fit is: covariance of its parameters from the whitened Jacobian,
 * what is determined, and what is not.
 *
 * With J^T J = V diag(s^2) V^T in scaled parameters x_j / scale_j, directions v
 * with a standard error 1 / s above `undetermined` are not determined by the
 * data: they are left out of covariance (pseudo-inverse), and parameters that
 * have a share in them have no standard error. */
#ifndef MURK_FIT_CERTAINTY_H
#define MURK_FIT_CERTAINTY_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_certainty {
    size_t n;
    double *covariance;      /* [n * n]; NaN rows and columns of those that are
                                fixed or undetermined */
    double *correlation;     /* [n * n]; likewise */
    double *standard_error;  /* [n]; NaN: at a bound, or undetermined */
    size_t directions;       /* of the free parameters, best determined first */
    double *direction;       /* [directions][n] unit, in scaled parameters */
    double *direction_error; /* [directions] standard error along it; INFINITY:
                                nothing depends on it */
    size_t determined;       /* the first so many directions */
} murk_certainty;

/* jacobian[rows][n] of whitened rows (row by row); is_fixed[n] (at a bound;
 * may be NULL); scale[n] > 0: a change of that much is a large one, say the
 * value itself. undetermined > 0, say 1. *out is the caller's. */
murk_status murk_certainty_create(murk_certainty *out, const double *jacobian,
                                  size_t rows, size_t n, const bool *is_fixed,
                                  const double *scale, double undetermined,
                                  murk_error *err);
void murk_certainty_release(murk_certainty *certainty);

#endif
