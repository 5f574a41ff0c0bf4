#include "placement/scan.h"

#include "base/interrupt.h"

#include <string.h>

#define NOT_WEIGHED UINT64_MAX

uint64_t murk_scan_stand(murk_search *s, uint32_t candidate)
{
    const murk_layout *layout = s->evaluator->layout;
    const murk_row row = murk_evaluator_row(s->evaluator, s->worker, candidate);
    s->looks += s->evaluator->matrix ? 0 : 1;
    s->rows += 2; /* weighed and joined */
    const uint64_t gain = murk_row_gain(layout, &row, &s->cover);
    murk_cover_add(&s->cover, layout, &row);
    s->is_partial[candidate] = true;
    if (s->evaluator->book) {
        murk_partial_plan_add(&s->partial, candidate);
    }
    return gain;
}

uint64_t murk_scan_stand_others(murk_search *s, const uint32_t *plan, size_t n,
                                size_t but)
{
    murk_cover_clear(&s->cover, s->evaluator->layout);
    memset(s->is_partial, 0, s->evaluator->candidates * sizeof *s->is_partial);
    if (s->evaluator->book) {
        murk_partial_plan_clear(&s->partial, s->partial.wanted);
    }
    uint64_t value = 0;
    for (size_t k = 0; k < n; ++k) {
        if (k != but) {
            value += murk_scan_stand(s, plan[k]);
        }
    }
    return value;
}

uint64_t murk_scan_weigh(murk_search *s, size_t n, uint64_t best)
{
    murk_evaluator_gains(s->evaluator, &s->cover, s->chunk, n, s->threads,
                         s->worker, s->chunk_gain);
    s->evaluations += n;
    s->rows += n;
    s->looks += s->evaluator->matrix ? 0 : n;
    for (size_t k = 0; k < n; ++k) {
        s->gain[s->chunk[k]] = s->chunk_gain[k];
        best = s->chunk_gain[k] > best ? s->chunk_gain[k] : best;
    }
    return best;
}

/* Weighs those of the chunk that may be the best: first the most promising. */
static uint64_t weigh_promising(murk_search *s, size_t n, uint64_t best)
{
    if (!s->max || n == 0) {
        return murk_scan_weigh(s, n, best);
    }
    murk_evaluator_mosts(s->evaluator, &s->cover, s->chunk, n, s->threads,
                         s->worker, s->chunk_gain);
    s->evaluations += n;
    size_t first = 0;
    for (size_t k = 0; k < n; ++k) {
        s->max[s->chunk[k]] = s->chunk_gain[k];
        first = s->chunk_gain[k] > s->chunk_gain[first] ? k : first;
    }
    const uint32_t held = s->chunk[0];
    s->chunk[0] = s->chunk[first];
    s->chunk[first] = held;
    if (s->max[s->chunk[0]] < best) {
        return best;
    }
    best = murk_scan_weigh(s, 1, best);
    size_t kept = 0;
    for (size_t k = 1; k < n; ++k) {
        if (s->max[s->chunk[k]] >= best) {
            s->chunk[kept++] = s->chunk[k];
        }
    }
    return murk_scan_weigh(s, kept, best);
}

/* The undominated, from the most promising on, until the rest cannot reach
 * the best. */
static uint64_t weigh_undominated(murk_search *s, const murk_ranked *ranking)
{
    const size_t n = s->evaluator->undominated;
    uint64_t best = 0;
    for (size_t k = 0; k < n && ranking[k].bound >= best;) {
        if (murk_interrupted()) {
            return 0;
        }
        size_t gathered = 0;
        for (;
             k < n && gathered < MURK_SEARCH_CHUNK && ranking[k].bound >= best;
             ++k) {
            if (murk_scan_is_open(s, ranking[k].candidate)) {
                s->chunk[gathered++] = ranking[k].candidate;
            }
        }
        best = weigh_promising(s, gathered, best);
    }
    return best;
}

/* The dominated whose dominator has the best gain: they may tie. */
static void weigh_dominated(murk_search *s, uint64_t best)
{
    const murk_evaluator *o = s->evaluator;
    size_t gathered = 0;
    for (size_t k = o->undominated; k < o->candidates; ++k) {
        const uint32_t j = o->ranked[k].candidate;
        if (s->gain[o->dominator[j]] == best && o->alone[j] >= best &&
            murk_scan_is_open(s, j)) {
            s->chunk[gathered++] = j;
        }
        if (gathered == MURK_SEARCH_CHUNK) {
            murk_scan_weigh(s, gathered, best);
            gathered = 0;
        }
    }
    murk_scan_weigh(s, gathered, best);
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

uint64_t murk_scan_candidates(murk_search *s, const murk_ranked *ranking,
                              const uint32_t *plan, size_t n, size_t but,
                              uint64_t value)
{
    const murk_evaluator *o = s->evaluator;
    memset(s->gain, 0xff, o->candidates * sizeof *s->gain); /* NOT_WEIGHED */
    if (s->max) {
        memset(s->max, 0xff, o->candidates * sizeof *s->max);
    }
    uint64_t best = 0;
    if (value < o->ceiling) {
        best = weigh_undominated(s, ranking);
    }
    s->ties = 0;
    if (best == 0) { /* all that are free add the same: nothing */
        for (uint32_t j = 0; j < o->candidates; ++j) {
            if (!holds(plan, n, but, j) && murk_scan_is_open(s, j)) {
                s->tie[s->ties++] = j;
            }
        }
        return 0;
    }
    weigh_dominated(s, best);
    for (uint32_t j = 0; j < o->candidates; ++j) {
        if (s->gain[j] == best) {
            s->tie[s->ties++] = j;
        }
    }
    return best;
}

void murk_scan_sharpen(murk_search *s)
{
    /* what was weighed can only fall, but for rounding */
    const size_t n = s->evaluator->undominated;
    for (size_t k = 0; k < n; ++k) {
        const uint32_t j = s->ranking[k].candidate;
        if (s->gain[j] != NOT_WEIGHED) {
            s->ranking[k].bound = s->gain[j] + murk_scan_slack(s, j);
        } else if (s->max && s->max[j] != NOT_WEIGHED) {
            const uint64_t max = s->max[j] + murk_scan_slack(s, j);
            uint64_t *bound = &s->ranking[k].bound;
            *bound = max < *bound ? max : *bound;
        }
    }
    murk_ranked_sort(s->ranking, n);
}
