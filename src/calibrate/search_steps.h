/* What a search does beside least squares: leaps to where to trace next, and
 * settling where photons' noise in slopes does not pull. Inside this room only.
 */
#ifndef MURK_CALIBRATE_SEARCH_STEPS_H
#define MURK_CALIBRATE_SEARCH_STEPS_H

#include "calibrate/search.h"

#include <math.h>

/* Room and bounds of one search. */
typedef struct murk_fit_workspace {
    double *residual, *jacobian; /* where light was traced */
    double *traced, *before;     /* [n] there, and the time before */
    double *lower, *upper;
} murk_fit_workspace;

/* A positive key goes no further than this factor from its start: it is then as
 * good as nothing, or as all there can be, and says so as a value at a bound
 * does. Logarithms have no end, numbers have. */
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

/* Least squares over the re-weighted rows, between bounds. */
murk_least_squares murk_fit_problem(murk_fit_search *search,
                                    const double *lower, const double *upper);

/* What a search lowers, of whitened residuals [n_fitted]: the sum of squares,
 * or less for outliers. */
double murk_fit_cost(const murk_fit_search *search, const double *residual);

/* The model as linear about x, where residual and jacobian are: moves x to
 * where to trace next. */
murk_status murk_fit_leap(murk_fit_search *search, double *x,
                          const double *residual, const double *jacobian,
                          murk_error *err);

/* From where least squares end to where they would without photons' noise in
 * slopes. search->is_starved where there is too little light for that. */
murk_status murk_fit_settle(murk_fit_search *search,
                            const murk_fit_workspace *workspace, double *x,
                            murk_error *err);

#endif
