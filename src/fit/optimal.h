/* Which measurements to make next: of candidates' rows, the K whose readings
 * add most to log det of the information (D-optimal; Fedorov, Theory of Optimal
 * Experiments, 1972; greedy, then exchanges of one for another until none adds,
 * or a stated amount of work is done). */
#ifndef MURK_FIT_OPTIMAL_H
#define MURK_FIT_OPTIMAL_H

#include "base/status.h"

#include <stddef.h>

typedef struct murk_optimal_pick {
    size_t candidate;
    double gain; /* of log det, when added to those before it */
} murk_optimal_pick;

/* information[n * n] is J^T J of what there is, symmetric, in scaled parameters
 * (it may be singular: a small multiple of 1, stated in the source, is added);
 * row[candidates][n] whitened by each reading's own error. Fills pick[k], the
 * largest gain first; no candidate twice; ties by number. Fails with
 * MURK_BAD_VALUE where k > candidates or a number is not finite,
 * MURK_RUN_FAILED where the information is not positive semidefinite, or
 * MURK_NO_MEMORY. */
murk_status murk_optimal_choose(murk_optimal_pick *pick, size_t k,
                                const double *information, const double *row,
                                size_t candidates, size_t n, murk_error *err);

#endif
