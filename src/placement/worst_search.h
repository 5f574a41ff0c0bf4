/* Finding plans by their worst block: greedy towards a level that every block
 * is to reach, and relocation by the least covered block.
 *
 * The least of several coverages is not submodular, and greedy on it alone
 * stops where no single sensor helps the worst block. The sum over blocks of
 * min(coverage, level) is submodular, and is level * blocks exactly where all
 * reach the level: that is what greedy climbs.
 *
 * Source: Krause, McMahan, Guestrin, Gupta, J. Mach. Learn. Res. 9 (2008)
 * 2761 (SATURATE). */
#ifndef MURK_PLACEMENT_WORST_SEARCH_H
#define MURK_PLACEMENT_WORST_SEARCH_H

#include "placement/blocks.h"
#include "placement/search.h"

/* What a plan is worth to a search, the first part counting most. */
typedef struct murk_objective_value {
    uint64_t first, second;
} murk_objective_value;

#define MURK_NO_LEVEL UINT64_MAX

/* What a search climbs: sum_c factor[c] min(share_c, level); or, with is_least,
 * the least share, then the sum of all. Factors are at most 2^7. */
typedef struct murk_block_objective {
    bool is_min;
    uint64_t level; /* MURK_NO_LEVEL: none */
    uint64_t factor[MURK_BLOCKS_MAX];
} murk_block_objective;

typedef struct murk_worst_search {
    const murk_block_views *views;
    const murk_evaluator *evaluator;
    murk_cover cover;                /* of what stands */
    uint64_t value[MURK_BLOCKS_MAX]; /* of what stands, by block */
    murk_partial_plan partial;       /* with rules */
    uint64_t *max;                   /* [candidates][n] no gain is more */
    uint64_t *gain;                  /* [a chunk][n] */
    uint32_t *chunk;
    struct murk_candidate_bound *candidate_bound; /* [candidates] */
    murk_gain_scan draw;                          /* random starts */
    size_t size; /* sensors of the plan last made */
    uint64_t evaluations;
    const uint32_t *fallback; /* with conflicts: a plan for dead ends */
    size_t fallback_size;
} murk_worst_search;

murk_status murk_worst_search_init(murk_worst_search *out,
                                   const murk_block_views *views,
                                   murk_error *err);
void murk_worst_search_release(murk_worst_search *search);

/* The least share of the plan; its values by block in search->value. */
uint64_t murk_worst_value(murk_worst_search *search, const uint32_t *plan,
                          size_t n);

/* Extends the first `given` of plan to n, each the one that climbs most; who
 * climbs nothing is chosen by the least share. Under rules as in
 * placement/search.h: search->size says how many there are. Returns the least
 * share. */
uint64_t murk_worst_greedy(murk_worst_search *search,
                           const murk_block_objective *objective,
                           uint32_t *plan, size_t given, size_t n);

/* Moves single sensors to where the least share, then the sum of shares, is
 * most, until none moves; with a budget also adds who can be paid. */
uint64_t murk_worst_relocate(murk_worst_search *search, uint32_t *plan,
                             size_t n);

/* A random plan of n, or under rules as many as there may be. */
void murk_worst_draw(murk_worst_search *search, uint32_t *plan, size_t n,
                     uint32_t seed, uint64_t restart);

#endif
