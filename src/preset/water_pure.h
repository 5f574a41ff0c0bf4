/* Absorption and scattering of pure water and of sea salt in it.
 *
 * Absorption: Pope & Fry, Appl. Opt. 36 (1997) 8710, doi:10.1364/AO.36.008710:
 * pure water at 22 degrees C, every 2.5 nm, linear between. Effects of salt and
 * temperature are neglected; they matter mostly beyond 700 nm.
 *
 * Scattering: Zhang, Hu & He, Opt. Express 17 (2009) 5698,
 * doi:10.1364/OE.17.005698, computed from fluctuations of density and salinity;
 * or measured, Morel (1974), with salinity as in Boss & Pegau, Appl. Opt. 40
 * (2001) 5503, doi:10.1364/AO.40.005503. */
#ifndef MURK_PRESET_WATER_PURE_H
#define MURK_PRESET_WATER_PURE_H

/* The range of the table of Pope & Fry. */
#define MURK_WATER_MIN_NM 380.0
#define MURK_WATER_MAX_NM 727.5

/* The depolarisation ratio: of light scattered at right angles, the intensity
 * polarised along the beam divided by the rest. Farinato & Rowell, J. Chem.
 * Phys. 65 (1976) 593. */
#define MURK_WATER_DEPOLARISATION 0.039

/* Absorption [1/m] between the two wavelengths above. */
double murk_water_absorption(double wavelength_nm);

/* Total scattering [1/m] by Zhang, Hu & He, at 0..30 degrees C, 0..40 psu and
 * normal pressure. */
double murk_water_scattering(double wavelength_nm, double temperature_c,
                             double salinity_psu);

/* Total scattering [1/m] by Morel, at 20 degrees C. */
double murk_water_scattering_morel(double wavelength_nm, double salinity_psu);

/* The phase function of water, in arbitrary scale: 1 + d mu^2 with d = (1 -
 * depolarisation) / (1 + depolarisation). */
double murk_water_phase(double mu);

#endif
