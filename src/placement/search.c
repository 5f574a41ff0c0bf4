/* Greedy, SPOQ and certified relocation (placement/search.h). All are made of
 * scans over a partial plan (placement/scan.h). Random numbers are addressed by
 * seed, start and step, so a start gives the same plan in any thread. */
#include "placement/search.h"

#include "base/interrupt.h"
#include "base/rng.h"

#include <stdlib.h>
#include <string.h>

#define CHUNK MURK_SCAN_CHUNK

/* Lowers greedy_bound by the ranking over a partial plan worth `value`. Every
 * candidate adds at most its bound in the ranking, so k more candidates add at
 * most the sum of the k largest bounds. (With detection probabilities, k
 * candidates that see one photon may together add more than the sum of their
 * gains, by rounding: less than 1.02 (k + 1) clarities. Each bound includes a
 * slack of 2 clarities for that.) */
static void lower_greedy_bounds(murk_gain_scan *s, uint64_t value)
{
    const size_t n = s->evaluator->undominated;
    uint64_t max = value;
    for (size_t k = 0; k < s->greedy_bound_count; ++k) {
        max = murk_sum_saturated(max, k < n ? s->ranking[k].bound : 0);
        s->greedy_bound[k] =
            max < s->greedy_bound[k] ? max : s->greedy_bound[k];
    }
}

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

/* True if a plan under a budget is complete and the last gain is 0. */
static bool is_enough(const murk_gain_scan *s, uint64_t gain)
{
    return gain == 0 && murk_has_budget(s->evaluator->set) &&
           s->partial.missing == 0;
}

uint64_t murk_search_greedy(murk_gain_scan *s, uint32_t *plan, size_t given,
                            size_t n, uint64_t enough, uint64_t *value_after)
{
    const murk_evaluator *o = s->evaluator;
    memcpy(s->ranking, o->ranked, o->candidates * sizeof *s->ranking);
    /* The given sensors form the partial plan. */
    given = murk_search_begin(s, plan, given, n);
    uint64_t value = murk_gain_scan_set_all_but(s, plan, given, given);
    if (value_after && given > 0) {
        value_after[given - 1] = value;
    }
    s->size = given;
    for (size_t k = given; k < n && value < enough && !murk_interrupted();
         ++k) {
        const uint64_t gain = murk_gain_scan_find_best(s, s->ranking, value);
        if (s->ties == 0 || is_enough(s, gain)) {
            break;
        }
        /* Add the best candidate, and lower the bounds by the gains of the
         * scan. */
        s->size = k + 1;
        plan[k] = s->tie[0];
        murk_gain_scan_add(s, plan[k]);
        murk_gain_scan_update_bounds(s);
        lower_greedy_bounds(s, value);
        value += gain;
        if (value_after) {
            value_after[k] = value;
        }
    }
    return value;
}

/* Finds the candidate with the largest gain per cost; gain 0 if no candidate
 * has one. Evaluates in falling order of an upper bound, until the bound falls
 * below the best; s->priced keeps the computed gains as bounds. */
static murk_priced find_best_density(murk_gain_scan *s)
{
    const size_t n = s->evaluator->candidates;
    murk_priced best = {.gain = 0};
    qsort(s->priced, n, sizeof *s->priced, murk_compare_density);
    for (size_t k = 0; k < n && s->priced[k].gain > 0 && !murk_interrupted();) {
        size_t place[CHUNK], gathered = 0;
        /* Gather candidates that may be the best. */
        for (; k < n && gathered < CHUNK && s->priced[k].gain > 0; ++k) {
            if (best.gain > 0 &&
                murk_compare_density(&s->priced[k], &best) > 0) {
                break;
            }
            if (murk_gain_scan_can_add(s, s->priced[k].candidate)) {
                place[gathered] = k;
                s->chunk[gathered++] = s->priced[k].candidate;
            }
        }
        if (gathered == 0) {
            break;
        }
        /* Evaluate them. */
        murk_gain_scan_evaluate(s, gathered, 0);
        for (size_t i = 0; i < gathered; ++i) {
            murk_priced *later = &s->priced[place[i]];
            murk_priced now = *later;
            now.gain = s->chunk_gain[i];
            later->gain = now.gain + murk_gain_scan_slack(s, now.candidate);
            if (now.gain > 0 &&
                (best.gain == 0 || murk_compare_density(&now, &best) < 0)) {
                best = now;
            }
        }
    }
    return best;
}

