/* One search from one start, in coordinates that suit it: logarithms of keys
 * that are positive. Inside this room only. */
#ifndef MURK_CALIBRATE_SEARCH_H
#define MURK_CALIBRATE_SEARCH_H

#include "calibrate/calibrate.h"
#include "fit/whitening.h"

typedef struct murk_fit_search {
    const murk_calibration_desc *desc;
    murk_model *model;
    size_t n, rows;            /* keys, rows of the data */
    size_t *fitted, n_fitted;  /* rows that are not held out: those of light
                                  first */
    size_t n_lit;              /* of them */
    double *measured, *error;  /* [rows] */
    murk_whitening *whitening; /* of the first n_lit; NULL: none */
    double *value;             /* [n] as predicted last */
    double *predicted, *slope; /* [rows], [rows][n] likewise */
    double *offset;            /* [n_fitted] of whitened residuals: see
                                  slope_noise.h */
    double share;
    size_t evaluations;
    int iterations;
    size_t traces;        /* of this start */
    size_t start;         /* its number */
    bool is_undersampled; /* the last search ended for want of light */
    bool has_light; /* the last search ended well, so its light can be used */
    bool shares_light;   /* the next search begins on that light */
    bool is_scouting;    /* least squares go on however little light is left */
    double cost_to_beat; /* of the best start so far */
    bool is_dropped; /* the last search was not followed: see shares_light */
    murk_error err;  /* why the last prediction failed */
} murk_fit_search;

/* Release also after a failure. */
murk_status murk_fit_search_create(murk_fit_search *out,
                                   const murk_calibration_desc *desc,
                                   murk_model *model, murk_error *err);
void murk_fit_search_release(murk_fit_search *search);

/* From coordinates x[n] to values, and back. */
void murk_fit_search_values(const murk_fit_search *search, const double *x,
                            double *value);
void murk_fit_search_coordinates(const murk_fit_search *search,
                                 const double *value, double *x);

/* Rows and slopes at x, and what whitens rows there: once light is traced. */
murk_status murk_fit_search_look(murk_fit_search *search, const double *x,
                                 murk_error *err);

/* Whitened residuals [n_fitted] of the last prediction, measured less
 * predicted, without the offset; and their slopes by coordinates [n_fitted][n],
 * or NULL. */
void murk_fit_search_residuals(const murk_fit_search *search, double *residual,
                               double *jacobian);

/* Searches from x[n], which it moves: to->converged, why and chi2 say how it
 * ended. Leaves the search looking at x. With shares_light and has_light, the
 * search follows the light at hand. Light is traced only where that leads to a
 * place that it no longer describes and that promises less than cost_to_beat;
 * a place that promises nothing is dropped: is_dropped, and to->why says so. */
murk_status murk_fit_search_run(murk_fit_search *search, double *x,
                                murk_calibration_start *to, murk_error *err);

#endif
