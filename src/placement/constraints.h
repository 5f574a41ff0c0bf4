/* What a plan must keep to, beside its count: classes with least and greatest
 * counts, costs and a budget, fixed sensors, and candidates that exclude each
 * other. Everything that is zero is no rule.
 *
 * Without a budget a plan has exactly the count asked for; with one it has as
 * many sensors as pay, at most that count. Fixed sensors are in every plan and
 * count: in the count, in their class, in the budget (cost 0: already paid),
 * and against those that they exclude. */
#ifndef MURK_PLACEMENT_CONSTRAINTS_H
#define MURK_PLACEMENT_CONSTRAINTS_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_COST_MAX INT64_C(1000000000000) /* of one candidate */

typedef struct murk_constraints {
    size_t classes;           /* 0: no classes */
    const uint32_t *class_of; /* [candidates], each below classes */
    const size_t *min, *max;  /* [classes] sensors; NULL: 0, any number */
    const int64_t *cost;      /* [candidates], 0 .. MURK_COST_MAX; NULL: none */
    int64_t budget;           /* cost of a plan at most, in the same unit */
    const size_t *fixed;      /* [fixed_count] distinct candidates */
    size_t fixed_count;
    const uint32_t *site; /* [candidates] one sensor a site; NULL: none */
    const double (*position_m)[3]; /* [candidates], for spacing_m */
    double spacing_m;              /* no two sensors closer than this */
    /* Candidate j excludes conflict[conflict_first[j] .. conflict_first[j+1]),
     * rising, and is excluded by each of them. NULL: none. */
    const size_t *conflict_first; /* [candidates + 1] */
    const uint32_t *conflict;
    /* For messages. */
    const char *const *class_name; /* [classes]; NULL: by number */
    double cost_unit;              /* of costs and budget as told; 0: 1 */
} murk_constraints;

/* Rules, checked and indexed. Immutable while plans are searched. */
typedef struct murk_constraint_set {
    const murk_constraints *constraints;
    size_t candidates, classes;
    size_t min_sensors, max_sensors; /* that a plan may have, >= 1 */
    uint32_t *class_of;              /* [candidates] */
    uint32_t *site;                  /* [candidates] below sites; NULL: none */
    size_t sites;
    size_t *min, *max;   /* [classes]; most at most the class's size */
    bool *is_fixed;      /* [candidates] */
    uint32_t *by_cost;   /* [candidates] class by class, cheapest first */
    size_t *class_first; /* [classes + 1] into by_cost */
    uint64_t budget;
    bool has_budget, has_min, has_caps, has_conflicts;
} murk_constraint_set;

/* Refuses, in one line, rules that contradict each other. `count` sensors are
 * wanted; with is_most, at most so many. Borrows the rules. */
murk_status murk_constraint_set_init(murk_constraint_set *out,
                                     const murk_constraints *constraints,
                                     size_t candidates, size_t count,
                                     bool is_max, murk_error *err);
void murk_constraint_set_release(murk_constraint_set *set);

static inline uint64_t murk_constraint_set_cost(const murk_constraint_set *set,
                                                uint32_t candidate)
{
    return set->constraints->cost ? (uint64_t)set->constraints->cost[candidate]
                                  : 0;
}

/* Whether two distinct candidates exclude each other. */
bool murk_constraint_set_conflict(const murk_constraint_set *set, uint32_t a,
                                  uint32_t b);

/* Whether b, which sees no more than a, is needed in no plan: wherever it may
 * stand a may, too, and where both stand b may go, or serve to fill. */
bool murk_constraint_set_may_drop(const murk_constraint_set *set, uint32_t a,
                                  uint32_t b);

#endif
