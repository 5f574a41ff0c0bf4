/* The Fournier-Forand phase function of particles in water.
 *
 * Spheres of one relative refractive index n in the anomalous-diffraction
 * approximation, their number falling as radius^-slope: in the form with the
 * backscatter term, which has its integral over the sphere at 1.
 *
 * Sources: Fournier & Forand, Proc. SPIE 2258 (1994) 194,
 * doi:10.1117/12.190063; Fournier & Jonasz, Proc. SPIE 3761 (1999) 62,
 * doi:10.1117/12.366488. */
#ifndef MURK_MEDIUM_FOURNIER_FORAND_H
#define MURK_MEDIUM_FOURNIER_FORAND_H

/* Slopes: at 3 there is no integral, at 5 no forward peak, and next to either
 * no table of sane size. */
#define MURK_FORAND_MIN 3.0001
#define MURK_FORAND_MAX 4.9999

/* Density [1/sr] at s = 1 - cos(angle), 0 < s <= 2. Needs 1.001 <= n <= 2 and
 * 3 < slope < 5; positive there. Goes as s^((slope - 5) / 2) towards s = 0. */
double murk_fournier_forand(double n, double slope, double s);

#endif
