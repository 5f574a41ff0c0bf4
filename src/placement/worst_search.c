/* Greedy and relocation for objectives over several blocks
 * (placement/worst_search.h). The candidates are evaluated in falling order of
 * an upper bound on the objective, made of upper bounds on the gains in each
 * block. */
#include "placement/worst_search.h"

#include "base/interrupt.h"
#include "base/sort.h"

#include <stdlib.h>
#include <string.h>

typedef struct murk_candidate_bound {
    murk_objective_value value_bound; /* upper bound on the objective */
    uint32_t candidate;
} murk_candidate_bound;

murk_status murk_worst_search_init(murk_worst_search *out,
                                   const murk_block_layouts *layouts,
                                   murk_gain_scan *scan, murk_arena *arena,
                                   murk_error *err)
{
    const size_t n = scan->evaluator->candidates + 1;
    const size_t blocks = layouts->blocks->n;
    *out = (murk_worst_search){
        .layouts = layouts, .evaluator = scan->evaluator, .scan = scan};
    out->max = murk_arena_array(arena, n * blocks, sizeof *out->max);
    out->gain =
        murk_arena_array(arena, MURK_SCAN_CHUNK * blocks, sizeof *out->gain);
    out->candidate_bound =
        murk_arena_array(arena, n, sizeof *out->candidate_bound);
    return arena->is_short
               ? murk_no_memory(err, "", "to search %zu candidates", n - 1)
               : MURK_OK;
}

/* ---- objective values ---- */

/* The objective value of the partial plan with gain[] added (NULL: as it is).
 */
static murk_objective_value
objective_with(const murk_worst_search *s,
               const murk_block_objective *objective, const uint64_t *gain)
{
    murk_objective_value out = {objective->is_min ? UINT64_MAX : 0, 0};
    for (size_t c = 0; c < s->layouts->blocks->n; ++c) {
        const uint64_t share =
            murk_block_worth(s->layouts, c, s->value[c] + (gain ? gain[c] : 0));
        if (objective->is_min) {
            out.first = share < out.first ? share : out.first;
            out.second += share;
        } else {
            out.first += objective->factor[c] *
                         (share < objective->level ? share : objective->level);
        }
    }
    return out;
}

const murk_block_objective MURK_MINIMUM_FIRST = {.is_min = true};

/* ---- the partial plan ---- */

static void add_to_plan(murk_worst_search *s, uint32_t candidate)
{
    const murk_row row = murk_evaluator_row(s->evaluator, 0, candidate);
    for (size_t c = 0; c < s->layouts->blocks->n; ++c) {
        s->value[c] +=
            murk_row_gain(&s->layouts->layout[c], &row, &s->scan->cover);
    }
    murk_gain_scan_add(s->scan, candidate);
}

/* Makes the partial plan equal to plan[n] without the entry `but` (n: all). */
static void set_all_but(murk_worst_search *s, const uint32_t *plan, size_t n,
                        size_t but)
{
    murk_gain_scan_set_all_but(s->scan, plan, 0, 0);
    memset(s->value, 0, sizeof s->value);
    for (size_t k = 0; k < n; ++k) {
        if (k != but) {
            add_to_plan(s, plan[k]);
        }
    }
}

/* ---- the best candidate ---- */

static bool can_add(const murk_worst_search *s, uint32_t candidate)
{
    return !s->scan->is_partial[candidate] &&
           murk_gain_scan_can_add(s->scan, candidate);
}

static int by_bound(const void *a, const void *b)
{
    const murk_candidate_bound *x = a, *y = b;
    if (murk_objective_is_greater(x->value_bound, y->value_bound) ||
        murk_objective_is_greater(y->value_bound, x->value_bound)) {
        return murk_objective_is_greater(x->value_bound, y->value_bound) ? -1
                                                                         : 1;
    }
    return MURK_ORDER(x->candidate, y->candidate);
}

/* Finds the candidate that makes the objective value largest, if that exceeds
 * *value_bound, which is raised; the lowest index on ties. False if no
 * candidate does. Only undominated candidates are tried, as a dominated one is
 * never better than the dominator. */
