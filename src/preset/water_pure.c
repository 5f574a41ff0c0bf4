/* Scattering by pure water and sea salt (Zhang, Hu & He 2009). The scattering
 * at 90 degrees is
 *
 *   pi^2/2 wavelength^-4 kT compressibility (rho dn^2/drho)^2 F      density
 *   + 2 pi^2 wavelength^-4 n^2 (dn/dS)^2 S M / (rho N (-dln a/dS)) F     salt
 *
 * with F = (6 + 6 delta) / (6 - 7 delta) for depolarisation delta. Total
 * scattering is 8 pi/3 (2 + delta) / (1 + delta) times the scattering at 90
 * degrees. The sources of the quantities are
 *
 *   n, dn/dS         Quan & Fry, Appl. Opt. 34 (1995) 3477,
 *                    doi:10.1364/AO.34.003477, times the index of air: Ciddor,
 *                    Appl. Opt. 35 (1996) 1566, doi:10.1364/AO.35.001566
 *   rho dn^2/drho    Proutiere, Megnassan & Hucteau, J. Phys. Chem. 96 (1992)
 *                    3485, doi:10.1021/j100187a058
 *   compressibility  Millero et al., Deep-Sea Res. A 27 (1980) 255
 *   rho              UNESCO Tech. Pap. Mar. Sci. 38 (1981)
 *   a                activity of the water: Millero & Leung, Am. J. Sci. 276
 *                    (1976) 1035
 *
 * k is the constant of Boltzmann, T the temperature, S the salinity, M the
 * molar mass of water, rho the density and N the constant of Avogadro. */
#include "preset/water_pure.h"

#include "preset/water_tables.h"

#include <math.h>
#include <stddef.h>

#define PI           3.14159265358979324 /* pi */
#define BOLTZMANN    1.3806503e-23       /* J/K, as Zhang, Hu & He use it */
#define AVOGADRO     6.0221417930e23     /* 1/mol, likewise */
#define WATER_MOLE   18e-3               /* kg/mol */
#define ZERO_CELSIUS 273.15              /* K */

/* Sum of coefficient[i] x^i. */
static double polynomial(const double *coefficient, size_t n, double x)
{
    double sum = 0;
    while (n-- > 0) {
        sum = sum * x + coefficient[n];
    }
    return sum;
}

#define POLYNOMIAL(x, ...)                    \
    polynomial((const double[]){__VA_ARGS__}, \
               sizeof(const double[]){__VA_ARGS__} / sizeof(double), (x))

/* The index of air (Ciddor). */
static double index_of_air(double wavelength_nm)
{
    const double per_um2 = 1e6 / (wavelength_nm * wavelength_nm);
    return 1 + 1e-8 * (5792105 / (238.0185 - per_um2) +
                       167917 / (57.362 - per_um2));
}

/* The index relative to vacuum (Quan & Fry); *per_psu is the derivative with
 * respect to salinity. */
static double index_of_water(double nm, double t, double s, double *per_psu)
{
    const double air = index_of_air(nm);
    const double slope = POLYNOMIAL(t, 1.779e-4, -1.05e-6, 1.6e-8);
    *per_psu = (slope + .01155 / nm) * air;
    return air * (1.31405 + slope * s - 2.02e-6 * t * t +
                  (15.868 + .01155 * s - .00423 * t) / nm - 4382 / (nm * nm) +
                  1.1455e6 / (nm * nm * nm));
}

/* rho d(n^2)/d(rho) (Proutiere et al.). */
static double by_density(double n)
{
    const double n2 = n * n, difference = n / 3 - 1 / (3 * n);
    return (n2 - 1) * (1 + 2. / 3 * (n2 + 2) * difference * difference);
}

/* Isothermal compressibility [1/Pa] (Millero et al.): the inverse of the secant
 * bulk modulus at normal pressure. */
static double compressibility(double t, double s)
{
    const double bar =
        POLYNOMIAL(t, 19652.21, 148.4206, -2.327105, 1.360477e-2,
                   -5.155288e-5) +
        POLYNOMIAL(t, 54.6746, -.603459, 1.09987e-2, -6.167e-5) * s +
        POLYNOMIAL(t, 7.944e-2, 1.6483e-2, -5.3009e-4) * s * sqrt(s);
    return 1e-5 / bar;
}

/* The density of sea water (UNESCO 1981). */
static double density_kg_per_m3(double t, double s)
{
    return POLYNOMIAL(t, 999.842594, 6.793952e-2, -9.09529e-3, 1.001685e-4,
                      -1.120083e-6, 6.536332e-9) +
           POLYNOMIAL(t, .824493, -4.0899e-3, 7.6438e-5, -8.2467e-7,
                      5.3875e-9) *
               s +
           POLYNOMIAL(t, -5.72466e-3, 1.0227e-4, -1.6546e-6) * s * sqrt(s) +
           4.8314e-4 * s * s;
}

/* The derivative of the logarithm of the activity of water with respect to
 * salinity (Millero & Leung); it is negative. */
static double activity_slope(double t, double s)
{
    return POLYNOMIAL(t, -5.58651e-4, 2.40452e-7, -3.12165e-9, 2.40808e-11) +
           1.5 * sqrt(s) *
               POLYNOMIAL(t, 1.79613e-5, -9.9422e-8, 2.08919e-9, -1.39872e-11) +
           2 * s * POLYNOMIAL(t, -2.31065e-6, -1.37674e-9, -1.93316e-11);
}

double murk_water_absorption(double wavelength_nm)
{
    return murk_water_column(&murk_water_pope_fry, wavelength_nm);
}

/* Total scattering from the scattering at right angles. */
static double total(double at_90, double depolarisation)
{
    return 8 * PI / 3 * at_90 * (2 + depolarisation) / (1 + depolarisation);
}

double murk_water_scattering(double wavelength_nm, double temperature_c,
                             double salinity_psu)
{
    const double t = temperature_c, s = salinity_psu;
    double per_psu;
    const double n = index_of_water(wavelength_nm, t, s, &per_psu);
    const double change = by_density(n);
    const double of_density = PI * PI / 2 * BOLTZMANN * (t + ZERO_CELSIUS) *
                              compressibility(t, s) * change * change;
    const double of_salt =
        2 * PI * PI * n * n * per_psu * per_psu * s * WATER_MOLE /
        (density_kg_per_m3(t, s) * AVOGADRO * -activity_slope(t, s));
    const double delta = MURK_WATER_DEPOLARISATION;
    const double at_90 = pow(wavelength_nm * 1e-9, -4) *
                         (of_density + of_salt) * (6 + 6 * delta) /
                         (6 - 7 * delta);
    return total(at_90, delta);
}

double murk_water_scattering_morel(double wavelength_nm, double salinity_psu)
{
    /* The depolarisation of Morel is .09. */
    const double at_90 = 1.38e-4 * pow(wavelength_nm / 500, -4.32) *
                         (1 + .3 * salinity_psu / 37);
    return total(at_90, .09);
}

double murk_water_phase(double mu)
{
    const double delta = MURK_WATER_DEPOLARISATION;
    return 1 + (1 - delta) / (1 + delta) * mu * mu;
}