/* The cheapest candidate that can be added in the first class whose minimum
 * count is not reached; false if there is none. */
static bool find_required(const murk_gain_scan *s, uint32_t *candidate)
{
    const murk_constraint_set *set = s->evaluator->set;
    for (size_t c = 0; c < set->classes; ++c) {
        for (size_t k = set->class_first[c];
             k < set->class_first[c + 1] &&
             s->partial.class_count[c] < set->min[c];
             ++k) {
            if (murk_gain_scan_can_add(s, set->by_cost[k])) {
                *candidate = set->by_cost[k];
                return true;
            }
        }
    }
    return false;
}

uint64_t murk_search_budget_greedy(murk_gain_scan *s, uint32_t *plan,
                                   size_t given)
{
    const murk_evaluator *o = s->evaluator;
    size_t n = murk_search_begin(s, plan, given, o->set->max_sensors);
    uint64_t value = murk_gain_scan_set_all_but(s, plan, n, n);
    for (uint32_t j = 0; j < o->candidates; ++j) {
        s->priced[j] = (murk_priced){murk_evaluator_gain_bound(o, j),
                                     murk_constraint_set_cost(o->set, j), j};
    }
    while (n < o->set->max_sensors && !murk_interrupted()) {
        const murk_priced best = find_best_density(s);
        plan[n] = best.candidate;
        if (best.gain == 0 && !find_required(s, &plan[n])) {
            break;
        }
        value += best.gain;
        murk_gain_scan_add(s, plan[n++]);
    }
    s->size = n;
    return value;
}

