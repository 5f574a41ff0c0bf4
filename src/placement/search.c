#include "placement/scan.h"

#include "base/interrupt.h"
#include "base/rng.h"
#include "placement/draw.h"
#include "placement/place.h"

#include <stdlib.h>
#include <string.h>

#define CHUNK MURK_SEARCH_CHUNK

uint64_t murk_search_rows_max(const murk_evaluator *evaluator)
{
    const uint64_t work =
        evaluator->search_work ? evaluator->search_work : MURK_SEARCH_WORK;
    return evaluator->matrix ? work / murk_evaluator_work(evaluator, 1)
                             : UINT64_MAX;
}

murk_status murk_search_init(murk_search *out, const murk_evaluator *evaluator,
                             unsigned worker, unsigned threads, murk_error *err)
{
    const size_t n = evaluator->candidates + 1;
    const bool has_budget = evaluator->book && evaluator->book->has_budget;
    *out = (murk_search){.evaluator = evaluator,
                         .has_many_views = evaluator->layout->layers > 1 ||
                                           evaluator->layout->doses,
                         .worker = worker,
                         .rows_max = UINT64_MAX,
                         .threads = threads,
                         .gain = malloc(n * sizeof *out->gain),
                         .tie = malloc(n * sizeof *out->tie),
                         .shuffle = malloc(n * sizeof *out->shuffle),
                         .ranking = malloc(n * sizeof *out->ranking),
                         .chunk_gain = calloc(CHUNK, sizeof *out->chunk_gain),
                         .chunk = malloc(CHUNK * sizeof *out->chunk),
                         .is_partial = calloc(n, sizeof *out->is_partial)};
    if (has_budget) {
        out->priced = malloc(n * sizeof *out->priced);
    }
    const bool is_quicker = evaluator->matrix && evaluator->slack;
    if (is_quicker) {
        out->max = malloc(n * sizeof *out->max);
    }
    if (!out->gain || !out->tie || (has_budget && !out->priced) ||
        !out->shuffle || !out->ranking || !out->chunk_gain || !out->chunk ||
        !out->is_partial || (is_quicker && !out->max) ||
        !murk_cover_init(&out->cover, evaluator->layout,
                         evaluator->all_clear)) {
        murk_search_release(out);
        return murk_fail(err, MURK_NO_MEMORY, "",
                         "no memory to search %zu candidates for %zu photons",
                         evaluator->candidates, evaluator->layout->photons);
    }
    murk_status status = MURK_OK;
    if (evaluator->book) {
        status = murk_partial_plan_init(&out->partial, evaluator->book, err);
    }
    if (status) {
        murk_search_release(out);
    }
    return status;
}

void murk_search_release(murk_search *search)
{
    murk_cover_release(&search->cover);
    murk_partial_plan_release(&search->partial);
    free(search->priced);
    free(search->gain);
    free(search->tie);
    free(search->shuffle);
    free(search->ranking);
    free(search->chunk_gain);
    free(search->chunk);
    free(search->is_partial);
    free(search->max);
    *search = (murk_search){0};
}

/* What any candidate adds to what stands, worth `value`, is at most its
 * ranking's bound, and k more add at most the sum of the k largest. (Rounding
 * of chances: k that see a photon together exceed their sum by less than 1.02
 * (k + 1), and each bound has 2 of slack.) */
static void note_reach(murk_search *s, uint64_t value)
{
    const size_t n = s->evaluator->undominated;
    uint64_t max = value;
    for (size_t k = 0; k < s->reach_count; ++k) {
        max = murk_sum_saturated(max, k < n ? s->ranking[k].bound : 0);
        s->reach[k] = max < s->reach[k] ? max : s->reach[k];
    }
}

/* Under rules: the plan is to have n sensors, or n at most, and begins with
 * those fixed. Returns how many are given. */
static size_t begin(murk_search *s, uint32_t *plan, size_t given, size_t n)
{
    const murk_rulebook *book = s->evaluator->book;
    if (!book) {
        return given;
    }
    murk_partial_plan_clear(&s->partial,
                            book->has_budget ? book->max_sensors : n);
    s->is_move = false;
    const size_t fixed = book->constraints->fixed_count;
    for (size_t k = given; k < fixed; ++k) {
        plan[k] = (uint32_t)book->constraints->fixed[k];
    }
    return given > fixed ? given : fixed;
}

static size_t fixed_count(const murk_search *s)
{
    return s->evaluator->book ? s->evaluator->book->constraints->fixed_count
                              : 0;
}

