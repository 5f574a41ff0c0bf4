/* Selects the next measurements: the K candidate rows whose readings add most
 * to log det of the information matrix (D-optimal design; Fedorov, Theory of
 * Optimal Experiments, 1972). The method is greedy selection, then exchanges of
 * one row for another until none increases log det or the limit on work is
 * reached (EXCHANGE_WORK_MAX in optimal.c). */
#ifndef MURK_FIT_OPTIMAL_H
#define MURK_FIT_OPTIMAL_H

#include "base/status.h"

#include <stddef.h>

/* A selected candidate. */
typedef struct murk_optimal_pick {
    size_t candidate;
    double gain; /* gain of log det, when added to the candidates before it */
} murk_optimal_pick;

/* information[n * n] is J^T J of the existing readings, symmetric, in scaled
 * parameters; it may be singular, because a small multiple of the unit matrix
 * (KNOWN_BEFORE in optimal.c) is added. row[candidates][n] is whitened by the
 * error of each reading. Fills pick[k], largest gain first, without duplicates;
 * ties go to the lower number. Fails with MURK_BAD_VALUE if k > candidates or a
 * number is not finite, with MURK_RUN_FAILED if the information is not positive
 * semidefinite, or with MURK_NO_MEMORY. */
murk_status murk_optimal_choose(murk_optimal_pick *pick, size_t k,
                                const double *information, const double *row,
                                size_t candidates, size_t n, murk_error *err);

#endif
