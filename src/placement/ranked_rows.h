/* Coverage rows that a search in an unknown environment caches: those of the
 * first candidates by falling upper bound on the gain (placement/evaluator.h),
 * as many as fit in a given memory. Searches evaluate candidates in that order,
 * so these rows are asked for most often. The rows that remain depend neither
 * on the order in which rows are offered nor on threads. */
#ifndef MURK_PLACEMENT_RANKED_ROWS_H
#define MURK_PLACEMENT_RANKED_ROWS_H

#include "base/arena.h"
#include "placement/row.h"

/* A candidate with an upper bound on the gain. */
typedef struct murk_ranked {
    uint64_t bound;
    uint32_t candidate;
} murk_ranked;

/* Order by falling bound, then by index, for qsort(). */
int murk_compare_ranked(const void *a, const void *b);

typedef struct murk_ranked_rows {
    murk_row *row; /* [candidates]; memory NULL: not cached */
    size_t candidates;
    size_t count; /* rows that are cached */
    uint64_t bytes, max_bytes;
    murk_ranked *heap;   /* [count] each element stands behind its two children
                            2 k + 1 and 2 k + 2 in the order; so the first one
                            is the last by rank */
    murk_ranked refused; /* the first by rank of those not cached */
    bool has_refused;
    murk_arena arena;
} murk_ranked_rows;

/* Fails with MURK_NO_MEMORY. */
murk_status murk_ranked_rows_init(murk_ranked_rows *out, size_t candidates,
                                  uint64_t max_bytes, murk_error *err);
void murk_ranked_rows_release(murk_ranked_rows *cached);

/* True if a row of this rank may become one of the cached rows. */
bool murk_ranked_rows_wants(const murk_ranked_rows *cached, murk_ranked ranked);

/* Takes over the row of a candidate, which may lack memory (row->memory NULL).
 * Each candidate is offered at most once. */
void murk_ranked_rows_offer(murk_ranked_rows *cached, murk_ranked ranked,
                            const murk_row *row);

#endif