static bool has_budget(const murk_search *s)
{
    return s->evaluator->book && s->evaluator->book->has_budget;
}

/* Whether a plan under a budget needs no more that bring nothing. */
static bool is_enough(const murk_search *s, uint64_t gain)
{
    return gain == 0 && has_budget(s) && s->partial.missing == 0;
}

uint64_t murk_search_greedy(murk_search *s, uint32_t *plan, size_t given,
                            size_t n, uint64_t enough, uint64_t *value_after)
{
    const murk_evaluator *o = s->evaluator;
    memcpy(s->ranking, o->ranked, o->candidates * sizeof *s->ranking);
    given = begin(s, plan, given, n);
    uint64_t value = murk_scan_stand_others(s, plan, given, given);
    if (value_after && given > 0) {
        value_after[given - 1] = value;
    }
    s->size = given;
    for (size_t k = given; k < n && value < enough && !murk_interrupted();
         ++k) {
        const uint64_t gain =
            murk_scan_candidates(s, s->ranking, plan, k, k, value);
        if (s->ties == 0 || is_enough(s, gain)) {
            break;
        }
        s->size = k + 1;
        plan[k] = s->tie[0];
        murk_scan_stand(s, plan[k]);
        murk_scan_sharpen(s);
        note_reach(s, value);
        value += gain;
        if (value_after) {
            value_after[k] = value;
        }
    }
    return value;
}

/* Weighs again, from the densest on, until the rest cannot be as dense; those
 * weighed keep what they now bring. Returns the densest, gain 0: none adds. */
static murk_priced find_densest(murk_search *s)
{
    const size_t n = s->evaluator->candidates;
    murk_priced best = {.gain = 0};
    qsort(s->priced, n, sizeof *s->priced, murk_by_density);
    for (size_t k = 0; k < n && s->priced[k].gain > 0 && !murk_interrupted();) {
        size_t place[CHUNK], gathered = 0;
        for (; k < n && gathered < CHUNK && s->priced[k].gain > 0; ++k) {
            if (best.gain > 0 && murk_by_density(&s->priced[k], &best) > 0) {
                break;
            }
            if (murk_scan_is_open(s, s->priced[k].candidate)) {
                place[gathered] = k;
                s->chunk[gathered++] = s->priced[k].candidate;
            }
        }
        if (gathered == 0) {
            break;
        }
        murk_scan_weigh(s, gathered, 0);
        for (size_t i = 0; i < gathered; ++i) {
            murk_priced *later = &s->priced[place[i]];
            murk_priced now = *later;
            now.gain = s->chunk_gain[i];
            later->gain = now.gain + murk_scan_slack(s, now.candidate);
            if (now.gain > 0 &&
                (best.gain == 0 || murk_by_density(&now, &best) < 0)) {
                best = now;
            }
        }
    }
    return best;
}

/* The cheapest that a least count still asks for; false when there is none. */
static bool find_asked(const murk_search *s, uint32_t *candidate)
{
    const murk_rulebook *book = s->evaluator->book;
    for (size_t c = 0; c < book->classes; ++c) {
        for (size_t k = book->class_first[c];
             k < book->class_first[c + 1] && s->partial.have[c] < book->min[c];
             ++k) {
            if (murk_scan_is_open(s, book->by_cost[k])) {
                *candidate = book->by_cost[k];
                return true;
            }
        }
    }
    return false;
}

uint64_t murk_search_spend(murk_search *s, uint32_t *plan, size_t given)
{
    const murk_evaluator *o = s->evaluator;
    size_t n = begin(s, plan, given, o->book->max_sensors);
    uint64_t value = murk_scan_stand_others(s, plan, n, n);
    for (uint32_t j = 0; j < o->candidates; ++j) {
        s->priced[j] = (murk_priced){murk_evaluator_most(o, j),
                                     murk_rulebook_cost(o->book, j), j};
    }
    while (n < o->book->max_sensors && !murk_interrupted()) {
        const murk_priced best = find_densest(s);
        plan[n] = best.candidate;
        if (best.gain == 0 && !find_asked(s, &plan[n])) {
            break;
        }
        value += best.gain;
        murk_scan_stand(s, plan[n++]);
    }
    s->size = n;
    return value;
}

static void draw_start(murk_search *s, uint32_t *plan, size_t n, uint32_t seed,
                       uint64_t restart)
{
    const size_t m = s->evaluator->candidates;
    murk_draw_begin(s->shuffle, m);
    for (uint32_t k = 0; k < n; ++k) {
        plan[k] = murk_draw_next(s->shuffle, m, k, seed, restart);
    }
}

