/* Scans: the largest gain over a partial plan, and all candidates that have it.
 * Undominated candidates are evaluated in falling order of an upper bound until
 * the bound falls below the best gain; dominated candidates are evaluated only
 * if the dominator has the best gain. Upper bounds for detection probabilities
 * are many times faster than gains, so they come first. */
#include "placement/scan.h"

#include "base/interrupt.h"
#include "placement/settings.h"

#include <string.h>

#define NOT_EVALUATED UINT64_MAX

uint64_t murk_gain_scan_rows_max(const murk_evaluator *evaluator)
{
    const uint64_t work =
        evaluator->search_work ? evaluator->search_work : MURK_SEARCH_WORK;
    return evaluator->matrix ? work / murk_evaluator_work(evaluator, 1)
                             : UINT64_MAX;
}

murk_status murk_gain_scan_init(murk_gain_scan *out,
                                const murk_evaluator *evaluator,
                                unsigned worker, unsigned threads,
                                murk_error *err)
{
    const size_t n = evaluator->candidates + 1;
    *out = (murk_gain_scan){.evaluator = evaluator,
                            .has_many_layers = evaluator->layout->layers > 1 ||
                                               evaluator->layout->doses,
                            .worker = worker,
                            .rows_max = UINT64_MAX,
                            .threads = threads};
    murk_arena *arena = &out->arena;
    out->gain = murk_arena_array(arena, n, sizeof *out->gain);
    out->tie = murk_arena_array(arena, n, sizeof *out->tie);
    out->shuffle = murk_arena_array(arena, n, sizeof *out->shuffle);
    out->ranking = murk_arena_array(arena, n, sizeof *out->ranking);
    out->is_partial = murk_arena_array(arena, n, sizeof *out->is_partial);
    out->chunk = murk_arena_array(arena, MURK_SCAN_CHUNK, sizeof *out->chunk);
    out->chunk_gain =
        murk_arena_array(arena, MURK_SCAN_CHUNK, sizeof *out->chunk_gain);
    /* Costs matter only with a budget; fast upper bounds exist for detection
     * probabilities. */
    if (murk_has_budget(evaluator->set)) {
        out->priced = murk_arena_array(arena, n, sizeof *out->priced);
    }
    if (evaluator->matrix && evaluator->slack) {
        out->max = murk_arena_array(arena, n, sizeof *out->max);
    }
    murk_status status = MURK_OK;
    if (arena->is_short || !murk_cover_init(&out->cover, evaluator->layout,
                                            evaluator->is_binary)) {
        status =
            murk_no_memory(err, "", "to search %zu candidates for %zu photons",
                           evaluator->candidates, evaluator->layout->photons);
    } else if (evaluator->set) {
        status = murk_partial_plan_init(&out->partial, evaluator->set, err);
    }
    if (status) {
        murk_gain_scan_release(out);
    }
    return status;
}

void murk_gain_scan_release(murk_gain_scan *search)
{
    murk_cover_release(&search->cover);
    murk_partial_plan_release(&search->partial);
    murk_arena_release(&search->arena);
    *search = (murk_gain_scan){0};
}

uint64_t murk_gain_scan_add(murk_gain_scan *s, uint32_t candidate)
{
    const murk_layout *layout = s->evaluator->layout;
    const murk_row row = murk_evaluator_row(s->evaluator, s->worker, candidate);
    s->queries += s->evaluator->matrix ? 0 : 1;
    s->rows += 2; /* evaluated and added */
    const uint64_t gain = murk_row_gain(layout, &row, &s->cover);
    murk_cover_add(&s->cover, layout, &row);
    s->is_partial[candidate] = true;
    if (s->evaluator->set) {
        murk_partial_plan_add(&s->partial, candidate);
    }
    return gain;
}

uint64_t murk_gain_scan_set_all_but(murk_gain_scan *s, const uint32_t *plan,
                                    size_t n, size_t but)
{
    murk_cover_clear(&s->cover, s->evaluator->layout);
    memset(s->is_partial, 0, s->evaluator->candidates * sizeof *s->is_partial);
    if (s->evaluator->set) {
        murk_partial_plan_clear(&s->partial, s->partial.wanted);
    }
    uint64_t value = 0;
    for (size_t k = 0; k < n; ++k) {
        if (k != but) {
            value += murk_gain_scan_add(s, plan[k]);
        }
    }
    return value;
}

uint64_t murk_gain_scan_evaluate(murk_gain_scan *s, size_t n, uint64_t best)
{
    if (s->known) {
        for (size_t k = 0; k < n; ++k) {
            s->chunk_gain[k] = s->known[s->chunk[k] * s->known_step];
        }
    } else {
        murk_evaluator_gains(s->evaluator, &s->cover, s->chunk, n, s->threads,
                             s->worker, s->chunk_gain);
    }
    s->evaluations += n;
    s->rows += n;
    s->queries += s->evaluator->matrix ? 0 : n;
    for (size_t k = 0; k < n; ++k) {
        s->gain[s->chunk[k]] = s->chunk_gain[k];
        best = s->chunk_gain[k] > best ? s->chunk_gain[k] : best;
    }
    return best;
}

