#include "placement/worst_search.h"

#include "base/interrupt.h"

#include <stdlib.h>
#include <string.h>

/* Candidates weighed between two looks at the best so far; fixed, so that who
 * is weighed does not depend on the threads. */
#define CHUNK 128

typedef struct murk_hope {
    murk_worth worth; /* at most */
    uint32_t candidate;
} murk_hope;

murk_status murk_worst_search_init(murk_worst_search *out,
                                   const murk_block_views *views,
                                   murk_error *err)
{
    const murk_evaluator *o = views->evaluator;
    const size_t n = o->candidates + 1, blocks = views->blocks->n;
    *out =
        (murk_worst_search){.views = views,
                            .evaluator = o,
                            .max = malloc(n * blocks * sizeof *out->max),
                            .gain = malloc(CHUNK * blocks * sizeof *out->gain),
                            .chunk = malloc(CHUNK * sizeof *out->chunk),
                            .hope = malloc(n * sizeof *out->hope)};
    murk_status status = MURK_OK;
    if (!out->max || !out->gain || !out->chunk || !out->hope ||
        !murk_cover_init(&out->cover, o->layout, o->all_clear)) {
        status = murk_fail(err, MURK_NO_MEMORY, "",
                           "no memory to search %zu candidates", o->candidates);
    }
    if (!status && o->book) {
        status = murk_partial_plan_init(&out->partial, o->book, err);
    }
    if (!status) {
        status = murk_search_init(&out->draw, o, 0, 1, err);
    }
    return status;
}

void murk_worst_search_release(murk_worst_search *s)
{
    murk_search_release(&s->draw);
    murk_partial_plan_release(&s->partial);
    murk_cover_release(&s->cover);
    free(s->max);
    free(s->gain);
    free(s->chunk);
    free(s->hope);
    *s = (murk_worst_search){0};
}

/* ---- worths ---- */

static bool is_more(murk_worth a, murk_worth b)
{
    return a.first != b.first ? a.first > b.first : a.second > b.second;
}

/* Of what stands with gain[] on top. */
static murk_worth worth_with(const murk_worst_search *s,
                             const murk_climb *climb, const uint64_t *gain)
{
    murk_worth out = {climb->is_min ? UINT64_MAX : 0, 0};
    for (size_t c = 0; c < s->views->blocks->n; ++c) {
        const uint64_t share =
            murk_block_worth(s->views, c, s->value[c] + (gain ? gain[c] : 0));
        if (climb->is_min) {
            out.first = share < out.first ? share : out.first;
            out.second += share;
        } else {
            out.first += climb->factor[c] *
                         (share < climb->level ? share : climb->level);
        }
    }
    return out;
}

static const murk_climb BY_LEAST = {.is_min = true};

/* ---- what stands ---- */

static void stand(murk_worst_search *s, uint32_t candidate)
{
    const murk_row row = murk_evaluator_row(s->evaluator, 0, candidate);
    for (size_t c = 0; c < s->views->blocks->n; ++c) {
        s->value[c] += murk_row_gain(&s->views->layout[c], &row, &s->cover);
    }
    murk_cover_add(&s->cover, s->evaluator->layout, &row);
    if (s->evaluator->book) {
        murk_partial_plan_add(&s->partial, candidate);
    }
}

/* All of the plan but its entry `but` (n: all). */
static void stand_others(murk_worst_search *s, const uint32_t *plan, size_t n,
                         size_t but)
{
    murk_cover_clear(&s->cover, s->evaluator->layout);
    memset(s->value, 0, sizeof s->value);
    if (s->evaluator->book) {
        murk_partial_plan_clear(&s->partial, s->partial.wanted);
    }
    for (size_t k = 0; k < n; ++k) {
        if (k != but) {
            stand(s, plan[k]);
        }
    }
}

static bool holds(const uint32_t *plan, size_t n, size_t but,
                  uint32_t candidate)
{
    for (size_t k = 0; k < n; ++k) {
        if (k != but && plan[k] == candidate) {
            return true;
        }
    }
    return false;
}

/* ---- who adds most ---- */

typedef struct question {
    const murk_climb *climb;
    const uint32_t *plan; /* whose entries but `but` stand */
    size_t n, but;
    bool is_move; /* who joins must make a plan of what stands */
} question;

static bool is_open(const murk_worst_search *s, const question *q,
                    uint32_t candidate)
{
    return !holds(q->plan, q->n, q->but, candidate) &&
           (!s->evaluator->book ||
            murk_partial_plan_admits(&s->partial, candidate, q->is_move));
}

static int by_hope(const void *a, const void *b)
{
    const murk_hope *x = a, *y = b;
    if (is_more(x->worth, y->worth) || is_more(y->worth, x->worth)) {
        return is_more(x->worth, y->worth) ? -1 : 1;
    }
    return (x->candidate > y->candidate) - (x->candidate < y->candidate);
}

/* Who makes what stands worth most, if more than *worth, which is raised; the
 * lowest number of equals. False when nobody does. Of dominated candidates
 * none does better than its dominator. */
