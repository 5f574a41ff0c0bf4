#include "placement/partial_plan.h"

#include "base/interrupt.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Candidates tried for any plan at all. */
#define TRIES_MAX 2000000u

murk_status murk_partial_plan_init(murk_partial_plan *out,
                                   const murk_rulebook *book, murk_error *err)
{
    *out = (murk_partial_plan){
        .book = book,
        .member = calloc(book->max_sensors + 1, sizeof *out->member),
        .have = calloc(book->classes, sizeof *out->have)};
    if (!out->member || !out->have) {
        murk_partial_plan_release(out);
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for %zu sensors",
                         book->max_sensors);
    }
    murk_partial_plan_clear(out, book->max_sensors);
    return MURK_OK;
}

void murk_partial_plan_release(murk_partial_plan *partial)
{
    free(partial->member);
    free(partial->have);
    *partial = (murk_partial_plan){0};
}

void murk_partial_plan_clear(murk_partial_plan *s, size_t wanted)
{
    assert(wanted <= s->book->max_sensors);
    s->wanted = wanted;
    s->size = 0;
    s->cost = 0;
    s->missing = 0;
    memset(s->have, 0, s->book->classes * sizeof *s->have);
    for (size_t c = 0; c < s->book->classes; ++c) {
        s->missing += s->book->min[c];
    }
}

void murk_partial_plan_add(murk_partial_plan *s, uint32_t candidate)
{
    const uint32_t class = s->book->class_of[candidate];
    s->missing -= s->have[class] < s->book->min[class];
    ++s->have[class];
    s->cost += murk_rulebook_cost(s->book, candidate);
    s->member[s->size++] = candidate;
}

void murk_partial_plan_drop_last(murk_partial_plan *s)
{
    const uint32_t candidate = s->member[--s->size];
    const uint32_t class = s->book->class_of[candidate];
    --s->have[class];
    s->missing += s->have[class] < s->book->min[class];
    s->cost -= murk_rulebook_cost(s->book, candidate);
}

static bool stands(const murk_partial_plan *s, uint32_t candidate)
{
    for (size_t k = 0; k < s->size; ++k) {
        if (s->member[k] == candidate) {
            return true;
        }
    }
    return false;
}

/* What the least counts ask for costs at least, once the candidate stands. */
static uint64_t reserve(const murk_partial_plan *s, uint32_t candidate)
{
    const murk_rulebook *book = s->book;
    uint64_t sum = 0;
    for (size_t c = 0; c < book->classes; ++c) {
        size_t have = s->have[c] + (book->class_of[candidate] == c);
        for (size_t k = book->class_first[c];
             k < book->class_first[c + 1] && have < book->min[c]; ++k) {
            const uint32_t j = book->by_cost[k];
            if (j != candidate && !stands(s, j)) {
                sum += murk_rulebook_cost(book, j);
                ++have;
            }
        }
    }
    return sum;
}

bool murk_partial_plan_admits(const murk_partial_plan *s, uint32_t candidate,
                              bool is_last)
{
    const murk_rulebook *book = s->book;
    const uint32_t class = book->class_of[candidate];
    const size_t missing =
        s->missing - (s->have[class] < book->min[class] ? 1 : 0);
    if (s->have[class] >= book->max[class] ||
        s->size + 1 + missing > s->wanted || (is_last && missing > 0)) {
        return false;
    }
    if (book->has_budget) {
        const uint64_t cost = s->cost + murk_rulebook_cost(book, candidate);
        if (cost > book->budget ||
            (missing > 0 && cost + reserve(s, candidate) > book->budget)) {
            return false;
        }
    }
    if (stands(s, candidate)) {
        return false;
    }
    for (size_t k = 0; book->has_conflicts && k < s->size; ++k) {
        if (murk_rulebook_excludes(book, candidate, s->member[k])) {
            return false;
        }
    }
    return true;
}

bool murk_partial_plan_is_plan(const murk_partial_plan *s)
{
    return s->missing == 0 && (s->book->has_budget || s->size == s->wanted);
}

bool murk_partial_plan_find_plan(murk_partial_plan *s, bool *is_sure)
{
    const uint32_t candidates = (uint32_t)s->book->candidates;
    const size_t first = s->size;
    uint32_t j = 0;
    *is_sure = true;
    for (uint32_t tries = 0; !murk_partial_plan_is_plan(s); ++tries) {
        if (tries == TRIES_MAX || (tries % 4096 == 0 && murk_interrupted())) {
            *is_sure = false;
            return false;
        }
        if (j < candidates) {
            if (murk_partial_plan_admits(s, j, false)) {
                murk_partial_plan_add(s, j);
            }
            ++j;
            continue;
        }
        if (s->size == first) {
            return false;
        }
        j = s->member[s->size - 1] + 1; /* the last one was a wrong choice */
        murk_partial_plan_drop_last(s);
    }
    return true;
}
