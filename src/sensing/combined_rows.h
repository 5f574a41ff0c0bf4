/* The rows of several sensors combined for each photon, in the way that plans
 * are valued (placement/problem.h). */
#ifndef MURK_SENSING_COMBINED_ROWS_H
#define MURK_SENSING_COMBINED_ROWS_H

#include "placement/dose.h"

typedef struct murk_combined_rows {
    size_t photons, layers; /* number of photons; number of the largest entries
                               of a photon that add up to the value */
    size_t capacity;        /* photons that the arrays have memory for */
    uint32_t *sensors;      /* [photons] number of sensors with an entry */
    uint16_t *clarity;      /* [photons][layers + 1] the largest entries of each
                               photon, in falling order */
    uint32_t *clearest; /* [photons][layers] the sensors of the first `layers`
                           of these entries */
    /* For detection probabilities, in place of clarity and clearest: the sum of
     * the doses of a photon, and the table of doses. The dose of a detection
     * probability p is -ln(1 - p), as a whole number (placement/dose.h). */
    uint64_t *dose; /* [photons] */
    murk_doses *doses;
} murk_combined_rows;

/* Starts without any row; layers >= 1, and 1 for MURK_COMBINE_INDEPENDENT.
 * False when out of memory; call murk_combined_rows_release() also then. */
bool murk_combined_rows_init(murk_combined_rows *out, size_t photons,
                             murk_combining combining, size_t layers);
void murk_combined_rows_release(murk_combined_rows *combined);

/* Adds photons without entries, so that there are `photons`; not for detection
 * probabilities. False when out of memory; the photons are then as before. */
bool murk_combined_rows_extend(murk_combined_rows *combined, size_t photons);

/* Adds the row of one sensor. The caller adds each sensor once. Of equal
 * entries the one that was added first stands before the others. */
void murk_combined_rows_add(murk_combined_rows *combined, uint32_t sensor,
                            const murk_sparse_row *row);

/* The value of photon i, 0 .. layers * MURK_CLEAR: the sum of the `layers`
 * largest entries, or MURK_CLEAR times the probability that some sensor detects
 * the photon. */
uint32_t murk_combined_rows_worth(const murk_combined_rows *combined, size_t i);

/* To be called after all rows were added. For each sensor, adds to only[sensor]
 * the sum over the photons of weight[i] times the difference of two values of
 * photon i: that of all sensors, and that without this sensor. weight[photons].
 * Not for detection probabilities. */
void murk_combined_rows_only(const murk_combined_rows *combined,
                             const uint32_t *weight, uint64_t *only);

/* Returns the sum of murk_combined_rows_only() for one sensor, whose row must
 * have been added. For detection probabilities only. */
uint64_t murk_combined_rows_only_of(const murk_combined_rows *combined,
                                    const uint32_t *weight,
                                    const murk_sparse_row *row);

#endif
