/* Absorption in case-1 water, derived from the observed attenuation of
 * daylight.
 *
 * A sum of particle absorption (Bricaud et al.) and dissolved matter, a fifth
 * of absorption at 440 nm (Morel & Maritorena), makes water too clear above .3
 * mg/m3: the attenuation of daylight at 490 nm is then 18 % below the observed
 * one at 1 mg/m3 and 30 % below at 5 mg/m3. Morel and Maritorena derive the
 * absorption from the observed attenuation instead, and so does this file:
 *
 *  1. Kd = Kw + chi C^e at six wavelengths is observed.
 *  2. Backscattering is that of pure water and of the particles
 *     (water_contents.h, after Morel & Maritorena).
 *  3. The law of Lee, Du and Arnone gives Kd by absorption and
 *     backscattering. The law is solved for the absorption, and the absorption
 *     of pure water is subtracted.
 *  4. Between the six wavelengths the spectrum has the shape of the sum
 *     above: the ratio of the absorption of step 3 to that sum is linear in
 *     wavelength. Beyond 555 nm pure water absorbs most of the light, the
 *     observed law is uncertain, and the ratio goes linearly to 1 at 650 nm.
 *
 * In very clear water the observed Kd at 510 and 555 nm is below that of pure
 * water with the same sun; the absorption by particles and dissolved matter is
 * then 0.
 *
 * Sources: Morel & Maritorena, J. Geophys. Res. 106 (2001) 7163,
 * doi:10.1029/2000JC000319; Morel et al., Remote Sens. Environ. 111 (2007) 69,
 * doi:10.1016/j.rse.2007.03.012 (490 nm, .0166 + .07242 C^.68955); Lee, Du &
 * Arnone, J. Geophys. Res. 110 (2005) C02016, doi:10.1029/2004JC002275. */
#include "preset/case_1.h"

#include "preset/water_contents.h"
#include "preset/water_pure.h"

#include <math.h>
#include <stddef.h>

/* Kw, chi and e of Morel and Maritorena as quoted by the programs of Westberry
 * et al., Global Biogeochem. Cycles 22 (2008) GB2024, doi:10.1029/2007GB003078.
 * Morel et al. 2007 confirm the row of 490 nm. */
static const struct row {
    double nm, water_per_m, chi, e;
} row[] = {
    {MURK_CASE_1_MIN_NM, .01042, .11748, .64358},
    {412, .007932, .122858, .653270},
    {443, .009480, .107212, .673358},
    {490, .01660, .07242, .68955},
    {510, .03385, .05943, .68567},
    {MURK_CASE_1_MAX_NM, .06053, .03996, .64204},
};
enum { ROWS = sizeof row / sizeof *row };

/* An effective zenith angle, not an observed one: with it the preset, traced by
 * this program, has the observed attenuation. The law of Lee et al. holds for
 * sun and sky together. Light traced from a sun at 30 degrees from the zenith,
 * without a sky, is attenuated 3 to 12 % less than the law predicts for 30
 * degrees, and agrees within 7 % with the prediction for 15 degrees
 * (tests/physics/RESULTS.md). With 30 degrees in the law, the absorption, pure
 * water included, would be 6 % less. */
#define SUN_ZENITH_DEG 15.0
#define BRICAUD_NM     650.0 /* from here on the ratio is 1 */

/* Temperature and salinity that are assumed for the sea water of the
 * observations. */
#define TEMPERATURE_C 20.0
#define SALINITY_PSU  35.0

/* Returns the index of the row at or before a wavelength (at least the first
 * row, at most the last but one), and the relative position between this row
 * and the next, 0..1 within the table. */
static size_t place_of(double wavelength_nm, double *share)
{
    size_t i = 0;
    while (i + 2 < ROWS && wavelength_nm >= row[i + 1].nm) {
        ++i;
    }
    *share = (wavelength_nm - row[i].nm) / (row[i + 1].nm - row[i].nm);
    return i;
}

static double kd_of_row(const struct row *r, double chlorophyll)
{
    return r->water_per_m + r->chi * pow(chlorophyll, r->e);
}

double murk_case_1_kd(double wavelength_nm, double chlorophyll_mg_per_m3)
{
    double share;
    const size_t i = place_of(wavelength_nm, &share);
    return (1 - share) * kd_of_row(&row[i], chlorophyll_mg_per_m3) +
           share * kd_of_row(&row[i + 1], chlorophyll_mg_per_m3);
}

double murk_case_1_kd_of(double absorption_per_m, double backscattering_per_m,
                         double sun_zenith_deg)
{
    return (1 + .005 * sun_zenith_deg) * absorption_per_m +
           4.18 * (1 - .52 * exp(-10.8 * absorption_per_m)) *
               backscattering_per_m;
}

/* Solves the law of Lee et al. for the absorption, by bisection, because the
 * attenuation rises with absorption. The result is 0 (below 1e-18 kd) if
 * backscattering alone attenuates more. */
static double absorption_of(double kd, double backscattering)
{
    double low = 0, high = kd;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        const double of_middle =
            murk_case_1_kd_of(middle, backscattering, SUN_ZENITH_DEG);
        *(of_middle < kd ? &low : &high) = middle;
    }
    return (low + high) / 2;
}

/* The sum of the absorption by particles (Bricaud et al.) and by the dissolved
 * matter that accompanies the same chlorophyll. */
static double of_parts(double nm, double chlorophyll)
{
    return murk_chlorophyll_absorption(nm, chlorophyll) +
           murk_cdom_absorption(nm, murk_cdom_of_chlorophyll(chlorophyll),
                                MURK_CDOM_SLOPE_OCEAN);
}

/* The ratio of the absorption from the observed attenuation to the sum
 * of_parts(), at a wavelength of the table. */
static double ratio_at(const struct row *r, double chlorophyll)
{
    const double backscattering =
        murk_water_scattering(r->nm, TEMPERATURE_C, SALINITY_PSU) / 2 +
        murk_chlorophyll_backward(chlorophyll) *
            murk_chlorophyll_scattering(r->nm, chlorophyll);
    const double whole =
        absorption_of(kd_of_row(r, chlorophyll), backscattering);
    return fmax(whole - murk_water_absorption(r->nm), 0) /
           of_parts(r->nm, chlorophyll);
}

double murk_case_1_absorption(double wavelength_nm,
                              double chlorophyll_mg_per_m3)
{
    const double c = chlorophyll_mg_per_m3, nm = wavelength_nm;
    if (!(c > 0)) {
        return 0;
    }
    double ratio;
    if (nm < MURK_CASE_1_MAX_NM) {
        double share;
        const size_t i = place_of(nm, &share);
        ratio = (1 - share) * ratio_at(&row[i], c) +
                share * ratio_at(&row[i + 1], c);
    } else {
        const double share = fmin(1, (nm - MURK_CASE_1_MAX_NM) /
                                         (BRICAUD_NM - MURK_CASE_1_MAX_NM));
        ratio = (1 - share) * ratio_at(&row[ROWS - 1], c) + share;
    }
    return ratio * of_parts(nm, c);
}
