/* What is in natural water: particles that come with chlorophyll, dissolved
 * organic matter, mineral sediment. Coefficients in 1/m.
 *
 * Sources, of absorption: Bricaud et al. 1998 (water_tables.h); Babin et al.,
 * J. Geophys. Res. 108 (2003) 3211, doi:10.1029/2001JC000882; of scattering:
 * Loisel & Morel, Limnol. Oceanogr. 43 (1998) 847,
 * doi:10.4319/lo.1998.43.5.0847; Morel & Maritorena, J. Geophys. Res. 106
 * (2001) 7163, doi:10.1029/2000JC000319; Babin, Morel, Fournier-Sicre, Fell &
 * Stramski, Limnol. Oceanogr. 48 (2003) 843, doi:10.4319/lo.2003.48.2.0843. */
#ifndef MURK_PRESET_WATER_CONTENTS_H
#define MURK_PRESET_WATER_CONTENTS_H

#define MURK_CHLOROPHYLL_MIN_NM 400.0
#define MURK_CHLOROPHYLL_MAX_NM 700.0

/* All particles that come with chlorophyll [mg/m3], 0 or more, between the two
 * wavelengths above: A C^E. */
double murk_chlorophyll_absorption(double wavelength_nm,
                                   double chlorophyll_mg_per_m3);

/* .416 C^.766 (wavelength / 550 nm)^v, v = .5 (log10 C - .3) up to 2 mg/m3, 0
 * above. */
double murk_chlorophyll_scattering(double wavelength_nm,
                                   double chlorophyll_mg_per_m3);

/* Share of it that turns by more than 90 degrees: .002 + .01 (.5 - .25 log10
 * C), at .02..20 mg/m3; beyond, that of the nearest. */
double murk_chlorophyll_backward(double chlorophyll_mg_per_m3);

/* Dissolved organic matter, by its absorption at 440 nm: falls as
 * exp(-slope (wavelength - 440 nm)). */
double murk_cdom_absorption(double wavelength_nm, double at_440_per_m,
                            double slope_per_nm);

/* Slopes [1/nm]: the mean of European coastal waters (Babin et al.), and that
 * of waters where all varies with chlorophyll (Morel & Maritorena). */
#define MURK_CDOM_SLOPE       0.0176
#define MURK_CDOM_SLOPE_OCEAN 0.014

/* What is dissolved at 440 nm where all varies with chlorophyll: a fifth of
 * what water and particles absorb there (Morel & Maritorena). */
double murk_cdom_of_chlorophyll(double chlorophyll_mg_per_m3);

/* Mineral particles [g/m3 dry]: .041 m2/g at 443 nm, falling by .0123 per nm;
 * .5 m2/g at 555 nm, as wavelength^-.5. */
double murk_sediment_absorption(double wavelength_nm, double sediment_g_per_m3);
double murk_sediment_scattering(double wavelength_nm, double sediment_g_per_m3);

/* The Fournier-Forand phase function of a share of backward scattering,
 * .002..0.1: index *n and slope of sizes *slope on the line n = 1.01 + .1542
 * (slope - 3): Mobley, Sundman & Boss, Appl. Opt. 41 (2002) 1035,
 * doi:10.1364/AO.41.001035. Beyond the range, that of the nearest. */
void murk_forand_of_backward(double backward, double *n, double *slope);

#endif
