/* Means, standard errors and limits for checks on random results. */
#ifndef MURK_BASE_STATS_H
#define MURK_BASE_STATS_H

#include <stddef.h>

/* A value with the standard deviation of its estimate. */
typedef struct murk_estimate {
    double value, standard_error;
} murk_estimate;

/* The ratio sum X / sum Y with a standard error by independent units (emitted
 * photons). x[n] and y[n] hold the sums of one unit each; units with x = y = 0
 * may be left out if `units` counts them. se^2 = N/(N-1) sum (x - C y)^2 / (sum
 * y)^2, the ratio estimator (Cochran, Sampling Techniques, 1977, ch. 6). Both
 * are NaN if sum y is not above 0; the standard error is NaN if units <= 1. */
murk_estimate murk_ratio_estimate(const double *x, const double *y, size_t n,
                                  double units);

/* The mean of n numbers (NaN for n = 0) with the standard error of the mean
 * (NaN for n < 2). */
murk_estimate murk_mean_estimate(const double *x, size_t n);

/* The two-sided limit, in standard deviations, at which `checks` independent
 * z-tests together raise a false alarm with probability `budget` (Sidak, J. Am.
 * Stat. Assoc. 62 (1967) 626, doi:10.2307/2283989). */
double murk_sidak_limit(double budget, double checks);

/* The upper quantile z of the standard normal distribution: P(Z > z) = p, 0 < p
 * < 1. */
double murk_normal_upper(double p);

/* P(X > chi2) of a chi-squared variable X with `freedom` > 0 degrees of
 * freedom, chi2 >= 0; NaN for other arguments. The relative error is below 1e-9
 * up to 10,000 degrees of freedom. */
double murk_chi2_upper(double chi2, double freedom);

#endif
