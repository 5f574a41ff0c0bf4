/* Covariance of fitted parameters from the whitened Jacobian, and which
 * parameters the data determine.
 *
 * In scaled parameters x_j / scale_j the Jacobian is J = U diag(s) V^T: along a
 * column v of V the data determine the parameters with a standard error of 1 /
 * s. Directions with a standard error above `undetermined` are not determined.
 * The variance of a parameter is the sum over all directions of (v_j / s)^2,
 * with 1 / s cut at 1000 (SCALES_MAX in certainty.c). In a direction on which
 * the data do not depend, components up to SHARE_MIN do not count. A parameter
 * whose error exceeds `undetermined` scales in this way has no standard error.
 * Therefore confounded parameters have none, and parameters with a small
 * component in a confounded direction keep theirs.
 *
 * Errors are those of rows with unit variance, to first order (Bard, Nonlinear
 * Parameter Estimation, 1974, ch. 7). */
#ifndef MURK_FIT_CERTAINTY_H
#define MURK_FIT_CERTAINTY_H

#include "base/arena.h"
#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

/* The result for n parameters. */
typedef struct murk_certainty {
    size_t n;
    double *covariance;      /* [n * n]; NaN rows and columns for fixed or
                              * undetermined parameters */
    double *correlation;     /* [n * n]; likewise */
    double *standard_error;  /* [n]; NaN: fixed, or undetermined */
    size_t directions;       /* number of directions, as many as free
                              * parameters; the best determined direction comes
                              * first */
    double *direction;       /* [directions][n] unit vectors in scaled
                              * parameters, the component of largest absolute
                              * value is positive; 0 for fixed parameters */
    double *direction_error; /* [directions] standard error along the direction,
                              * in scaled parameters; INFINITY: the data do not
                              * depend on the direction, except by rounding */
    size_t determined;       /* number of determined directions, which come
                              * first */
    murk_arena arena;        /* of all arrays */
} murk_certainty;

/* jacobian[rows][n] of whitened rows (row by row); is_fixed[n]: the parameter
 * is fixed, for example at a bound (NULL: no parameter is fixed); scale[n] > 0:
 * a large change of the parameter, for example the value itself; undetermined >
 * 0: the largest standard error of a determined parameter in scales, for
 * example 1. The caller releases *out. Fails with MURK_BAD_VALUE if a scale is
 * not finite and above 0, if a slope times its scale is not finite or if
 * `undetermined` is not above 0, or with MURK_NO_MEMORY. */
murk_status murk_certainty_create(murk_certainty *out, const double *jacobian,
                                  size_t rows, size_t n, const bool *is_fixed,
                                  const double *scale, double undetermined,
                                  murk_error *err);
void murk_certainty_release(murk_certainty *certainty);

#endif
