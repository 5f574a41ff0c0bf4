/* The placement problem: the weights of the photons, and the coverage matrix.
 *
 * Entry clarity_ij of the coverage matrix tells how clearly candidate j sees
 * photon i, as a whole number 0..MURK_CLEAR. By default the entry is 0 if the
 * sightline is blocked, and otherwise the transmittance of the sightline times
 * MURK_CLEAR, rounded; another mode of detection (base/detection.h) gives
 * another entry. Placement knows no physics.
 *
 * The value of a plan is sum_i weight_i f_i. f_i is computed from the entries
 * of the plan's candidates for photon i; by default f_i is the largest of them
 * (facility location). Weights and f_i are whole numbers, so the value is an
 * exact integer sum: equal values are equal in every bit, and no sum depends on
 * the order of addition. */
#ifndef MURK_PLACEMENT_PROBLEM_H
#define MURK_PLACEMENT_PROBLEM_H

#include "base/detection.h"
#include "base/status.h"
#include "base/tally.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The clarity of an unattenuated sightline. 16 bits: rounding to a whole
 * clarity is off by half a unit at most, 7.7e-6 of MURK_CLEAR. */
#define MURK_CLEAR 65535

/* The row of one candidate in the coverage matrix, without the zero entries:
 * photon[] increases, clarity[] is 1..MURK_CLEAR. clarity NULL: all entries are
 * MURK_CLEAR. */
typedef struct murk_sparse_row {
    size_t seen;
    const uint32_t *photon;
    const uint16_t *clarity;
} murk_sparse_row;

/* The entries of a row that a search still needs, in an unknown environment. */
typedef struct murk_row_need {
    const uint64_t *entry_max; /* [photons] upper bounds on the amounts by which
                             an entry of each photon can increase the value; 0:
                             the entry may be left out */
    uint64_t
        gain_min; /* a row whose entries cannot add so much may be given up */
} murk_row_need;

/* The rule by which the entries of several sensors for one photon make f_i. */
typedef enum murk_combining {
    MURK_COMBINE_CLEAREST,   /* the sum of the `redundancy` largest entries; for
                                0/1 entries min(redundancy, sensors that see the
                                photon) */
    MURK_COMBINE_INDEPENDENT /* 1 - prod_j (1 - p_ij) with the detection
                                probabilities p = clarity / MURK_CLEAR, as a
                                whole clarity (placement/dose.h has the
                                rounding); one entry alone gives exactly its own
                                clarity */
} murk_combining;

/* The rule for a mode of detection. */
static inline murk_combining murk_combining_of(murk_detection detection)
{
    return murk_detection_is(detection, MURK_DETECTION_BY_CHANCE)
               ? MURK_COMBINE_INDEPENDENT
               : MURK_COMBINE_CLEAREST;
}

/* A chosen limit: memory of covers and time grow in proportion. */
#define MURK_REDUNDANCY_MAX 16

/* Counters of work, which ranks (base/ranks.h) add when they divide the rows.
 */
#define MURK_COUNTERS_MAX 512

typedef struct murk_counters {
    murk_tally *counter[MURK_COUNTERS_MAX]; /* [n] */
    size_t n;
} murk_counters;

/* The stored coverage matrix: the known environment. Each row has one of
 * several formats (placement/row.h). */
typedef struct murk_matrix murk_matrix;

/* How a row differs from that of a candidate of an earlier matrix: in the
 * entries of photons that the earlier matrix had not, and of those with a bit
 * in again[photons / 64]. Of all these, `come` has those that are not 0. */
typedef struct murk_row_patch {
    size_t candidate; /* number in the earlier matrix */
    const uint64_t *again;
    murk_sparse_row come;
    bool is_last; /* the earlier row is not read again */
} murk_row_patch;

/* In place of a number of a photon: the earlier matrix had not the photon. */
#define MURK_NO_PHOTON UINT32_MAX

/* Rows that are patched: murk_matrix_create() then needs not ask for all
 * entries. */
typedef struct murk_row_patches {
    murk_matrix *matrix;    /* for which murk_matrix_can_be_patched() is true;
                             * NULL: nothing is patched */
    const uint32_t *photon; /* [photons] number of the same photon there, or
                             * MURK_NO_PHOTON */
    /* As murk_problem.get_row, but for the patch of a row; false if the earlier
     * row is not known, and get_row() is then asked for the row. */
    bool (*get)(void *context, unsigned worker, size_t candidate,
                murk_row_patch *patch);
} murk_row_patches;

