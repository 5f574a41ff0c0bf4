/* Checks and indexes the constraints on plans: costs, conflicts, classes,
 * counts, fixed sensors, budget. Each check refuses a contradiction that can be
 * seen before any search. Whether a plan exists under conflicts is found out by
 * a search only (murk_partial_plan_complete). */
#include "placement/constraints.h"

#include "base/sort.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct keyed {
    uint64_t key, then;
    uint32_t candidate;
} keyed;

static int by_key(const void *a, const void *b)
{
    const keyed *x = a, *y = b;
    const int key = MURK_ORDER(x->key, y->key);
    const int then = MURK_ORDER(x->then, y->then);
    return key ? key : then ? then : MURK_ORDER(x->candidate, y->candidate);
}

static bool is_too_close(const murk_constraints *constraints, uint32_t a,
                         uint32_t b)
{
    if (!(constraints->spacing_m > 0)) {
        return false;
    }
    double square = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
        const double d =
            constraints->position_m[a][axis] - constraints->position_m[b][axis];
        square += d * d;
    }
    return square < constraints->spacing_m * constraints->spacing_m;
}

/* True if b is in a's list of conflicts. */
static bool is_listed(const murk_constraints *constraints, uint32_t a,
                      uint32_t b)
{
    const size_t *first = constraints->conflict_first;
    return first && bsearch(&b, constraints->conflict + first[a],
                            first[a + 1] - first[a],
                            sizeof *constraints->conflict, murk_by_uint32);
}

/* ---- for messages ---- */

#define NAME_SIZE 80 /* longer names are cut */

static const char *class_name(const murk_constraints *constraints, size_t class,
                              char out[NAME_SIZE])
{
    if (constraints->class_name) {
        snprintf(out, NAME_SIZE, "type %s", constraints->class_name[class]);
    } else {
        snprintf(out, NAME_SIZE, "class %zu", class);
    }
    return out;
}

static double in_user_units(const murk_constraint_set *set, uint64_t cost)
{
    const double unit = set->constraints->cost_unit;
    return (double)cost * (unit > 0 ? unit : 1);
}

/* The reason for the conflict of fixed sensors i and k. */
static const char *why_excluded(const murk_constraint_set *set, size_t i,
                                size_t k)
{
    const uint32_t a = (uint32_t)set->constraints->fixed[i],
                   b = (uint32_t)set->constraints->fixed[k];
    return set->site && set->site[a] == set->site[b]
               ? "one sensor may stand at a site"
           : is_too_close(set->constraints, a, b)
               ? "they stand closer than the least spacing"
               : "they are given as a conflict";
}

bool murk_constraint_set_conflict(const murk_constraint_set *set, uint32_t a,
                                  uint32_t b)
{
    return (set->site && set->site[a] == set->site[b]) ||
           is_too_close(set->constraints, a, b) ||
           is_listed(set->constraints, a, b);
}

/* True if it is certain that every candidate that conflicts with a is b or
 * conflicts with b as well. Only a simple case is recognised: with one sensor a
 * site the result is false unless a and b have the same site, and with a
 * spacing it is false unless a and b have the same position. */
static bool has_fewer_conflicts(const murk_constraint_set *set, uint32_t a,
                                uint32_t b)
{
    const murk_constraints *constraints = set->constraints;
    if (set->site && set->site[a] != set->site[b]) {
        return false;
    }
    if (constraints->spacing_m > 0 &&
        memcmp(constraints->position_m[a], constraints->position_m[b],
               sizeof constraints->position_m[a]) != 0) {
        return false;
    }
    if (constraints->conflict_first) {
        for (size_t k = constraints->conflict_first[a];
             k < constraints->conflict_first[a + 1]; ++k) {
            const uint32_t c = constraints->conflict[k];
            if (c != b && !is_listed(constraints, b, c)) {
                return false;
            }
        }
    }
    return true;
}

bool murk_constraint_set_may_drop(const murk_constraint_set *set, uint32_t a,
                                  uint32_t b)
{
    const uint32_t class = set->class_of[a];
    if (set->is_fixed[b] || class != set->class_of[b] ||
        murk_constraint_set_cost(set, a) > murk_constraint_set_cost(set, b) ||
        !has_fewer_conflicts(set, a, b)) {
        return false;
    }
    /* A newcomer does not replace a sensor of the start plan. */
    if (set->is_start && set->is_start[b] && !set->is_start[a]) {
        return false;
    }
    /* If a and b are not in conflict, a plan may have both. A plan of exactly n
     * sensors that loses b can be filled up again for certain only if the set
     * has no conflicts; a plan within a budget need not be filled up unless the
     * class has a minimum count. */
    const bool may_go =
        set->has_budget ? set->min[class] == 0 : !set->has_conflicts;
    return may_go || murk_constraint_set_conflict(set, a, b);
}

