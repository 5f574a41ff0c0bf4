/* In units of the width a slope x has the density exp(-x^2) / sqrt(pi). A ray
 * of cosine c and t = width sin sees of facets that fall by x in its direction
 * the area c - t x, up to x = c / t. Its integral from -infinity to x is
 * c erfc(-x) / 2 + t exp(-x^2) / (2 sqrt(pi)), whose slope is the density
 * itself, so that Halley's steps need nothing more. */
#include "medium/waves.h"

#include <assert.h>
#include <math.h>

#define ROOT_PI 1.77245385090551602730

/* Beyond it there is less than 1e-27 of all facets. */
#define SLOPES_MAX 8

/* A step as small as this leaves an error of the order of its cube. */
#define LAST_STEP 1e-4
#define STEPS_MAX 100

double murk_wind_mean_square_slope(double wind_m_per_s)
{
    return 0.003 + 0.00512 * wind_m_per_s;
}

static double sine_of(double cosine)
{
    return sqrt(fmax(0, (1 - cosine) * (1 + cosine)));
}

static double seen_up_to(double c, double t, double x)
{
    return c * erfc(-x) / 2 + t * exp(-x * x) / (2 * ROOT_PI);
}

double murk_facets_seen(double width, double cosine)
{
    assert(width > 0 && cosine >= -1 && cosine <= 1);
    const double t = width * sine_of(cosine);
    const double last = t > 0 ? cosine / t : copysign(INFINITY, cosine);
    /* Rounding may leave less than nothing where hardly any is seen. */
    return fmax(0, seen_up_to(cosine, t, last));
}

/* Near the place: of a ray that is not steep the law is nearly exp(-x^2) below
 * 0 and little above, of a steep one nearly the normal law, for which the
 * logistic does. */
static double first_guess(double c, double t, double u)
{
    return c > t ? 0.42 * log(u / (1 - u)) : fmin(c / t, 0) - sqrt(-log(u));
}

/* Where the share u of all that is seen lies below: Halley's steps, halving the
 * bracket where they would leave it. */
static double slope_below(double c, double t, double u)
{
    const double last = t * SLOPES_MAX > c ? c / t : SLOPES_MAX;
    const double wanted = u * seen_up_to(c, t, last);
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

murk_slope murk_facet_met(double width, double cosine, const double u[3])
{
    assert(width > 0 && cosine >= -1 && cosine <= 1);
    const double t = width * sine_of(cosine);
    return (murk_slope){.along = -width * slope_below(cosine, t, u[0]),
                        .across = width * sqrt(-log(u[1])) *
                                  cos(2 * 3.14159265358979323846 * u[2])};
}
