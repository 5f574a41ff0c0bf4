/* The simple spectral model of Bird and Riordan (SPCTRAL2). Equation numbers
 * are those of the report NREL/TR-215-2436. Where the text of the report, the
 * appendix and the later program of NREL differ, the program is followed:
 * constants in 2-4 and 2-11, gases instead of ozone in 3-8, and the factor of
 * 3-17 once. */
#include "source/clear_spectrum.h"

#include "base/vector.h"

#define RAD_PER_DEG   (MURK_PI / 180) /* degrees to radians */
#define SEA_LEVEL_HPA 1013.0          /* of the report */
/* The air mass for light that the ground reflects upwards. */
#define AIRMASS_OF_SKY 1.8
#define OZONE_HEIGHT   (22.0 / 6370) /* height over earth's radius, km */

/* Rural aerosol: exponent of 2-7, albedo at 400 nm and the decrease of 3-16,
 * mean cosine. */
#define ANGSTROM       1.14
#define AEROSOL_ALBEDO 0.945
#define ALBEDO_FALL    0.095
#define MEAN_COSINE    0.65

/* The transmittances of the constituents of the atmosphere. */
typedef struct passed {
    double rayleigh, aerosol, scattering, absorption, vapour, ozone, gases;
} passed;

static passed pass(const murk_bird_line *line, const murk_clear_air *air,
                   double airmass)
{
    const double um = line->nm / 1000;
    const double absolute = airmass * air->pressure_hpa / SEA_LEVEL_HPA;
    const double fall = log(line->nm / 400);
    const double albedo = AEROSOL_ALBEDO * exp(-ALBEDO_FALL * fall * fall);
    const double aerosol = air->aerosol_500 * pow(line->nm / 500, -ANGSTROM);
    const double vapour = line->vapour * air->water_cm * airmass;
    const double gases = line->gases * absolute;
    const double cosine = cos(RAD_PER_DEG * air->zenith_deg);
    const double ozone_airmass =
        (1 + OZONE_HEIGHT) / sqrt(cosine * cosine + 2 * OZONE_HEIGHT);
    return (passed){
        .rayleigh = exp(-absolute / (um * um * (115.6406 * um * um - 1.3366))),
        .aerosol = exp(-aerosol * airmass),
        .scattering = exp(-albedo * aerosol * airmass),
        .absorption = exp(-(1 - albedo) * aerosol * airmass),
        .vapour = exp(-0.2385 * vapour / pow(1 + 20.07 * vapour, 0.45)),
        .ozone = exp(-line->ozone * air->ozone_cm * ozone_airmass),
        .gases = exp(-1.41 * gases / pow(1 + 118.3 * gases, 0.45))};
}

/* The share of the light scattered by aerosol that continues downward, 3-11 to
 * 3-15. */
static double downward(double cosine)
{
    const double g = log(1 - MEAN_COSINE);
    const double a = g * (1.459 + g * (0.1595 + g * 0.4129));
    const double b = g * (0.0783 + g * (-0.3824 - g * 0.5874));
    return 1 - 0.5 * exp((a + b * cosine) * cosine);
}

static double sky_reflectance(const passed *p)
{
    return p->gases * p->vapour * p->absorption *
           (0.5 * (1 - p->rayleigh) + (1 - downward(1 / AIRMASS_OF_SKY)) *
                                          p->rayleigh * (1 - p->scattering));
}

void murk_clear_spectrum_make(murk_clear_spectrum *out,
                              const murk_clear_air *air)
{
    const double cosine = cos(RAD_PER_DEG * air->zenith_deg);
    for (int i = 0; i < MURK_BIRD_LINES; ++i) {
        const murk_bird_line *line = &murk_bird[i];
        const passed p = pass(line, air, air->relative_airmass);
        const passed up = pass(line, air, AIRMASS_OF_SKY);
        const double direct = line->outside * p.rayleigh * p.aerosol *
                              p.vapour * p.ozone * p.gases;
        const double arriving = line->outside * cosine * p.ozone * p.gases *
                                p.vapour * p.absorption;
        const double by_air = arriving * (1 - pow(p.rayleigh, 0.95)) * 0.5;
        const double by_aerosol = arriving * pow(p.rayleigh, 1.5) *
                                  (1 - p.scattering) * downward(cosine);
        const double sky = sky_reflectance(&up);
        const double again = (direct * cosine + by_air + by_aerosol) * sky *
                             air->ground_albedo /
                             (1 - sky * air->ground_albedo);
        const double ultraviolet =
            line->nm <= 450 ? pow((line->nm + 550) / 1000, 1.8) : 1;
        out->direct[i] = direct;
        out->diffuse[i] = (by_air + by_aerosol + again) * ultraviolet;
    }
}
