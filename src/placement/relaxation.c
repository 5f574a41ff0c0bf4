/* Relaxations of the constraints, for candidates whose gains simply add up:
 * greedy over the matroid of class counts, greedy over sites, greedy over
 * newcomers and sensors of a start plan, and the fractional knapsack. The
 * knapsack charges Lagrangian multipliers for places in classes with a maximum
 * count; the multipliers are improved from call to call by Rprop steps. Every
 * bound is valid for every multiplier. */
#include "placement/relaxation.h"

#include <stdlib.h>
#include <string.h>

/* A gain below 2^63 times a cost below 2^64. */
__extension__ typedef unsigned __int128 wide;

static bool is_denser(uint64_t gain, uint64_t cost, uint64_t than_gain,
                      uint64_t than_cost)
{
    return (wide)gain * than_cost > (wide)than_gain * cost;
}

/* Falling gain per cost. Candidates without cost come first, by gain;
 * candidates without gain come last; then by index. */
int murk_compare_density(const void *a, const void *b)
{
    const murk_priced *x = a, *y = b;
    if ((x->gain == 0) != (y->gain == 0)) {
        return x->gain == 0 ? 1 : -1;
    }
    if ((x->cost == 0) != (y->cost == 0)) {
        return x->cost == 0 ? -1 : 1;
    }
    if (x->cost == 0 && x->gain != y->gain) {
        return x->gain > y->gain ? -1 : 1;
    }
    if (is_denser(x->gain, x->cost, y->gain, y->cost)) {
        return -1;
    }
    if (is_denser(y->gain, y->cost, x->gain, x->cost)) {
        return 1;
    }
    return (x->candidate > y->candidate) - (x->candidate < y->candidate);
}

murk_status murk_relaxation_init(murk_relaxation *out,
                                 const murk_constraint_set *set,
                                 murk_error *err)
{
    const size_t n = set->candidates + 1;
    *out = (murk_relaxation){.set = set};
    murk_arena *arena = &out->arena;
    out->order = murk_arena_array(arena, n, sizeof *out->order);
    out->picked = murk_arena_array(arena, n, sizeof *out->picked);
    out->priced = murk_arena_array(arena, n, sizeof *out->priced);
    out->value = murk_arena_array(arena, n, sizeof *out->value);
    out->cost = murk_arena_array(arena, n, sizeof *out->cost);
    out->class_count =
        murk_arena_array(arena, set->classes, sizeof *out->class_count);
    out->is_used =
        murk_arena_array(arena, set->sites + 1, sizeof *out->is_used);
    /* Multipliers exist only for maximum counts under a budget. */
    if (set->has_budget && set->has_caps) {
        out->multiplier =
            murk_arena_array(arena, set->classes, sizeof *out->multiplier);
    }
    if (arena->is_short) {
        murk_relaxation_release(out);
        return murk_no_memory(err, "", "to bound plans under rules");
    }
    return MURK_OK;
}

void murk_relaxation_release(murk_relaxation *relaxed)
{
    murk_arena_release(&relaxed->arena);
    *relaxed = (murk_relaxation){0};
}

/* Chooses the first `left` candidates of ranked[n] (or fewer) that the maximum
 * counts allow, and with with_min also the minimum counts, into r->picked.
 * Returns the sum of the gains. */
static uint64_t pick_by_class(murk_relaxation *r, const murk_partial_plan *s,
                              const murk_ranked *ranked, size_t n, size_t left,
                              bool with_min, size_t *chosen)
{
    const murk_constraint_set *set = r->set;
    size_t missing = with_min ? s->missing : 0, picked = 0;
    uint64_t sum = 0;
    memcpy(r->class_count, s->class_count,
           set->classes * sizeof *r->class_count);
    for (size_t k = 0; k < n && picked < left; ++k) {
        const uint32_t class = set->class_of[ranked[k].candidate];
        const bool is_asked =
            with_min && r->class_count[class] < set->min[class];
        if (r->class_count[class] < set->max[class] &&
            (is_asked || picked + 1 + missing <= left)) {
            ++r->class_count[class];
            missing -= is_asked;
            r->picked[picked++] = ranked[k];
            sum = murk_sum_saturated(sum, ranked[k].bound);
        }
    }
    *chosen = picked;
    return sum;
}

/* Chooses the first `left` candidates of r->order[n] (or fewer) with one a
 * site, into r->picked. Returns the sum of the gains. */
