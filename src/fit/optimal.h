/* Selects the next measurements: K candidate rows whose readings together raise
 * log det of the information matrix as far as the method finds (D-optimal
 * design; Fedorov, Theory of Optimal Experiments, 1972). The method is greedy
 * selection, then exchanges of one row for another until no exchange increases
 * log det by more than rounding (EXCHANGE_MIN in optimal.c) or the limit on
 * work is reached (EXCHANGE_WORK_MAX). */
#ifndef MURK_FIT_OPTIMAL_H
#define MURK_FIT_OPTIMAL_H

#include "base/status.h"

#include <stddef.h>

/* A selected candidate. */
typedef struct murk_optimal_pick {
    size_t candidate;
    double gain; /* gain of log det, when added to the existing readings and the
                  * picks before it */
} murk_optimal_pick;

/* information[n * n] is J^T J of the existing readings, symmetric, in scaled
 * parameters; the matrix may be singular, because a small multiple of the unit
 * matrix (KNOWN_BEFORE in optimal.c) is added. row[candidates][n] is whitened
 * by the error of each reading. Fills pick[k], largest gain first, without
 * duplicates; of equal gains the lower number comes first. Fails with
 * MURK_BAD_VALUE if k > candidates or a number is not finite, with
 * MURK_RUN_FAILED if the information with that multiple is not positive
 * definite, or with MURK_NO_MEMORY. */
murk_status murk_optimal_choose(murk_optimal_pick *pick, size_t k,
                                const double *information, const double *row,
                                size_t candidates, size_t n, murk_error *err);

#endif
