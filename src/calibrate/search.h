/* Steps of a search besides least squares: extrapolation to the point of the
 * next trace, and correction for photon noise in the slopes. Internal to this
 * room. */
#ifndef MURK_CALIBRATE_SEARCH_STEPS_H
#define MURK_CALIBRATE_SEARCH_STEPS_H

#include "calibrate/search.h"

#include <math.h>

/* Workspace and bounds of one search. */
typedef struct murk_fit_workspace {
    double *residual, *jacobian; /* at the point of the last trace */
    double *traced, *before;     /* [n]; that point, and the one before */
    double *lower, *upper;
} murk_fit_workspace;

/* A positive key may change by at most this factor from the start. At that
 * limit the key is practically zero or infinite, and is reported as being at a
 * bound; logarithms have no limit of their own. */
#define MURK_FREE_REACH 1e9

/* Bounds in search coordinates. */
static inline double murk_free_lowest(const murk_free_key *key)
{
    return key->is_log ? log(fmax(key->lower, key->start / MURK_FREE_REACH))
                       : key->lower;
}

static inline double murk_free_highest(const murk_free_key *key)
{
    return key->is_log ? log(fmin(key->upper, key->start * MURK_FREE_REACH))
                       : key->upper;
}

/* The least squares problem of the re-weighted rows, within bounds. */
murk_least_squares murk_fit_problem(murk_fit_search *search,
                                    const double *lower, const double *upper);

/* The minimised quantity of whitened residuals [n_fitted]: the sum of squares,
 * or less for outliers with a robust loss. */
double murk_fit_cost(const murk_fit_search *search, const double *residual);

/* Minimises the model linearised about x, with the given residual and Jacobian,
 * and moves x to the point of the next trace. */
murk_status murk_fit_leap(murk_fit_search *search, double *x,
                          const double *residual, const double *jacobian,
                          murk_error *err);

/* From the end of least squares, moves x to the solution without the bias from
 * photon noise in the slopes. Sets search->is_undersampled if the light is not
 * valid there. */
murk_status murk_fit_settle(murk_fit_search *search,
                            const murk_fit_workspace *workspace, double *x,
                            murk_error *err);

#endif
