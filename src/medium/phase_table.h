/* Phase functions kept as nodes: tabulated ones and Fournier-Forand.
 *
 * With s = 1 - cos(angle), in which equal steps are equal solid angles, the
 * density is linear between nodes and a power law of s before the first one.
 * Its integral is quadratic, inverted by one square root, so density, sampling
 * and mean cosine are those of one function to rounding, however sharp the
 * forward peak. Nodes are laid as densely as needed for it to be within
 * MURK_PHASE_TOLERANCE (relative) of the law that it stands for. Immutable:
 * any number of threads. */
#ifndef MURK_MEDIUM_PHASE_TABLE_H
#define MURK_MEDIUM_PHASE_TABLE_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

#define MURK_PHASE_TOLERANCE 1e-5

typedef struct murk_phase_table murk_phase_table;

/* A phase function as measured or computed. Between rows the law is straight
 * in log angle and log value; where either value is 0, or from a row at angle
 * 0 on, linear in the cosine. Before the first row the power law of the first
 * two goes on to angle 0 (flat where it would fall towards 0), behind the last
 * one its value goes on to 180. */
typedef struct murk_phase_rows {
    size_t rows;                /* 2..1e6 */
    const double *angle_deg;    /* rising: first 0 or 1e-6..10, last 150..180 */
    const double *phase_per_sr; /* 0, or 1e-30..1e30; of any scale */
    const int *line;            /* [rows] of the file; NULL: not from a file */
    const char *where;          /* "petzold.csv" */
} murk_phase_rows;

/* *out is the caller's: murk_phase_table_destroy(). Fails with MURK_BAD_VALUE
 * at the file and line (or row) of what is wrong: also a first slope of -2 or
 * steeper, which has no integral. */
murk_status murk_phase_table_create(murk_phase_table **out,
                                    const murk_phase_rows *rows,
                                    murk_error *err);

/* Fournier-Forand for particles of relative refractive index n, 1.001..2, with
 * a size distribution falling as radius^-slope, 3 < slope < 5: at 3 and below
 * the phase function has no integral, at 5 it has lost its forward peak.
 * See fournier_forand.h. */
murk_status murk_phase_table_fournier_forand(murk_phase_table **out, double n,
                                             double slope, const char *where,
                                             murk_error *err);
void murk_phase_table_destroy(murk_phase_table *table); /* NULL is fine */

/* As murk_phase_density() and murk_phase_sample(); the density at mu = 1 is
 * that at the smallest angle that a double's cosine tells from 0. */
double murk_phase_table_density(const murk_phase_table *table, double mu);
double murk_phase_table_sample(const murk_phase_table *table, double u);

/* Share of the light that turns by less than the angle of which s is 1 - cos,
 * 0 <= s <= 2. */
double murk_phase_table_share(const murk_phase_table *table, double s);

/* Whether both have the same nodes, bit by bit. */
bool murk_phase_table_is_same(const murk_phase_table *a,
                              const murk_phase_table *b);

typedef struct murk_phase_facts {
    double integral;                  /* over the sphere, before it became 1 */
    double mean_cosine;               /* to rounding */
    double backward;                  /* share beyond 90 degrees */
    double before_first, behind_last; /* shares that no row speaks of */
    size_t nodes;
} murk_phase_facts;

const murk_phase_facts *murk_phase_table_facts(const murk_phase_table *table);

#endif
