/* Case-1 water, the open ocean where everything in the water varies with
 * chlorophyll: the attenuation of daylight that is observed there, and the
 * absorption beside the water's own that has this attenuation. Coefficients in
 * 1/m, chlorophyll in mg/m3. */
#ifndef MURK_PRESET_CASE_1_H
#define MURK_PRESET_CASE_1_H

/* Wavelengths of the observed law; the law is linear between them. */
#define MURK_CASE_1_MIN_NM 400.0
#define MURK_CASE_1_MAX_NM 555.0

/* Diffuse attenuation of daylight, Kw + chi C^e, within those wavelengths. */
double murk_case_1_kd(double wavelength_nm, double chlorophyll_mg_per_m3);

/* Attenuation of daylight down to 10 % of the light at the surface, by
 * absorption and backward scattering, for the sun at that distance from the
 * zenith in air. */
double murk_case_1_kd_of(double absorption_per_m, double backscattering_per_m,
                         double sun_zenith_deg);

/* Absorption by particles and dissolved matter together, 400 to 700 nm. */
double murk_case_1_absorption(double wavelength_nm,
                              double chlorophyll_mg_per_m3);

#endif
