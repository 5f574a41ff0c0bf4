/* The constraints on a plan besides the count of sensors: classes (sensor
 * types) with minimum and maximum counts, costs and a budget, fixed sensors,
 * and conflicts between candidates. A member that is zero is no constraint.
 *
 * Without a budget a plan has exactly the wanted count of sensors. With a
 * budget a plan has at most that count. Fixed sensors belong to every plan.
 * They count towards the wanted count, their class and the budget, and their
 * conflicts hold. A fixed sensor that is paid for already has the cost 0.
 *
 * A rule on moves compares a plan with a start plan. Of both, fixed sensors do
 * not count. A newcomer is a sensor of the plan that is not in the start plan.
 * The moves are the newcomers, or the sensors of the start plan that are not in
 * the plan, whichever are fewer: each move is a pair of one that leaves and one
 * that comes. Newcomers beyond the pairs are additions, and sensors that leave
 * beyond the pairs are removed; neither is a move. So a plan of n sensors, with
 * s in the start plan, may have max(0, n - s) newcomers without a move. */
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
    /* The rule on moves, for plans without a budget. The start plan; NULL: no
     * rule. */
    const uint32_t *start; /* [start_count] distinct candidates */
    size_t start_count;
    size_t moves_max; /* maximum number of moves; SIZE_MAX: any number */
    double move_cost; /* value that each move costs, as a share 0..1 of the
                         value of a plan that sees everything */
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
    bool has_budget, has_min, has_caps, has_conflicts; /* has_conflicts: some
                        partial plans cannot be completed */
    bool *is_start; /* [candidates] in the start plan and not fixed; NULL: there
                       is no rule on moves */
    size_t starts;  /* candidates in the start plan and not fixed */
    uint64_t move_cost; /* constraints->move_cost as a value, by
                           murk_place_run_begin() */
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

static inline bool murk_has_moves(const murk_constraint_set *set)
{
    return set && set->is_start; /* NULL: no constraints */
}

/* True if the candidate would be a newcomer. False without a rule on moves. */
static inline bool murk_is_newcomer(const murk_constraint_set *set,
                                    uint32_t candidate)
{
    return set->is_start && !set->is_start[candidate] &&
           !set->is_fixed[candidate];
}

/* The newcomers of a plan of n sensors that are additions and not moves. */
static inline size_t murk_additions(const murk_constraint_set *set, size_t n)
{
    const size_t stay = set->constraints->fixed_count + set->starts;
    return n > stay ? n - stay : 0;
}

/* The cost of so many moves, as a value; UINT64_MAX where that would overflow.
 */
static inline uint64_t murk_cost_of_moves(const murk_constraint_set *set,
                                          size_t moves)
{
    return set->move_cost > 0 && moves > UINT64_MAX / set->move_cost
               ? UINT64_MAX
               : moves * set->move_cost;
}

/* The value less the cost of `moves` moves, or 0. */
static inline uint64_t murk_less_moves(const murk_constraint_set *set,
                                       uint64_t value, size_t moves)
{
    const uint64_t cost = murk_cost_of_moves(set, moves);
    return value > cost ? value - cost : 0;
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
