/* Scattering by the molecules of dry air. */
#ifndef MURK_PRESET_AIR_H
#define MURK_PRESET_AIR_H

/* The scattering cross section of a molecule [cm2], 250..1690 nm. Sources:
 * air.c. */
double murk_air_cross_section_cm2(double wavelength_nm);

#endif
