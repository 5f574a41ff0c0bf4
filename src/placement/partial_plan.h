/* What stands of a plan, and who may join it under the rules. */
#ifndef MURK_PLACEMENT_PARTIAL_PLAN_H
#define MURK_PLACEMENT_PARTIAL_PLAN_H

#include "placement/constraints.h"

typedef struct murk_partial_plan {
    const murk_constraint_set *set;
    size_t wanted; /* sensors that the plan is to have; with a budget at most */
    uint32_t *member; /* [size], the fixed ones first */
    size_t size;
    size_t *class_count; /* [classes] members */
    size_t missing;      /* sensors that least counts still ask for */
    uint64_t cost;
} murk_partial_plan;

murk_status murk_partial_plan_init(murk_partial_plan *out,
                                   const murk_constraint_set *set,
                                   murk_error *err);
void murk_partial_plan_release(murk_partial_plan *partial);

/* Nobody stands. wanted is at most the book's most_sensors. */
void murk_partial_plan_clear(murk_partial_plan *partial, size_t wanted);
void murk_partial_plan_add(murk_partial_plan *partial, uint32_t candidate);
void murk_partial_plan_drop_last(murk_partial_plan *partial);

/* Whether the candidate may join, with what least counts ask for still in
 * reach (certainly so where nothing excludes); with is_last, in place. */
bool murk_partial_plan_can_add(const murk_partial_plan *partial,
                               uint32_t candidate, bool is_last);

/* Whether all that is asked for stands. */
bool murk_partial_plan_is_complete(const murk_partial_plan *partial);

/* Fills what stands up to a plan, whatever it sees. False when there is none,
 * *is_sure, or when too many were tried. */
bool murk_partial_plan_complete(murk_partial_plan *partial, bool *is_sure);

#endif
