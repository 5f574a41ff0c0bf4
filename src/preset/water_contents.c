/* Absorption, scattering and phase function of the constituents of natural
 * water, by power laws and exponentials of the literature;
 * preset/water_contents.h states the formulas with the sources. */
#include "preset/water_contents.h"

#include "preset/water_pure.h"
#include "preset/water_tables.h"

#include <math.h>

double murk_chlorophyll_absorption(double wavelength_nm,
                                   double chlorophyll_mg_per_m3)
{
    return murk_water_column(&murk_water_bricaud_factor, wavelength_nm) *
           pow(chlorophyll_mg_per_m3,
               murk_water_column(&murk_water_bricaud_exponent, wavelength_nm));
}

double murk_chlorophyll_scattering(double wavelength_nm,
                                   double chlorophyll_mg_per_m3)
{
    const double c = chlorophyll_mg_per_m3;
    if (!(c > 0)) {
        return 0;
    }
    const double power = c < 2 ? .5 * (log10(c) - .3) : 0;
    return .416 * pow(c, .766) * pow(wavelength_nm / 550, power);
}

double murk_chlorophyll_backward(double chlorophyll_mg_per_m3)
{
    const double c = fmin(fmax(chlorophyll_mg_per_m3, .02), 20);
    return .002 + .01 * (.5 - .25 * log10(c));
}

double murk_cdom_absorption(double wavelength_nm, double at_440_per_m,
                            double slope_per_nm)
{
    return at_440_per_m * exp(-slope_per_nm * (wavelength_nm - 440));
}

double murk_cdom_of_chlorophyll(double chlorophyll_mg_per_m3)
{
    return .2 * (murk_water_absorption(440) +
                 murk_chlorophyll_absorption(440, chlorophyll_mg_per_m3));
}

double murk_sediment_absorption(double wavelength_nm, double sediment_g_per_m3)
{
    return .041 * sediment_g_per_m3 * exp(-.0123 * (wavelength_nm - 443));
}

double murk_sediment_scattering(double wavelength_nm, double sediment_g_per_m3)
{
    return .5 * sediment_g_per_m3 * sqrt(555 / wavelength_nm);
}

static double index_of(double slope)
{
    return 1.01 + .1542 * (slope - 3);
}

/* The share of Fournier-Forand scattering beyond 90 degrees: Fournier & Jonasz,
 * Proc. SPIE 3761 (1999) 62, doi:10.1117/12.366488. */
static double backward_of(double slope)
{
    const double n = index_of(slope), v = (3 - slope) / 2;
    const double delta = 2 / (3 * (n - 1) * (n - 1)), power = pow(delta, v);
    return 1 - (1 - power * delta - .5 * (1 - power)) / ((1 - delta) * power);
}

void murk_forand_of_backward(double backward, double *n, double *slope)
{
    const double wanted = fmin(fmax(backward, .002), .1);
    double low = 3.01, high = 4.5; /* bisection: the share increases with the
                                    * slope */
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        *(backward_of(middle) < wanted ? &low : &high) = middle;
    }
    *slope = (low + high) / 2;
    *n = index_of(*slope);
}