static murk_status check_costs(const murk_constraints *constraints,
                               size_t candidates, murk_error *err)
{
    for (size_t j = 0; constraints->cost && j < candidates; ++j) {
        if (constraints->cost[j] < 0 || constraints->cost[j] > MURK_COST_MAX) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "cost of candidate %zu is %lld, must be 0..%lld",
                             j, (long long)constraints->cost[j],
                             (long long)MURK_COST_MAX);
        }
    }
    if (constraints->budget < 0) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "budget is %lld, must be 0 or more",
                         (long long)constraints->budget);
    }
    if (constraints->budget > 0 && !constraints->cost) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "budget is %lld, but no candidate has a cost",
                         (long long)constraints->budget);
    }
    return MURK_OK;
}

static murk_status check_conflicts(const murk_constraints *constraints,
                                   size_t candidates, murk_error *err)
{
    /* Spacing. */
    if (!(constraints->spacing_m >= 0 && isfinite(constraints->spacing_m))) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "spacing is %g m, must be 0 or more",
                         constraints->spacing_m);
    }
    if (constraints->spacing_m > 0 && !constraints->position_m) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "spacing is %g m, but no candidate has a position",
                         constraints->spacing_m);
    }
    if (!constraints->conflict_first) {
        return MURK_OK;
    }
    /* Lists: increasing, and listed for both candidates. */
    for (size_t j = 0; j < candidates; ++j) {
        const size_t first = constraints->conflict_first[j];
        for (size_t k = first; k < constraints->conflict_first[j + 1]; ++k) {
            const uint32_t other = constraints->conflict[k];
            if (other >= candidates || other == j ||
                (k > first && other <= constraints->conflict[k - 1]) ||
                !is_listed(constraints, other, (uint32_t)j)) {
                return murk_fail(err, MURK_BAD_VALUE, "",
                                 "conflict of candidate %zu with %u: must "
                                 "name another one below %zu, once, rising, "
                                 "and be named there, too",
                                 j, other, candidates);
            }
        }
    }
    return MURK_OK;
}

static bool allocate(murk_constraint_set *set)
{
    const size_t n = set->candidates, classes = set->classes;
    murk_arena *arena = &set->arena;
    set->class_of = murk_arena_array(arena, n, sizeof *set->class_of);
    set->min = murk_arena_array(arena, classes, sizeof *set->min);
    set->max = murk_arena_array(arena, classes, sizeof *set->max);
    set->is_fixed = murk_arena_array(arena, n, sizeof *set->is_fixed);
    set->by_cost = murk_arena_array(arena, n, sizeof *set->by_cost);
    set->class_first =
        murk_arena_array(arena, classes + 1, sizeof *set->class_first);
    if (set->constraints->site) {
        set->site = murk_arena_array(arena, n, sizeof *set->site);
    }
    if (set->constraints->start) {
        set->is_start = murk_arena_array(arena, n, sizeof *set->is_start);
    }
    return !arena->is_short;
}

/* Renumbers the sites without gaps. scratch[candidates]. */
static void index_sites(murk_constraint_set *set, keyed *scratch)
{
    for (size_t j = 0; j < set->candidates; ++j) {
        scratch[j] = (keyed){set->constraints->site[j], 0, (uint32_t)j};
    }
    qsort(scratch, set->candidates, sizeof *scratch, by_key);
    for (size_t k = 0; k < set->candidates; ++k) {
        set->sites += k == 0 || scratch[k].key != scratch[k - 1].key;
        set->site[scratch[k].candidate] = (uint32_t)(set->sites - 1);
    }
}

static void index_costs(murk_constraint_set *set, keyed *scratch)
{
    for (size_t j = 0; j < set->candidates; ++j) {
        const uint32_t class = set->class_of[j];
        scratch[j] = (keyed){class, murk_constraint_set_cost(set, (uint32_t)j),
                             (uint32_t)j};
        ++set->class_first[class + 1];
    }
    for (size_t c = 0; c < set->classes; ++c) {
        set->class_first[c + 1] += set->class_first[c];
    }
    qsort(scratch, set->candidates, sizeof *scratch, by_key);
    for (size_t k = 0; k < set->candidates; ++k) {
        set->by_cost[k] = scratch[k].candidate;
    }
}

