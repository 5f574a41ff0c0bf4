/* Greedy, SPOQ and certified relocation (placement/search.h). All are made of
 * scans over a partial plan (placement/scan.h). Random numbers are addressed by
 * seed, start and step, so a start gives the same plan in any thread. The plans
 * that SPOQ and relocation begin with are made in search_begin.c. */
#include "placement/search.h"

#include "base/interrupt.h"
#include "base/rng.h"
#include "placement/moves.h"

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

/* A random order of 0..n-1 for one sweep (Fisher-Yates). */
static void draw_order(uint32_t *order, size_t n, uint32_t seed,
                       uint64_t restart, uint32_t sweep)
{
    for (uint32_t k = 0; k < n; ++k) {
        order[k] = k;
    }
    for (uint32_t k = 0; k + 1 < n; ++k) {
        uint32_t word[4];
        murk_random_words(seed, MURK_SPOQ_ORDER, restart, sweep, k, word);
        const uint32_t at = k + murk_random_below(word[0], (uint32_t)n - k);
        const uint32_t held = order[at];
        order[at] = order[k];
        order[k] = held;
    }
}

/* True if the search must end: by the limit on work, by a request to finish or
 * by an interrupt. */
static bool is_work_spent(murk_gain_scan *s)
{
    s->is_cut = s->is_cut || s->rows > s->rows_max;
    return s->is_cut || murk_must_finish();
}

/* Begins a sweep: each sensor that is not fixed will move once, in random
 * order. */
static void begin_sweep(murk_climb *c, murk_gain_scan *s)
{
    c->before = c->value;
    c->at = 0;
    draw_order(s->shuffle, c->n - c->fixed, c->seed, c->restart, c->sweep++);
}

/* Begins SPOQ at the plan of n sensors in plan[]. */
static void begin_spoq_at(murk_climb *c, murk_gain_scan *s, uint32_t *plan,
                          size_t n, uint32_t seed, uint64_t restart)
{
    *c = (murk_climb){.plan = plan,
                      .n = n,
                      .is_spoq = true,
                      .fixed = murk_fixed_count(s->evaluator->set),
                      .seed = seed,
                      .restart = restart};
    c->value = murk_has_moves(s->evaluator->set)
                   ? murk_moves_objective(s, plan, n)
                   : murk_gain_scan_set_all_but(s, plan, n, n);
    begin_sweep(c, s);
}

void murk_climb_begin_spoq(murk_climb *c, murk_gain_scan *s, uint32_t *plan,
                           size_t n, uint32_t seed, uint64_t restart)
{
    const size_t drawn = murk_search_draw(s, plan, n, seed, restart);
    begin_spoq_at(c, s, plan, drawn, seed, restart);
}

/* SPOQ: the next sensor of the sweep. After each sweep a budget is spent; the
 * climb ends after a sweep without gain. */
static bool prepare_spoq(murk_climb *c, murk_gain_scan *s)
{
    while (c->at == c->n - c->fixed || is_work_spent(s)) {
        if (murk_has_budget(s->evaluator->set)) {
            c->value = murk_search_budget_greedy(s, c->plan, c->n);
            c->n = s->size;
        }
        if (!(c->value > c->before) || is_work_spent(s)) {
            s->size = c->n;
            return false;
        }
        begin_sweep(c, s);
    }
    c->mover = c->fixed + s->shuffle[c->at++];
    return true;
}

/* SPOQ: the sensor moves to the best candidate, ties at random. */
static void move_spoq(murk_climb *c, const murk_gain_scan *s)
{
    uint32_t word[4];
    murk_random_words(c->seed, MURK_SPOQ_TIE, c->restart, c->step++, 0, word);
    c->plan[c->mover] = s->tie[murk_random_below(word[0], (uint32_t)s->ties)];
}

/* Begins to relocate the sensors of plan[c->n] one after the other. */
static void begin_moves(murk_climb *c, murk_gain_scan *s)
{
    c->value = c->n == c->fixed
                   ? murk_gain_scan_set_all_but(s, c->plan, c->n, c->n)
                   : 0;
    c->at = 0;
    c->still = 0;
}

