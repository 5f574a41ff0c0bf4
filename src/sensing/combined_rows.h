/* The rows of several sensors combined for each photon, in the way that plans
 * are valued (placement/problem.h). */
#ifndef MURK_SENSING_COMBINED_ROWS_H
#define MURK_SENSING_COMBINED_ROWS_H

#include "placement/dose.h"

typedef struct murk_combined_rows {
    size_t photons, layers; /* entries of a photon that count */
    uint32_t *sensors;      /* [photons] number of sensors with an entry */
    uint16_t *clarity;  /* [photons][layers + 1] the largest entries, falling */
    uint32_t *clearest; /* [photons][layers] the sensors of these entries */
    /* For detection probabilities, in place of both. */
    uint64_t *dose; /* [photons] */
    murk_doses *doses;
} murk_combined_rows;

/* Without any row. False when out of memory; call murk_combined_rows_release()
 * also then. */
bool murk_combined_rows_init(murk_combined_rows *out, size_t photons,
                             murk_combining combining, size_t layers);
void murk_combined_rows_release(murk_combined_rows *combined);

/* Adds the row of one sensor. Sensors must come in increasing order; of equal
 * entries the first counts. */
void murk_combined_rows_add(murk_combined_rows *combined, uint32_t sensor,
                            const murk_sparse_row *row);

/* The value of photon i, 0 .. layers * MURK_CLEAR. */
uint32_t murk_combined_rows_worth(const murk_combined_rows *combined, size_t i);

/* After all rows: only[sensor] += the value of all sensors less the value
 * without this one, times weight. For largest entries only. */
void murk_combined_rows_only(const murk_combined_rows *combined,
                             const uint32_t *weight, uint64_t *only);

/* The same for one sensor with this row; for detection probabilities only. */
uint64_t murk_combined_rows_only_of(const murk_combined_rows *combined,
                                    const uint32_t *weight,
                                    const murk_sparse_row *row);

#endif
