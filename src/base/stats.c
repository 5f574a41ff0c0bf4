/* Estimates with standard errors, and tail probabilities of the normal and the
 * chi-squared distribution. Sources are in base/stats.h and beside the
 * functions. */
#include "base/stats.h"

#include "base/log_gamma.h"

#include <float.h>
#include <math.h>

#define SQRT_2 1.41421356237309504880 /* square root of 2 */

murk_estimate murk_ratio_estimate(const double *x, const double *y, size_t n,
                                  double units)
{
    double sum_x = 0, sum_y = 0;
    for (size_t i = 0; i < n; ++i) {
        sum_x += x[i];
        sum_y += y[i];
    }
    if (!(sum_y > 0)) {
        return (murk_estimate){NAN, NAN};
    }
    const double ratio = sum_x / sum_y;
    double squares = 0;
    for (size_t i = 0; i < n; ++i) {
        const double off = x[i] - ratio * y[i];
        squares += off * off;
    }
    const double error =
        units > 1 ? sqrt(units / (units - 1) * squares) / sum_y : NAN;
    return (murk_estimate){ratio, error};
}

murk_estimate murk_mean_estimate(const double *x, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; ++i) {
        sum += x[i];
    }
    const double mean = n ? sum / (double)n : NAN;
    double squares = 0;
    for (size_t i = 0; i < n; ++i) {
        squares += (x[i] - mean) * (x[i] - mean);
    }
    const double error =
        n > 1 ? sqrt(squares / ((double)n * (double)(n - 1))) : NAN;
    return (murk_estimate){mean, error};
}

double murk_sidak_limit(double budget, double checks)
{
    const double each = -expm1(log1p(-budget) / checks);
    return murk_normal_upper(each / 2);
}

/* Bisection of erfc() to the precision of double, some hundred evaluations; not
 * for hot loops. */
double murk_normal_upper(double p)
{
    double low = -40, high = 40;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        if (0.5 * erfc(middle / SQRT_2) > p) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return (low + high) / 2;
}

/* The largest number of terms of the series and of the continued fraction
 * below. Both converge to rounding within some multiple of sqrt(a) terms, so
 * this number suffices up to a = 1e7, which is twenty million degrees of
 * freedom. */
#define GAMMA_TERMS_MAX 100000

/* The regularised incomplete gamma function Q(a, x) with a = freedom / 2 and
 * x = chi2 / 2: the power series of P = 1 - Q where x < a + 1, else the
 * continued fraction of Q by the modified Lentz method (Press et al., Numerical
 * Recipes, 3rd ed. 2007, section 6.2). */
double murk_chi2_upper(double chi2, double freedom)
{
    const double a = freedom / 2, x = chi2 / 2;
    if (!(a > 0 && isfinite(a) && x >= 0)) {
        return NAN;
    }
    if (x == 0 || isinf(x)) {
        return x == 0 ? 1 : 0;
    }
    const double scale = exp(a * log(x) - x - murk_log_gamma(a));
    if (x < a + 1) {
        /* Power series of P, all terms positive. */
        double term = 1 / a, sum = term;
        for (int i = 1; i < GAMMA_TERMS_MAX && term > DBL_EPSILON * sum; ++i) {
            term *= x / (a + i);
            sum += term;
        }
        return 1 - scale * sum;
    }
    /* Continued fraction of Q. */
    double b = x + 1 - a, c = 1 / DBL_MIN, d = 1 / b, fraction = d;
    for (int i = 1; i < GAMMA_TERMS_MAX; ++i) {
        const double numerator = -i * (i - a);
        b += 2;
        d = 1 / (numerator * d + b);
        c = b + numerator / c;
        fraction *= d * c;
        if (fabs(d * c - 1) <= DBL_EPSILON) {
            break;
        }
    }
    return scale * fraction;
}
