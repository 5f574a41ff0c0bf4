/* The moonlight model of Krisciunas and Schaefer 1991 (source/moonlight.h).
 * Diffuse illuminance is a sum over rings around the moon, which resolve the
 * aureole. */
#include "source/moonlight.h"

#include "source/clear_sky.h"
#include "source/night_sky.h"
#include "source/twilight.h"

#include <math.h>

#define PI              3.14159265358979323846 /* pi */
#define LUX_A_FOOT      10.763910417           /* lux per foot-candle */
#define MEAN_DISTANCE_M 384400e3               /* of the moon */

/* The radius [degrees] of the disc of the moon. The diffuse illuminance leaves
 * out the sky within this angle of the center, and scattering by aerosol does
 * not grow within this angle. */
#define DISC_DEG 0.26
/* Within this angle of the moon [degrees], in the aureole, scattering by
 * aerosol follows a power law of the angle; beyond it, an exponential law. */
#define AUREOLE_DEG 10.0

/* The sum over the sky: rings around the moon, with equal steps of the
 * logarithm of the angle inside the aureole and equal steps outside, each with
 * PLACES points. Halving the steps changes the sum by .3 % at most. */
#define INNER_RINGS 12
#define OUTER_RINGS 34
#define PLACES      36

/* Optical depths at 550 nm of a vertical path through the whole atmosphere:
 * molecules (exponential in height) and ozone; scale height of the pressure. */
#define RAYLEIGH_DEPTH 0.0973
#define OZONE_DEPTH    0.0274
#define SCALE_HEIGHT_M 8434.5
#define MAG_A_DEPTH    1.0857362047581296 /* 2.5 / ln 10 */

static double radians(double degrees)
{
    return degrees * PI / 180;
}

double murk_moon_lux(double phase_angle_deg, double distance_m)
{
    const double a = fabs(phase_angle_deg);
    const double magnitude = -12.73 + 0.026 * a + 4e-9 * a * a * a * a;
    const double opposition = a < 7 ? 1.35 - 0.05 * a : 1;
    const double nearness = MEAN_DISTANCE_M / distance_m;
    return LUX_A_FOOT * pow(10, -0.4 * (magnitude + 16.57)) * opposition *
           nearness * nearness;
}

double murk_visual_extinction(double linke_turbidity, double altitude_m)
{
    const double pressure = exp(-altitude_m / SCALE_HEIGHT_M);
    const double inverse = 1 / pressure;
    const double clean =
        2 + inverse * (0.54 + inverse * (-0.5 + inverse * 0.16));
    const double aerosol =
        (linke_turbidity - clean) / (3.91 * exp(0.689 * inverse));
    return MAG_A_DEPTH *
           (RAYLEIGH_DEPTH * pressure + OZONE_DEPTH + fmax(aerosol, 0));
}

/* The scattering function of Krisciunas and Schaefer at an angle from the
 * center of the moon: the sum of a term for molecules and a term for aerosol.
 * Unlike theirs, the term for aerosol is constant within DISC_DEG. Times an
 * illuminance in foot-candles the function gives nanolamberts. */
static double scattered(double separation_deg)
{
    const double c = cos(radians(separation_deg));
    const double rho = fmax(separation_deg, DISC_DEG);
    const double aerosol =
        rho < AUREOLE_DEG ? 6.2e7 / (rho * rho) : pow(10, 6.15 - rho / 40);
    return pow(10, 5.36) * (1.06 + c * c) + aerosol;
}

/* The factor that does not depend on the direction of the line of sight:
 * nanolamberts to cd/m2, the light that arrives at the scattering air, and
 * twilight by the moon. */
static double strength(const murk_moon *moon, double extinction_mag)
{
    const double up = fmax(moon->elevation_deg, 0);
    const double dusk =
        murk_twilight_lux(fmin(moon->elevation_deg, 0)) / murk_twilight_lux(0);
    const double foot_candles =
        murk_moon_lux(moon->phase_angle_deg, moon->distance_m) / LUX_A_FOOT;
    return 1e-5 / PI * foot_candles * dusk *
           pow(10, -0.4 * extinction_mag * murk_sky_path(90 - up));
}

static double scattered_share(double zenith_deg, double extinction_mag)
{
    return 1 - pow(10, -0.4 * extinction_mag * murk_sky_path(zenith_deg));
}

double murk_moonlit_sky(const murk_moon *moon, double zenith_deg,
                        double separation_deg, double extinction_mag)
{
    return strength(moon, extinction_mag) * scattered(separation_deg) *
           scattered_share(zenith_deg, extinction_mag);
}

/* The sum of luminance times the cosine of the zenith distance over a ring
 * around the moon, per radian of width and per unit of strength(). */
static double ring(double rho_deg, double up_deg, double extinction_mag)
{
    const double s = sin(radians(rho_deg));
    const double c = cos(radians(rho_deg));
    double sum = 0;
    for (int i = 0; i < PLACES; ++i) {
        const double around = 2 * PI * (i + 0.5) / PLACES;
        const double mu =
            c * sin(radians(up_deg)) + s * cos(radians(up_deg)) * cos(around);
        if (mu > 0) {
            const double zenith = acos(fmin(mu, 1)) * 180 / PI;
            sum += mu * scattered_share(zenith, extinction_mag);
        }
    }
    return sum * s * scattered(rho_deg) * 2 * PI / PLACES;
}

static double diffuse(const murk_moon *moon, double extinction_mag)
{
    const double up = fmax(moon->elevation_deg, 0);
    const double growth = log(AUREOLE_DEG / DISC_DEG) / INNER_RINGS;
    double sum = 0;
    for (int i = 0; i < INNER_RINGS; ++i) {
        const double rho = DISC_DEG * exp((i + 0.5) * growth);
        sum += ring(rho, up, extinction_mag) * radians(rho) * growth;
    }
    const double step = (180 - AUREOLE_DEG) / OUTER_RINGS;
    for (int i = 0; i < OUTER_RINGS; ++i) {
        const double rho = AUREOLE_DEG + (i + 0.5) * step;
        sum += ring(rho, up, extinction_mag) * radians(step);
    }
    return sum * strength(moon, extinction_mag);
}

murk_moonlight murk_moonlight_at(const murk_moon *moon, double extinction_mag)
{
    murk_moonlight out = {0, 0};
    if (moon->elevation_deg > 0) {
        out.direct_lux =
            murk_moon_lux(moon->phase_angle_deg, moon->distance_m) *
            pow(10, -0.4 * extinction_mag *
                        murk_relative_airmass(90 - moon->elevation_deg));
    }
    if (moon->elevation_deg > MURK_TWILIGHT_END_DEG) {
        out.diffuse_lux = diffuse(moon, extinction_mag);
    }
    return out;
}