static bool find_best(murk_worst_search *s, const question *q,
                      murk_worth *worth, uint32_t *best)
{
    const murk_evaluator *o = s->evaluator;
    const size_t blocks = s->views->blocks->n;
    size_t n = 0;
    for (size_t k = 0; k < o->undominated; ++k) {
        const uint32_t j = o->ranked[k].candidate;
        const murk_worth max = worth_with(s, q->climb, s->max + j * blocks);
        if (is_more(max, *worth) && is_open(s, q, j)) {
            s->hope[n++] = (murk_hope){max, j};
        }
    }
    qsort(s->hope, n, sizeof *s->hope, by_hope);
    bool is_found = false;
    for (size_t k = 0; k < n && !murk_interrupted();) {
        size_t gathered = 0;
        for (; k < n && gathered < CHUNK && !is_more(*worth, s->hope[k].worth);
             ++k) {
            s->chunk[gathered++] = s->hope[k].candidate;
        }
        if (gathered == 0) {
            break;
        }
        murk_block_gains(s->views, &s->cover, s->chunk, gathered, s->gain);
        s->evaluations += gathered;
        for (size_t i = 0; i < gathered; ++i) {
            const uint32_t j = s->chunk[i];
            const murk_worth now =
                worth_with(s, q->climb, s->gain + i * blocks);
            if (is_more(now, *worth) ||
                (is_found && !is_more(*worth, now) && j < *best)) {
                *worth = now;
                *best = j;
                is_found = true;
            }
        }
    }
    return is_found;
}

/* Anyone, lowest number first. */
static bool find_any(const murk_worst_search *s, const question *q,
                     uint32_t *candidate)
{
    for (uint32_t j = 0; j < s->evaluator->candidates; ++j) {
        if (is_open(s, q, j)) {
            *candidate = j;
            return true;
        }
    }
    return false;
}

/* ---- plans ---- */

uint64_t murk_worst_value(murk_worst_search *s, const uint32_t *plan, size_t n)
{
    stand_others(s, plan, n, n);
    return worth_with(s, &BY_LEAST, NULL).first;
}

static bool has_budget(const murk_worst_search *s)
{
    return s->evaluator->book && s->evaluator->book->has_budget;
}

/* Under rules: the plan is to have n sensors, or n at most, and begins with
 * those fixed. Returns how many are given. */
static size_t begin(murk_worst_search *s, uint32_t *plan, size_t given,
                    size_t n)
{
    const murk_rulebook *book = s->evaluator->book;
    if (!book) {
        return given;
    }
    murk_partial_plan_clear(&s->partial,
                            book->has_budget ? book->max_sensors : n);
    const size_t fixed = book->constraints->fixed_count;
    for (size_t k = given; k < fixed; ++k) {
        plan[k] = (uint32_t)book->constraints->fixed[k];
    }
    return given > fixed ? given : fixed;
}

/* What stands can only grow from here on: gains never exceed those alone. */
static void forget_gains(murk_worst_search *s)
{
    memcpy(s->max, s->views->max,
           s->evaluator->candidates * s->views->blocks->n * sizeof *s->max);
}

uint64_t murk_worst_greedy(murk_worst_search *s, const murk_climb *climb,
                           uint32_t *plan, size_t given, size_t n)
{
    given = begin(s, plan, given, n);
    stand_others(s, plan, given, given);
    forget_gains(s);
    s->size = given;
    for (size_t k = given; k < n && !murk_interrupted(); ++k) {
        question q = {.climb = climb, .plan = plan, .n = k, .but = k};
        murk_worth worth = worth_with(s, climb, NULL);
        bool is_found = find_best(s, &q, &worth, &plan[k]);
        if (!is_found) {
            q.climb = &BY_LEAST;
            worth = worth_with(s, &BY_LEAST, NULL);
            is_found = find_best(s, &q, &worth, &plan[k]);
        }
        const bool is_enough = has_budget(s) && s->partial.missing == 0;
        if (!is_found && (is_enough || !find_any(s, &q, &plan[k]))) {
            break;
        }
        stand(s, plan[k]);
        s->size = k + 1;
    }
    return worth_with(s, &BY_LEAST, NULL).first;
}

/* Moves single sensors until none gains. */
static void settle(murk_worst_search *s, uint32_t *plan, size_t n)
{
    const murk_rulebook *book = s->evaluator->book;
    const size_t fixed = book ? book->constraints->fixed_count : 0;
    const size_t movers = n - fixed;
    size_t still = 0; /* sensors in a row that did not move */
    forget_gains(s);
    for (size_t at = 0; still < movers && !murk_interrupted();
         at = (at + 1) % movers) {
        const size_t k = fixed + at;
        const question q = {.climb = &BY_LEAST,
                            .plan = plan,
                            .n = n,
                            .but = k,
                            .is_move = true};
        stand_others(s, plan, n, k);
        murk_block_gains(s->views, &s->cover, &plan[k], 1, s->gain);
        murk_worth worth = worth_with(s, &BY_LEAST, s->gain);
        if (find_best(s, &q, &worth, &plan[k])) {
            still = 0;
        }
        ++still; /* one that has just moved stands best, too */
    }
}

uint64_t murk_worst_relocate(murk_worst_search *s, uint32_t *plan, size_t n)
{
    begin(s, plan, n, n);
    settle(s, plan, n);
    s->size = n;
    while (has_budget(s) && !murk_interrupted()) {
        const size_t before = s->size;
        murk_worst_greedy(s, &BY_LEAST, plan, before,
                          s->evaluator->book->max_sensors);
        if (s->size == before) {
            break;
        }
        settle(s, plan, s->size);
    }
    return murk_worst_value(s, plan, s->size);
}

void murk_worst_draw(murk_worst_search *s, uint32_t *plan, size_t n,
                     uint32_t seed, uint64_t restart)
{
    s->draw.spare = s->spare;
    s->draw.spare_size = s->spare_size;
    s->size = murk_search_draw(&s->draw, plan, n, seed, restart);
}
