/* The plans that searches begin with: the fixed sensors, then candidates drawn
 * at random, or those of a given list. Under constraints each added candidate
 * keeps the constraints, and a plan that cannot be completed is replaced by the
 * fallback plan (placement/scan.h). */
#include "placement/search.h"

#include "base/rng.h"

#include <string.h>

size_t murk_search_begin(murk_gain_scan *s, uint32_t *plan, size_t given,
                         size_t n)
{
    const murk_constraint_set *set = s->evaluator->set;
    if (!set) {
        return given;
    }
    murk_partial_plan_clear(&s->partial,
                            set->has_budget ? set->max_sensors : n);
    s->is_move = false;
    const size_t fixed = set->constraints->fixed_count;
    for (size_t k = given; k < fixed; ++k) {
        plan[k] = (uint32_t)set->constraints->fixed[k];
    }
    return given > fixed ? given : fixed;
}

/* Draws entry k of a random permutation of 0..m-1 (Fisher-Yates), after all
 * entries before it; k < m. */
static uint32_t draw_next(uint32_t *shuffle, size_t m, uint32_t k,
                          uint32_t seed, uint64_t restart)
{
    uint32_t word[4];
    murk_random_words(seed, MURK_SPOQ_START, restart, k, 0, word);
    const uint32_t at = k + murk_random_below(word[0], (uint32_t)m - k);
    const uint32_t drawn = shuffle[at];
    shuffle[at] = shuffle[k];
    return drawn;
}

/* Begins a plan with the fixed sensors, which also become the partial plan.
 * Returns their number. */
static size_t begin_with_fixed(murk_gain_scan *s, uint32_t *plan, size_t n)
{
    const size_t size = murk_search_begin(s, plan, 0, n);
    for (size_t k = 0; k < size; ++k) {
        murk_partial_plan_add(&s->partial, plan[k]);
    }
    return size;
}

/* Adds a candidate to plan[size] and, with constraints, to the partial plan,
 * if the constraints admit it. Returns the new size. */
static size_t add_if_possible(murk_gain_scan *s, uint32_t *plan, size_t size,
                              uint32_t candidate)
{
    if (!s->evaluator->set) {
        plan[size++] = candidate;
    } else if (murk_gain_scan_can_add(s, candidate)) {
        plan[size++] = candidate;
        murk_partial_plan_add(&s->partial, candidate);
    }
    return size;
}

/* With constraints: if the partial plan is not complete, puts the fallback plan
 * in plan[]. Returns the number of sensors. */
static size_t or_fallback(const murk_gain_scan *s, uint32_t *plan, size_t size)
{
    if (!s->evaluator->set || murk_partial_plan_is_complete(&s->partial)) {
        return size;
    }
    memcpy(plan, s->fallback, s->fallback_size * sizeof *plan);
    return s->fallback_size;
}

/* Adds candidates in random order; with constraints, those that can be added.
 * If that does not complete a plan, returns the fallback plan. */
size_t murk_search_draw(murk_gain_scan *s, uint32_t *plan, size_t n,
                        uint32_t seed, uint64_t restart)
{
    const size_t m = s->evaluator->candidates;
    size_t size = begin_with_fixed(s, plan, n);
    /* Draw until the plan has the wanted size. */
    const size_t wanted = s->evaluator->set ? s->partial.wanted : n;
    for (uint32_t k = 0; k < m; ++k) {
        s->shuffle[k] = k;
    }
    for (uint32_t k = 0; k < m && size < wanted; ++k) {
        size = add_if_possible(s, plan, size,
                               draw_next(s->shuffle, m, k, seed, restart));
    }
    return or_fallback(s, plan, size);
}

size_t murk_search_begin_at(murk_gain_scan *s, uint32_t *plan, size_t n,
                            const uint32_t *list, size_t given, size_t *taken)
{
    const murk_constraint_set *set = s->evaluator->set;
    /* The fixed sensors come first, then those of the list that can be added.
     */
    size_t size = begin_with_fixed(s, plan, n), of_list = 0;
    for (size_t k = 0; k < given && (set || size < n); ++k) {
        const size_t before = size;
        size = add_if_possible(s, plan, size, list[k]);
        of_list += size > before || (set && set->is_fixed[list[k]]);
    }
    /* Complete the plan. */
    if (murk_has_budget(set)) {
        murk_search_budget_greedy(s, plan, size);
    } else {
        murk_search_greedy(s, plan, size, n, UINT64_MAX, NULL);
    }
    const bool is_complete = !set || murk_partial_plan_is_complete(&s->partial);
    *taken = is_complete ? of_list : 0;
    return or_fallback(s, plan, s->size);
}