static murk_status index_classes(murk_constraint_set *set, murk_error *err)
{
    const murk_constraints *constraints = set->constraints;
    for (size_t j = 0; constraints->classes > 0 && j < set->candidates; ++j) {
        set->class_of[j] = constraints->class_of[j];
        if (constraints->class_of[j] >= constraints->classes) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "class of candidate %zu is %u, must be below %zu",
                             j, constraints->class_of[j], constraints->classes);
        }
    }
    return MURK_OK;
}

static murk_status index_counts(murk_constraint_set *set, murk_error *err)
{
    const murk_constraints *constraints = set->constraints;
    char name[NAME_SIZE];
    for (size_t c = 0; c < set->classes; ++c) {
        /* A missing minimum is 0, a missing maximum is the size of the class.
         */
        const size_t size = set->class_first[c + 1] - set->class_first[c];
        const bool is_given = constraints->classes > 0;
        const size_t min =
            is_given && constraints->min ? constraints->min[c] : 0;
        const size_t max =
            is_given && constraints->max ? constraints->max[c] : size;
        if (min > size) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "%s must have at least %zu sensors, but has "
                             "only %zu usable candidates",
                             class_name(set->constraints, c, name), min, size);
        }
        if (min > max) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "%s must have at least %zu sensors, but at most "
                             "%zu",
                             class_name(set->constraints, c, name), min, max);
        }
        set->min[c] = min;
        set->max[c] = max < size ? max : size;
        set->has_min |= min > 0;
        set->has_caps |= max < size;
    }
    return MURK_OK;
}

static murk_status index_fixed(murk_constraint_set *set, murk_error *err)
{
    const murk_constraints *constraints = set->constraints;
    for (size_t k = 0; k < constraints->fixed_count; ++k) {
        const size_t j = constraints->fixed[k];
        /* A fixed sensor must be one of the candidates, be given once, and not
         * be in conflict with another fixed sensor. */
        if (j >= set->candidates) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "fixed sensor at candidate %zu, must be below "
                             "%zu",
                             j, set->candidates);
        }
        if (set->is_fixed[j]) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "fixed sensor at candidate %zu is given twice", j);
        }
        for (size_t i = 0; i < k; ++i) {
            if (murk_constraint_set_conflict(
                    set, (uint32_t)constraints->fixed[i], (uint32_t)j)) {
                return murk_fail(
                    err, MURK_BAD_VALUE, "",
                    "fixed sensors %zu and %zu exclude each other: "
                    "%s",
                    i, k, why_excluded(set, i, k));
            }
        }
        set->is_fixed[j] = true;
    }
    return MURK_OK;
}

/* Marks the start plan of a rule on moves. Minimum and maximum counts of
 * classes together with the rule may leave a partial plan that no sensor
 * completes, as conflicts do. */
static murk_status index_start(murk_constraint_set *set, murk_error *err)
{
    const murk_constraints *constraints = set->constraints;
    for (size_t k = 0; set->is_start && k < constraints->start_count; ++k) {
        const uint32_t j = constraints->start[k];
        if (j >= set->candidates || set->is_start[j]) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "start plan with candidate %u, must be below %zu "
                             "and be given once",
                             j, set->candidates);
        }
        set->is_start[j] = !set->is_fixed[j];
        set->starts += set->is_start[j];
    }
    set->has_conflicts |= set->is_start && (set->has_min || set->has_caps);
    return MURK_OK;
}

static size_t fixed_of_class(const murk_constraint_set *set, size_t class)
{
    size_t sum = 0;
    for (size_t k = 0; k < set->constraints->fixed_count; ++k) {
        sum += set->class_of[set->constraints->fixed[k]] == class;
    }
    return sum;
}

/* Lower bound on the cost of a plan: the fixed sensors, and the cheapest
 * candidates that fill up the minimum count of each class. Conflicts are
 * ignored. */
static uint64_t min_cost(const murk_constraint_set *set)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < set->constraints->fixed_count; ++k) {
        sum +=
            murk_constraint_set_cost(set, (uint32_t)set->constraints->fixed[k]);
    }
    for (size_t c = 0; c < set->classes; ++c) {
        size_t class_count = fixed_of_class(set, c);
        for (size_t k = set->class_first[c];
             k < set->class_first[c + 1] && class_count < set->min[c]; ++k) {
            if (!set->is_fixed[set->by_cost[k]]) {
                sum += murk_constraint_set_cost(set, set->by_cost[k]);
                ++class_count;
            }
        }
    }
    return sum;
}

