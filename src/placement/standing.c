#include "placement/standing.h"

#include "base/interrupt.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Candidates tried for any plan at all. */
#define TRIES_MOST 2000000u

murk_status murk_standing_init(murk_standing *out, const murk_rulebook *book,
                               murk_error *err)
{
    *out = (murk_standing){
        .book = book,
        .member = calloc(book->most_sensors + 1, sizeof *out->member),
        .have = calloc(book->classes, sizeof *out->have)};
    if (!out->member || !out->have) {
        murk_standing_release(out);
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for %zu sensors",
                         book->most_sensors);
    }
    murk_standing_clear(out, book->most_sensors);
    return MURK_OK;
}

void murk_standing_release(murk_standing *standing)
{
    free(standing->member);
    free(standing->have);
    *standing = (murk_standing){0};
}

void murk_standing_clear(murk_standing *s, size_t wanted)
{
    assert(wanted <= s->book->most_sensors);
    s->wanted = wanted;
    s->size = 0;
    s->cost = 0;
    s->missing = 0;
    memset(s->have, 0, s->book->classes * sizeof *s->have);
    for (size_t c = 0; c < s->book->classes; ++c) {
        s->missing += s->book->least[c];
    }
}

void murk_standing_add(murk_standing *s, uint32_t candidate)
{
    const uint32_t class = s->book->class_of[candidate];
    s->missing -= s->have[class] < s->book->least[class];
    ++s->have[class];
    s->cost += murk_rulebook_cost(s->book, candidate);
    s->member[s->size++] = candidate;
}

void murk_standing_drop_last(murk_standing *s)
{
    const uint32_t candidate = s->member[--s->size];
    const uint32_t class = s->book->class_of[candidate];
    --s->have[class];
    s->missing += s->have[class] < s->book->least[class];
    s->cost -= murk_rulebook_cost(s->book, candidate);
}

static bool stands(const murk_standing *s, uint32_t candidate)
{
    for (size_t k = 0; k < s->size; ++k) {
        if (s->member[k] == candidate) {
            return true;
        }
    }
    return false;
}

/* What the least counts ask for costs at least, once the candidate stands. */
static uint64_t reserve(const murk_standing *s, uint32_t candidate)
{
    const murk_rulebook *book = s->book;
    uint64_t sum = 0;
    for (size_t c = 0; c < book->classes; ++c) {
        size_t have = s->have[c] + (book->class_of[candidate] == c);
        for (size_t k = book->class_first[c];
             k < book->class_first[c + 1] && have < book->least[c]; ++k) {
            const uint32_t j = book->by_cost[k];
            if (j != candidate && !stands(s, j)) {
                sum += murk_rulebook_cost(book, j);
                ++have;
            }
        }
    }
    return sum;
}

bool murk_standing_admits(const murk_standing *s, uint32_t candidate,
                          bool is_last)
{
    const murk_rulebook *book = s->book;
    const uint32_t class = book->class_of[candidate];
    const size_t missing =
        s->missing - (s->have[class] < book->least[class] ? 1 : 0);
    if (s->have[class] >= book->most[class] ||
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

bool murk_standing_is_plan(const murk_standing *s)
{
    return s->missing == 0 && (s->book->has_budget || s->size == s->wanted);
}

bool murk_standing_find_plan(murk_standing *s, bool *is_sure)
{
    const uint32_t candidates = (uint32_t)s->book->candidates;
    const size_t first = s->size;
    uint32_t j = 0;
    *is_sure = true;
    for (uint32_t tries = 0; !murk_standing_is_plan(s); ++tries) {
        if (tries == TRIES_MOST || (tries % 4096 == 0 && murk_interrupted())) {
            *is_sure = false;
            return false;
        }
        if (j < candidates) {
            if (murk_standing_admits(s, j, false)) {
                murk_standing_add(s, j);
            }
            ++j;
            continue;
        }
        if (s->size == first) {
            return false;
        }
        j = s->member[s->size - 1] + 1; /* the last one was a wrong choice */
        murk_standing_drop_last(s);
    }
    return true;
}
