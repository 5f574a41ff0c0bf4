/* Searches for plans by the worst block: greedy towards a level that every
 * block is to reach, and relocation by the smallest share.
 *
 * The smallest of several coverages is not submodular: greedy on it stops at
 * the first plan for which no single sensor helps the worst block. The sum over
 * blocks of min(coverage, level) is submodular, and equals level * blocks if
 * and only if all blocks reach the level. Greedy maximises that sum.
 *
 * Source: Krause, McMahan, Guestrin, Gupta, J. Mach. Learn. Res. 9 (2008) 2761
 * (SATURATE). */
#ifndef MURK_PLACEMENT_WORST_SEARCH_H
#define MURK_PLACEMENT_WORST_SEARCH_H

#include "placement/blocks.h"
#include "placement/search.h"

#define MURK_NO_LEVEL UINT64_MAX

/* The objective of a search: sum_c factor[c] min(share_c, level); or, with
 * is_min, the smallest share, then the sum of the shares. A share here is the
 * worth of a block (placement/blocks.h). The sum of the factors is at most
 * 2^10, so the objective fits 64 bits. */
typedef struct murk_block_objective {
    bool is_min;
    uint64_t level; /* MURK_NO_LEVEL: none */
    uint64_t factor[MURK_BLOCKS_MAX];
} murk_block_objective;

extern const murk_block_objective MURK_MINIMUM_FIRST; /* is_min alone */

typedef struct murk_worst_search {
    const murk_block_layouts *layouts;
    const murk_evaluator *evaluator;
    murk_gain_scan *scan; /* borrowed: the partial plan and the cover of it */
    uint64_t value[MURK_BLOCKS_MAX]; /* of the partial plan, by block */
    uint64_t *max;  /* [candidates][blocks] upper bounds on gains */
    uint64_t *gain; /* [MURK_SCAN_CHUNK][blocks] */
    struct murk_candidate_bound *candidate_bound; /* [candidates] scratch */
    uint64_t evaluations;
} murk_worst_search;

/* The arena owns the arrays. */
murk_status murk_worst_search_init(murk_worst_search *out,
                                   const murk_block_layouts *layouts,
                                   murk_gain_scan *scan, murk_arena *arena,
                                   murk_error *err);

/* The smallest share of the plan; sets search->value, the values by block. */
uint64_t murk_worst_value(murk_worst_search *search, const uint32_t *plan,
                          size_t n);

/* Extends plan[given] to n sensors. Each step adds the candidate that increases
 * the objective most. If no candidate increases the objective, the step adds
 * the candidate that increases the smallest share most, then the sum of the
 * shares; if none increases these, any candidate that can be added. Constraints
 * as in placement/search.h: scan->size is the number of sensors. Returns the
 * smallest share. */
uint64_t murk_worst_greedy(murk_worst_search *search,
                           const murk_block_objective *objective,
                           uint32_t *plan, size_t given, size_t n);

/* Moves single sensors to increase the smallest share, then the sum of shares,
 * until no sensor moves. With a budget also adds sensors that the budget pays.
 * Returns the smallest share. */
uint64_t murk_worst_relocate(murk_worst_search *search, uint32_t *plan,
                             size_t n);

#endif
