/* Extinction by visibility: the definitions of visibility, and two laws for
 * other wavelengths. */
#ifndef MURK_PRESET_VISIBILITY_H
#define MURK_PRESET_VISIBILITY_H

/* The extinction at 550 nm [1/m] for a visibility above 0 (contrast of 2 %).
 * The function is its own inverse. */
double murk_visibility_extinction(double visibility_m);

/* The visibility with the same extinction as a meteorological optical range
 * (contrast of 5 %). */
double murk_visibility_of_mor(double mor_m);

/* The exponents q of extinction in proportion to wavelength^-q, by the laws of
 * Kruse and Kim (visibility.c). */
double murk_visibility_kruse_q(double visibility_km);
double murk_visibility_kim_q(double visibility_km);

#endif
