/* The Fournier-Forand phase function of particles in water.
 *
 * It describes spheres of one relative refractive index n in the
 * anomalous-diffraction approximation, with a size distribution that falls as
 * radius^-slope. The form with the backscatter term is used, whose integral
 * over the sphere is 1.
 *
 * Sources: Fournier & Forand, Proc. SPIE 2258 (1994) 194,
 * doi:10.1117/12.190063; Fournier & Jonasz, Proc. SPIE 3761 (1999) 62,
 * doi:10.1117/12.366488. */
#ifndef MURK_MEDIUM_FOURNIER_FORAND_H
#define MURK_MEDIUM_FOURNIER_FORAND_H

/* Range of slopes. At 3 the integral diverges, at 5 the forward peak
 * vanishes; closer to either a table would need too many nodes. */
#define MURK_FORAND_MIN 3.0001
#define MURK_FORAND_MAX 4.9999

/* Density [1/sr] at s = 1 - cos(angle), 0 < s <= 2. Needs 1.001 <= n <= 2
 * and 3 < slope < 5; positive there. Proportional to s^((slope - 5) / 2) for
 * s towards 0. */
double murk_fournier_forand(double n, double slope, double s);

#endif
