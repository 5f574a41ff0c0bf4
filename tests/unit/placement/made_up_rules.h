/* Made-up rules of every kind for made-up problems, and their plans by brute
 * force: all subsets, each judged by the plain meaning of the rules. */
#ifndef MURK_TESTS_MADE_UP_CONSTRAINTS_H
#define MURK_TESTS_MADE_UP_CONSTRAINTS_H

#include "made_up.h"

#include <string.h>

#define MADE_UP_MAX 12 /* candidates */

enum made_up_kind {
    CAPS = 1,
    MIN = 2,
    BUDGET = 4,
    FIXED = 8,
    SITES = 16,
    SPACING = 32,
    LIST = 64,
    KINDS = 7
};

typedef struct made_up_constraints {
    murk_constraints constraints;
    unsigned kinds;
    size_t candidates;
    uint32_t class_of[MADE_UP_MAX];
    size_t min[3], max[3];
    int64_t cost[MADE_UP_MAX];
    size_t fixed[2];
    uint32_t site[MADE_UP_MAX];
    double position_m[MADE_UP_MAX][3];
    size_t conflict_first[MADE_UP_MAX + 1];
    uint32_t conflict[MADE_UP_MAX * MADE_UP_MAX];
    bool is_listed[MADE_UP_MAX][MADE_UP_MAX];
} made_up_constraints;

static uint32_t made_up_draw(uint32_t seed, uint32_t what, uint32_t at,
                             uint32_t below)
{
    uint32_t word[4];
    murk_random_words(seed, MURK_TEST, 1000 + what, at, 7, word);
    return murk_random_below(word[0], below);
}

/* The last half exclude all that the first half do, one by one. */
static void made_up_nest(made_up_constraints *out)
{
    const size_t n = out->candidates, half = n / 2;
    for (int pass = 0; pass < 3; ++pass) {
        for (size_t j = half; j < n; ++j) {
            for (size_t i = 0; i < n; ++i) {
                if (i != j && out->is_listed[j - half][i]) {
                    out->is_listed[j][i] = out->is_listed[i][j] = true;
                }
            }
        }
    }
}

/* Fills *out in place, whose arrays out->rules points to. */
static inline void made_up_constraints_fill(made_up_constraints *out,
                                            uint32_t seed, unsigned kinds,
                                            size_t candidates)
{
    *out = (made_up_constraints){.kinds = kinds, .candidates = candidates};
    murk_constraints *constraints = &out->constraints;
    size_t listed = 0;
    for (uint32_t j = 0; j < candidates; ++j) {
        out->class_of[j] = made_up_draw(seed, 1, j, 3);
        out->cost[j] = made_up_draw(seed, 2, j, 8); /* some are free */
        out->site[j] = 100 * made_up_draw(seed, 3, j, 5);
        for (uint32_t axis = 0; axis < 2; ++axis) { /* some in one place */
            out->position_m[j][axis] =
                made_up_draw(seed, 4 + axis, j, kinds & SPACING ? 4 : 1);
        }
        for (uint32_t i = 0; i < j; ++i) {
            out->is_listed[i][j] = out->is_listed[j][i] =
                made_up_draw(seed, 6, 100 * i + j, 8) == 0;
        }
    }
    if (seed % 2) {
        made_up_nest(out);
    }
    for (size_t j = 0; j < candidates; ++j) {
        out->conflict_first[j] = listed;
        for (size_t i = 0; i < candidates; ++i) {
            if (out->is_listed[j][i]) {
                out->conflict[listed++] = (uint32_t)i;
            }
        }
    }
    out->conflict_first[candidates] = listed;
    for (uint32_t c = 0; c < 3; ++c) {
        out->min[c] = made_up_draw(seed, 7, c, 2);
        out->max[c] = 1 + made_up_draw(seed, 8, c, 2);
    }
    if (kinds & (CAPS | MIN)) {
        constraints->classes = 3;
        constraints->class_of = out->class_of;
        constraints->min = kinds & MIN ? out->min : NULL;
        constraints->max = kinds & CAPS ? out->max : NULL;
    }
    if (kinds & BUDGET) {
        constraints->cost = out->cost;
        constraints->budget = 4 + made_up_draw(seed, 9, 0, 8);
    }
    if (kinds & FIXED) {
        out->fixed[0] = made_up_draw(seed, 10, 0, (uint32_t)candidates);
        constraints->fixed = out->fixed;
        constraints->fixed_count = 1;
        out->fixed[1] = made_up_draw(seed, 10, 1, (uint32_t)candidates);
        constraints->fixed_count +=
            out->fixed[1] != out->fixed[0] && seed % 2 == 0;
    }
    constraints->site = kinds & SITES ? out->site : NULL;
    if (kinds & SPACING) {
        constraints->position_m = (const double(*)[3])out->position_m;
        constraints->spacing_m = 1.2;
    }
    if (kinds & LIST) {
        constraints->conflict_first = out->conflict_first;
        constraints->conflict = out->conflict;
    }
}

