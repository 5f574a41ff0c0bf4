/* The search: parameters that bring the model to the data, and how sure they
 * are.
 *
 * Light is traced at the present parameters, re-weighted while Ceres moves
 * them, and traced anew where what is left of it, by effective sample size, is
 * less than MURK_MIN_SHARE; the fit ends when it has converged on light that
 * is still good there. Rows are whitened by measurement errors and the photons'
 * covariance together. */
#ifndef MURK_CALIBRATE_CALIBRATE_H
#define MURK_CALIBRATE_CALIBRATE_H

#include "calibrate/model.h"
#include "fit/certainty.h"
#include "fit/least_squares.h"

/* Of the light's effective sample, below which it is traced again. */
#define MURK_MIN_SHARE 0.5

/* Directions whose standard error is a factor e, or all of a parameter's own
 * scale, are not determined. */
#define MURK_UNDETERMINED 1.0

/* Searches of a fit that is asked for nothing else. By a single one 2 of 110
 * planted fits (three parameters, thirteen readings of 3 %) ended in a false
 * minimum. The number is fixed, so that a result does not depend on the
 * machine. */
#define MURK_FIT_STARTS 4

typedef struct murk_calibration_desc {
    const murk_free_keys *keys;
    const murk_measurements *measured;
    const murk_imported_stages *imported; /* of the keys' scene */
    murk_loss_function loss;
    double loss_width; /* in standard errors */
    size_t starts;     /* 0: MURK_FIT_STARTS; 1: from the scene's values, and
                          no restart; more: others around, too */
    size_t traces_max; /* of light, each start; 0: 12 */
    unsigned threads;
    uint32_t seed;      /* of further starts */
    bool only_predicts; /* rows at the start; no search */
    /* After each step of the search, on the caller's thread; may be NULL. */
    void (*watch)(void *context, size_t start, size_t traces, int iteration,
                  double chi2, const double *value);
    /* As in murk_model_desc. */
    void (*forecast)(void *context, double bytes, double have_bytes);
    void *context;
} murk_calibration_desc;

typedef struct murk_calibrated_row {
    double predicted;    /* in the row's unit */
    double photon_error; /* its standard error by photons */
    double residual;     /* measured less predicted, over both errors */
} murk_calibrated_row;

typedef struct murk_calibration_start {
    double *from, *to; /* [keys->n] */
    double chi2;       /* NaN: it failed, */
    double cost;       /* what was lowered: chi2, or less by a robust loss */
    char why[256];     /* or how it ended */
    bool converged;
    size_t traces; /* 0: it found its way on the light of the one before */
    size_t light;  /* lights that the fit had traced when it ended */
} murk_calibration_start;

typedef struct murk_calibration {
    size_t n;                 /* parameters */
    double *value;            /* [n] */
    double *lower, *upper;    /* [n] 95 % interval; NaN: undetermined */
    double *standard_error;   /* [n] NaN: undetermined, or at a bound */
    bool *at_bound;           /* [n] */
    murk_certainty certainty; /* in search coordinates: logarithms of keys that
                                 are positive */
    double *covariance, *correlation; /* [n * n] of the values */
    murk_calibrated_row *row;         /* [measured->rows] */
    double chi2;
    long degrees_of_freedom;
    double p_value;    /* chance of at least this chi2; NaN: no freedom */
    bool is_accepted;  /* false: chi2 refuses the model (verdict.h) */
    char verdict[512]; /* the fit in a sentence or two, for every output */
    size_t held_out;
    double held_out_rms; /* in units, where all held-out rows have one unit;
                            else NaN */
    double held_out_rms_sigma; /* in their own errors; NaN without any */
    bool converged;
    char why[256];
    int iterations;
    size_t evaluations, traces;
    uint64_t photons;
    double effective_share;
    double slope_noise;  /* the largest part of what any direction seems to tell
                            that is photons' noise, and is taken off; near 1:
                            more photons are needed */
    size_t fitted;       /* rows */
    double *jacobian;    /* [fitted][n] that carry what is known: whitened, in
                            search coordinates, without photons' noise */
    double *scale;       /* [n] what a large change is there */
    double *information; /* [n * n] likewise, of the fitted rows */
    murk_calibration_start *start; /* [starts], of which [starts_done] were
                                      made: those asked for, then restarts */
    size_t starts, starts_done, best;
    double trace_s;
    murk_model *model; /* built at the values, or near them */
} murk_calibration;

/* *out is the caller's; release it also after a failure. Where a first start
 * fails, so does the fit; where it is interrupted after starts have ended,
 * these are there (starts_done) and the status is MURK_INTERRUPTED. */
murk_status murk_calibrate(murk_calibration *out,
                           const murk_calibration_desc *desc, murk_error *err);
void murk_calibration_release(murk_calibration *calibration);

#endif
