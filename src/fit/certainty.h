/* How sure a fit is: covariance of its parameters from the whitened Jacobian,
 * what is determined, and what is not.
 *
 * In scaled parameters x_j / scale_j, J = U diag(s) V^T: along a column v of V
 * the data have a standard error of 1 / s. Directions where it is above
 * `undetermined` are not determined. A parameter's variance is the sum over all
 * directions of (v_j / s)^2, 1 / s being 1000 at most; one whose error so comes
 * out above `undetermined` scales has no standard error, so what is confounded
 * has none, and what happens to lie beside it keeps its own.
 *
 * Errors are those of rows with unit variance, to first order (Bard, Nonlinear
 * Parameter Estimation, 1974, ch. 7). */
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
    double *standard_error;  /* [n]; NaN: fixed, or undetermined */
    size_t directions;       /* of the free parameters, best determined first */
    double *direction;       /* [directions][n] unit, in scaled parameters, the
                                largest component positive; 0 where fixed */
    double *direction_error; /* [directions] standard error along it; INFINITY:
                                nothing depends on it, but for rounding */
    size_t determined;       /* the first so many directions */
} murk_certainty;

/* jacobian[rows][n] of whitened rows (row by row); is_fixed[n] (at a bound;
 * may be NULL); scale[n] > 0: a change of that much is a large one, say the
 * value itself. undetermined > 0, say 1. *out is the caller's. Fails with
 * MURK_BAD_VALUE where a number is not finite, or MURK_NO_MEMORY. */
murk_status murk_certainty_create(murk_certainty *out, const double *jacobian,
                                  size_t rows, size_t n, const bool *is_fixed,
                                  const double *scale, double undetermined,
                                  murk_error *err);
void murk_certainty_release(murk_certainty *certainty);

#endif
