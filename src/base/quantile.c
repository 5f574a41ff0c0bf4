/* Student t quantiles by bisection of the distribution function, and
 * distribution-free confidence limits of sample quantiles by summing binomial
 * probabilities. Sources are in base/quantile.h. */
#include "base/quantile.h"

#include "base/log_gamma.h"
#include "base/sort.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#define HALF_PI 1.5707963267948966 /* pi / 2 */

void murk_sort(double *x, size_t n)
{
    qsort(x, n, sizeof *x, murk_by_double);
}

/* P(|T| <= t). With tan(angle) = t / sqrt(degrees), the probability is
 * sin(angle) times a sum of even powers of cos(angle), or, for odd degrees, of
 * odd powers, with the angle added and the result divided by pi / 2. Each term
 * follows from the previous one by a factor cos^2 and a ratio of whole numbers.
 */
static double within(double t, size_t degrees)
{
    const double angle = atan(t / sqrt((double)degrees));
    const double cos2 = cos(angle) * cos(angle);
    const size_t odd = degrees % 2;
    double term = odd ? cos(angle) : 1, sum = 0;
    for (size_t k = 2 + odd; k <= degrees; k += 2) {
        sum += term;
        term *= cos2 * ((double)k - 1) / (double)k;
    }
    return odd ? (angle + sin(angle) * sum) / HALF_PI : sin(angle) * sum;
}

/* Bisection to the precision of double; not for hot loops. */
double murk_student_upper(double p, size_t degrees)
{
    assert(p > 0 && p < 1 && degrees >= 1);
    if (p > 0.5) {
        return -murk_student_upper(1 - p, degrees);
    }
    double low = 0, high = 1;
    while (1 - within(high, degrees) > 2 * p && high < 1e300) {
        high *= 2;
    }
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        if (1 - within(middle, degrees) > 2 * p) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return (low + high) / 2;
}

/* P(K = k) of a binomial variable K with n trials of probability q. */
static double chance(size_t n, double q, size_t k)
{
    const double all = (double)n, in = (double)k;
    return exp(murk_log_gamma(all + 1) - murk_log_gamma(in + 1) -
               murk_log_gamma(all - in + 1) + in * log(q) +
               (all - in) * log1p(-q));
}

murk_order_statistics murk_quantile_ranks(size_t n, double q, double miss)
{
    assert(n >= 1 && q > 0 && q < 1 && miss > 0);
    /* The factor just below 1 prevents that rounding of a whole q n upwards
     * raises the rank. */
    const double middle = ceil(q * (double)n * (1 - 0x1p-51));
    murk_order_statistics ranks = {.value = middle < 1 ? 1 : (size_t)middle};
    /* The number at rank r lies above the quantile if fewer than r numbers lie
     * below the quantile, and below it if at least r do. */
    double below = 0; /* P(K < k) */
    for (size_t k = 0; k <= n; ++k) {
        if (below <= miss) {
            ranks.lower = k; /* P(K < k): the number at rank k is above */
        }
        if (1 - below <= miss) {
            ranks.upper = k; /* P(K >= k): the number at rank k is below */
            break;
        }
        below += chance(n, q, k);
    }
    return ranks;
}
