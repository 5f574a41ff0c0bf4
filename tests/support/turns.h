/* Densities over the sphere of directions, against quadrature and against
 * samples: what a phase function promises, and whether it is kept. */
#ifndef MURK_TESTS_TURNS_H
#define MURK_TESTS_TURNS_H

#include <stddef.h>
#include <stdint.h>

/* 1/sr at a cosine; a cosine at u. */
typedef double (*turn_density)(const void *context, double mu);
typedef double (*turn_sample)(const void *context, double u);

/* Integral of the density between two angles, by Gauss-Legendre on panels that
 * are narrow near angle 0. */
double turn_share(turn_density density, const void *context, double from_rad,
                  double to_rad);

/* Pearson's chi-square of n samples against the density, over up to 40 bins of
 * angle with about equal shares, as a standard normal z (Wilson & Hilferty,
 * PNAS 17 (1931) 684, doi:10.1073/pnas.17.12.684). What the density leaves of 1
 * belongs to the angles below 1e-5 rad. */
double turn_misfit(turn_sample sample, const void *sampled,
                   turn_density density, const void *expected, uint64_t n,
                   uint32_t seed);

#endif