typedef struct murk_problem {
    size_t photons, candidates;
    const uint32_t
        *weight; /* [photons]; the sum times the redundancy is below 2^47 */
    /* Fills *row with the row of one candidate. The arrays stay valid until the
     * next call with the same worker. Each call for a candidate must give the
     * same answer. Called from any thread, with worker in [0, threads). */
    void (*get_row)(void *context, unsigned worker, size_t candidate,
                    murk_sparse_row *row);
    /* Fills *row with the entries that are needed, and perhaps others, in less
     * time than get_row; false, without a row, if the sum of need->entry_max
     * over the row is below need->gain_min. NULL: there is no such function. */
    bool (*get_part)(void *context, unsigned worker, size_t candidate,
                     const murk_row_need *need, murk_sparse_row *row);
    /* Called when no further row is asked for soon: gives back memory that only
     * rows need. Rows may be asked for afterwards. NULL: there is nothing to
     * give back. */
    void (*rest)(void *context);
    /* Adds the counters of the work of get_row() to the list, MURK_COUNTERS_MAX
     * at most. NULL: nothing is counted. */
    void (*list_counters)(void *context, murk_counters *list);
    void *context;
    unsigned threads;
    bool is_distributed; /* ranks distribute the matrix, whatever its size
                            (placement/matrix.h); for tests */
    bool has_columns;    /* murk_matrix_slot() will be asked for the photons */
    bool is_unmerged;    /* equal columns are not looked for: an earlier matrix
                            of nearly the same entries had too few */
    /* [photons] the hashes of the columns of an earlier matrix of the same
     * candidates (murk_matrix_hashes()), 0 for a photon that it had not; NULL:
     * none. Not with ranks. The hashes of this matrix are computed from them
     * by the entries in which the row that get_row() gave last differs: *gone
     * lists entries of the earlier row, *come those in their place. */
    const uint64_t *earlier_hash;
    void (*get_differences)(void *context, unsigned worker,
                            murk_sparse_row *gone, murk_sparse_row *come);
    murk_row_patches patches; /* get() has the context of get_row() */
    bool is_reweighed;        /* the matrix will get other weights
                                 (murk_matrix_reweigh), so photons with equal columns
                                 are not merged */
    murk_combining combining;
    unsigned redundancy; /* entries of a photon that count: 0 or 1 means one,
                            the maximum is MURK_REDUNDANCY_MAX; with
                            MURK_COMBINE_INDEPENDENT all entries count and the
                            redundancy is 0 or 1 */
} murk_problem;

static inline size_t murk_problem_layers(const murk_problem *problem)
{
    return problem->redundancy > 1 ? problem->redundancy : 1;
}

/* With more candidates, rows are not compared in pairs (placement/presolve.h).
 * The number of pairs grows with the square: beyond so many candidates the
 * comparisons take longer than the evaluations that they save. */
#define MURK_PRESOLVE_CANDIDATES_MAX 10000

/* Ranks (base/ranks.h) distribute a matrix of so many pairs of candidate and
 * photon: each rank keeps the rows that it has computed. A choice between two
 * measurements with 2 ranks on one machine: of 3e7 pairs the divided search
 * took half the time of a search in each rank; of some 1e7 pairs a search over
 * two conditions took ten times as long. */
#define MURK_DISTRIBUTED_PAIRS 16777216.0

static inline bool murk_matrix_spreads(double candidates, double photons,
                                       unsigned ranks)
{
    return ranks > 1 && candidates * photons >= MURK_DISTRIBUTED_PAIRS;
}

/* Asks the problem for the row of each candidate, and reports progress. Rows
 * take at most memory_bytes of memory; if the matrix is larger, the other rows
 * lie in a scratch file (base/scratch_file.h), and a note tells the sizes and
 * the time after the first rows. Results do not depend on memory_bytes. Fails
 * with MURK_RUN_FAILED, and names the sizes, if the scratch file cannot take
 * the rows; or with MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_matrix_create(murk_matrix **out, const murk_problem *problem,
                               uint64_t memory_bytes, murk_error *err);
/* The same rows with other weights, weight[photons]. Borrows the rows of
 * `from`, which must outlive *out and must have been made with is_reweighed.
 * Fails with MURK_NO_MEMORY. */
murk_status murk_matrix_reweigh(murk_matrix **out, const murk_matrix *from,
                                const uint32_t *weight, murk_error *err);
void murk_matrix_destroy(murk_matrix *matrix); /* accepts NULL */
uint64_t
murk_matrix_pairs(const murk_matrix *matrix); /* entries that are not 0 */
/* The bytes of the rows that this rank stores, in memory and in the scratch
 * file. */
size_t murk_matrix_bytes(const murk_matrix *matrix);
/* The bytes of those rows that lie in memory. */
uint64_t murk_matrix_memory(const murk_matrix *matrix);

/* The entries of a stored row by slot, of which a matrix has
 * murk_matrix_slots(): fills slot[] and clarity[], which have room for all
 * slots, with the *n entries that are not 0. False if another rank stores the
 * row. murk_matrix_slot() is the slot of a photon of the problem, with
 * has_columns only; photons with equal columns may have the same slot. May be
 * called from any thread. */
size_t murk_matrix_slots(const murk_matrix *matrix);
size_t murk_matrix_slot(const murk_matrix *matrix, uint32_t photon);
bool murk_matrix_list(uint32_t *slot, uint16_t *clarity, size_t *n,
                      const murk_matrix *matrix, size_t candidate);

/* Frees the stored row of a candidate, which is not read again. May be called
 * from any thread. */
void murk_matrix_drop(murk_matrix *matrix, size_t candidate);

/* True if a matrix for so many photons, `added` of which this one has not,
 * while it has `gone` others, may be made of patched rows: if photons were not
 * merged, all rows are here, and few photons were added since the photons were
 * last put in order. */
bool murk_matrix_can_be_patched(const murk_matrix *matrix, size_t photons,
                                size_t added, size_t gone);

/* [photons of the problem] a hash of the column of each photon, the sum of
 * words that depend on candidate and clarity; NULL unless the matrix was made
 * with has_columns and photons with equal columns were merged. */
const _Atomic uint64_t *murk_matrix_hashes(const murk_matrix *matrix);

#endif
