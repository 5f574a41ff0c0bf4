/* The interface to Ceres and Eigen, in C. Only ceres_bridge.cpp includes these
 * packages. It is a module of its own (base/program.h), since only fits need
 * these packages and what they bring with them.
 *
 * No function here throws an exception, prints or ends the program. */
#ifndef MURK_FIT_CERES_BRIDGE_H
#define MURK_FIT_CERES_BRIDGE_H

#include "base/status.h"
#include "fit/problem.h"

#include <stdbool.h>
#include <stddef.h>

/* The reason why Ceres stopped. */
typedef enum murk_ceres_end {
    MURK_CERES_LEVEL,      /* the last step hardly changed the cost */
    MURK_CERES_SHORT_STEP, /* the last step was too short */
    MURK_CERES_FLAT,       /* the gradient is 0 */
    MURK_CERES_ITERATIONS, /* iterations_max reached */
    MURK_CERES_STOPPED,    /* by the callback `watch` */
    MURK_CERES_FAILED
} murk_ceres_end;

typedef struct murk_ceres_found {
    murk_ceres_end end;
    int iterations;
    char message[256]; /* the message of Ceres, one line */
} murk_ceres_found;

/* The functions of the module. All fail with MURK_NO_MEMORY or
 * MURK_RUN_FAILED (an exception of the package). */
typedef struct murk_ceres {
    /* Runs Ceres once from x[n] for a problem that least_squares.c has checked,
     * without bounds. Parameters with is_held keep their values; at least one
     * is free. The callback `watch` receives the best x so far, and the cost of
     * the last step, also if that step failed. At the end x[n] is the best x;
     * it is unchanged if Ceres reports a failure. Residuals and Jacobian must
     * be finite if the callback `residuals` returns true. */
    murk_status (*minimise)(murk_ceres_found *found, double *x,
                            const bool *is_held,
                            const murk_least_squares *problem, murk_error *err);

    /* Replaces the lower triangle of a[n * n] (row by row) by the Cholesky
     * factor L of a = L L^T; the upper triangle is neither read nor written.
     * *is_positive is false if a is not positive definite; the lower triangle
     * is then of no use. */
    murk_status (*cholesky)(double *a, size_t n, bool *is_positive,
                            murk_error *err);

    /* Singular values and right singular vectors of a[rows][n] =
     * U diag(singular) V^T: singular[n], largest first, 0 beyond `rows`. The
     * rows of direction[n][n] are the columns of V, each with the sign that
     * makes its component of largest absolute value positive. */
    murk_status (*singular)(double *singular, double *direction,
                            const double *a, size_t rows, size_t n,
                            murk_error *err);
} murk_ceres;

/* The object of the module. */
extern const murk_ceres murk_ceres_functions;

/* Loads the module if it is not loaded yet. Returns NULL, with MURK_RUN_FAILED
 * in *err, if it cannot be loaded. */
const murk_ceres *murk_ceres_load(murk_error *err);

#endif
