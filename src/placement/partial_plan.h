/* A partial plan: the candidates chosen so far, with the tests whether another
 * candidate can be added and whether the plan is complete. */
#ifndef MURK_PLACEMENT_PARTIAL_PLAN_H
#define MURK_PLACEMENT_PARTIAL_PLAN_H

#include "placement/constraints.h"

typedef struct murk_partial_plan {
    const murk_constraint_set *set;
    size_t wanted;    /* sensors of a complete plan; with a budget the largest
                         number */
    uint32_t *member; /* [size], in the order in which they were added; callers
                         add the fixed sensors first */
    size_t size;
    size_t *class_count; /* [classes] members of each class */
    size_t missing;      /* sensors that the minimum counts still need */
    uint64_t cost;
    size_t newcomers; /* members that a rule on moves counts as newcomers */
    murk_arena arena;
} murk_partial_plan;

/* Makes an empty partial plan for plans of set->max_sensors sensors. Borrows
 * the set. Fails with MURK_NO_MEMORY; *out then owns nothing. */
murk_status murk_partial_plan_init(murk_partial_plan *out,
                                   const murk_constraint_set *set,
                                   murk_error *err);
void murk_partial_plan_release(murk_partial_plan *partial);

/* Removes all members, fixed sensors too, and sets the number of sensors of a
 * complete plan (with a budget: the largest number). `wanted` must not exceed
 * set->max_sensors. */
void murk_partial_plan_clear(murk_partial_plan *partial, size_t wanted);
/* Adds a candidate without a test of the constraints. drop_last removes the
 * member that was added last; there must be one. */
void murk_partial_plan_add(murk_partial_plan *partial, uint32_t candidate);
void murk_partial_plan_drop_last(murk_partial_plan *partial);

/* The moves of a partial plan with so many newcomers, if it is completed by
 * sensors of the start plan as far as they go. */
static inline size_t murk_moves_with(const murk_partial_plan *partial,
                                     size_t newcomers)
{
    const size_t additions = murk_additions(partial->set, partial->wanted);
    return newcomers > additions ? newcomers - additions : 0;
}

/* True if the candidate is no member, adding it keeps all constraints, and
 * enough places and budget are left for the minimum counts. If candidates may
 * be in conflict, the minimum counts may still turn out not to be reachable.
 * With is_last the plan must also meet all minimum counts after the
 * addition. */
bool murk_partial_plan_can_add(const murk_partial_plan *partial,
                               uint32_t candidate, bool is_last);

/* True if the partial plan meets the minimum counts and has the wanted number
 * of sensors (with a budget any number). */
bool murk_partial_plan_is_complete(const murk_partial_plan *partial);

/* Adds any candidates that complete the partial plan, by depth-first search.
 * Returns false if the search fails: *is_sure is true if no complete plan
 * contains the partial plan, and false if a limit on the work or an interrupt
 * ended the search, which leaves members added. */
bool murk_partial_plan_complete(murk_partial_plan *partial, bool *is_sure);

#endif
