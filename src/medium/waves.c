/* Slopes of facets on water waves (medium/waves.h).
 *
 * In units of the width, a slope x has the density exp(-x^2) / sqrt(pi). For
 * a ray with cosine c and t = width * sine, a facet that falls by x along
 * the ray has the projected area c - t x, up to x = c / t. The integral of
 * density times area from -infinity to x is c erfc(-x) / 2 + t exp(-x^2) /
 * (2 sqrt(pi)). The derivative of the integrand is elementary, so Halley's
 * method inverts the integral without further function calls. */
#include "medium/waves.h"

#include <assert.h>
#include <math.h>

/* The square root of pi. */
#define ROOT_PI 1.77245385090551602730

/* Largest slope in units of the width: beyond it are fewer than 1e-27 of all
 * facets. */
#define SLOPES_MAX 8

/* After a step of Halley's method this small the error is of the order of the
 * cube of the step, 1e-12. */
#define LAST_STEP 1e-4
#define STEPS_MAX 100 /* that many bisections use up the digits of a double */

double murk_wind_mean_square_slope(double wind_m_per_s)
{
    return 0.003 + 0.00512 * wind_m_per_s;
}

static double sine_of(double cosine)
{
    return sqrt(fmax(0, (1 - cosine) * (1 + cosine)));
}

static double projected_up_to(double c, double t, double x)
{
    return c * erfc(-x) / 2 + t * exp(-x * x) / (2 * ROOT_PI);
}

double murk_facets_projected_area(double width, double cosine)
{
    assert(width > 0 && cosine >= -1 && cosine <= 1);
    const double t = width * sine_of(cosine);
    const double last = t > 0 ? cosine / t : copysign(INFINITY, cosine);
    /* Rounding may make the result negative if hardly any facet faces the
     * ray. */
    return fmax(0, projected_up_to(cosine, t, last));
}

/* First estimate of the slope x. For a ray far from grazing (c > t) x is almost
 * normally distributed, which a logistic distribution approximates. For a
 * grazing ray the share of the projected area below x is nearly exp(-x^2) for
 * x < 0, and slopes above 0 are rare. */
static double first_guess(double c, double t, double u)
{
    return c > t ? 0.42 * log(u / (1 - u)) : fmin(c / t, 0) - sqrt(-log(u));
}

/* The slope below which the share u of the projected area lies: Halley's
 * method, with a bisection if a step leaves the bracket. */
static double slope_below(double c, double t, double u)
{
    const double last = t * SLOPES_MAX > c ? c / t : SLOPES_MAX;
    const double wanted = u * projected_up_to(c, t, last);
    double low = fmin(-SLOPES_MAX, last - 1), high = last;
    const double guess = first_guess(c, t, u);
    double x = guess < last ? fmax(low, guess) : last / 2;
    for (int i = 0; i < STEPS_MAX; ++i) {
        const double e = exp(-x * x) / ROOT_PI, area = c - t * x;
        const double over = c * erfc(-x) / 2 + t * e / 2 - wanted;
        *(over > 0 ? &high : &low) = x;
        const double newton = over / (area * e);
        const double step = newton / (1 + newton * (t / (2 * area) + x));
        const double next = x - step;
        if (fabs(step) < LAST_STEP && next > low && next < high) {
            return next;
        }
        x = next > low && next < high ? next : (low + high) / 2;
    }
    return x;
}

murk_slope murk_facet_sample(double width, double cosine, const double u[3])
{
    assert(width > 0 && cosine >= -1 && cosine <= 1);
    const double t = width * sine_of(cosine);
    return (murk_slope){.along = -width * slope_below(cosine, t, u[0]),
                        .across = width * sqrt(-log(u[1])) *
                                  cos(2 * 3.14159265358979323846 * u[2])};
}
