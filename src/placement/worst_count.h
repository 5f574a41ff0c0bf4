/* The best plan of one count for the worst block, and its bound: levels,
 * starts, relocation, and branch and bound. */
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
    murk_block_layouts layouts;
    murk_worst_search search;
    murk_worst_bound bound;
    size_t first, last; /* smallest and largest count tried */
    uint32_t *plan;     /* [last] the incumbent of this count */
    size_t size;
    uint64_t value;
    bool has_plan;
    uint32_t *trial;    /* [last] scratch */
    uint32_t *fallback; /* [last] with conflicts: any feasible plan */
    uint64_t upper;
    murk_place_result *result;
} murk_worst_run;

/* The smallest worth of the blocks with all candidates chosen. */
uint64_t murk_worst_ceiling(const murk_worst_run *run);

/* Finds the best plan of n sensors by the method of run->desc, run->plan, and a
 * bound. A count below the wanted one (is_plan_asked false) gets less work.
 * `from`: a plan of one sensor fewer, or NULL. */
murk_status murk_worst_count(murk_worst_run *run, size_t n, bool is_plan_asked,
                             const uint32_t *from, murk_error *err);

/* After murk_worst_count(): branch and bound, if the method has it. */
murk_status murk_worst_branch_and_bound(murk_worst_run *run, size_t n,
                                        murk_error *err);

#endif