static murk_status check_budget(const murk_constraint_set *set, murk_error *err)
{
    if (!set->has_budget) {
        return MURK_OK;
    }
    /* The budget must pay for all that is required, and for one sensor. */
    const uint64_t needed = min_cost(set);
    if (needed > set->budget) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "budget is %.10g, but fixed sensors and least counts "
                         "cost %.10g at least",
                         in_user_units(set, set->budget),
                         in_user_units(set, needed));
    }
    uint64_t cheapest = UINT64_MAX;
    for (uint32_t j = 0; j < set->candidates; ++j) {
        const uint64_t cost = murk_constraint_set_cost(set, j);
        cheapest = cost < cheapest ? cost : cheapest;
    }
    if (set->constraints->fixed_count == 0 && cheapest > set->budget) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "budget is %.10g, but the cheapest candidate costs "
                         "%.10g",
                         in_user_units(set, set->budget),
                         in_user_units(set, cheapest));
    }
    return MURK_OK;
}

/* Compares the wanted count with the fixed sensors, the minimum and maximum
 * counts of the classes, and the number of sites; then sets the limits of a
 * plan's size. */
static murk_status check_count(murk_constraint_set *set, size_t count,
                               bool is_max, murk_error *err)
{
    /* Sum up required and allowed sensors over the classes. */
    char name[NAME_SIZE];
    size_t needed = 0, allowed = 0;
    for (size_t c = 0; c < set->classes; ++c) {
        const size_t fixed = fixed_of_class(set, c);
        if (fixed > set->max[c]) {
            return murk_fail(err, MURK_BAD_VALUE, "",
                             "%s may have at most %zu sensors, but %zu are "
                             "fixed",
                             class_name(set->constraints, c, name), set->max[c],
                             fixed);
        }
        needed += fixed > set->min[c] ? fixed : set->min[c];
        allowed += set->max[c];
    }
    /* Compare with the wanted count. */
    if (needed > count) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%zu sensors asked for, but fixed sensors and least "
                         "counts need %zu",
                         count, needed);
    }
    if (!is_max && allowed < count) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%zu sensors asked for, but the classes' greatest "
                         "counts allow only %zu",
                         count, allowed);
    }
    if (!is_max && set->site && set->sites < count) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%zu sensors asked for, but only %zu sites, with one "
                         "sensor each",
                         count, set->sites);
    }
    /* The limits of a plan's size. */
    allowed = set->site && set->sites < allowed ? set->sites : allowed;
    set->max_sensors = count < allowed ? count : allowed;
    set->min_sensors = needed > 0 ? needed : 1;
    if (needed > set->max_sensors) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "fixed sensors and least counts need %zu sensors, "
                         "but only %zu may stand, one a site",
                         needed, set->max_sensors);
    }
    return MURK_OK;
}

murk_status murk_constraint_set_init(murk_constraint_set *out,
                                     const murk_constraints *constraints,
                                     size_t candidates, size_t count,
                                     bool is_max, murk_error *err)
{
    assert(constraints->classes == 0 || constraints->class_of);
    *out = (murk_constraint_set){
        .constraints = constraints,
        .candidates = candidates,
        .classes = constraints->classes > 0 ? constraints->classes : 1,
        .budget = constraints->budget > 0 ? (uint64_t)constraints->budget
                                          : UINT64_MAX,
        .has_budget = constraints->budget > 0,
        .has_conflicts = constraints->site || constraints->spacing_m > 0 ||
                         constraints->conflict_first};
    /* Checks that need no index come first. */
    murk_status status = check_costs(constraints, candidates, err);
    if (!status) {
        status = check_conflicts(constraints, candidates, err);
    }
    if (status) {
        return status;
    }
    /* Index and check, step by step. */
    keyed *scratch = calloc(candidates + 1, sizeof *scratch);
    status = scratch && allocate(out)
                 ? index_classes(out, err)
                 : murk_no_memory(err, "", "for the rules of %zu candidates",
                                  candidates);
    if (!status) {
        if (constraints->site) {
            index_sites(out, scratch);
        }
        index_costs(out, scratch);
        status = index_counts(out, err);
    }
    if (!status) {
        status = index_fixed(out, err);
    }
    if (!status) {
        status = index_start(out, err);
    }
    if (!status) {
        status = check_count(out, count, is_max, err);
    }
    if (!status) {
        status = check_budget(out, err);
    }
    free(scratch);
    if (status) {
        murk_constraint_set_release(out);
    }
    return status;
}

void murk_constraint_set_release(murk_constraint_set *set)
{
    murk_arena_release(&set->arena);
    *set = (murk_constraint_set){0};
}
