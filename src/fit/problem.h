/* The description of a least-squares problem: callback, bounds and loss.
 *
 * The sum to minimise is 1/2 sum rho(r_i(x)^2) over lower <= x <= upper, where
 * r_i is residual i of the callback `residuals` and rho the loss.
 * murk_least_squares_solve() (fit/least_squares.h) minimises it. */
#ifndef MURK_FIT_PROBLEM_H
#define MURK_FIT_PROBLEM_H

#include <stdbool.h>
#include <stddef.h>

/* The losses rho. */
typedef enum murk_loss_function {
    MURK_LOSS_FUNCTION_NONE, /* rho(s) = s */
    MURK_LOSS_FUNCTION_HUBER,
    MURK_LOSS_FUNCTION_CAUCHY
} murk_loss_function;

/* Computes residual[rows] and, unless NULL, jacobian[rows][n] (row by row) at
 * x[n]. Returns false if that is impossible: the search then tries a shorter
 * step, or ends if x is its start. Values that are not finite, or whose sum of
 * squares is not finite, have the same effect. */
typedef bool (*murk_residuals)(void *context, const double *x, double *residual,
                               double *jacobian);

/* The state after an iteration. */
typedef struct murk_least_squares_step {
    int iteration; /* 0: start */
    bool is_successful;
    double cost;
    const double *x; /* [n] best so far */
} murk_least_squares_step;

/* Called for the start (if its residuals are finite) and after each iteration;
 * false ends the search. */
typedef bool (*murk_least_squares_watch)(void *context,
                                         const murk_least_squares_step *step);

/* A least-squares problem. */
typedef struct murk_least_squares {
    size_t n, rows;
    const double *lower, *upper; /* [n]; -INFINITY, INFINITY: unbounded */
    murk_residuals residuals;
    bool is_jacobian_free; /* the Jacobian costs nothing beside the residuals:
                            * residuals are then never requested alone */
    murk_least_squares_watch watch; /* may be NULL */
    void *context;
    murk_loss_function loss;
    double loss_width;  /* > 0, not used without a loss; Huber: residuals beyond
                         * this width have less weight; Cauchy: the weight of
                         * every residual falls with its size, to a half at this
                         * width */
    int iterations_max; /* 0: 100 */
    double tolerance;   /* relative tolerance of the cost; 0: 1e-10 */
} murk_least_squares;

#endif