static bool made_up_excludes(const made_up_constraints *m, size_t a, size_t b)
{
    const double x = m->position_m[a][0] - m->position_m[b][0];
    const double y = m->position_m[a][1] - m->position_m[b][1];
    return (m->kinds & SITES && m->site[a] == m->site[b]) ||
           (m->kinds & SPACING && hypot(x, y) < 1.2) ||
           (m->kinds & LIST && m->is_listed[a][b]);
}

/* Whether the set (bit j: candidate j) meets all constraints except the
 * number of sensors, which the caller compares. */
static bool made_up_keeps(const made_up_constraints *m, uint32_t set)
{
    /* Count the members of each class, add up costs, and refuse pairs that
     * exclude each other. */
    size_t class_count[3] = {0};
    int64_t cost = 0;
    for (size_t j = 0; j < m->candidates; ++j) {
        if (!(set >> j & 1)) {
            continue;
        }
        ++class_count[m->class_of[j]];
        cost += m->cost[j];
        for (size_t i = 0; i < j; ++i) {
            if (set >> i & 1 && made_up_excludes(m, i, j)) {
                return false;
            }
        }
    }
    /* Minimum and maximum of each class. */
    for (size_t c = 0; c < 3; ++c) {
        if ((m->kinds & MIN && class_count[c] < m->min[c]) ||
            (m->kinds & CAPS && class_count[c] > m->max[c])) {
            return false;
        }
    }
    /* All fixed sensors are in the set, and the cost is within the budget. */
    for (size_t k = 0; k < m->constraints.fixed_count; ++k) {
        if (!(set >> m->fixed[k] & 1)) {
            return false;
        }
    }
    return set != 0 && (!(m->kinds & BUDGET) || cost <= m->constraints.budget);
}

static uint64_t made_up_set_value(const made_up *m, uint32_t set)
{
    size_t plan[MADE_UP_MAX], n = 0;
    for (size_t j = 0; j < m->problem.candidates; ++j) {
        if (set >> j & 1) {
            plan[n++] = j;
        }
    }
    return made_up_value(m, plan, n);
}

/* best[n]: of the plans of n sensors; UINT64_MAX: there is none. */
static inline void made_up_ruled_optima(const made_up *m,
                                        const made_up_constraints *r,
                                        uint64_t best[MADE_UP_MAX + 1])
{
    for (size_t n = 0; n <= MADE_UP_MAX; ++n) {
        best[n] = UINT64_MAX;
    }
    for (uint32_t set = 1; set < 1u << r->candidates; ++set) {
        if (made_up_keeps(r, set)) {
            const int n = __builtin_popcount(set);
            const uint64_t value = made_up_set_value(m, set);
            if (best[n] == UINT64_MAX || value > best[n]) {
                best[n] = value;
            }
        }
    }
}

/* The set of a plan: bit j for candidate j. */
static inline uint32_t made_up_set(const murk_place_result *plan)
{
    uint32_t set = 0;
    for (size_t k = 0; k < plan->count; ++k) {
        set |= 1u << plan->sensor[k];
    }
    return set;
}

/* The largest value of plans of `count` sensors; with a budget, of plans of any
 * number up to `count`, where 0 means all candidates. best: as
 * made_up_ruled_optima() sets it. UINT64_MAX: there is no plan. */
static inline uint64_t
made_up_ruled_optimum(const made_up_constraints *r,
                      const uint64_t best[MADE_UP_MAX + 1], size_t count)
{
    if (!(r->kinds & BUDGET)) {
        return best[count];
    }
    uint64_t max = UINT64_MAX;
    for (size_t n = 1; n <= (count > 0 ? count : r->candidates); ++n) {
        if (best[n] != UINT64_MAX && (max == UINT64_MAX || best[n] > max)) {
            max = best[n];
        }
    }
    return max;
}

#endif