/* Candidates in random order, each taken if the rules let it; the spare plan
 * where that ends short. */
static size_t draw_ruled_start(murk_search *s, uint32_t *plan, size_t n,
                               uint32_t seed, uint64_t restart)
{
    const size_t m = s->evaluator->candidates;
    const size_t fixed = begin(s, plan, 0, n);
    for (size_t k = 0; k < fixed; ++k) {
        murk_partial_plan_add(&s->partial, plan[k]);
    }
    murk_draw_begin(s->shuffle, m);
    for (uint32_t k = 0; k < m && s->partial.size < s->partial.wanted; ++k) {
        const uint32_t candidate =
            murk_draw_next(s->shuffle, m, k, seed, restart);
        if (murk_scan_is_open(s, candidate)) {
            plan[s->partial.size] = candidate;
            murk_partial_plan_add(&s->partial, candidate);
        }
    }
    if (murk_partial_plan_is_plan(&s->partial)) {
        return s->partial.size;
    }
    memcpy(plan, s->spare, s->spare_size * sizeof *plan);
    return s->spare_size;
}

size_t murk_search_draw(murk_search *s, uint32_t *plan, size_t n, uint32_t seed,
                        uint64_t restart)
{
    if (s->evaluator->book) {
        return draw_ruled_start(s, plan, n, seed, restart);
    }
    draw_start(s, plan, n, seed, restart);
    return n;
}

/* Whether the work is to end here. */
static bool is_over(murk_search *s)
{
    s->is_cut = s->is_cut || s->rows > s->rows_max;
    return s->is_cut || murk_interrupted();
}

uint64_t murk_search_spoq(murk_search *s, uint32_t *plan, size_t n,
                          uint32_t seed, uint64_t restart)
{
    n = murk_search_draw(s, plan, n, seed, restart);
    const size_t fixed = fixed_count(s);
    uint64_t value = murk_scan_stand_others(s, plan, n, n);
    uint64_t before;
    uint32_t sweep = 0, step = 0;
    do {
        before = value;
        murk_draw_order(s->shuffle, n - fixed, seed, restart, sweep++);
        for (size_t k = 0; k < n - fixed && !is_over(s); ++k) {
            const size_t mover = fixed + s->shuffle[k];
            s->is_move = true;
            const uint64_t others = murk_scan_stand_others(s, plan, n, mover);
            value = others + murk_scan_candidates(s, s->evaluator->ranked, plan,
                                                  n, mover, others);
            uint32_t word[4];
            murk_random_words(seed, MURK_SPOQ_TIE, restart, step++, 0, word);
            plan[mover] = s->tie[murk_random_below(word[0], (uint32_t)s->ties)];
        }
        if (has_budget(s)) {
            value = murk_search_spend(s, plan, n);
            n = s->size;
        }
    } while (value > before && !is_over(s));
    s->size = n;
    return value;
}

uint64_t murk_search_value(murk_search *s, const uint32_t *plan, size_t n)
{
    return murk_scan_stand_others(s, plan, n, n);
}

/* Moves single sensors until none gains; returns the value. */
static uint64_t settle(murk_search *s, uint32_t *plan, size_t n)
{
    const size_t fixed = fixed_count(s), movers = n - fixed;
    if (movers == 0) {
        return murk_scan_stand_others(s, plan, n, n);
    }
    uint64_t value = 0;
    size_t still = 0; /* sensors in a row that did not move */
    s->is_move = true;
    for (size_t at = 0;
         still < movers && !(value > 0 && is_over(s)) && !murk_interrupted();
         at = (at + 1) % movers) {
        const size_t k = fixed + at;
        const uint64_t others = murk_scan_stand_others(s, plan, n, k);
        const uint64_t best =
            murk_scan_candidates(s, s->evaluator->ranked, plan, n, k, others);
        value = others + best;
        if (best > 0 && s->gain[plan[k]] != best) {
            plan[k] = s->tie[0];
            still = 0;
        }
        ++still; /* one that has just moved stands best, too */
    }
    return value;
}

uint64_t murk_search_relocate(murk_search *s, uint32_t *plan, size_t n)
{
    begin(s, plan, n, n);
    uint64_t value = settle(s, plan, n);
    s->size = n;
    while (has_budget(s) && !murk_interrupted()) {
        const uint64_t before = value;
        value = murk_search_spend(s, plan, s->size);
        if (value == before) {
            break;
        }
        value = settle(s, plan, s->size);
    }
    return value;
}
