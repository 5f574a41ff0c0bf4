/* Scattering of clear air (Rayleigh) and extinction of aerosol (Angstrom).
 *
 * The cross section of a molecule is
 *
 *   24 pi^3 (n^2 - 1)^2 / (wavelength^4 N^2 (n^2 + 2)^2) F
 *
 * for dry air at 288.15 K and 1013.25 hPa, with the wavelength in cm, N
 * molecules per cm3, the index n of Peck & Reeder for 300 ppm of CO2, and the
 * King factor F of nitrogen, oxygen, argon and CO2, all as in Bodhaine et al.
 * The scattering coefficient is the cross section times the number of molecules
 * per volume. This number is proportional to pressure / temperature; the cross
 * section depends on neither.
 *
 * Sources: Bodhaine, Wood, Dutton & Slusser, J. Atmos. Ocean. Tech. 16 (1999)
 * 1854, doi:10.1175/1520-0426(1999)016<1854:ORODC>2.0.CO;2; Peck & Reeder, J.
 * Opt. Soc. Am. 62 (1972) 958, doi:10.1364/JOSA.62.000958; Angstrom, Tellus 16
 * (1964) 64, doi:10.1111/j.2153-3490.1964.tb00144.x. */
#include "preset/laws.h"

#include <math.h>

/* Physical constants, and the composition of dry air in percent by volume, as
 * in Bodhaine et al. 1999, sections 2 and 3, with 300 ppm of CO2. */
#define PI               3.14159265358979323846
#define PER_CM3          2.546899e19 /* molecules at 288.15 K, 1013.25 hPa */
#define STANDARD_K       288.15
#define STANDARD_HPA     1013.25
#define ZERO_CELSIUS_K   273.15
#define CO2_PERCENT      .03
#define NITROGEN_PERCENT 78.084
#define OXYGEN_PERCENT   20.946
#define ARGON_PERCENT    .934

static double king_factor(double per_um2)
{
    const double nitrogen = 1.034 + 3.17e-4 * per_um2;
    const double oxygen =
        1.096 + 1.385e-3 * per_um2 + 1.448e-4 * per_um2 * per_um2;
    return (NITROGEN_PERCENT * nitrogen + OXYGEN_PERCENT * oxygen +
            ARGON_PERCENT * 1.00 + CO2_PERCENT * 1.15) /
           (NITROGEN_PERCENT + OXYGEN_PERCENT + ARGON_PERCENT + CO2_PERCENT);
}

/* The scattering cross section of a molecule [cm2], 250..1690 nm. */
static double cross_section_cm2(double wavelength_nm)
{
    const double um = wavelength_nm / 1000, per_um2 = 1 / (um * um);
    const double n = 1 + 1e-8 * (8060.51 + 2480990 / (132.274 - per_um2) +
                                 17455.7 / (39.32957 - per_um2));
    const double ratio = (n * n - 1) / (n * n + 2);
    const double cm4 = pow(wavelength_nm * 1e-7, 4);
    return 24 * PI * PI * PI * ratio * ratio / (cm4 * PER_CM3 * PER_CM3) *
           king_factor(per_um2);
}

murk_status murk_law_rayleigh(murk_law_result *out, const murk_law_call *call,
                              murk_error *err)
{
    (void)err;
    const double hpa = call->words->value[MURK_WORD_PRESSURE][0];
    const double kelvin =
        call->words->value[MURK_WORD_TEMPERATURE][0] + ZERO_CELSIUS_K;
    const double per_cm3 =
        PER_CM3 * (hpa / STANDARD_HPA) * (STANDARD_K / kelvin);
    for (size_t i = 0; i < call->n; ++i) {
        out->scattering_per_m[i] =
            cross_section_cm2(call->wavelength_nm[i]) * per_cm3 * 100;
    }
    return MURK_OK;
}

murk_status murk_law_angstrom(murk_law_result *out, const murk_law_call *call,
                              murk_error *err)
{
    (void)err;
    const double *p = call->parameter;
    murk_law_power(out, call, p[0], p[1], p[2], p[3]);
    return MURK_OK;
}
