/* Visibility and extinction. */
#ifndef MURK_PRESET_VISIBILITY_H
#define MURK_PRESET_VISIBILITY_H

/* Extinction at 550 nm [1/m] of a visibility above 0: contrast down to 2 %. */
double murk_visibility_extinction(double visibility_m);

/* The visibility of the same extinction as a meteorological optical range:
 * contrast down to 5 %. */
double murk_visibility_of_mor(double mor_m);

/* Exponents of wavelength; see visibility.c. */
double murk_visibility_kruse_q(double visibility_km);
double murk_visibility_kim_q(double visibility_km);

#endif
