/* Moments, range checks and integration limits of the modified gamma
 * distribution of droplet radii. Moments are ratios of gamma functions; the
 * share of uncounted droplets is an incomplete gamma function. */
#include "preset/droplet_sizes.h"

#include <assert.h>
#include <math.h>

#include "base/log_gamma.h"
#include "preset/mie.h"

#define PI 3.141592653589793 /* to the digits of double */

/* The share of an integral that is cut off at each end. */
#define LEFT_OUT 1e-7

/* The share of the gamma distribution of a given order below t: the series
 * t^order e^-t / Gamma(order + 1) (1 + t / (order + 1) + ...), with positive
 * terms only. For large t the share is 1 to rounding, and no terms are
 * summed. */
static double share_below(double order, double t)
{
    if (!(t < order + 40 + 12 * sqrt(order))) {
        return 1;
    }
    double term = 1, sum = 1;
    for (int i = 1; i < 10000 && term > 1e-17 * sum; ++i) {
        term *= t / (order + i);
        sum += term;
    }
    return fmin(1, sum * exp(order * log(t) - t - murk_log_gamma(order + 1)));
}

/* The share of all droplets that are counted. */
static double counted(const murk_droplets *shape)
{
    const double t = shape->b * pow(MURK_COUNTED_FROM_UM, shape->c);
    return 1 - share_below((shape->a + 1) / shape->c, t);
}

/* The mean of r^power over all droplets, counted or not. */
static double moment(const murk_droplets *shape, double power)
{
    const double c = shape->c;
    return exp(murk_log_gamma((shape->a + 1 + power) / c) -
               murk_log_gamma((shape->a + 1) / c) - power / c * log(shape->b));
}

double murk_droplets_effective_radius_um(const murk_droplets *shape)
{
    return moment(shape, 3) / moment(shape, 2);
}

double murk_droplets_effective_variance(const murk_droplets *shape)
{
    const double third = moment(shape, 3);
    return moment(shape, 4) * moment(shape, 2) / (third * third) - 1;
}

double murk_droplets_water_g_per_m3(const murk_droplets *shape)
{
    /* 1 um3 in 1 cm3 is a share of 1e-12; 1 m3 of water has 1e6 g */
    return 4 * PI / 3 * moment(shape, 3) / counted(shape) * 1e-12 * 1e6;
}

murk_status murk_droplets_check(const murk_droplets *shape, const char *where,
                                murk_error *err)
{
    /* Check the exponents and the factor. */
    if (!(shape->a >= 0 && shape->a <= 40)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "the power of r is %g, must be 0..40", shape->a);
    }
    if (!(shape->c >= .1 && shape->c <= 6)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "the power of r in the exponential is %g, must be "
                         "0.1..6",
                         shape->c);
    }
    if (!(shape->b > 0 && isfinite(shape->b))) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "the factor in the exponential is %g, must be more "
                         "than 0 [um^-%g]",
                         shape->b, shape->c);
    }
    /* Check the moments, then the share of counted droplets. */
    const double radius = murk_droplets_effective_radius_um(shape);
    if (!(radius >= .05 && radius <= 50)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "the droplet sizes make an effective radius of %g, "
                         "must be 0.05..50 um",
                         radius);
    }
    const double variance = murk_droplets_effective_variance(shape);
    if (!(variance >= .003 && variance <= 10)) {
        return murk_fail(
            err, MURK_BAD_VALUE, where,
            "the droplet sizes make an effective variance of %g, must be "
            "0.003..10",
            variance);
    }
    if (!(counted(shape) >= .01)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "the droplet sizes leave %.2g of the droplets above a "
                         "radius of %g um, "
                         "from which they are counted; must be 0.01 or more",
                         counted(shape), MURK_COUNTED_FROM_UM);
    }
    return MURK_OK;
}

double murk_droplet_area(const murk_droplet_population *population, double x)
{
    const double log_r = log(x * population->radius_um);
    return exp(population->log_norm + (population->shape.a + 3) * log_r -
               population->shape.b * exp(population->shape.c * log_r));
}

murk_droplet_population murk_droplet_population_of(const murk_droplets *shape,
                                                   double wavelength_nm)
{
    const double order = (shape->a + 1) / shape->c;
    return (murk_droplet_population){
        .shape = *shape,
        .radius_um = wavelength_nm / 1000 / (2 * PI),
        .log_norm = log(shape->c) + order * log(shape->b) -
                    murk_log_gamma(order) - log(counted(shape))};
}

/* The weights with which the ends are judged approximate the efficiencies of a
 * sphere, without interference fringes. Small spheres absorb as x and scatter
 * as x^4, so the lower end is judged by absorption. The intensity that large
 * spheres scatter forward grows as x^2, and the upper end is judged by that. */
static double weight_small(double x)
{
    return x / (1 + x);
}

static double weight_large(double x)
{
    return x * x * x * x / (1 + x * x);
}

/* The sums use equal steps of ln x. This is sufficient because the integrand
 * has one peak, which is wider than 1/40 for every shape that passes the
 * check. */
void murk_droplet_ends(const murk_droplet_population *population, double *min,
                       double *max)
{
    const double step = 1. / 64;
    const int from = -64 * 14, to = 64 * 10; /* x from 8e-7 to 2.2e4 */
    double small = 0, large = 0;
    for (int i = from; i <= to; ++i) {
        const double x = exp(i * step), area = murk_droplet_area(population, x);
        small += area * weight_small(x);
        large += area * weight_large(x);
    }
    /* Move each end inwards until the cut share exceeds LEFT_OUT. */
    int low = from, high = to;
    double sum = 0;
    for (; low < to; ++low) {
        const double x = exp(low * step);
        sum += murk_droplet_area(population, x) * weight_small(x);
        if (!(sum < LEFT_OUT * small)) {
            break;
        }
    }
    sum = 0;
    for (; high > low + 1; --high) {
        const double x = exp(high * step);
        sum += murk_droplet_area(population, x) * weight_large(x);
        if (!(sum < LEFT_OUT * large)) {
            break;
        }
    }
    *min = fmax(exp(low * step), MURK_MIE_SIZE_MIN);
    *max = fmin(exp(high * step), MURK_MIE_SIZE_MAX);
}
