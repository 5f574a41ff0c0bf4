/* The best plan of one count for the worst block, and its bound: starts,
 * levels, relocation, and branch and bound. */
#ifndef MURK_PLACEMENT_WORST_COUNT_H
#define MURK_PLACEMENT_WORST_COUNT_H

#include "placement/settings.h"
#include "placement/worst_bound.h"
#include "placement/worst_search.h"

typedef struct murk_worst_run {
    const murk_place_desc *desc;
    const murk_constraint_set *set;
    size_t blocks;
    murk_evaluator evaluator;
    murk_block_views views;
    murk_worst_search search;
    murk_worst_bound bound;
    size_t first, last; /* sensors tried, at least and at most */
    uint32_t *plan;     /* [last] the best of this count */
    size_t size;
    uint64_t value;
    bool has_plan;
    uint32_t *trial;    /* [last] */
    uint32_t *fallback; /* [last] */
    uint64_t upper;
    murk_place_result *result;
} murk_worst_run;

/* What all candidates reach. */
uint64_t murk_worst_ceiling(const murk_worst_run *run);

/* The best plan of n that the method finds, run->plan, and its bound. A count
 * on the way to the one asked for gets less work. `from`: a plan of one sensor
 * fewer, or NULL. */
murk_status murk_worst_count(murk_worst_run *run, size_t n, bool is_plan_asked,
                             const uint32_t *from, murk_error *err);

/* After that: branch and bound, where the method has it. */
murk_status murk_worst_branch_and_bound(murk_worst_run *run, size_t n,
                                        murk_error *err);

#endif
