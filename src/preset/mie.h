/* Lorenz and Mie: how one sphere scatters and absorbs a plane wave.
 *
 * The size parameter is x = 2 pi radius / wavelength, both in the medium
 * around the sphere; the refractive index n + i k is relative to that medium,
 * k > 0 absorbs. Efficiencies are cross sections over pi radius^2. Light is
 * unpolarised.
 *
 * Absorption is summed for itself, not as extinction less scattering, so a
 * co-albedo of 1e-12 has as many digits as any other (mie.c says how).
 *
 * Sources: Bohren & Huffman, Absorption and Scattering of Light by Small
 * Particles (1983), chapter 4, doi:10.1002/9783527618156; number of terms:
 * Wiscombe, Appl. Opt. 19 (1980) 1505, doi:10.1364/AO.19.001505. */
#ifndef MURK_PRESET_MIE_H
#define MURK_PRESET_MIE_H

#include "base/status.h"

#include <stddef.h>

#define MURK_MIE_SIZE_MIN  1e-6
#define MURK_MIE_SIZE_MAX  2e4
#define MURK_MIE_INDEX_MAX 1e3 /* of |n + i k|; at least 1e-3 */

typedef struct murk_mie_index {
    double n, k; /* n > 0, k >= 0 */
} murk_mie_index;

typedef struct murk_mie_sphere {
    double extinction, scattering, absorption; /* efficiencies */
    double mean_cosine;
} murk_mie_sphere;

/* Room for the coefficients of one sphere at a time: one for each thread. */
typedef struct murk_mie murk_mie;

/* For spheres of size parameters to `largest`, which must be within
 * MURK_MIE_SIZE_MIN..MAX. *out is the caller's: murk_mie_destroy(). Fails with
 * MURK_NO_MEMORY only. */
murk_status murk_mie_create(murk_mie **out, double largest, murk_error *err);
void murk_mie_destroy(murk_mie *mie); /* NULL is fine */

/* The sphere of size parameter x, MURK_MIE_SIZE_MIN..largest. */
murk_mie_sphere murk_mie_solve(murk_mie *mie, double x, murk_mie_index index);

/* For the sphere that was solved last: adds `weight` times (|S1|^2 + |S2|^2)/2
 * at the cosine mu[i], -1..1, to intensity[i]. Over all directions that sum is
 * pi x^2 times the scattering efficiency. */
void murk_mie_add_intensity(const murk_mie *mie, double weight, size_t count,
                            const double *mu, double *intensity);

/* Terms of the series that a sphere of size parameter x takes. */
size_t murk_mie_terms(double x);

#endif
