/* The effect of photon noise in slopes on a fit, and the correction for it.
 * For use inside src/calibrate only.
 *
 * Values f and slopes J of re-weighted rows come from the same photons, so
 * their errors are correlated. With y the measured values, L the Cholesky
 * factor of the covariance of the rows and weights W = L^-T L^-1, the equation
 * of least squares, J^T W (y - f) = 0, has the bias tr(W cov(f, J)), and J^T W
 * J exceeds the information by N = tr(W cov(J, J)). Without correction,
 * parameters are drawn to where paths have less noise, and their errors are too
 * small (errors in variables: Fuller, Measurement Error Models, 1987,
 * doi:10.1002/9780470316665). The weights come from the same photons, too: rows
 * with few photons have too small an error and weigh too much, which has the
 * opposite effect J^T W <p (p^T W p)>, with p the noise of f and < > the mean.
 * If photons are most of the noise, both nearly cancel. All of these terms are
 * estimated from runs of photons.
 *
 * The correction: with R = -J the slopes of the residuals r = y - f, the mean
 * of R^T W r at the true parameters is b, the difference of both effects. So
 * residuals are offset by d with R^T W d = -b, and the search, which ends where
 * R^T W (r + d) = 0, ends where R^T W r = b. The information is A = J^T W J -
 * N, and the covariance is A^-1 (A + (1 + phi) N) A^-1; phi, the share of
 * photons in all noise of the rows, bounds the effect of the correlation of
 * values and slopes. */
#ifndef MURK_CALIBRATE_SLOPE_NOISE_H
#define MURK_CALIBRATE_SLOPE_NOISE_H

#include "calibrate/search_state.h"

typedef struct murk_slope_noise {
    double *bias;     /* [n]; in search coordinates */
    double *noise;    /* [n * n]; in search coordinates */
    double share;     /* phi, 0..1 */
    murk_arena arena; /* of both arrays */
} murk_slope_noise;

/* Adds one run of photons. off[n_light][1 + n] is the deviation of values and
 * slopes of the run from an equal share of the total, whitened;
 * jacobian[n_light][n] is that of the residuals. The caller multiplies the sums
 * by runs / (runs - 1), and divides share by n_light. */
void murk_slope_noise_add(murk_slope_noise *out, const double *off,
                          const double *jacobian, size_t n_light, size_t n);

/* Estimates bias and noise at the last prediction, which must have been with
 * slopes. Release also after a failure. */
murk_status murk_slope_noise_find(murk_slope_noise *out,
                                  const murk_fit_search *search,
                                  murk_error *err);
void murk_slope_noise_release(murk_slope_noise *noise);

/* Computes the offset d[n_fitted] of the whitened residuals, with R^T d = -b as
 * far as R has that direction. jacobian[rows][n] is R, whitened; rows is the
 * number of fitted rows. */
murk_status murk_slope_noise_offset(double *offset,
                                    const murk_slope_noise *noise,
                                    const double *jacobian, size_t rows,
                                    size_t n, murk_error *err);

/* Computes step[n] = A^-1 (b - jacobian^T residual), with the jacobian of the
 * residuals, and the length of the step in standard errors of A. No step is
 * taken along a direction if noise contributes more than half of the apparent
 * information. */
murk_status murk_slope_noise_step(double *step, double *length,
                                  const murk_slope_noise *noise,
                                  const double *residual,
                                  const double *jacobian, size_t rows, size_t n,
                                  murk_error *err);

/* Computes rows [n][n] that carry the remaining information: the inverse of
 * their J^T J is the covariance above. *max is the largest share of the
 * apparent information in any direction that is photon noise; 1 and more: that
 * direction carries no information. */
murk_status murk_slope_noise_information(double *rows_out, double *max,
                                         const murk_slope_noise *noise,
                                         const double *jacobian, size_t rows,
                                         size_t n, murk_error *err);

#endif
