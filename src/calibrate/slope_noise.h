/* What photons' noise does to a fit by its slopes, and how it is undone.
 *
 * Values f and slopes J of re-weighted rows come from the same photons, so
 * their noises go together. With weights W = L^-T L^-1 the equation that least
 * squares solve, J^T W (y - f) = 0, is off by tr(W cov(f, J)), and J^T W J is
 * too large by N = tr(W cov(J, J)): parameters would be drawn towards where
 * paths carry less noise, and look surer than they are (errors in variables:
 * Fuller, Measurement Error Models, 1987, doi:10.1002/9780470316665). Weights
 * come from these photons, too: rows with too few of them are too low and
 * weigh too much, which draws the other way by J^T W <p (p^T W p)>, p being the
 * noise of f; where photons are most of the noise, both nearly cancel. All are
 * known from the photons themselves, run by run. So rows are offset by d with
 * J^T W d = b, the difference, and what is said to be known is A = J^T W J - N,
 * with the covariance A^-1 (A + (1 + phi) N) A^-1, where phi, the photons'
 * share of all noise, bounds what their joint noise adds. Inside this room
 * only. */
#ifndef MURK_CALIBRATE_SLOPE_NOISE_H
#define MURK_CALIBRATE_SLOPE_NOISE_H

#include "calibrate/search.h"

typedef struct murk_slope_noise {
    double *bias;  /* [n] by search coordinates */
    double *noise; /* [n * n] likewise */
    double share;  /* phi, 0..1 */
} murk_slope_noise;

/* Adds one run of photons: off[n_lit][1 + n], how far its values and slopes are
 * from its share of the whole, whitened; jacobian[n_lit][n] of residuals. The
 * sums still want the factor runs / (runs - 1), and share a division by n_lit.
 */
void murk_slope_noise_add(murk_slope_noise *out, const double *off,
                          const double *jacobian, size_t n_lit, size_t n);

/* Of the last prediction with slopes. Release also after a failure. */
murk_status murk_slope_noise_find(murk_slope_noise *out,
                                  const murk_fit_search *search,
                                  murk_error *err);
void murk_slope_noise_release(murk_slope_noise *noise);

/* d[n_fitted], whitened: J^T d = b as far as J can. jacobian[n_fitted][n] is
 * whitened. */
murk_status murk_slope_noise_offset(double *offset,
                                    const murk_slope_noise *noise,
                                    const double *jacobian, size_t rows,
                                    size_t n, murk_error *err);

/* step[n] = A^-1 (J^T residual + b), and how long that is in standard errors of
 * A. Directions of which more than half of what they tell is noise stay. */
murk_status murk_slope_noise_step(double *step, double *length,
                                  const murk_slope_noise *noise,
                                  const double *residual,
                                  const double *jacobian, size_t rows, size_t n,
                                  murk_error *err);

/* Rows [n][n] that carry the information there is: their J^T J is the inverse
 * of the covariance above. *most is the largest part of what any direction
 * seems to tell that is photons' noise; 1 and more: nothing is told. */
murk_status murk_slope_noise_information(double *rows_out, double *max,
                                         const murk_slope_noise *noise,
                                         const double *jacobian, size_t rows,
                                         size_t n, murk_error *err);

#endif
