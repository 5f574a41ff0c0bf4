/* A partial plan: the candidates chosen so far, with the tests whether another
 * candidate can be added and whether the plan is complete. */
#ifndef MURK_PLACEMENT_PARTIAL_PLAN_H
#define MURK_PLACEMENT_PARTIAL_PLAN_H

#include "placement/constraints.h"

typedef struct murk_partial_plan {
    const murk_constraint_set *set;
    size_t wanted; /* sensors of a complete plan; with a budget the maximum */
    uint32_t *member; /* [size], the fixed sensors first */
    size_t size;
    size_t *class_count; /* [classes] members of each class */
    size_t missing;      /* sensors that the minimum counts still need */
    uint64_t cost;
    murk_arena arena;
} murk_partial_plan;

murk_status murk_partial_plan_init(murk_partial_plan *out,
                                   const murk_constraint_set *set,
                                   murk_error *err);
void murk_partial_plan_release(murk_partial_plan *partial);

/* Makes the partial plan empty. wanted is at most the set's max_sensors. */
void murk_partial_plan_clear(murk_partial_plan *partial, size_t wanted);
void murk_partial_plan_add(murk_partial_plan *partial, uint32_t candidate);
void murk_partial_plan_drop_last(murk_partial_plan *partial);

/* True if adding the candidate keeps all constraints and leaves enough places
 * and budget for the minimum counts. The minimum counts are then reachable for
 * certain only without conflicts. With is_last the plan must also meet all
 * minimum counts after the addition. */
bool murk_partial_plan_can_add(const murk_partial_plan *partial,
                               uint32_t candidate, bool is_last);

/* True if the partial plan meets the minimum counts and has the wanted number
 * of sensors (with a budget any number). */
bool murk_partial_plan_is_complete(const murk_partial_plan *partial);

/* Completes the partial plan with any candidates, by depth-first search. False
 * if the search fails: *is_sure says that no complete plan exists; otherwise
 * the search was cut off. */
bool murk_partial_plan_complete(murk_partial_plan *partial, bool *is_sure);

#endif
