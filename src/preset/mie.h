/* Lorenz-Mie theory: scattering and absorption of a plane wave by one sphere.
 *
 * The size parameter is x = 2 pi radius / wavelength, with the wavelength in
 * the medium around the sphere. The refractive index n + i k is relative to
 * that medium; k > 0 absorbs. Efficiencies are cross sections divided by pi
 * radius^2. Light is unpolarised.
 *
 * Absorption is summed directly, not as extinction minus scattering, so a
 * co-albedo of 1e-12 has full precision (mie.c).
 *
 * Sources: Bohren & Huffman, Absorption and Scattering of Light by Small
 * Particles (1983), chapter 4, doi:10.1002/9783527618156; number of terms:
 * Wiscombe, Appl. Opt. 19 (1980) 1505, doi:10.1364/AO.19.001505. */
#ifndef MURK_PRESET_MIE_H
#define MURK_PRESET_MIE_H

#include "base/status.h"

#include <stddef.h>

/* The accepted size parameters (Wiscombe's number of terms holds to 2e4), and
 * the largest accepted |n + i k|. */
#define MURK_MIE_SIZE_MIN  1e-6
#define MURK_MIE_SIZE_MAX  2e4
#define MURK_MIE_INDEX_MAX 1e3

typedef struct murk_mie_index {
    double n, k; /* n > 0, k >= 0 */
} murk_mie_index;

/* The solution for one sphere. */
typedef struct murk_mie_sphere {
    double extinction, scattering, absorption; /* efficiencies */
    double mean_cosine;
} murk_mie_sphere;

/* Memory for the coefficients of one sphere at a time; each thread needs
 * one. */
typedef struct murk_mie murk_mie;

/* Creates memory for size parameters up to `largest`, which must be within
 * MURK_MIE_SIZE_MIN..MAX. The caller destroys *out with murk_mie_destroy().
 * Fails with MURK_NO_MEMORY only. */
murk_status murk_mie_create(murk_mie **out, double largest, murk_error *err);
void murk_mie_destroy(murk_mie *mie); /* NULL is fine */

/* Solves the sphere of size parameter x, MURK_MIE_SIZE_MIN..largest. */
murk_mie_sphere murk_mie_solve(murk_mie *mie, double x, murk_mie_index index);

/* Adds `weight` times (|S1|^2 + |S2|^2)/2 of the sphere that was solved last,
 * at the cosine mu[i], -1..1, to intensity[i]. The integral of (|S1|^2 +
 * |S2|^2)/2 over all directions is pi x^2 times the scattering efficiency. */
void murk_mie_add_intensity(const murk_mie *mie, double weight, size_t count,
                            const double *mu, double *intensity);

#endif