static uint64_t pick_by_site(murk_relaxation *r, size_t n, size_t left,
                             size_t *chosen)
{
    const murk_constraint_set *set = r->set;
    size_t picked = 0;
    uint64_t sum = 0;
    memset(r->is_used, 0, set->sites * sizeof *r->is_used);
    for (size_t k = 0; k < n && picked < left; ++k) {
        bool *is_used = &r->is_used[set->site[r->order[k].candidate]];
        if (!*is_used) {
            *is_used = true;
            r->picked[picked++] = r->order[k];
            sum = murk_sum_saturated(sum, r->order[k].bound);
        }
    }
    *chosen = picked;
    return sum;
}

/* The first of ranked[n] at or after `at` that is a newcomer, or is none. */
static size_t next_of(const murk_constraint_set *set, const murk_ranked *ranked,
                      size_t n, size_t at, bool is_newcomer)
{
    while (at < n &&
           murk_is_newcomer(set, ranked[at].candidate) != is_newcomer) {
        ++at;
    }
    return at;
}

/* The cost of the moves of the partial plan with so many newcomers. */
static uint64_t cost_with(const murk_partial_plan *s, size_t newcomers)
{
    return murk_cost_of_moves(s->set, murk_moves_with(s, newcomers));
}

/* Chooses at most `left` candidates of ranked[n], by falling gain, that the
 * rule on moves allows, into r->picked, such that the sum of the gains less the
 * cost of their moves is largest, and returns this sum. Each
 * further newcomer costs at least as much as the one before and gains at most
 * as much, so the choice is that of the better of two sorted lists. */
static uint64_t pick_by_moves(murk_relaxation *r, const murk_partial_plan *s,
                              const murk_ranked *ranked, size_t n, size_t left,
                              size_t *chosen)
{
    const murk_constraint_set *set = r->set;
    size_t newcomers = s->newcomers, picked = 0;
    size_t come = next_of(set, ranked, n, 0, true),
           stay = next_of(set, ranked, n, 0, false);
    uint64_t sum = 0;
    while (picked < left && (come < n || stay < n)) {
        /* The gain of the next newcomer after its cost. */
        const bool may_come = come < n && murk_moves_with(s, newcomers + 1) <=
                                              set->constraints->moves_max;
        const uint64_t cost =
            cost_with(s, newcomers + 1) - cost_with(s, newcomers);
        const uint64_t net = may_come && ranked[come].bound > cost
                                 ? ranked[come].bound - cost
                                 : 0;
        if (stay < n && ranked[stay].bound >= net) {
            sum = murk_sum_saturated(sum, ranked[stay].bound);
            r->picked[picked++] = ranked[stay];
            stay = next_of(set, ranked, n, stay + 1, false);
        } else if (may_come) {
            sum = murk_sum_saturated(sum, net);
            r->picked[picked++] = ranked[come];
            ++newcomers;
            come = next_of(set, ranked, n, come + 1, true);
        } else {
            break;
        }
    }
    *chosen = picked;
    return sum;
}

/* gain * part / whole, rounded down: the sum of whole gains is whole, so the
 * bound stays valid. */
static uint64_t part_of(uint64_t gain, uint64_t part, uint64_t whole)
{
    return (uint64_t)((wide)gain * part / whole);
}

static uint64_t product_saturated(uint64_t a, uint64_t b)
{
    const wide product = (wide)a * b;
    return product > UINT64_MAX ? UINT64_MAX : (uint64_t)product;
}

/* Sorts r->order[n] by gain per cost into r->priced and makes the prefix sums.
 * With multipliers (s not NULL) each gain is first reduced by the charge of the
 * class, and cap_charges is the sum of the charges for all free places. */
static void price(murk_relaxation *r, size_t n, const murk_partial_plan *s)
{
    /* Charges of all free places. */
    const murk_constraint_set *set = r->set;
    murk_constraint_multiplier *multiplier = s ? r->multiplier : NULL;
    r->cap_charges = 0;
    for (size_t c = 0; multiplier && c < set->classes; ++c) {
        multiplier[c].charged = multiplier[c].multiplier;
        r->cap_charges = murk_sum_saturated(
            r->cap_charges, product_saturated(multiplier[c].multiplier,
                                              set->max[c] - s->class_count[c]));
    }
    /* Gains less charges, by gain per cost, with prefix sums. */
    for (size_t k = 0; k < n; ++k) {
        const uint32_t j = r->order[k].candidate;
        const uint64_t gain = r->order[k].bound;
        const uint64_t charged =
            multiplier ? multiplier[set->class_of[j]].multiplier : 0;
        r->priced[k] = (murk_priced){gain > charged ? gain - charged : 0,
                                     murk_constraint_set_cost(set, j), j};
    }
    qsort(r->priced, n, sizeof *r->priced, murk_compare_density);
    for (size_t k = 0; k < n; ++k) {
        r->value[k + 1] = murk_sum_saturated(r->value[k], r->priced[k].gain);
        r->cost[k + 1] = murk_sum_saturated(r->cost[k], r->priced[k].cost);
    }
    r->live = n;
}

