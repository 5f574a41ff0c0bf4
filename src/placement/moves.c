/* Relocation under a rule on moves (placement/moves.h): steepest ascent over
 * the moves of single sensors, and over pairs of a return to the start plan and
 * a move. A scan finds the best newcomer of all candidates; the few places of
 * the start plan are evaluated one by one, because they cost nothing and may be
 * worth more with a smaller gain. */
#include "placement/moves.h"

#include "base/interrupt.h"

uint64_t murk_moves_objective(murk_gain_scan *s, const uint32_t *plan, size_t n)
{
    const uint64_t value = murk_gain_scan_set_all_but(s, plan, n, n);
    return murk_less_moves(s->evaluator->set, value,
                           murk_moves_with(&s->partial, s->partial.newcomers));
}

/* The best place so far for a sensor that the partial plan lacks. */
typedef struct best_place {
    uint64_t objective;
    uint32_t place;
    bool is_found;
} best_place;

/* Takes a candidate with this gain over the partial plan if it is better than
 * the best place so far. */
static void compare(best_place *best, const murk_gain_scan *s,
                    uint32_t candidate, uint64_t gain)
{
    const murk_constraint_set *set = s->evaluator->set;
    const size_t newcomers =
        s->partial.newcomers + murk_is_newcomer(set, candidate);
    const uint64_t objective = murk_less_moves(
        set, s->value + gain, murk_moves_with(&s->partial, newcomers));
    if (!best->is_found || objective > best->objective) {
        *best = (best_place){objective, candidate, true};
    }
}

/* Compares the candidates gathered in s->chunk. */
static void compare_chunk(best_place *best, murk_gain_scan *s, size_t *n)
{
    (void)murk_gain_scan_evaluate(s, *n, 0);
    for (size_t k = 0; k < *n; ++k) {
        compare(best, s, s->chunk[k], s->chunk_gain[k]);
    }
    *n = 0;
}

/* Compares the places of the start plan that can be added. */
static void compare_start(best_place *best, murk_gain_scan *s)
{
    const murk_constraint_set *set = s->evaluator->set;
    const murk_constraints *constraints = set->constraints;
    size_t gathered = 0;
    for (size_t k = 0; k < constraints->start_count; ++k) {
        const uint32_t j = constraints->start[k];
        if (set->is_start[j] && murk_gain_scan_can_add(s, j)) {
            s->chunk[gathered++] = j;
        }
        if (gathered == MURK_SCAN_CHUNK) {
            compare_chunk(best, s, &gathered);
        }
    }
    compare_chunk(best, s, &gathered);
}

/* Compares the newcomer with the largest gain. */
static void compare_newcomers(best_place *best, murk_gain_scan *s)
{
    const murk_constraint_set *set = s->evaluator->set;
    if (murk_moves_with(&s->partial, s->partial.newcomers + 1) >
        set->constraints->moves_max) {
        return;
    }
    const uint64_t gain = murk_gain_scan_find_move(s, s->value, 0);
    for (size_t k = 0; k < s->ties; ++k) {
        if (murk_is_newcomer(set, s->tie[k])) {
            compare(best, s, s->tie[k], gain);
            return; /* further ones are worth as much */
        }
    }
}

/* Makes the partial plan equal to plan[n] without the mover. */
static void set_all_but(murk_gain_scan *s, const uint32_t *plan, size_t n,
                        size_t mover)
{
    s->is_move = true;
    murk_gain_scan_set_all_but(s, plan, n, mover);
}

uint64_t murk_moves_find_place(murk_gain_scan *s, const uint32_t *plan,
                               size_t n, size_t mover, uint32_t *place)
{
    best_place best = {.is_found = false};
    set_all_but(s, plan, n, mover);
    /* The present place comes first, so that the sensor stays on ties. */
    size_t one = 1;
    s->chunk[0] = plan[mover];
    compare_chunk(&best, s, &one);
    compare_start(&best, s);
    compare_newcomers(&best, s);
    *place = best.place;
    return best.objective;
}

/* True if the search must end. */
static bool is_work_spent(murk_gain_scan *s)
{
    s->is_cut = s->is_cut || s->rows > s->rows_max;
    return s->is_cut || murk_must_finish();
}

/* Makes the best move of one sensor other than `but` if it leads to an
 * objective above *objective, which becomes that of the plan. */
static bool make_best_move(murk_gain_scan *s, uint32_t *plan, size_t n,
                           size_t but, uint64_t *objective)
{
    size_t mover = n;
    uint32_t place = 0;
    for (size_t k = murk_fixed_count(s->evaluator->set);
         k < n && !is_work_spent(s); ++k) {
        uint32_t best;
        const uint64_t with =
            k == but ? 0 : murk_moves_find_place(s, plan, n, k, &best);
        if (with > *objective) {
            *objective = with;
            mover = k;
            place = best;
        }
    }
    if (mover == n || murk_interrupted()) {
        return false;
    }
    plan[mover] = place;
    return true;
}

/* Moves a newcomer of the plan back to the best free place of the start plan,
 * and then another sensor, if both together lead to an objective above
 * *objective, which becomes that of the plan. */
static bool return_and_move(murk_gain_scan *s, uint32_t *plan, size_t n,
                            uint64_t *objective)
{
    const murk_constraint_set *set = s->evaluator->set;
    for (size_t k = murk_fixed_count(set); k < n && !is_work_spent(s); ++k) {
        const uint32_t before = plan[k];
        best_place best = {.is_found = false};
        if (!murk_is_newcomer(set, before)) {
            continue;
        }
        set_all_but(s, plan, n, k);
        compare_start(&best, s);
        if (best.is_found) {
            plan[k] = best.place;
            if (make_best_move(s, plan, n, k, objective)) {
                return true;
            }
            plan[k] = before;
        }
    }
    return false;
}

uint64_t murk_moves_relocate(murk_gain_scan *s, uint32_t *plan, size_t n)
{
    uint64_t objective = murk_moves_objective(s, plan, n);
    s->size = n;
    while (make_best_move(s, plan, n, n, &objective) ||
           return_and_move(s, plan, n, &objective)) {
    }
    return objective;
}
