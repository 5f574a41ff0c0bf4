/* The fluence rate of a point source in an infinite even medium, averaged over
 * spherical shells.
 *
 * Lengths in mean free paths. Here f(r) = 4 pi r^2 * fluence rate per watt: the
 * mean length that a photon flies in a shell over the shell's thickness. f(0)
 * is 1. */
#ifndef MURK_TESTS_CASES_POINT_TABLE_H
#define MURK_TESTS_CASES_POINT_TABLE_H

#include <stddef.h>

#define POINT_RADII_MAX 16

typedef struct point_table {
    double albedo, g;
    size_t n;
    double r[POINT_RADII_MAX]; /* increasing; r[0] = 0 */
    double log_f[POINT_RADII_MAX];
    double curvature[POINT_RADII_MAX]; /* of the natural cubic spline through
                                          them */
} point_table;

/* The rows of reference/point_source.csv for that medium. Ends the program
 * when there are none. */
point_table point_table_read(double albedo, double g);

/* The table's own value at its radius i. */
double point_table_at(const point_table *table, size_t i);

/* Mean of f over [r0, r1], by the spline. */
double point_table_fluence(const point_table *table, double r0, double r1);

/* The same for isotropic scattering, exact: Case, de Hoffmann and Placzek,
 * Introduction to the Theory of Neutron Diffusion (1953); r0 > 0. */
double point_exact_fluence(double albedo, double r0, double r1);

/* How far off the spline's means are at most, as a share, for shells from
 * r / stretch to r * stretch, stretch up to 1.25. The group measures it against
 * the exact means. */
double point_table_error(double stretch);

#endif
