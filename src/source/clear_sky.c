/* Air mass (Kasten and Young 1989) and clear-sky irradiance (Ineichen and Perez
 * 2002); the coefficients in the code are those of the papers
 * (source/clear_sky.h). */
#include "source/clear_sky.h"

#include "base/vector.h"

#define ASTRONOMICAL_M 149597870700.0 /* IAU 2012 */
#define SEA_LEVEL_HPA  1013.25        /* ISO 2533 */
#define LOWEST_ZENITH                                      \
    91.0 /* about the end of the table of Kasten and Young \
          */
#define RAD_PER_DEG (MURK_PI / 180) /* degrees to radians */

double murk_extraterrestrial_w_per_m2(double distance_m)
{
    const double astronomical = distance_m / ASTRONOMICAL_M;
    return MURK_SOLAR_CONSTANT_W_PER_M2 / (astronomical * astronomical);
}

double murk_relative_airmass(double apparent_zenith_deg)
{
    if (!(apparent_zenith_deg <= LOWEST_ZENITH)) {
        return INFINITY;
    }
    return 1 / (cos(RAD_PER_DEG * apparent_zenith_deg) +
                0.50572 * pow(96.07995 - apparent_zenith_deg, -1.6364));
}

double murk_absolute_airmass(double apparent_zenith_deg, double pressure_hpa)
{
    return murk_relative_airmass(apparent_zenith_deg) * pressure_hpa /
           SEA_LEVEL_HPA;
}

murk_clear_sky murk_clear_sky_at(double apparent_zenith_deg,
                                 double absolute_airmass, double linke,
                                 double altitude_m,
                                 double extraterrestrial_w_per_m2)
{
    const double cosine = cos(RAD_PER_DEG * apparent_zenith_deg);
    murk_clear_sky out = {0, 0, 0};
    if (!(apparent_zenith_deg < 90 && isfinite(absolute_airmass))) {
        return out;
    }
    /* fh1 and fh2 of the paper, then global and direct irradiance. */
    const double high = exp(-altitude_m / 8000);
    const double low = exp(-altitude_m / 1250);
    out.global_w_per_m2 = (5.09e-5 * altitude_m + 0.868) *
                          extraterrestrial_w_per_m2 * cosine *
                          exp(-(3.92e-5 * altitude_m + 0.0387) *
                              absolute_airmass * (high + low * (linke - 1)));
    const double beam = extraterrestrial_w_per_m2 * (0.664 + 0.163 / high) *
                        exp(-0.09 * absolute_airmass * (linke - 1));
    /* the least share of the sky in the global irradiance */
    const double min_diffuse = (0.1 - 0.2 * exp(-linke)) / (0.1 + 0.882 / high);
    out.direct_w_per_m2 =
        fmin(beam, out.global_w_per_m2 * (1 - min_diffuse) / cosine);
    out.diffuse_w_per_m2 = out.global_w_per_m2 - out.direct_w_per_m2 * cosine;
    return out;
}
