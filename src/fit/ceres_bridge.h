/* The one door to Ceres and Eigen: what fit needs of them, with a C face.
 *
 * Nothing here throws, prints or ends the program. */
#ifndef MURK_FIT_CERES_BRIDGE_H
#define MURK_FIT_CERES_BRIDGE_H

#include "base/status.h"
#include "fit/least_squares.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum murk_ceres_end {
    MURK_CERES_LEVEL,      /* the cost hardly changed with the last step */
    MURK_CERES_SHORT_STEP, /* the last step was next to nothing */
    MURK_CERES_FLAT,       /* the gradient is 0 */
    MURK_CERES_ITERATIONS, /* iterations_max reached */
    MURK_CERES_STOPPED,    /* by the watch */
    MURK_CERES_FAILED
} murk_ceres_end;

typedef struct murk_ceres_found {
    murk_ceres_end end;
    int iterations;
    char message[256]; /* Ceres' own, one line */
} murk_ceres_found;

/* One run of Ceres from x[n] for a problem that least_squares.c has checked,
 * without its bounds; parameters that are held stay, at least one is free. The
 * watch is called with the best x so far, which is in x[n] at the end; its cost
 * is that of the last step where that failed. Residuals and Jacobian must be
 * finite where the callback returns true. */
murk_status murk_ceres_minimise(murk_ceres_found *found, double *x,
                                const bool *is_held,
                                const murk_least_squares *problem,
                                murk_error *err);

/* L of a = L L^T, in the lower triangle of a[n * n] (row by row), of which the
 * upper one is neither read nor written. *is_positive is false where a is not
 * positive definite. */
murk_status murk_eigen_cholesky(double *a, size_t n, bool *is_positive,
                                murk_error *err);

/* a[rows][n] = U diag(singular) V^T: singular[n], largest first, 0 beyond
 * `rows`; direction[n][n] has V's columns as rows, each with its largest
 * component positive. */
murk_status murk_eigen_singular(double *singular, double *direction,
                                const double *a, size_t rows, size_t n,
                                murk_error *err);

#endif