/* The number of candidates, in the order of priced, that the budget pays
 * entirely. */
static size_t paid_by(const murk_relaxation *r, uint64_t budget)
{
    size_t low = 0, high = r->live; /* invariant: cost[low] <= budget */
    while (low < high) {
        const size_t middle = low + (high - low + 1) / 2;
        if (r->cost[middle] <= budget) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return low;
}

static uint64_t knapsack(const murk_relaxation *r, uint64_t budget)
{
    const size_t k = paid_by(r, budget);
    if (k == r->live) {
        return r->value[k];
    }
    return murk_sum_saturated(
        r->value[k],
        part_of(r->priced[k].gain, budget - r->cost[k], r->priced[k].cost));
}

/* Chooses the candidates that the budget pays. The last one is paid in part:
 * over many calls it is chosen as often as its fraction. */
static void pick_by_cost(murk_relaxation *r, uint64_t budget, size_t *chosen)
{
    const size_t k = paid_by(r, budget);
    for (size_t i = 0; i < k; ++i) {
        r->picked[i] = (murk_ranked){r->priced[i].gain, r->priced[i].candidate};
    }
    *chosen = k;
    if (k < r->live) {
        r->carry += (double)(budget - r->cost[k]) / (double)r->priced[k].cost;
        if (r->carry >= 0.5) {
            r->carry -= 1;
            r->picked[(*chosen)++] =
                (murk_ranked){r->priced[k].gain, r->priced[k].candidate};
        }
    }
}

/* Updates the multipliers: up for a class of which the choice has more sensors
 * with a gain than the class has free places, down for a class of which it has
 * fewer. Step lengths grow by 1/4 while the direction stays and halve when it
 * changes (Riedmiller, Braun, Proc. IEEE ICNN (1993) 586,
 * doi:10.1109/ICNN.1993.298623). The first `picked` entries of r->picked are
 * the choice under the present multipliers. */
static void update_multipliers(murk_relaxation *r, const murk_partial_plan *s,
                               size_t picked)
{
    const murk_constraint_set *set = r->set;
    memset(r->class_count, 0, set->classes * sizeof *r->class_count);
    for (size_t k = 0; k < picked; ++k) {
        r->class_count[set->class_of[r->picked[k].candidate]] +=
            r->picked[k].bound > 0;
    }
    /* a charge above the largest gain keeps no further candidate out */
    const uint64_t max = r->live ? r->order[0].bound : 0;
    for (size_t c = 0; c < set->classes; ++c) {
        murk_constraint_multiplier *t = &r->multiplier[c];
        const size_t places = set->max[c] - s->class_count[c];
        const int direction = r->class_count[c] > places   ? 1
                              : r->class_count[c] < places ? -1
                                                           : 0;
        if (t->step == 0) { /* first guess: half of the mean gain */
            t->step = picked ? r->value[picked < r->live ? picked : r->live] /
                                   (2 * picked)
                             : 0;
        } else if (direction * t->direction < 0) {
            t->step -= t->step / 2;
        } else if (direction * t->direction > 0) {
            t->step = murk_sum_saturated(t->step, t->step / 4);
        }
        if (direction > 0) {
            t->multiplier = murk_sum_saturated(t->multiplier, t->step);
            t->multiplier = t->multiplier < max ? t->multiplier : max;
        } else if (direction < 0) {
            t->multiplier -= t->step < t->multiplier ? t->step : t->multiplier;
        }
        t->direction = direction ? direction : t->direction;
    }
}

uint64_t murk_relaxation_top(murk_relaxation *r, const murk_partial_plan *s,
                             const uint32_t *live, const uint64_t *gain,
                             size_t n, murk_ranked *top, size_t *chosen)
{
    const murk_constraint_set *set = r->set;
    /* Sort by gain. */
    const size_t left = s->wanted - s->size;
    for (size_t k = 0; k < n; ++k) {
        r->order[k] = (murk_ranked){gain[k], live[k]};
    }
    murk_ranked_sort(r->order, n);
    /* Class counts. */
    const size_t fewer = left > 0 ? left - 1 : 0;
    r->others = pick_by_class(r, s, r->order, n, fewer, false, chosen);
    uint64_t best = pick_by_class(r, s, r->order, n, left, true, chosen);
    memcpy(top, r->picked, *chosen * sizeof *top);
    /* One sensor a site, if that bound is smaller. */
    if (set->site) {
        size_t picked = 0;
        const uint64_t others = pick_by_site(r, n, fewer, &picked);
        r->others = others < r->others ? others : r->others;
        const uint64_t now = pick_by_site(r, n, left, &picked);
        if (now < best) {
            best = now;
            *chosen = picked;
            memcpy(top, r->picked, picked * sizeof *top);
        }
    }
    /* Moves, if that bound is smaller. */
    if (murk_has_moves(set)) {
        size_t picked = 0;
        const uint64_t others =
            pick_by_moves(r, s, r->order, n, fewer, &picked);
        r->others = others < r->others ? others : r->others;
        const uint64_t now = pick_by_moves(r, s, r->order, n, left, &picked);
        if (now < best) {
            best = now;
            *chosen = picked;
            memcpy(top, r->picked, picked * sizeof *top);
        }
    }
    /* The budget, if that bound is smaller. */
    if (set->has_budget) {
        const uint64_t budget = set->budget - s->cost;
        price(r, n, s);
        const uint64_t now =
            murk_sum_saturated(r->cap_charges, knapsack(r, budget));
        size_t paid = 0;
        pick_by_cost(r, budget, &paid);
        if (now < best) {
            best = now;
            *chosen = paid;
            memcpy(top, r->picked, paid * sizeof *top);
        }
        if (r->multiplier) {
            update_multipliers(r, s, paid);
        }
    }
    return best;
}

uint64_t murk_relaxation_others(const murk_relaxation *r,
                                const murk_partial_plan *s, uint32_t candidate)
{
    if (!r->set->has_budget) {
        return r->others;
    }
    const uint64_t left = r->set->budget - s->cost;
    const uint64_t cost = murk_constraint_set_cost(r->set, candidate);
    /* the candidate occupies one place of its class, so the charge of that
     * place is left out of the bound on the others */
    const uint64_t own =
        r->multiplier ? r->multiplier[r->set->class_of[candidate]].charged : 0;
    const uint64_t cap_charges =
        r->cap_charges == UINT64_MAX
            ? r->cap_charges
            : r->cap_charges - (own < r->cap_charges ? own : r->cap_charges);
    const uint64_t paid = murk_sum_saturated(
        cap_charges, knapsack(r, left > cost ? left - cost : 0));
    return paid < r->others ? paid : r->others;
}

void murk_relaxation_sort(murk_relaxation *r, murk_ranked *ranked, size_t n)
{
    if (!r->set->has_budget) {
        murk_ranked_sort(ranked, n);
        return;
    }
    memcpy(r->order, ranked, n * sizeof *ranked);
    price(r, n, NULL);
    for (size_t k = 0; k < n; ++k) {
        ranked[k] = (murk_ranked){r->priced[k].gain, r->priced[k].candidate};
    }
}

uint64_t murk_relaxation_rest(murk_relaxation *r, const murk_partial_plan *s,
                              const murk_ranked *ranked, size_t n)
{
    if (!r->set->has_budget) {
        /* Counts, and moves. */
        size_t picked = 0;
        const size_t places = s->wanted - s->size;
        const uint64_t of_class =
            pick_by_class(r, s, ranked, n, places, false, &picked);
        const uint64_t of_moves =
            murk_has_moves(r->set)
                ? pick_by_moves(r, s, ranked, n, places, &picked)
                : of_class;
        return of_moves < of_class ? of_moves : of_class;
    }
    uint64_t left = r->set->budget - s->cost, sum = 0;
    for (size_t k = 0; k < n; ++k) {
        const uint64_t cost =
            murk_constraint_set_cost(r->set, ranked[k].candidate);
        if (cost > left) {
            return murk_sum_saturated(sum,
                                      part_of(ranked[k].bound, left, cost));
        }
        left -= cost;
        sum = murk_sum_saturated(sum, ranked[k].bound);
    }
    return sum;
}
