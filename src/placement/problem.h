/* Which photons each candidate sees, and how clearly: all that placement
 * knows. No physics here, only sets and weights.
 *
 * Weights and clarities are whole numbers, so every coverage is an exact
 * integer sum, ties are true ties, and nothing depends on the order of adding.
 * A plan is worth sum_i weight_i f_i, f_i what its sensors see of photon i
 * together: by default the clearest view, max_j clarity_ij (facility location).
 */
#ifndef MURK_PLACEMENT_PROBLEM_H
#define MURK_PLACEMENT_PROBLEM_H

#include "base/detection.h"
#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Clarity of an unattenuated sightline. A stored clarity is off by at most
 * half a unit: 7.7e-6 of full. */
#define MURK_CLEAR 65535

/* What one candidate sees: photon[] increasing, clarity[] in 1..MURK_CLEAR;
 * clarity NULL means all are MURK_CLEAR. */
typedef struct murk_sparse_row {
    size_t seen;
    const uint32_t *photon;
    const uint16_t *clarity;
} murk_sparse_row;

/* How the views of one photon by several sensors combine. */
typedef enum murk_combining {
    MURK_COMBINE_CLEAREST,   /* the sum of the `redundancy` clearest: for 0/1
                                views min(redundancy, sensors that see it) */
    MURK_COMBINE_INDEPENDENT /* clarities are chances: 1 - prod_j (1 - p_ij),
                                p = clarity / MURK_CLEAR, rounded down to a
                                clarity; one view is worth just itself */
} murk_combining;

static inline murk_combining murk_combining_of(murk_detection detection)
{
    return murk_detection_is(detection, MURK_DETECTION_BY_CHANCE)
               ? MURK_COMBINE_INDEPENDENT
               : MURK_COMBINE_CLEAREST;
}

#define MURK_REDUNDANCY_MAX 16

typedef struct murk_problem {
    size_t photons, candidates;
    const uint32_t *weight; /* [photons]; their sum, times the redundancy, is
                               below 2^47 */
    /* Fills *row, valid until the same worker's next call. Pure: the same
     * answer each time. Called from any thread, worker in [0, threads). */
    void (*get_row)(void *context, unsigned worker, size_t candidate,
                    murk_sparse_row *row);
    void *context;
    unsigned threads;
    bool is_reweighed; /* its matrix will be: photons that all see alike are
                          kept apart (murk_matrix_reweigh) */
    murk_combining combining;
    unsigned redundancy; /* views of a photon that count, 0 or 1: one, up to
                            MURK_REDUNDANCY_MAX; with INDEPENDENT all do, and
                            it is 0 or 1 */
} murk_problem;

static inline size_t murk_problem_layers(const murk_problem *problem)
{
    return problem->redundancy > 1 ? problem->redundancy : 1;
}

/* Every look of a problem, made once and kept: the known environment. Words of
 * 64 photons, a bit each, those without any left out, or lists where that is
 * less; behind it the clarities where not all are clear. */
typedef struct murk_matrix murk_matrix;

/* Fails with MURK_RUN_FAILED, naming the figures, when it would take more than
 * most_bytes. Looks once at every candidate, with progress. */
murk_status murk_matrix_create(murk_matrix **out, const murk_problem *problem,
                               uint64_t max_bytes, murk_error *err);
/* The same looks under other weights, weight[photons]: shares the rows of
 * `from`, which must outlive it. */
murk_status murk_matrix_reweigh(murk_matrix **out, const murk_matrix *from,
                                const uint32_t *weight, murk_error *err);
void murk_matrix_destroy(murk_matrix *matrix);         /* NULL is fine */
uint64_t murk_matrix_pairs(const murk_matrix *matrix); /* seen pairs */
size_t murk_matrix_memory_bytes(const murk_matrix *matrix);

#endif
