/* The partial plan under constraints: counts by class, cost and members are
 * kept up to date, so a test of a candidate takes time in proportion to the
 * plan's size. If a budget must leave enough for minimum counts, the test also
 * goes through the cheapest candidates of the classes. */
#include "placement/partial_plan.h"

#include "base/interrupt.h"

#include <assert.h>
#include <string.h>

/* Candidates tried before the search for a complete plan gives up (a choice).
 */
#define TRIES_MAX 2000000u

murk_status murk_partial_plan_init(murk_partial_plan *out,
                                   const murk_constraint_set *set,
                                   murk_error *err)
{
    *out = (murk_partial_plan){.set = set};
    out->member = murk_arena_array(&out->arena, set->max_sensors + 1,
                                   sizeof *out->member);
    out->class_count =
        murk_arena_array(&out->arena, set->classes, sizeof *out->class_count);
    if (out->arena.is_short) {
        murk_partial_plan_release(out);
        return murk_no_memory(err, "", "for %zu sensors", set->max_sensors);
    }
    murk_partial_plan_clear(out, set->max_sensors);
    return MURK_OK;
}

void murk_partial_plan_release(murk_partial_plan *partial)
{
    murk_arena_release(&partial->arena);
    *partial = (murk_partial_plan){0};
}

void murk_partial_plan_clear(murk_partial_plan *s, size_t wanted)
{
    assert(wanted <= s->set->max_sensors);
    s->wanted = wanted;
    s->size = 0;
    s->cost = 0;
    s->newcomers = 0;
    s->missing = 0;
    memset(s->class_count, 0, s->set->classes * sizeof *s->class_count);
    for (size_t c = 0; c < s->set->classes; ++c) {
        s->missing += s->set->min[c];
    }
}

void murk_partial_plan_add(murk_partial_plan *s, uint32_t candidate)
{
    const uint32_t class = s->set->class_of[candidate];
    s->missing -= s->class_count[class] < s->set->min[class];
    ++s->class_count[class];
    s->cost += murk_constraint_set_cost(s->set, candidate);
    s->newcomers += murk_is_newcomer(s->set, candidate);
    s->member[s->size++] = candidate;
}

void murk_partial_plan_drop_last(murk_partial_plan *s)
{
    const uint32_t candidate = s->member[--s->size];
    const uint32_t class = s->set->class_of[candidate];
    --s->class_count[class];
    s->missing += s->class_count[class] < s->set->min[class];
    s->cost -= murk_constraint_set_cost(s->set, candidate);
    s->newcomers -= murk_is_newcomer(s->set, candidate);
}

static bool is_member(const murk_partial_plan *s, uint32_t candidate)
{
    for (size_t k = 0; k < s->size; ++k) {
        if (s->member[k] == candidate) {
            return true;
        }
    }
    return false;
}

/* The smallest cost of the candidates that the minimum counts still need after
 * the candidate is added. Conflicts are ignored. */
static uint64_t min_remaining_cost(const murk_partial_plan *s,
                                   uint32_t candidate)
{
    const murk_constraint_set *set = s->set;
    uint64_t sum = 0;
    for (size_t c = 0; c < set->classes; ++c) {
        size_t class_count =
            s->class_count[c] + (set->class_of[candidate] == c);
        for (size_t k = set->class_first[c];
             k < set->class_first[c + 1] && class_count < set->min[c]; ++k) {
            const uint32_t j = set->by_cost[k];
            if (j != candidate && !is_member(s, j)) {
                sum += murk_constraint_set_cost(set, j);
                ++class_count;
            }
        }
    }
    return sum;
}

bool murk_partial_plan_can_add(const murk_partial_plan *s, uint32_t candidate,
                               bool is_last)
{
    const murk_constraint_set *set = s->set;
    const uint32_t class = set->class_of[candidate];
    /* Counts: the class, the plan, and the places for minimum counts. */
    const size_t missing =
        s->missing - (s->class_count[class] < set->min[class] ? 1 : 0);
    if (s->class_count[class] >= set->max[class] ||
        s->size + 1 + missing > s->wanted || (is_last && missing > 0)) {
        return false;
    }
    /* Moves. */
    if (murk_is_newcomer(set, candidate) &&
        murk_moves_with(s, s->newcomers + 1) > set->constraints->moves_max) {
        return false;
    }
    /* Budget, with a reserve for minimum counts. */
    if (set->has_budget) {
        const uint64_t cost =
            s->cost + murk_constraint_set_cost(set, candidate);
        if (cost > set->budget ||
            (missing > 0 &&
             cost + min_remaining_cost(s, candidate) > set->budget)) {
            return false;
        }
    }
    /* Members and conflicts. */
    if (is_member(s, candidate)) {
        return false;
    }
    for (size_t k = 0; set->has_conflicts && k < s->size; ++k) {
        if (murk_constraint_set_conflict(set, candidate, s->member[k])) {
            return false;
        }
    }
    return true;
}

bool murk_partial_plan_is_complete(const murk_partial_plan *s)
{
    return s->missing == 0 && (s->set->has_budget || s->size == s->wanted);
}

bool murk_partial_plan_complete(murk_partial_plan *s, bool *is_sure)
{
    const uint32_t candidates = (uint32_t)s->set->candidates;
    const size_t first = s->size;
    uint32_t j = 0;
    *is_sure = true;
    /* Add candidates in order of their index; at the end of the list,
     * backtrack. */
    for (uint32_t tries = 0; !murk_partial_plan_is_complete(s); ++tries) {
        if (tries == TRIES_MAX || (tries % 4096 == 0 && murk_interrupted())) {
            *is_sure = false;
            return false;
        }
        if (j < candidates) {
            if (murk_partial_plan_can_add(s, j, false)) {
                murk_partial_plan_add(s, j);
            }
            ++j;
            continue;
        }
        if (s->size == first) {
            return false;
        }
        j = s->member[s->size - 1] +
            1; /* backtrack: the last choice leads to no complete plan */
        murk_partial_plan_drop_last(s);
    }
    return true;
}
