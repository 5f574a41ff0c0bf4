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
    return work / murk_evaluator_work(evaluator, 1);
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
    if (murk_evaluator_is_distributed(evaluator) && !out->max) {
        out->ahead = murk_arena_array(arena, n, sizeof *out->ahead);
        out->ahead_list = murk_arena_array(arena, n, sizeof *out->ahead_list);
        out->ahead_gain = murk_arena_array(arena, n, sizeof *out->ahead_gain);
    }
    if (murk_evaluator_asks_parts(evaluator)) {
        out->entry_max = murk_arena_array(arena, evaluator->layout->slots,
                                          sizeof *out->entry_max);
        out->is_entry_max_old = true;
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

/* The needs of an evaluation over the present cover; NULL: no part of a row is
 * asked for, as rows are in memory. */
static const murk_row_need *update_need(murk_gain_scan *s, uint64_t gain_min,
                                        murk_row_need *need)
{
    if (!s->entry_max) {
        return NULL;
    }
    if (s->is_entry_max_old) {
        murk_evaluator_bound_entries(s->evaluator, &s->cover, s->entry_max);
        s->is_entry_max_old = false;
    }
    *need = (murk_row_need){s->entry_max, gain_min};
    return need;
}

uint64_t murk_gain_scan_add(murk_gain_scan *s, uint32_t candidate)
{
    const murk_layout *layout = s->evaluator->layout;
    murk_row_need need;
    const murk_row row = murk_evaluator_part(s->evaluator, s->worker, candidate,
                                             update_need(s, 0, &need));
    s->queries += s->evaluator->matrix ? 0 : 1;
    s->rows += 2; /* evaluated and added */
    const uint64_t gain = murk_row_gain(layout, &row, &s->cover);
    murk_cover_add(&s->cover, layout, &row);
    s->is_entry_max_old = true;
    s->value += gain;
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
    s->is_entry_max_old = true;
    s->value = 0;
    memset(s->is_partial, 0, s->evaluator->candidates * sizeof *s->is_partial);
    if (s->evaluator->set) {
        murk_partial_plan_clear(&s->partial, s->partial.wanted);
    }
    for (size_t k = 0; k < n; ++k) {
        if (k != but) {
            (void)murk_gain_scan_add(s, plan[k]);
        }
    }
    return s->value;
}

/* Candidates that are evaluated before the largest gain so far becomes the
 * smallest gain of interest. A constant, so the sightlines that are looked
 * along do not depend on the number of threads. */
#define ROWS_PER_COMPARISON 32

/* Evaluates the candidates of the chunk, whose rows are asked of the problem if
 * they are not in memory. */
static void compute_gains(murk_gain_scan *s, size_t n, uint64_t best)
{
    const murk_evaluator *o = s->evaluator;
    /* Gains that a pass for several searches has computed. */
    if (s->known) {
        for (size_t k = 0; k < n; ++k) {
            s->chunk_gain[k] = s->known[s->chunk[k] * s->known_step];
        }
        return;
    }
    /* A partial plan that sees nothing leaves each candidate's value. */
    if (!o->matrix && s->value == 0) {
        for (size_t k = 0; k < n; ++k) {
            s->chunk_gain[k] = o->single_value[s->chunk[k]];
        }
        return;
    }
    const size_t at_once =
        s->entry_max && s->is_moving ? ROWS_PER_COMPARISON : n;
    for (size_t first = 0; first < n; first += at_once) {
        const size_t left = n - first;
        const uint64_t gain_min = best > s->gain_min ? best : s->gain_min;
        murk_row_need need;
        murk_evaluator_needed_gains(
            o, &s->cover, s->chunk + first, left < at_once ? left : at_once,
            s->threads, s->worker,
            update_need(s, s->is_moving ? gain_min : 0, &need),
            s->chunk_gain + first);
        for (size_t k = first; k < n && k < first + at_once; ++k) {
            best = s->chunk_gain[k] > best ? s->chunk_gain[k] : best;
        }
    }
}

uint64_t murk_gain_scan_evaluate(murk_gain_scan *s, size_t n, uint64_t best)
{
    compute_gains(s, n, best);
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

static uint64_t larger(uint64_t a, uint64_t b)
{
    return a > b ? a : b;
}

/* Candidates whose gains are first computed ahead; each time later as many as
 * before together (a choice). */
#define FIRST_AHEAD 1024

/* With a distributed matrix every evaluation is an exchange. So that a scan
 * makes few of them, the gains of more candidates in the order of the ranking,
 * at least up to number `end`, are computed and exchanged at once. Some may be
 * in vain; only those that the scan takes are counted. */
static void evaluate_ahead(murk_gain_scan *s, const murk_ranked *ranking,
                           size_t end)
{
    if (s->ahead_end >= end) {
        return;
    }
    const size_t all = s->evaluator->undominated, first = s->ahead_end;
    size_t past = first > 0 ? 2 * first : FIRST_AHEAD;
    past = past < end ? end : past;
    past = past < all ? past : all;
    for (size_t k = first; k < past; ++k) {
        s->ahead_list[k - first] = ranking[k].candidate;
    }
    murk_evaluator_gains(s->evaluator, &s->cover, s->ahead_list, past - first,
                         s->threads, s->worker, s->ahead_gain);
    for (size_t k = first; k < past; ++k) {
        s->ahead[ranking[k].candidate] = s->ahead_gain[k - first];
    }
    s->ahead_end = past;
}

/* Evaluates the undominated candidates by falling upper bound, until no bound
 * reaches the best gain. Returns the best gain; 0 if the run is interrupted. */
static uint64_t evaluate_undominated(murk_gain_scan *s,
                                     const murk_ranked *ranking)
{
    const size_t n = s->evaluator->undominated;
    /* In an unknown environment gains below s->gain_min may be inexact, so they
     * must not decide which candidates are evaluated. */
    const uint64_t min = s->evaluator->matrix ? 0 : s->gain_min;
    uint64_t best = 0;
    const bool evaluates_ahead = s->ahead && !s->known;
    s->ahead_end = 0;
    for (size_t k = 0; k < n && ranking[k].bound >= larger(best, min);) {
        if (murk_interrupted()) {
            best = 0;
            break;
        }
        size_t gathered = 0;
        for (; k < n && gathered < MURK_SCAN_CHUNK &&
               ranking[k].bound >= larger(best, min);
             ++k) {
            if (murk_gain_scan_can_add(s, ranking[k].candidate)) {
                s->chunk[gathered++] = ranking[k].candidate;
            }
        }
        if (evaluates_ahead) {
            evaluate_ahead(s, ranking, k);
            s->known = s->ahead;
            s->known_step = 1;
        }
        best = evaluate_promising(s, gathered, best);
    }
    s->known = evaluates_ahead ? NULL : s->known;
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

uint64_t murk_gain_scan_find_move(murk_gain_scan *s, uint64_t value,
                                  uint64_t gain_min)
{
    s->is_moving = true;
    s->gain_min = gain_min;
    const uint64_t best =
        murk_gain_scan_find_best(s, s->evaluator->ranked, value);
    s->is_moving = false;
    s->gain_min = 0;
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
