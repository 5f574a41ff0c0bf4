/* The search for the best parameters from one start, in search coordinates:
 * logarithms of positive keys, values of others. Internal to this room. */
#ifndef MURK_CALIBRATE_SEARCH_H
#define MURK_CALIBRATE_SEARCH_H

#include "calibrate/calibrate.h"
#include "fit/whitening.h"

typedef struct murk_fit_search {
    const murk_calibration_desc *desc;
    murk_model *model;
    size_t n, rows;            /* number of keys, and of rows of the data */
    size_t *fitted, n_fitted;  /* rows that are not held out; those that need
                                * light first */
    size_t n_lit;              /* number of fitted rows that need light */
    double *measured, *error;  /* [rows] */
    murk_whitening *whitening; /* of the first n_lit rows; NULL: none */
    double *value;             /* [n]; at the last prediction */
    double *predicted, *slope; /* [rows], [rows][n]; at the last prediction */
    double *offset;            /* [n_fitted]; offset of the whitened residuals,
                                * see slope_noise.h */
    double share;
    size_t evaluations;
    int iterations;
    size_t traces;        /* of this start */
    size_t start;         /* number of the start */
    bool is_undersampled; /* the last search ended because the effective share
                           * was too low */
    bool has_light; /* the last search succeeded, so the light can be used again
                     */
    bool shares_light;   /* the next search begins with that light */
    bool is_scouting;    /* least squares continue for any effective share */
    double cost_to_beat; /* cost of the best start so far */
    bool is_dropped;     /* the last search was abandoned: see shares_light */
    murk_error err;      /* why the last prediction failed */
} murk_fit_search;

/* Release also after a failure. */
murk_status murk_fit_search_create(murk_fit_search *out,
                                   const murk_calibration_desc *desc,
                                   murk_model *model, murk_error *err);
void murk_fit_search_release(murk_fit_search *search);

/* Converts coordinates x[n] to values, and back. */
void murk_fit_search_values(const murk_fit_search *search, const double *x,
                            double *value);
void murk_fit_search_coordinates(const murk_fit_search *search,
                                 const double *value, double *x);

/* Predicts rows and slopes at x, and computes the whitening there; only after a
 * trace. */
murk_status murk_fit_search_look(murk_fit_search *search, const double *x,
                                 murk_error *err);

/* Whitened residuals [n_fitted] of the last prediction, measured minus
 * predicted, without the offset, and their derivatives [n_fitted][n] with
 * respect to the coordinates, or NULL. */
void murk_fit_search_residuals(const murk_fit_search *search, double *residual,
                               double *jacobian);

/* Searches from x[n] and moves x to the end: to->converged, why and chi2
 * describe the end. Afterwards the last prediction is that at x. With
 * shares_light and has_light, the search first follows the light at hand
 * without tracing. Light is traced only if that leads to a point that the light
 * no longer describes and whose cost is below cost_to_beat; otherwise the
 * search is abandoned: is_dropped, with the reason in to->why. */
murk_status murk_fit_search_run(murk_fit_search *search, double *x,
                                murk_calibration_start *to, murk_error *err);

#endif