static bool find_best(murk_worst_search *s,
                      const murk_block_objective *objective,
                      murk_objective_value *value_bound, uint32_t *best)
{
    const murk_evaluator *o = s->evaluator;
    const size_t blocks = s->layouts->blocks->n;
    /* Sort the candidates by an upper bound on the objective. */
    size_t n = 0;
    for (size_t k = 0; k < o->undominated; ++k) {
        const uint32_t j = o->ranked[k].candidate;
        const murk_objective_value max =
            objective_with(s, objective, s->max + j * blocks);
        if (murk_objective_is_greater(max, *value_bound) && can_add(s, j)) {
            s->candidate_bound[n++] = (murk_candidate_bound){max, j};
        }
    }
    qsort(s->candidate_bound, n, sizeof *s->candidate_bound, by_bound);
    bool is_found = false;
    for (size_t k = 0; k < n && !murk_interrupted();) {
        size_t gathered = 0;
        /* Gather candidates that may be the best, and evaluate them. */
        for (; k < n && gathered < MURK_SCAN_CHUNK &&
               !murk_objective_is_greater(*value_bound,
                                          s->candidate_bound[k].value_bound);
             ++k) {
            s->scan->chunk[gathered++] = s->candidate_bound[k].candidate;
        }
        if (gathered == 0) {
            break;
        }
        murk_block_gains(s->layouts, &s->scan->cover, s->scan->chunk, gathered,
                         s->gain);
        s->evaluations += gathered;
        for (size_t i = 0; i < gathered; ++i) {
            const uint32_t j = s->scan->chunk[i];
            const murk_objective_value now =
                objective_with(s, objective, s->gain + i * blocks);
            if (murk_objective_is_greater(now, *value_bound) ||
                (is_found && !murk_objective_is_greater(*value_bound, now) &&
                 j < *best)) {
                *value_bound = now;
                *best = j;
                is_found = true;
            }
        }
    }
    return is_found;
}

/* The lowest candidate that can be added, if there is one. */
static bool find_any(const murk_worst_search *s, uint32_t *candidate)
{
    for (uint32_t j = 0; j < s->evaluator->candidates; ++j) {
        if (can_add(s, j)) {
            *candidate = j;
            return true;
        }
    }
    return false;
}

/* ---- plans ---- */

uint64_t murk_worst_value(murk_worst_search *s, const uint32_t *plan, size_t n)
{
    set_all_but(s, plan, n, n);
    return objective_with(s, &MURK_MINIMUM_FIRST, NULL).first;
}

/* Resets the upper bounds on gains to the values of the candidates alone, which
 * bound every later gain. */
static void reset_gain_bounds(murk_worst_search *s)
{
    memcpy(s->max, s->layouts->max,
           s->evaluator->candidates * s->layouts->blocks->n * sizeof *s->max);
}

uint64_t murk_worst_greedy(murk_worst_search *s,
                           const murk_block_objective *objective,
                           uint32_t *plan, size_t given, size_t n)
{
    const bool has_budget = murk_has_budget(s->evaluator->set);
    given = murk_search_begin(s->scan, plan, given, n);
    set_all_but(s, plan, given, given);
    reset_gain_bounds(s);
    s->scan->size = given;
    for (size_t k = given; k < n && !murk_interrupted(); ++k) {
        murk_objective_value value_bound = objective_with(s, objective, NULL);
        /* Choose the candidate that increases the objective most. If no
         * candidate increases the objective, choose the candidate that most
         * increases the smallest share, or, with equal smallest shares, the sum
         * of the shares. If no candidate increases these either, take the first
         * candidate that can be added; but with a budget stop here, once the
         * plan has the required sensors. */
        bool is_found = find_best(s, objective, &value_bound, &plan[k]);
        if (!is_found) {
            value_bound = objective_with(s, &MURK_MINIMUM_FIRST, NULL);
            is_found =
                find_best(s, &MURK_MINIMUM_FIRST, &value_bound, &plan[k]);
        }
        const bool is_enough = has_budget && s->scan->partial.missing == 0;
        if (!is_found && (is_enough || !find_any(s, &plan[k]))) {
            break;
        }
        add_to_plan(s, plan[k]);
        s->scan->size = k + 1;
    }
    return objective_with(s, &MURK_MINIMUM_FIRST, NULL).first;
}

/* Relocates single sensors until no sensor moves, or until asked to finish. */
static void relocate_sensors(murk_worst_search *s, uint32_t *plan, size_t n)
{
    const size_t fixed = murk_fixed_count(s->evaluator->set);
    const size_t movers = n - fixed;
    size_t still = 0; /* sensors in a row that did not move */
    s->scan->is_move = true;
    reset_gain_bounds(s);
    for (size_t at = 0; still < movers && !murk_must_finish();
         at = (at + 1) % movers) {
        const size_t k = fixed + at;
        set_all_but(s, plan, n, k);
        murk_block_gains(s->layouts, &s->scan->cover, &plan[k], 1, s->gain);
        murk_objective_value value_bound =
            objective_with(s, &MURK_MINIMUM_FIRST, s->gain);
        if (find_best(s, &MURK_MINIMUM_FIRST, &value_bound, &plan[k])) {
            still = 0;
        }
        ++still; /* a sensor that has just moved is at the best candidate */
    }
}

uint64_t murk_worst_relocate(murk_worst_search *s, uint32_t *plan, size_t n)
{
    murk_search_begin(s->scan, plan, n, n);
    relocate_sensors(s, plan, n);
    s->scan->size = n;
    while (murk_has_budget(s->evaluator->set) && !murk_interrupted()) {
        const size_t before = s->scan->size;
        murk_worst_greedy(s, &MURK_MINIMUM_FIRST, plan, before,
                          s->evaluator->set->max_sensors);
        if (s->scan->size == before) {
            break;
        }
        relocate_sensors(s, plan, s->scan->size);
    }
    return murk_worst_value(s, plan, s->scan->size);
}
