/* The constraints on a plan besides the count of sensors: classes (sensor
 * types) with minimum and maximum counts, costs and a budget, fixed sensors,
 * and conflicts between candidates. A member that is zero is no constraint.
 *
 * Without a budget a plan has exactly the wanted count of sensors. With a
 * budget a plan has at most that count. Fixed sensors belong to every plan.
 * They count towards the wanted count, their class and the budget, and their
 * conflicts hold. A fixed sensor that is paid for already has the cost 0. */
#ifndef MURK_PLACEMENT_CONSTRAINTS_H
#define MURK_PLACEMENT_CONSTRAINTS_H

#include "base/arena.h"
#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Largest cost of one candidate: sums over 1e6 candidates fit 63 bits. */
#define MURK_COST_MAX INT64_C(1000000000000)

typedef struct murk_constraints {
    size_t classes;           /* 0: no classes */
    const uint32_t *class_of; /* [candidates], each below `classes` */
    const size_t *min,
        *max;            /* [classes] smallest and largest number of sensors of
                            the class; min NULL: 0; max NULL: no maximum */
    const int64_t *cost; /* [candidates], 0 .. MURK_COST_MAX; NULL: none */
    int64_t budget;      /* maximum cost of a plan, in the same unit; 0: none */
    const size_t *fixed; /* [fixed_count] distinct candidates */
    size_t fixed_count;
    const uint32_t *site; /* [candidates] number of the site; one sensor a site;
                             NULL: no such constraint */
    const double (*position_m)[3]; /* [candidates], for spacing_m */
    double spacing_m;              /* minimum distance of two sensors */
    /* Candidate j is in conflict with conflict[conflict_first[j] ..
     * conflict_first[j+1]), which increase; conflicts must be listed for both
     * candidates. NULL: none. */
    const size_t *conflict_first; /* [candidates + 1] */
    const uint32_t *conflict;
    /* For messages only. */
    const char *const
        *class_name;  /* [classes]; NULL: messages give the number */
    double cost_unit; /* the user's cost that 1 in cost[] and budget stands for;
                         0 means 1 */
} murk_constraints;

/* Constraints, checked and indexed. Immutable while plans are searched. */
typedef struct murk_constraint_set {
    const murk_constraints *constraints;
    size_t candidates, classes;
    size_t min_sensors, max_sensors; /* limits of a plan's size, >= 1 */
    uint32_t *class_of;              /* [candidates] */
    uint32_t *site; /* [candidates] renumbered without gaps; NULL: none */
    size_t sites;
    size_t *min, *max; /* [classes]; max is at most the size of the class */
    bool *is_fixed;    /* [candidates] */
    uint32_t *by_cost; /* [candidates] by class, then by increasing cost */
    size_t
        *class_first; /* [classes + 1] first entry of each class in by_cost */
    uint64_t budget;
    bool has_budget, has_min, has_caps, has_conflicts;
    murk_arena arena;
} murk_constraint_set;

/* Checks and indexes the constraints, which are borrowed. `count` sensors are
 * wanted, or at most so many with is_max. Fails with MURK_BAD_VALUE and one
 * line if a constraint is malformed or the constraints contradict each other,
 * or with MURK_NO_MEMORY. After a failure *out owns nothing. */
murk_status murk_constraint_set_init(murk_constraint_set *out,
                                     const murk_constraints *constraints,
                                     size_t candidates, size_t count,
                                     bool is_max, murk_error *err);
void murk_constraint_set_release(murk_constraint_set *set);

/* The cost of one candidate; 0 without costs. */
static inline uint64_t murk_constraint_set_cost(const murk_constraint_set *set,
                                                uint32_t candidate)
{
    return set->constraints->cost ? (uint64_t)set->constraints->cost[candidate]
                                  : 0;
}

static inline bool murk_has_budget(const murk_constraint_set *set)
{
    return set && set->has_budget; /* NULL: no constraints */
}

static inline size_t murk_fixed_count(const murk_constraint_set *set)
{
    return set ? set->constraints->fixed_count : 0;
}

/* True if no plan may have both of two distinct candidates. */
bool murk_constraint_set_conflict(const murk_constraint_set *set, uint32_t a,
                                  uint32_t b);

/* For a candidate a that dominates candidate b in coverage: true if b may be
 * dropped, because a may take the place of b in every plan, and a plan with
 * both stays feasible without b, or can be filled up to the count again. */
bool murk_constraint_set_may_drop(const murk_constraint_set *set, uint32_t a,
                                  uint32_t b);

#endif
