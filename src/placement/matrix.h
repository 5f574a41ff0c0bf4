/* The members of the coverage matrix. For use inside src/placement only.
 *
 * With ranks (base/ranks.h) a large matrix is distributed: a rank stores the
 * rows of its own candidates (murk_row_is_own()) alone, so memory and the
 * evaluation of gains are divided. Everything else, counts and sums of the
 * whole matrix included, is the same in all ranks. Each evaluation of gains is
 * an exchange then, so all ranks have the rows of a small matrix, and search
 * alone. */
#ifndef MURK_PLACEMENT_MATRIX_H
#define MURK_PLACEMENT_MATRIX_H

#include "placement/row_exchange.h"
#include "placement/row_space.h"

struct murk_matrix {
    murk_layout layout;
    size_t candidates;
    murk_row *row; /* [candidates]; read by murk_matrix_row() */
    murk_row_space *space;
    bool borrows_rows; /* row and space belong to another matrix */
    bool is_binary;    /* each row is BITS or CLEAR_LIST */
    bool is_distributed;
    uint32_t *representative;   /* [photons of the problem] the number of each
                                   photon in the layout; NULL: the photons
                                   were not merged, or nobody asks */
    _Atomic uint64_t *hash;     /* [photons of the problem] of the columns;
                                   NULL: not computed, or nobody asks */
    murk_fetched_rows *fetched; /* of a distributed matrix; of another matrix if
                                   borrows_rows */
    uint64_t pairs;             /* entries of all rows that are not 0 */
    uint64_t bytes;             /* of all rows */
};

/* The choice whether photons with equal columns are merged (placement/merge.h).
 */
typedef enum murk_merging {
    MURK_MERGE_NEVER,
    MURK_MERGE_WHERE_IT_PAYS,
    MURK_MERGE_ALWAYS
} murk_merging;

/* True if this rank stores the row. */
static inline bool murk_matrix_has(const murk_matrix *matrix, size_t candidate)
{
    return !matrix->is_distributed || murk_row_is_own(candidate);
}

/* The row of a candidate that this rank stores, to be called before each
 * reading, which brings pages of a scratch file into memory. May be called from
 * any thread. */
static inline const murk_row *murk_matrix_row(const murk_matrix *matrix,
                                              size_t candidate)
{
    const murk_row *row = &matrix->row[candidate];
    murk_row_space_read(matrix->space, row);
    return row;
}

/* The row of any candidate of a distributed matrix (murk_fetched_rows_get()).
 * Collective. */
static inline murk_row murk_matrix_fetch(const murk_matrix *matrix,
                                         size_t candidate)
{
    return murk_fetched_rows_get(matrix->fetched, matrix->row, matrix->space,
                                 candidate);
}

/* murk_matrix_create() with an explicit choice. */
murk_status murk_matrix_make(murk_matrix **out, const murk_problem *problem,
                             uint64_t memory_bytes, murk_merging merging,
                             murk_error *err);

#endif
