/* Constituents of natural water: particles that vary with chlorophyll,
 * dissolved organic matter, and mineral sediment. Coefficients in 1/m.
 *
 * Sources of absorption: Bricaud et al. 1998 (water_tables.h); Babin et al., J.
 * Geophys. Res. 108 (2003) 3211, doi:10.1029/2001JC000882. Sources of
 * scattering: Loisel & Morel, Limnol. Oceanogr. 43 (1998) 847,
 * doi:10.4319/lo.1998.43.5.0847; Morel & Maritorena, J. Geophys. Res. 106
 * (2001) 7163, doi:10.1029/2000JC000319; Babin, Morel, Fournier-Sicre, Fell &
 * Stramski, Limnol. Oceanogr. 48 (2003) 843, doi:10.4319/lo.2003.48.2.0843. */
#ifndef MURK_PRESET_WATER_CONTENTS_H
#define MURK_PRESET_WATER_CONTENTS_H

/* The range of the tables of Bricaud et al. */
#define MURK_CHLOROPHYLL_MIN_NM 400.0
#define MURK_CHLOROPHYLL_MAX_NM 700.0

/* Absorption by all particles that vary with the chlorophyll C [mg/m3], 0 or
 * more, between the two wavelengths above: factor C^exponent, with the spectra
 * of Bricaud et al. (water_tables.h). */
double murk_chlorophyll_absorption(double wavelength_nm,
                                   double chlorophyll_mg_per_m3);

/* Scattering by these particles: .416 C^.766 (wavelength / 550 nm)^v, with v =
 * .5 (log10 C - .3) below 2 mg/m3 and v = 0 from there on; 0 for C = 0. */
double murk_chlorophyll_scattering(double wavelength_nm,
                                   double chlorophyll_mg_per_m3);

/* The share of this scattering beyond 90 degrees: .002 + .01 (.5 - .25 log10
 * C), at .02..20 mg/m3, and constant outside. */
double murk_chlorophyll_backward(double chlorophyll_mg_per_m3);

/* Absorption by dissolved organic matter, given at 440 nm: proportional to
 * exp(-slope (wavelength - 440 nm)). */
double murk_cdom_absorption(double wavelength_nm, double at_440_per_m,
                            double slope_per_nm);

/* Slopes [1/nm]: the mean of European coastal waters (Babin et al.), and the
 * value for waters in which all constituents vary with chlorophyll (Morel &
 * Maritorena). */
#define MURK_CDOM_SLOPE       0.0176
#define MURK_CDOM_SLOPE_OCEAN 0.014

/* The absorption by dissolved matter at 440 nm if all constituents vary with
 * chlorophyll: a fifth of the absorption of water and particles there (Morel &
 * Maritorena). */
double murk_cdom_of_chlorophyll(double chlorophyll_mg_per_m3);

/* Mineral particles, by dry mass [g/m3]: absorption of .041 m2/g at 443 nm,
 * falling exponentially by .0123 per nm; scattering of .5 m2/g at 555 nm,
 * proportional to wavelength^-.5. */
double murk_sediment_absorption(double wavelength_nm, double sediment_g_per_m3);
double murk_sediment_scattering(double wavelength_nm, double sediment_g_per_m3);

/* The Fournier-Forand phase function with a given share of backward scattering,
 * .002..0.1: index *n and slope of the size distribution *slope on the line n =
 * 1.01 + .1542 (slope - 3) (Mobley, Sundman & Boss, Appl. Opt. 41 (2002) 1035,
 * doi:10.1364/AO.41.001035). Shares outside the range are cut to it. */
void murk_forand_of_backward(double backward, double *n, double *slope);

#endif
