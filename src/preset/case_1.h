/* Case-1 water: open ocean in which all constituents vary with chlorophyll. The
 * functions give the observed attenuation of daylight, and the absorption by
 * particles and dissolved matter that, added to that of pure water, causes this
 * attenuation. Coefficients in 1/m, chlorophyll in mg/m3. */
#ifndef MURK_PRESET_CASE_1_H
#define MURK_PRESET_CASE_1_H

/* The first and the last wavelength of the table of the observed attenuation.
 */
#define MURK_CASE_1_MIN_NM 400.0
#define MURK_CASE_1_MAX_NM 555.0

/* The observed diffuse attenuation of daylight at MURK_CASE_1_MIN_NM..MAX_NM:
 * Kw + chi C^e, C being the chlorophyll, at the six wavelengths for which
 * case_1.c has a table of Kw, chi and e, linear in between. */
double murk_case_1_kd(double wavelength_nm, double chlorophyll_mg_per_m3);

/* The diffuse attenuation of daylight, averaged over the depth in which the
 * light falls to 10 %, by total absorption and total backward scattering, both
 * with pure water (Lee et al. 2005), for the zenith angle of the sun in air
 * [degrees]. */
double murk_case_1_kd_of(double absorption_per_m, double backscattering_per_m,
                         double sun_zenith_deg);

/* The absorption by particles and dissolved matter together, at 400 to 700 nm;
 * 0 without chlorophyll. */
double murk_case_1_absorption(double wavelength_nm,
                              double chlorophyll_mg_per_m3);

#endif
