/* Extinction and absorption of rain by rain rate R [mm/h].
 *
 * rain_power: attenuation of k R^power dB/km, as used in radio engineering.
 *
 * marshall_palmer: N(D) = 8000 exp(-slope D) drops per m3 and mm of diameter,
 * slope = 4.1 R^-.21 per mm. Drops are much larger than the wavelength, so the
 * extinction cross section of each drop is twice the geometrical one, half of
 * it by refracted and reflected rays and half by diffraction: extinction = pi
 * 8000 / slope^3 mm2/m3. At rate 0 the extinction is 0.
 *
 * Each law returns one half of the extinction: diffraction (parameter rays: 0),
 * or the rays (rays: 1), of which the drops absorb a share that is computed for
 * the sizes of Marshall and Palmer at that rate.
 *
 * Sources: Marshall & Palmer, J. Meteorol. 5 (1948) 165,
 * doi:10.1175/1520-0469(1948)005<0165:TDORWS>2.0.CO;2; van de Hulst, Light
 * Scattering by Small Particles, Wiley (1957), ch. 8. */
#include "preset/rain.h"

#include "preset/laws.h"
#include "preset/refraction.h"

#include <math.h>
#include <stdbool.h>

#define PI         3.14159265358979323846 /* pi */
#define DROPS      8000.0                 /* per m3 and mm */
#define SLOPE      4.1                    /* per mm, at 1 mm/h */
#define SLOPE_FALL .21                    /* exponent of the rate */
#define M2_PER_MM2 1e-6                   /* square metres in a mm2 */

/* Numbers of midpoints: of angles of incidence, and of diameters up to
 * SIZES_SLOPES / slope, beyond which 2e-5 of all cross section lies. Compared
 * with finer sums, the relative error of the absorbed share is at most 1e-4 for
 * one drop and 2e-4 for the drops of rain, for any size and absorption. */
#define ANGLES       64
#define SIZES        48
#define SIZES_SLOPES 16.0

/* 1 / slope [mm], which is 0 without rain. */
static double size_of(double rate)
{
    return pow(rate, SLOPE_FALL) / SLOPE;
}

/* The absorbed share of a ray: it enters with probability 1 - reflectance, and
 * each chord transmits the share `left`. */
static double taken(double reflectance, double left)
{
    return (1 - reflectance) * (1 - left) / (1 - reflectance * left);
}

double murk_drop_absorbs(double diameter_m, double n, double absorption_per_m)
{
    double sum = 0;
    for (int i = 0; i < ANGLES; ++i) {
        const double angle = (i + .5) / ANGLES * PI / 2;
        const double sine = sin(angle), cosine = cos(angle);
        const double inside = sqrt(1 - sine * sine / (n * n));
        const double left = exp(-absorption_per_m * diameter_m * inside);
        const double across = (cosine - n * inside) / (cosine + n * inside);
        const double along = (n * cosine - inside) / (n * cosine + inside);
        sum += sine * cosine *
               (taken(across * across, left) + taken(along * along, left));
    }
    return sum * PI / 2 / ANGLES;
}

/* The share of the rays that the drops of a rain rate absorb. */
static double rain_absorbs(double rate, double wavelength_nm)
{
    const murk_mie_index index = murk_water_refraction(wavelength_nm);
    const double per_m = 4 * PI * index.k / (wavelength_nm * 1e-9);
    const double m = size_of(rate) * 1e-3;
    double sum = 0, all = 0;
    for (int i = 0; i < SIZES; ++i) {
        const double size = (i + .5) / SIZES * SIZES_SLOPES;
        const double area = size * size * exp(-size);
        sum += area * murk_drop_absorbs(size * m, index.n, per_m);
        all += area;
    }
    return sum / all;
}

/* Fills in one half of the extinction: is_rays selects the half that is
 * refracted and reflected, of which drops absorb a share; the other half is
 * diffracted. */
static murk_status fill(murk_law_result *out, const murk_law_call *call,
                        double extinction_per_m, bool is_rays)
{
    const double rate = call->words->value[MURK_WORD_RAIN][0];
    const double half = extinction_per_m / 2;
    for (size_t i = 0; i < call->n; ++i) {
        const double share =
            is_rays ? rain_absorbs(rate, call->wavelength_nm[i]) : 0;
        out->absorption_per_m[i] = half * share;
        out->scattering_per_m[i] = half * (1 - share);
    }
    return MURK_OK;
}

murk_status murk_law_rain_power(murk_law_result *out, const murk_law_call *call,
                                murk_error *err)
{
    (void)err;
    const double rate = call->words->value[MURK_WORD_RAIN][0];
    const double db_per_km = call->parameter[1] * pow(rate, call->parameter[2]);
    return fill(out, call, db_per_km * log(10) / 10 / 1000,
                call->parameter[0] > 0);
}

murk_status murk_law_marshall_palmer(murk_law_result *out,
                                     const murk_law_call *call, murk_error *err)
{
    (void)err;
    const double mm = size_of(call->words->value[MURK_WORD_RAIN][0]);
    return fill(out, call, PI * DROPS * mm * mm * mm * M2_PER_MM2,
                call->parameter[0] > 0);
}
