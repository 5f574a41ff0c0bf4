/* Phase functions stored as nodes: measured ones and Fournier-Forand.
 *
 * In s = 1 - cos(angle) equal steps are equal solid angles. The density is
 * linear in s between nodes and a power law of s before the first node. The
 * integral is quadratic and is inverted by one square root, so density,
 * sampling and mean cosine belong to one function to rounding, however sharp
 * the forward peak. Nodes are as dense as needed for a relative error of at
 * most MURK_PHASE_TOLERANCE. Immutable: any number of threads may use a
 * table. */
#ifndef MURK_MEDIUM_PHASE_TABLE_H
#define MURK_MEDIUM_PHASE_TABLE_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

/* Relative error of a table: far below the error of any measured phase
 * function. */
#define MURK_PHASE_TOLERANCE 1e-5

typedef struct murk_phase_table murk_phase_table;

/* A measured or computed phase function. Between rows log value is linear in
 * log angle; if either value is 0, or from a row at angle 0, the value is
 * linear in the cosine. Before the first row the power law of the first two
 * rows continues to angle 0 (the value is constant if it would fall towards
 * angle 0, or if one of the two values is 0); beyond the last row the value is
 * constant up to 180 degrees. */
typedef struct murk_phase_rows {
    size_t rows; /* 2..1e6 */
    const double
        *angle_deg; /* rising; the first is 0 or 1e-6..10, the last 150..180 */
    const double *phase_per_sr; /* 0, or 1e-30..1e30; any scale */
    const int *line;   /* [rows] line of the file; NULL: not from a file */
    const char *where; /* file or place for messages, such as "petzold.csv" */
} murk_phase_rows;

/* Makes a table from rows. The caller owns *out and releases it with
 * murk_phase_table_destroy(). Fails with MURK_BAD_VALUE if the number of rows,
 * an angle or a value is outside the limits of murk_phase_rows; if no value is
 * above 0; if the power law before the first row falls as angle^-2 or steeper,
 * because its integral to angle 0 diverges; or if, row by row, more than
 * MURK_PHASE_NODES_MAX nodes (medium/phase_nodes.h) would be needed or the
 * memory for nodes runs out. The message begins with rows->where and, if one
 * row is the cause, its line or number. Fails with MURK_NO_MEMORY if there is
 * no memory for the finished table. */
murk_status murk_phase_table_create(murk_phase_table **out,
                                    const murk_phase_rows *rows,
                                    murk_error *err);

/* Makes a Fournier-Forand table for particles of relative refractive index n,
 * 1.001..2, with a size distribution falling as radius^-slope, 3.0001 <= slope
 * <= 4.9999 (fournier_forand.h). The caller owns *out as above. Fails at
 * `where` with MURK_BAD_VALUE or MURK_NO_MEMORY. */
murk_status murk_phase_table_fournier_forand(murk_phase_table **out, double n,
                                             double slope, const char *where,
                                             murk_error *err);
void murk_phase_table_destroy(murk_phase_table *table); /* NULL is fine */

/* murk_phase_density() and murk_phase_sample() (medium/phase.h) for a table.
 * The density at mu = 1 is that at the smallest angle whose cosine differs from
 * 1 in double precision. */
double murk_phase_table_density(const murk_phase_table *table, double mu);
double murk_phase_table_sample(const murk_phase_table *table, double u);

/* Share of the light scattered by less than the angle with s = 1 -
 * cos(angle), 0 <= s <= 2. */
double murk_phase_table_share(const murk_phase_table *table, double s);

/* True if both have the same nodes, bit by bit, and the same power law before
 * the first node. */
bool murk_phase_table_is_same(const murk_phase_table *a,
                              const murk_phase_table *b);

typedef struct murk_phase_facts {
    double integral;    /* over the sphere, before it was scaled to 1 */
    double mean_cosine; /* to rounding */
    double backward;    /* share beyond 90 degrees */
    double before_first,
        behind_last; /* shares of the light before the first and beyond the
                        last row; 0 for Fournier-Forand */
    size_t nodes;
} murk_phase_facts;

const murk_phase_facts *murk_phase_table_facts(const murk_phase_table *table);

#endif