static void fill_with_numbers(uint32_t *order, size_t n)
{
    for (uint32_t k = 0; k < n; ++k) {
        order[k] = k;
    }
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

/* A random order of 0..n-1 for one sweep (Fisher-Yates). */
static void draw_order(uint32_t *order, size_t n, uint32_t seed,
                       uint64_t restart, uint32_t sweep)
{
    fill_with_numbers(order, n);
    for (uint32_t k = 0; k + 1 < n; ++k) {
        uint32_t word[4];
        murk_random_words(seed, MURK_SPOQ_ORDER, restart, sweep, k, word);
        const uint32_t at = k + murk_random_below(word[0], (uint32_t)n - k);
        const uint32_t held = order[at];
        order[at] = order[k];
        order[k] = held;
    }
}

/* Adds candidates in random order; with constraints, those that can be added.
 * If that does not complete a plan, returns the fallback plan. */
size_t murk_search_draw(murk_gain_scan *s, uint32_t *plan, size_t n,
                        uint32_t seed, uint64_t restart)
{
    const size_t m = s->evaluator->candidates;
    const bool is_constrained = s->evaluator->set;
    size_t size = murk_search_begin(s, plan, 0, n);
    for (size_t k = 0; k < size; ++k) {
        murk_partial_plan_add(&s->partial, plan[k]);
    }
    /* Draw until the plan has the wanted size. */
    const size_t wanted = is_constrained ? s->partial.wanted : n;
    fill_with_numbers(s->shuffle, m);
    for (uint32_t k = 0; k < m && size < wanted; ++k) {
        const uint32_t candidate = draw_next(s->shuffle, m, k, seed, restart);
        if (!is_constrained) {
            plan[size++] = candidate;
        } else if (murk_gain_scan_can_add(s, candidate)) {
            plan[size++] = candidate;
            murk_partial_plan_add(&s->partial, candidate);
        }
    }
    if (!is_constrained || murk_partial_plan_is_complete(&s->partial)) {
        return size;
    }
    memcpy(plan, s->fallback, s->fallback_size * sizeof *plan);
    return s->fallback_size;
}

/* True if the search must end: by the limit on work or by an interrupt. */
static bool is_work_spent(murk_gain_scan *s)
{
    s->is_cut = s->is_cut || s->rows > s->rows_max;
    return s->is_cut || murk_interrupted();
}

/* The gain of a sensor in a plan of this value over the others; 0 if the value
 * of the plan is not known yet. */
static uint64_t gain_above(uint64_t value, uint64_t others)
{
    return value > others ? value - others : 0;
}

uint64_t murk_search_spoq(murk_gain_scan *s, uint32_t *plan, size_t n,
                          uint32_t seed, uint64_t restart)
{
    n = murk_search_draw(s, plan, n, seed, restart);
    const size_t fixed = murk_fixed_count(s->evaluator->set);
    uint64_t value = murk_gain_scan_set_all_but(s, plan, n, n);
    uint64_t before;
    uint32_t sweep = 0, step = 0;
    do {
        before = value;
        /* One sweep: each sensor moves to the best candidate, ties at random.
         */
        draw_order(s->shuffle, n - fixed, seed, restart, sweep++);
        for (size_t k = 0; k < n - fixed && !is_work_spent(s); ++k) {
            const size_t mover = fixed + s->shuffle[k];
            s->is_move = true;
            const uint64_t others =
                murk_gain_scan_set_all_but(s, plan, n, mover);
            value = others + murk_gain_scan_find_move(
                                 s, others, gain_above(value, others));
            uint32_t word[4];
            murk_random_words(seed, MURK_SPOQ_TIE, restart, step++, 0, word);
            plan[mover] = s->tie[murk_random_below(word[0], (uint32_t)s->ties)];
        }
        /* With a budget, spend the rest of it. */
        if (murk_has_budget(s->evaluator->set)) {
            value = murk_search_budget_greedy(s, plan, n);
            n = s->size;
        }
    } while (value > before && !is_work_spent(s));
    s->size = n;
    return value;
}

/* Relocates single sensors until no move increases the value, the limit on work
 * is spent, or the run is interrupted. Returns the value. */
static uint64_t relocate_sensors(murk_gain_scan *s, uint32_t *plan, size_t n)
{
    const size_t fixed = murk_fixed_count(s->evaluator->set),
                 movers = n - fixed;
    if (movers == 0) {
        return murk_gain_scan_set_all_but(s, plan, n, n);
    }
    uint64_t value = 0;
    size_t still = 0; /* sensors in a row that did not move */
    s->is_move = true;
    for (size_t at = 0; still < movers && !(value > 0 && is_work_spent(s)) &&
                        !murk_interrupted();
         at = (at + 1) % movers) {
        const size_t k = fixed + at;
        const uint64_t others = murk_gain_scan_set_all_but(s, plan, n, k);
        const uint64_t best =
            murk_gain_scan_find_move(s, others, gain_above(value, others));
        value = others + best;
        if (best > 0 && s->gain[plan[k]] != best) {
            plan[k] = s->tie[0];
            still = 0;
        }
        ++still; /* a sensor that has just moved is at the best candidate */
    }
    return value;
}

uint64_t murk_search_relocate(murk_gain_scan *s, uint32_t *plan, size_t n)
{
    murk_search_begin(s, plan, n, n);
    uint64_t value = relocate_sensors(s, plan, n);
    s->size = n;
    while (murk_has_budget(s->evaluator->set) && !murk_interrupted()) {
        const uint64_t before = value;
        value = murk_search_budget_greedy(s, plan, s->size);
        if (value == before) {
            break;
        }
        value = relocate_sensors(s, plan, s->size);
    }
    return value;
}
