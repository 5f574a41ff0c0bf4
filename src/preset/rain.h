/* What a drop of rain absorbs: rays by Fresnel's and Beer's laws, for spheres
 * far larger than the wavelength.
 *
 * A ray that meets the drop at an angle goes in but for Fresnel's reflectance
 * and crosses it again and again by chords of one length, reflected inside each
 * time by the same reflectance. The light's two polarisations go apart.
 *
 * Source: Bohren & Huffman, Absorption and Scattering of Light by Small
 * Particles (1983), section 7.1, doi:10.1002/9783527618156. Mie's theory has
 * 1 to 2 % more for drops of half a millimetre, less for larger ones. */
#ifndef MURK_PRESET_RAIN_H
#define MURK_PRESET_RAIN_H

/* Absorbed share of the light that falls on a drop, 0..1: its absorption over
 * its cross section. The index n is above 1, absorption that of its water. */
double murk_drop_absorbs(double diameter_m, double n, double absorption_per_m);

#endif
