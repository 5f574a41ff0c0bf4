/* Phase functions given by Legendre moments, made into tables that murk reads.
 *
 * p(mu) = sum over l < n of (2l + 1) chi[l] P_l(mu) / (4 pi), per sr, with
 * chi[0] = 1. A series that ends early may go a little below 0: such values
 * become 0, and what that adds is told. */
#ifndef MURK_TESTS_MOMENTS_H
#define MURK_TESTS_MOMENTS_H

#include <stddef.h>

#define MOMENTS_MAX 400

/* A column of a CSV file with `l` first ("haze_L" and "cloud_C1" of
 * tests/physics/reference/cloud_c1_haze_l_moments.csv), up to its first empty
 * cell. The number of moments, at most MOMENTS_MAX; 0 where there is no such
 * file or column. */
size_t moments_read(const char *path, const char *column,
                    double chi[MOMENTS_MAX]);

/* p(mu), as the series has it. */
double moments_density(const double *chi, size_t n, double mu);

/* Rows of the table: 0, .01, .. 10 degrees, where forward peaks are steep, then
 * every .05 to 180: 12 rows to the narrowest lobe of 300 moments. */
#define MOMENTS_ROWS 4401

/* Fills angle_deg and phase_per_sr; gives back the share of the sphere's
 * integral that was below 0 and became 0. */
double moments_tabulate(const double *chi, size_t n,
                        double angle_deg[MOMENTS_ROWS],
                        double phase_per_sr[MOMENTS_ROWS]);

/* The same as a file `angle_deg,phase_per_sr` for `phase: {table: ..}`.
 * Ends the program where it cannot be written. */
void moments_write(const char *path, const double *chi, size_t n);

/* Moments 0..n-1 of a density over the sphere (context and mu to 1/sr), by
 * Gauss-Legendre on panels that narrow towards mu = 1 like those of a forward
 * peak, from `from_rad` on. */
void moments_of(double (*density)(const void *context, double mu),
                const void *context, double from_rad, double *chi, size_t n);

#endif
