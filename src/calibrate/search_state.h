/* The state of a search for the best parameters, in search coordinates (the
 * logarithm of a key with is_log, the value of any other), and the residuals
 * that least squares minimise. For use inside src/calibrate only. */
#ifndef MURK_CALIBRATE_SEARCH_STATE_H
#define MURK_CALIBRATE_SEARCH_STATE_H

#include "calibrate/calibration.h"
#include "fit/whitening.h"

typedef struct murk_fit_search {
    const murk_calibration_desc *desc;
    murk_model *model;
    size_t n, rows;              /* number of keys, and of rows of the data */
    size_t *fitted, n_fitted;    /* rows that are not held out; those that need
                                  * light first */
    size_t n_light;              /* number of fitted rows that need light */
    size_t *place;               /* [n_light]; index of a fitted row that needs
                                  * light among all light rows of the model */
    double *measured, *error;    /* [rows] */
    murk_whitening *whitening;   /* of the first n_light rows; NULL: none */
    murk_whitening *scouting;    /* that at the end of start 0, for further
                                  * starts; NULL: none */
    double *x;                   /* [n]; present point of the search */
    double *lower, *upper;       /* [n]; bounds */
    double *traced, *before;     /* [n]; point of the last trace that was
                                  * accepted; point to which the search goes
                                  * back halfway if a step was too long */
    double *lit;                 /* [n]; point of the last trace of light */
    double *residual, *jacobian; /* [n_fitted], [n_fitted][n]; whitened; while
                                  * least squares run, those at `traced` */
    double *value;               /* [n]; at the last prediction */
    double *predicted, *slope;   /* [rows], [rows][n]; at the last prediction */
    double *offset;              /* [n_fitted]; offset of the whitened
                                  * residuals, see slope_noise.h */
    double share; /* effective share (murk_reweighed) at the last prediction */
    size_t evaluations;
    int iterations;
    size_t traces;        /* of this start */
    size_t start;         /* number of the start */
    bool is_undersampled; /* least squares, or the correction after them, ended
                           * last because the effective share was too low */
    size_t lit_by;        /* number of the start that traced the light at hand;
                           * SIZE_MAX: no light is at hand */
    size_t ended; /* number of the start at whose end the last prediction is;
                   * SIZE_MAX: none */
    bool shares_light;   /* the search follows the light of start 0, and waits
                          * when it has to trace light: see search.h */
    bool is_scouting;    /* least squares continue for any effective share */
    double cost_to_beat; /* cost of start 0 */
    bool is_dropped;     /* the last search was abandoned: see search.h */
    murk_error err;      /* why the last prediction failed */
    murk_arena arena;    /* of all arrays */
} murk_fit_search;

/* Release also after a failure. */
murk_status murk_fit_search_create(murk_fit_search *out,
                                   const murk_calibration_desc *desc,
                                   murk_model *model, murk_error *err);
void murk_fit_search_release(murk_fit_search *search);

/* Bounds of a key in search coordinates; those of a logarithm lie at most a
 * factor 1e9 (MURK_FREE_REACH) from the start. */
double murk_free_lowest(const murk_free_key *key);
double murk_free_highest(const murk_free_key *key);

/* Converts coordinates x[n] to values, and back. */
void murk_fit_search_values(const murk_fit_search *search, const double *x,
                            double *value);
void murk_fit_search_coordinates(const murk_fit_search *search,
                                 const double *value, double *x);

/* Predicts the rows at x, with slopes or without; only after a trace. */
murk_status murk_fit_search_predict(murk_fit_search *search, const double *x,
                                    bool with_slopes, murk_error *err);

/* Predicts rows and slopes at x, and computes the whitening of the rows at
 * x. */
murk_status murk_fit_search_evaluate(murk_fit_search *search, const double *x,
                                     murk_error *err);

/* Computes the whitened residuals [n_fitted] of the last prediction, measured
 * minus predicted, without the offset. If jacobian is not NULL, also computes
 * the derivatives [n_fitted][n] of the residuals with respect to the search
 * coordinates. */
void murk_fit_search_residuals(const murk_fit_search *search, double *residual,
                               double *jacobian);

/* The minimised quantity of whitened residuals [n_fitted]: the sum of squares,
 * or less for outliers with a robust loss. */
double murk_fit_cost(const murk_fit_search *search, const double *residual);

/* The least squares problem of the re-weighted rows, within the bounds. */
murk_least_squares murk_fit_problem(murk_fit_search *search);

#endif