void murk_climb_begin_relocation(murk_climb *c, murk_gain_scan *s,
                                 uint32_t *plan, size_t n)
{
    *c = (murk_climb){
        .plan = plan, .n = n, .fixed = murk_fixed_count(s->evaluator->set)};
    murk_search_begin(s, plan, n, n);
    begin_moves(c, s);
}

/* True while a sensor may still move. At least one scan is made, so that the
 * value is known. */
static bool may_move(const murk_climb *c, murk_gain_scan *s)
{
    return c->still < c->n - c->fixed && !(c->value > 0 && is_work_spent(s)) &&
           !murk_interrupted();
}

/* Relocation: the next sensor. When none moves any more, the rest of a budget
 * is spent, and the moves begin again if that increased the value. */
static bool prepare_relocation(murk_climb *c, murk_gain_scan *s)
{
    while (!may_move(c, s)) {
        s->size = c->n;
        if (!murk_has_budget(s->evaluator->set) || murk_interrupted()) {
            return false;
        }
        const uint64_t before = c->value;
        c->value = murk_search_budget_greedy(s, c->plan, c->n);
        c->n = s->size;
        if (c->value == before) {
            return false;
        }
        begin_moves(c, s);
    }
    c->mover = c->fixed + c->at;
    c->at = (c->at + 1) % (c->n - c->fixed);
    return true;
}

/* Relocation: the sensor moves to the best candidate, the lowest index on ties,
 * but stays if no other candidate gives more. */
static void move_relocated(murk_climb *c, const murk_gain_scan *s,
                           uint64_t best)
{
    if (best > 0 && s->gain[c->plan[c->mover]] != best) {
        c->plan[c->mover] = s->tie[0];
        c->still = 0;
    }
    ++c->still; /* a sensor that has just moved is at the best candidate */
}

bool murk_climb_prepare(murk_climb *c, murk_gain_scan *s)
{
    if (!(c->is_spoq ? prepare_spoq(c, s) : prepare_relocation(c, s))) {
        return false;
    }
    s->is_move = true;
    c->others = murk_gain_scan_set_all_but(s, c->plan, c->n, c->mover);
    return true;
}

/* The gain of a sensor in a plan of this value over the others; 0 if the value
 * of the plan is not known yet. */
static uint64_t gain_above(uint64_t value, uint64_t others)
{
    return value > others ? value - others : 0;
}

void murk_climb_move(murk_climb *c, murk_gain_scan *s)
{
    if (murk_has_moves(s->evaluator->set)) { /* SPOQ, by the objective */
        c->value = murk_moves_find_place(s, c->plan, c->n, c->mover,
                                         &c->plan[c->mover]);
        return;
    }
    const uint64_t best =
        murk_gain_scan_find_move(s, c->others, gain_above(c->value, c->others));
    c->value = c->others + best;
    if (c->is_spoq) {
        move_spoq(c, s);
    } else {
        move_relocated(c, s, best);
    }
}

/* Makes all steps of a climb. Returns the value of the plan. */
static uint64_t climb(murk_climb *c, murk_gain_scan *s)
{
    while (murk_climb_prepare(c, s)) {
        murk_climb_move(c, s);
    }
    return c->value;
}

uint64_t murk_search_spoq(murk_gain_scan *s, uint32_t *plan, size_t n,
                          uint32_t seed, uint64_t restart)
{
    murk_climb c;
    murk_climb_begin_spoq(&c, s, plan, n, seed, restart);
    return climb(&c, s);
}

uint64_t murk_search_spoq_from(murk_gain_scan *s, uint32_t *plan, size_t n,
                               uint32_t seed)
{
    murk_climb c;
    begin_spoq_at(&c, s, plan, n, seed, 0);
    return climb(&c, s);
}

uint64_t murk_search_relocate(murk_gain_scan *s, uint32_t *plan, size_t n)
{
    murk_climb c;
    murk_climb_begin_relocation(&c, s, plan, n);
    return climb(&c, s);
}
