/* Bounded least squares over a callback, with Ceres behind a C interface.
 *
 * Minimises 1/2 sum rho(r_i(x)^2) over lower <= x <= upper, where rho is a loss
 * that acts on each row (Huber, Ann. Math. Statist. 35 (1964) 73,
 * doi:10.1214/aoms/1177703732). The method is Levenberg-Marquardt with the
 * Jacobian of the caller, on one thread, so that results are reproducible.
 * Nothing is printed: the first run of Ceres turns off all messages of glog in
 * the process except fatal ones. */
#ifndef MURK_FIT_LEAST_SQUARES_H
#define MURK_FIT_LEAST_SQUARES_H

#include "base/status.h"
#include "fit/problem.h"

#include <stdbool.h>
#include <stddef.h>

/* Returns rho(square): twice the cost of a row with this squared residual.
 * *slope: d rho / d square; with MURK_LOSS_FUNCTION_HUBER 1 for residuals
 * within width, without a loss always 1. width > 0 unless there is no loss. */
double murk_loss_at(murk_loss_function loss, double width, double square,
                    double *slope);

/* The reason for the end of a search. */
typedef enum murk_least_squares_end {
    MURK_LEAST_SQUARES_CONVERGED,
    MURK_LEAST_SQUARES_ITERATIONS, /* iterations_max reached */
    MURK_LEAST_SQUARES_STOPPED,    /* by the callback `watch` */
    MURK_LEAST_SQUARES_FAILED      /* no finite residuals at the start or at the
                                    * last point that the search tried, no step
                                    * that lowers the cost, or a numerical
                                    * failure */
} murk_least_squares_end;

/* The result of a search. */
typedef struct murk_least_squares_found {
    murk_least_squares_end end;
    double initial_cost, cost; /* NaN: no finite residuals at the start */
    int iterations, evaluations;
    char why[256]; /* one line */
} murk_least_squares_found;

/* Minimises from the start x[n], which lies within the bounds; x[n] is then the
 * best point found, also if the search ended early. x[n] is unchanged if the
 * function fails. Fails with MURK_BAD_VALUE (bounds, start, width of the loss,
 * tolerance, iterations_max; sizes: at least one row and one parameter, and
 * rows * n at most INT_MAX), MURK_NO_MEMORY or MURK_RUN_FAILED (an exception of
 * Ceres). A search that does not converge, or has no finite residuals at the
 * start, is no failure: found->end says so. */
murk_status murk_least_squares_solve(murk_least_squares_found *found, double *x,
                                     const murk_least_squares *problem,
                                     murk_error *err);

#endif
