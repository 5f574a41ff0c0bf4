/* What a fit is asked for, and its result. */
#ifndef MURK_CALIBRATE_CALIBRATION_H
#define MURK_CALIBRATE_CALIBRATION_H

#include "base/arena.h"
#include "base/shard.h"
#include "calibrate/model.h"
#include "fit/certainty.h"
#include "fit/least_squares.h"

/* Light is traced again when the effective sample size falls below this share
 * of the sample: at one half, the variance of estimates has doubled. */
#define MURK_MIN_SHARE 0.5

/* A direction in parameter space is undetermined if its standard error is more
 * than this, in units of the scales of the parameters (murk_calibration.scale).
 * The same limit is used for single parameters. */
#define MURK_UNDETERMINED 1.0

/* Number of searches from different starts, if the user does not state one.
 * With a single search, 2 of 110 synthetic fits (three parameters, thirteen
 * readings with errors of 3 %) ended in a false minimum. The number is fixed,
 * so that a result does not depend on the machine. */
#define MURK_FIT_STARTS 4

typedef struct murk_calibration_desc {
    const murk_free_keys *keys;
    const murk_readings *measured;
    const murk_imported_stages *imported; /* of the scene of the keys */
    murk_loss_function loss;
    double loss_width; /* in standard errors */
    size_t starts;     /* 0: MURK_FIT_STARTS; 1: from the values of the scene,
                        * and no restart; more: also from other values */
    size_t traces_max; /* limit on traces of light for each start; 0: 12 */
    unsigned threads;
    uint32_t seed;      /* for the values of further starts */
    bool only_predicts; /* predict the rows at the start values; no search */
    /* Parts of a fit. */
    const murk_scene_desc *scene; /* to which parts belong */
    murk_shard shard; /* count above 0: run the starts of this shard, and
                       * compute no other results */
    const char *const
        *part; /* [parts]; files with starts that are taken over */
    size_t parts;
    /* Called for the start of least squares and after each successful step with
     * the cost (chi2, or less with a robust loss) and the values, in the thread
     * of the caller; may be NULL. */
    void (*watch)(void *context, size_t start, size_t traces, int iteration,
                  double chi2, const double *value);
    /* As in murk_model_desc. */
    void (*forecast)(void *context, double bytes, double have_bytes);
    void *context;
} murk_calibration_desc;

typedef struct murk_calibrated_row {
    double predicted;    /* in the unit of the row */
    double photon_error; /* standard error by photons */
    double residual;     /* measured minus predicted, divided by the square root
                          * of the sum of squares of the measurement error and
                          * photon_error */
} murk_calibrated_row;

typedef struct murk_calibration_start {
    double *from, *to; /* [keys->n] */
    double *x;         /* [keys->n] search coordinates of the end; while the
                        * search waits, of the point to trace light at */
    double *lit;       /* [keys->n] search coordinates at which this search
                        * traced light last */
    double chi2;       /* NaN if the search failed or was abandoned */
    double cost;       /* the minimised quantity: chi2, or less with a robust
                        * loss */
    char why[256];     /* why the search failed or ended */
    bool converged;
    bool has_ended;
    size_t traces; /* number of times that this search traced light; 0: it used
                    * only the light of start 0 */
    /* Of this search alone: traces by conditions and for slopes of world keys,
     * evaluations of the model, and iterations. */
    size_t lights, evaluations;
    int iterations;
    /* State of a search that waits (calibrate/search.h). */
    bool is_waiting;
    double *before; /* [keys->n]; as in murk_fit_search */
    double lowest;  /* the cost at `before`; INFINITY: none yet */
} murk_calibration_start;

typedef struct murk_calibration {
    size_t n;                 /* number of parameters */
    double *value;            /* [n] */
    double *lower, *upper;    /* [n]; 95 % confidence interval, cut at the
                                 limits of the key; NaN where standard_error
                                 is NaN */
    double *standard_error;   /* [n]; NaN if undetermined or at a bound */
    bool *at_bound;           /* [n] */
    murk_certainty certainty; /* in search coordinates: the logarithm of a key
                               * with is_log, the value of any other */
    double *covariance, *correlation; /* [n * n]; of the values */
    murk_calibrated_row *row;         /* [measured->rows] */
    double chi2;
    long degrees_of_freedom;
    double p_value;    /* probability of at least this chi2; NaN without degrees
                        * of freedom */
    bool is_accepted;  /* false: chi2 rejects the model (verdict.h) */
    char verdict[512]; /* the verdict in a few sentences, the same for every
                        * output */
    size_t held_out;
    double held_out_rms; /* in the unit of the held-out rows; NaN if their kinds
                          * or units differ, or without held-out rows */
    double held_out_rms_sigma; /* in standard errors; NaN without held-out rows
                                */
    bool converged;
    char why[256];
    int iterations;
    size_t evaluations, traces;
    uint64_t photons;
    double effective_share;
    double slope_noise;  /* largest share of the apparent information in any
                          * direction that is photon noise and is subtracted;
                          * close to 1: more photons are needed */
    size_t fitted;       /* number of rows of jacobian, equal to n */
    double *jacobian;    /* [fitted][n]; rows whose J^T J is the information:
                            whitened, in search coordinates, without photon
                            noise */
    double *scale;       /* [n]; size of a large change in search coordinates: 1
                          * (a factor e) if a logarithm is searched; the value
                          * of a factor of readings, if above 0; else the width
                          * of the range of the key or, if the range is not
                          * finite, the larger of the absolute value and 1 */
    double *information; /* [n * n]; Fisher information of the fitted rows */
    murk_calibration_start *start; /* [starts]; of which starts_done were run:
                                    * the requested ones, then restarts */
    size_t starts, starts_done, best;
    double trace_s;
    murk_model *model; /* the last prediction of the model is at the values; the
                        * light was traced at the values or nearby */
    murk_arena arena;  /* of all arrays but those of the certainty */
} murk_calibration;

#endif