/* Evaluates the candidates of the chunk that may have the best gain. With fast
 * upper bounds: the candidate with the largest bound first, then those whose
 * bound still reaches the best gain. */
static uint64_t evaluate_promising(murk_gain_scan *s, size_t n, uint64_t best)
{
    if (!s->max || n == 0) {
        return murk_gain_scan_evaluate(s, n, best);
    }
    murk_evaluator_gain_bounds(s->evaluator, &s->cover, s->chunk, n, s->threads,
                               s->worker, s->chunk_gain);
    s->evaluations += n;
    size_t first = 0;
    for (size_t k = 0; k < n; ++k) {
        s->max[s->chunk[k]] = s->chunk_gain[k];
        first = s->chunk_gain[k] > s->chunk_gain[first] ? k : first;
    }
    /* Evaluate the candidate with the largest bound. */
    const uint32_t held = s->chunk[0];
    s->chunk[0] = s->chunk[first];
    s->chunk[first] = held;
    if (s->max[s->chunk[0]] < best) {
        return best;
    }
    best = murk_gain_scan_evaluate(s, 1, best);
    /* Then those that may still reach the best gain. */
    size_t remaining = 0;
    for (size_t k = 1; k < n; ++k) {
        if (s->max[s->chunk[k]] >= best) {
            s->chunk[remaining++] = s->chunk[k];
        }
    }
    return murk_gain_scan_evaluate(s, remaining, best);
}

/* Evaluates the undominated candidates by falling upper bound, until no bound
 * reaches the best gain. Returns the best gain; 0 if the run is interrupted. */
static uint64_t evaluate_undominated(murk_gain_scan *s,
                                     const murk_ranked *ranking)
{
    const size_t n = s->evaluator->undominated;
    uint64_t best = 0;
    for (size_t k = 0; k < n && ranking[k].bound >= best;) {
        if (murk_interrupted()) {
            return 0;
        }
        size_t gathered = 0;
        for (; k < n && gathered < MURK_SCAN_CHUNK && ranking[k].bound >= best;
             ++k) {
            if (murk_gain_scan_can_add(s, ranking[k].candidate)) {
                s->chunk[gathered++] = ranking[k].candidate;
            }
        }
        best = evaluate_promising(s, gathered, best);
    }
    return best;
}

/* Evaluates the dominated candidates whose dominator has the best gain: they
 * may tie. */
static void evaluate_dominated(murk_gain_scan *s, uint64_t best)
{
    const murk_evaluator *o = s->evaluator;
    size_t gathered = 0;
    for (size_t k = o->undominated; k < o->candidates; ++k) {
        const uint32_t j = o->ranked[k].candidate;
        if (s->gain[o->dominator[j]] == best && o->single_value[j] >= best &&
            murk_gain_scan_can_add(s, j)) {
            s->chunk[gathered++] = j;
        }
        if (gathered == MURK_SCAN_CHUNK) {
            murk_gain_scan_evaluate(s, gathered, best);
            gathered = 0;
        }
    }
    murk_gain_scan_evaluate(s, gathered, best);
}

uint64_t murk_gain_scan_find_best(murk_gain_scan *s, const murk_ranked *ranking,
                                  uint64_t value)
{
    const murk_evaluator *o = s->evaluator;
    memset(s->gain, 0xff, o->candidates * sizeof *s->gain); /* NOT_EVALUATED */
    if (s->max) {
        memset(s->max, 0xff, o->candidates * sizeof *s->max);
    }
    uint64_t best = 0;
    if (value < o->ceiling) {
        best = evaluate_undominated(s, ranking);
    }
    s->ties = 0;
    if (best == 0) { /* every candidate that can be added has gain 0, or the run
                        is interrupted */
        for (uint32_t j = 0; j < o->candidates; ++j) {
            if (!s->is_partial[j] && murk_gain_scan_can_add(s, j)) {
                s->tie[s->ties++] = j;
            }
        }
        return 0;
    }
    evaluate_dominated(s, best);
    for (uint32_t j = 0; j < o->candidates; ++j) {
        if (s->gain[j] == best) {
            s->tie[s->ties++] = j;
        }
    }
    return best;
}

void murk_gain_scan_update_bounds(murk_gain_scan *s)
{
    /* computed gains bound later ones, up to the rounding slack */
    const size_t n = s->evaluator->undominated;
    for (size_t k = 0; k < n; ++k) {
        const uint32_t j = s->ranking[k].candidate;
        if (s->gain[j] != NOT_EVALUATED) {
            s->ranking[k].bound = s->gain[j] + murk_gain_scan_slack(s, j);
        } else if (s->max && s->max[j] != NOT_EVALUATED) {
            const uint64_t max = s->max[j] + murk_gain_scan_slack(s, j);
            uint64_t *bound = &s->ranking[k].bound;
            *bound = max < *bound ? max : *bound;
        }
    }
    murk_ranked_sort(s->ranking, n);
}
