/* The members of the coverage matrix. For use inside src/placement only. */
#ifndef MURK_PLACEMENT_MATRIX_H
#define MURK_PLACEMENT_MATRIX_H

#include "placement/row.h"

struct murk_matrix {
    murk_layout layout;
    size_t candidates;
    murk_row *row; /* [candidates] */
    bool borrows_rows;
    bool is_binary; /* each row is BITS or CLEAR_LIST */
    uint64_t pairs;
    size_t memory_bytes;
};

/* The choice whether photons with equal columns are merged (placement/merge.h).
 */
typedef enum murk_merging {
    MURK_MERGE_NEVER,
    MURK_MERGE_WHERE_IT_PAYS,
    MURK_MERGE_ALWAYS
} murk_merging;

/* murk_matrix_create() with an explicit choice. */
murk_status murk_matrix_make(murk_matrix **out, const murk_problem *problem,
                             uint64_t max_bytes, murk_merging merging,
                             murk_error *err);

#endif
