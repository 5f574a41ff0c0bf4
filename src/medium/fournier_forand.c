/* The Fournier-Forand phase function (medium/fournier_forand.h), evaluated
 * by a series where the closed form loses digits. */
#include "medium/fournier_forand.h"

#include <math.h>

/* The ratio of circumference and diameter of a circle. */
#define PI 3.14159265358979324

/* The numerators of brackets() vanish as (1 - d)^2 at d = 1. If d is closer to
 * 1 than NEAR, the binomial series with TERMS terms is used: the first omitted
 * term is below 1e-14 there, while the closed form has a relative error of eps
 * / NEAR^2 = 2e-11 at |1 - d| = NEAR (eps: rounding of double precision). */
#define NEAR  3e-3
#define TERMS 6

/* The two brackets of the formula, with d and v as in murk_fournier_forand():
 * (v (1 - d) - (1 - d^v)) / (1 - d)^2 and (d (1 - d^v) - v (1 - d)) / (1 -
 * d)^2. With x = 1 - d, 1 - d^v = v x - c2 x^2 + c3 x^3 - ..., where c2, c3,
 * ... are the binomial coefficients of v. */
static void brackets(double v, double d, double *first, double *second)
{
    const double x = 1 - d, rest = 1 - pow(d, v);
    if (fabs(x) >= NEAR) {
        *first = (v * x - rest) / (x * x);
        *second = (d * rest - v * x) / (x * x);
        return;
    }
    double c = v,
           power = 1; /* the previous coefficient, and x^(k-2) with sign */
    *first = *second = 0;
    for (int k = 2; k < 2 + TERMS; ++k) {
        const double next = c * (v - k + 1) / k;
        *first += next * power;
        *second -= (next + c) * power;
        c = next;
        power *= -x;
    }
}

double murk_fournier_forand(double n, double slope, double s)
{
    const double v = .5 * (3 - slope), mu = 1 - s;
    const double scale = 2 / (3 * (n - 1) * (n - 1));
    const double d = scale * s, d_back = scale * 2;
    double first, second, back_first, back_second;
    brackets(v, d, &first, &second);
    brackets(v, d_back, &back_first, &back_second);
    /* (1 - d^v) / (d - 1) for d = d_back, computed from the first bracket,
     * which is finite at d = 1 */
    const double back = back_first * (1 - d_back) - v;
    return (first + second * 2 / s) / (4 * PI * pow(d, v)) +
           back * (3 * mu * mu - 1) / (16 * PI * pow(d_back, v));
}
