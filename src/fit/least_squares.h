/* Bounded least squares over a callback: Ceres behind a C face.
 *
 * Minimises 1/2 sum rho(r_i(x)^2) over lower <= x <= upper, rho the loss of
 * each row apart (Huber, Ann. Math. Statist. 35 (1964) 73,
 * doi:10.1214/aoms/1177703732). Levenberg-Marquardt with the caller's own
 * Jacobian; one thread, so the same bits always. Nothing is printed: the first
 * use turns glog's messages of the process off, but for fatal ones. */
#ifndef MURK_FIT_LEAST_SQUARES_H
#define MURK_FIT_LEAST_SQUARES_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum murk_loss_function {
    MURK_LOSS_FUNCTION_NONE, /* rho(s) = s */
    MURK_LOSS_FUNCTION_HUBER,
    MURK_LOSS_FUNCTION_CAUCHY
} murk_loss_function;

/* rho, what a row of this squared residual costs, twice over; *slope: d rho /
 * d square, 1 where residuals are within width. */
double murk_loss_at(murk_loss_function loss, double width, double square,
                    double *slope);

/* Fills residual[rows] and, unless NULL, jacobian[rows][n] (row by row) at
 * x[n]. False where that cannot be done: the step is then tried shorter. So it
 * is where a value or a sum of squares is not finite. */
typedef bool (*murk_residuals)(void *context, const double *x, double *residual,
                               double *jacobian);

typedef struct murk_least_squares_step {
    int iteration; /* 0: the start */
    bool is_successful;
    double cost;
    const double *x; /* [n] the best so far */
} murk_least_squares_step;

/* After each iteration; false ends the search there. */
typedef bool (*murk_least_squares_watch)(void *context,
                                         const murk_least_squares_step *step);

typedef struct murk_least_squares {
    size_t n, rows;
    const double *lower, *upper; /* [n]; -INFINITY, INFINITY: none */
    murk_residuals residuals;
    bool is_jacobian_free; /* comes along with residuals at no cost: they are
                              then never asked for alone */
    murk_least_squares_watch watch; /* may be NULL */
    void *context;
    murk_loss_function loss;
    double loss_width;  /* residuals beyond it count for less; > 0 */
    int iterations_max; /* 0: 100 */
    double tolerance;   /* of cost, relative; 0: 1e-10 */
} murk_least_squares;

typedef enum murk_least_squares_end {
    MURK_LEAST_SQUARES_CONVERGED,
    MURK_LEAST_SQUARES_ITERATIONS, /* used up */
    MURK_LEAST_SQUARES_STOPPED,    /* by watch */
    MURK_LEAST_SQUARES_FAILED      /* no residuals at the start, or where the
                                      search goes; or numerically */
} murk_least_squares_end;

typedef struct murk_least_squares_found {
    murk_least_squares_end end;
    double initial_cost, cost; /* NaN: no residuals at the start */
    int iterations, evaluations;
    char why[256]; /* one line */
} murk_least_squares_found;

/* x[n]: the start, within the bounds; then what is found, also where the
 * search ended early. Fails with MURK_BAD_VALUE (bounds, start, sizes: at
 * least one row and one x) or MURK_NO_MEMORY; a search that ends badly is no
 * failure. */
murk_status murk_least_squares_solve(murk_least_squares_found *found, double *x,
                                     const murk_least_squares *problem,
                                     murk_error *err);

#endif
