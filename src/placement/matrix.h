/* The members of the coverage matrix. For use inside src/placement only. */
#ifndef MURK_PLACEMENT_MATRIX_H
#define MURK_PLACEMENT_MATRIX_H

#include "placement/row_space.h"

struct murk_matrix {
    murk_layout layout;
    size_t candidates;
    murk_row *row; /* [candidates]; read by murk_matrix_row() */
    murk_row_space *space;
    bool borrows_rows; /* row and space belong to another matrix */
    bool is_binary;    /* each row is BITS or CLEAR_LIST */
    uint64_t pairs;
};

/* The choice whether photons with equal columns are merged (placement/merge.h).
 */
typedef enum murk_merging {
    MURK_MERGE_NEVER,
    MURK_MERGE_WHERE_IT_PAYS,
    MURK_MERGE_ALWAYS
} murk_merging;

/* The row of a candidate, to be called before each reading, which brings pages
 * of a scratch file into memory. May be called from any thread. */
static inline const murk_row *murk_matrix_row(const murk_matrix *matrix,
                                              size_t candidate)
{
    const murk_row *row = &matrix->row[candidate];
    murk_row_space_read(matrix->space, row);
    return row;
}

/* murk_matrix_create() with an explicit choice. */
murk_status murk_matrix_make(murk_matrix **out, const murk_problem *problem,
                             uint64_t memory_bytes, murk_merging merging,
                             murk_error *err);

#endif
