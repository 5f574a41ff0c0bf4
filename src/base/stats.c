#include "base/stats.h"

#include <math.h>

#define SQRT_2 1.41421356237309504880

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

/* Bisection on erfc: some sixty evaluations, never in a hot loop. */
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
