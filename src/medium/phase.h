/* Phase functions: how light turns when a droplet scatters it.
 *
 * Angles are between the directions of travel before and after, so mu = +1 is
 * straight on. The density is per steradian and integrates to 1 over the
 * sphere.
 *
 * Source: Henyey & Greenstein, Astrophys. J. 93 (1941) 70, doi:10.1086/144246.
 */
#ifndef MURK_MEDIUM_PHASE_H
#define MURK_MEDIUM_PHASE_H

typedef enum murk_phase_kind {
    MURK_PHASE_HG /* Henyey-Greenstein; isotropic where g is 0 */
} murk_phase_kind;

/* One phase function, held by value. All zero: isotropic. */
typedef struct murk_phase {
    murk_phase_kind kind;
    double g; /* mean cosine, -1 < g < 1 */
} murk_phase;

murk_phase murk_phase_hg(double g);

/* Density [1/sr] at mu = cos(angle), -1 <= mu <= 1. */
double murk_phase_density(const murk_phase *phase, double mu);

/* A cosine distributed as the density: the inverse CDF at u in (0, 1). */
double murk_phase_sample(const murk_phase *phase, double u);

double murk_phase_mean_cosine(const murk_phase *phase);

/* Density [1/sr] at mu = cos(angle), for mean cosine g.
 * Needs -1 <= mu <= 1 and -1 < g < 1. */
double murk_hg_density(double g, double mu);

/* A cosine distributed as murk_hg_density: the inverse CDF at u in (0, 1).
 * Exact: mean is g, variance is (1 - g^2) / 3. */
double murk_hg_sample(double g, double u);

#endif
