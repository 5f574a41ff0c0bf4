/* Brightness and distribution of the night sky after Krisciunas and Schaefer
 * 1991 (source/night_sky.h). */
#include "source/night_sky.h"

#include <math.h>

#define PI 3.14159265358979323846 /* pi */

/* Krisciunas and Schaefer, eq. 1: B = 34.08 exp(20.7233 - .92104 V) in
 * nanolamberts, each 1e-5 / pi cd/m2. */
#define MAGNITUDE_ZERO (34.08 * 1e-5 / PI)
#define SCALE_LOG      20.7233
#define SCALE_SLOPE    0.92104

/* The number of midpoints of the sum over the zenith distance: the pattern is
 * smooth, and the error of the sum is 1e-4. */
#define STEPS 90

double murk_sky_luminance(double mag_per_arcsec2)
{
    return MAGNITUDE_ZERO * exp(SCALE_LOG - SCALE_SLOPE * mag_per_arcsec2);
}

double murk_sky_magnitude(double cd_per_m2)
{
    return (SCALE_LOG - log(cd_per_m2 / MAGNITUDE_ZERO)) / SCALE_SLOPE;
}

double murk_sky_path(double zenith_deg)
{
    const double s = sin(zenith_deg * PI / 180);
    return 1 / sqrt(1 - 0.96 * s * s);
}

double murk_night_sky_pattern(double zenith_deg, double extinction_mag)
{
    const double path = murk_sky_path(zenith_deg);
    return path * pow(10, -0.4 * extinction_mag * (path - 1));
}

double murk_night_sky_lux(double mag_per_arcsec2, double extinction_mag)
{
    const double step = 90.0 / STEPS;
    double sum = 0;
    for (int i = 0; i < STEPS; ++i) {
        const double z = (i + 0.5) * step;
        sum += murk_night_sky_pattern(z, extinction_mag) *
               sin(2 * z * PI / 180); /* sin(2 z) = 2 sin z cos z: solid angle
                                       * and tilt */
    }
    return murk_sky_luminance(mag_per_arcsec2) * PI * sum * step * PI / 180;
}
