/* Depth-first branch and bound over partial plans (placement/exact.h). Each
 * level of the search has a cover, multipliers of the bound (placement/bound.h)
 * and live candidates of its own; these arrays are allocated when the search
 * first reaches the level. Work is counted in evaluations of one photon for one
 * candidate (murk_evaluator_work()), so that the limit ends every run at the
 * same place. Only a request to finish, an interrupt or lack of memory ends the
 * search elsewhere. */
#include "placement/exact.h"

#include "base/interrupt.h"
#include "base/progress.h"

#include <assert.h>
#include <string.h>

/* Largest number of subgradient rounds of the bound at the root and at every
 * other node. Each round is an evaluation of the bound; one more evaluation, at
 * the lowest bound, follows unless the node is fathomed. The multipliers of the
 * parent are a good start, so a node below the root needs fewer rounds. Both
 * numbers are chosen, not derived. */
#define ROUNDS_AT_ROOT 60
#define ROUNDS_BELOW   30

/* A level of the search: level k is the present node with k candidates chosen
 * besides the fixed sensors. */
typedef struct level {
    murk_cover cover; /* of the chosen candidates; bits if the matrix is 0/1 */
    murk_cover clarity_cover; /* if the matrix is 0/1: the same as clarities,
                                 for the bound */
    float *multiplier;        /* [slots] of the node's lowest bound */
    murk_ranked *live; /* [candidates] that may be added, by falling gain (with
                          a budget: gain per cost) */
    size_t live_count;
    uint64_t base;  /* first sum of the bound (placement/multipliers.h) */
    uint64_t value; /* of the chosen candidates */
} level;

typedef struct exact {
    murk_bound *bound;
    const murk_evaluator *evaluator;
    size_t n;
    level *level; /* [n + 1], the arrays of a level are allocated when first
                     needed */
    size_t fixed; /* sensors chosen at the root */
    murk_partial_plan partial; /* with constraints: the chosen candidates */
    uint32_t *chosen;          /* [n] */
    uint32_t *members;         /* [candidates] scratch: candidates of leaves */
    uint64_t *gain;            /* [candidates] scratch: gains of leaves */
    uint32_t *plan;
    size_t size;    /* of the incumbent */
    uint64_t value; /* of the incumbent, or the cutoff of the callback */
    uint64_t work, work_max;
    const murk_exact_callback *callback; /* NULL: the value is the objective */
    bool is_cut, lacks_memory;
    murk_arena arena;
} exact;

static void count_work(exact *e, uint64_t candidates)
{
    const uint64_t nodes = e->work / MURK_NODE_WEIGHINGS;
    e->work += murk_evaluator_work(e->evaluator, candidates);
    murk_progress_add(e->work / MURK_NODE_WEIGHINGS - nodes);
    e->is_cut |= e->work > e->work_max || murk_must_finish();
}

/* Rounds an upper bound down to a multiple of the grain, as every value of a
 * plan is one. */
static uint64_t in_grains(const exact *e, uint64_t value)
{
    return value - value % e->evaluator->grain;
}

/* Stores the chosen candidates as the incumbent if they are worth more than the
 * present incumbent; with a callback, passes them to the callback if they are
 * worth more than the cutoff. */
static void update_incumbent(exact *e, size_t size, uint64_t value)
{
    if (value > e->value && e->callback) {
        e->value = e->callback->callback(e->callback->context, e->chosen, size,
                                         e->value);
        count_work(e, size);
    } else if (value > e->value) {
        e->value = value;
        e->size = size;
        memcpy(e->plan, e->chosen, size * sizeof *e->plan);
    }
}

/* True if the partial plan is complete, or can be completed for certain. */
static bool is_plan(const exact *e)
{
    return !e->evaluator->set->has_conflicts ||
           murk_partial_plan_is_complete(&e->partial);
}

static murk_cover *clarity_cover(const exact *e, level *l)
{
    return e->evaluator->is_binary ? &l->clarity_cover : &l->cover;
}

/* Of the n members, keeps those that may improve the incumbent according to a
 * fast upper bound on the gain; keeps all if there is no such bound. */
static size_t keep_promising(exact *e, const level *l, size_t n)
{
    if (!e->evaluator->slack) {
        return n;
    }
    murk_evaluator_gain_bounds(e->evaluator, &l->cover, e->members, n,
                               e->evaluator->problem->threads, 0, e->gain);
    size_t remaining = 0;
    for (size_t k = 0; k < n; ++k) {
        if (l->value + e->gain[k] > e->value) {
            e->members[remaining++] = e->members[k];
        }
    }
    return remaining;
}

/* One sensor is left to choose: evaluates all candidates that may be added. */
static void evaluate_leaves(exact *e, const level *l)
{
    for (size_t k = 0; k < l->live_count; ++k) {
        e->members[k] = l->live[k].candidate;
    }
    const size_t n = keep_promising(e, l, l->live_count);
    murk_evaluator_gains(e->evaluator, &l->cover, e->members, n,
                         e->evaluator->problem->threads, 0, e->gain);
    count_work(e, n);
    for (size_t k = 0; k < n; ++k) {
        e->chosen[e->n - 1] = e->members[k];
        update_incumbent(e, e->n, l->value + e->gain[k]);
    }
}

/* Lowers the bound of a level, starting at the parent's multipliers. The live
 * candidates become those that may still belong to a better plan, sorted. */
static uint64_t bound_level(exact *e, level *l, size_t left,
                            const float *multiplier, size_t rounds)
{
    murk_bound *b = e->bound;
    const size_t slots = e->evaluator->layout->slots;
    /* Hand the level's state to the bound. */
    if (multiplier != b->multiplier) {
        memcpy(b->multiplier, multiplier, slots * sizeof *multiplier);
    }
    for (size_t k = 0; k < l->live_count; ++k) {
        b->live[k] = l->live[k].candidate;
    }
    b->live_count = l->live_count;
    b->partial = e->evaluator->set ? &e->partial : NULL;
    b->evaluations = 0;
    const uint64_t upper = murk_bound_tighten_within(
        b, left, e->value, clarity_cover(e, l), rounds);
    count_work(e, b->evaluations);
    /* Take the lowest bound and the candidates that remain. */
    memcpy(l->multiplier, b->multiplier, slots * sizeof *l->multiplier);
    for (size_t k = 0; k < b->live_count; ++k) {
        l->live[k] = (murk_ranked){b->gain[k], b->live[k]};
    }
    l->live_count = b->live_count;
    l->base = b->base;
    if (e->evaluator->set) {
        murk_relaxation_sort(&b->relaxed, l->live, l->live_count);
    } else {
        murk_ranked_sort(l->live, l->live_count);
    }
    return upper;
}

/* Upper bound for plans of the node that add no live candidate before number
 * k. */
static uint64_t rest_of(const exact *e, const level *l, size_t k, size_t left)
{
    if (e->evaluator->set) {
        const uint64_t rest = murk_relaxation_rest(
            &e->bound->relaxed, &e->partial, l->live + k, l->live_count - k);
        return in_grains(e, murk_sum_saturated(l->base, rest));
    }
    uint64_t sum = l->base;
    for (size_t i = k; i < l->live_count && i < k + left; ++i) {
        sum += l->live[i].bound;
    }
    return in_grains(e, sum);
}

/* Allocates a level unless that is done already. False when out of memory; the
 * search then ends. */
static bool level_ready(exact *e, size_t depth)
{
    const murk_evaluator *o = e->evaluator;
    level *l = &e->level[depth];
    if (l->live) {
        return true;
    }
    l->multiplier =
        murk_arena_array(&e->arena, o->layout->slots, sizeof *l->multiplier);
    l->live = murk_arena_array(&e->arena, o->candidates, sizeof *l->live);
    if (e->arena.is_short ||
        !murk_cover_init(&l->cover, o->layout, o->is_binary) ||
        (o->is_binary &&
         !murk_cover_init(&l->clarity_cover, o->layout, false))) {
        e->lacks_memory = e->is_cut = true;
    }
    return !e->lacks_memory;
}

/* Makes the cover and the value of level `to`: those of `from` with a candidate
 * added. Both may be the same level. */
static void add_candidate(const exact *e, level *to, const level *from,
                          uint32_t candidate)
{
    const murk_layout *layout = e->evaluator->layout;
    const murk_row row = murk_evaluator_row(e->evaluator, 0, candidate);
    to->value = from->value + murk_row_gain(layout, &row, &from->cover);
    if (to != from) {
        murk_cover_copy(&to->cover, layout, &from->cover);
    }
    murk_cover_add(&to->cover, layout, &row);
    if (e->evaluator->is_binary) {
        if (to != from) {
            murk_cover_copy(&to->clarity_cover, layout, &from->clarity_cover);
        }
        murk_cover_add(&to->clarity_cover, layout, &row);
    }
}

/* Keeps the live candidates that can be added. */
static void keep_feasible(const exact *e, level *l)
{
    size_t remaining = 0;
    for (size_t k = 0; k < l->live_count; ++k) {
        if (murk_partial_plan_can_add(&e->partial, l->live[k].candidate,
                                      false)) {
            l->live[remaining++] = l->live[k];
        }
    }
    l->live_count = remaining;
}

/* Makes the child of a node that adds live candidate k. The child has the live
 * candidates after k. */
static void branch(exact *e, size_t depth, size_t k)
{
    const level *from = &e->level[depth];
    level *to = &e->level[depth + 1];
    const uint32_t candidate = from->live[k].candidate;
    e->chosen[e->fixed + depth] = candidate;
    add_candidate(e, to, from, candidate);
    to->live_count = from->live_count - k - 1;
    memcpy(to->live, from->live + k + 1, to->live_count * sizeof *to->live);
    if (e->evaluator->set) {
        murk_partial_plan_add(&e->partial, candidate);
        keep_feasible(e, to);
    }
}

/* Searches the node at this depth. Returns an upper bound on the plans of the
 * node, at least the value of the incumbent; the bound is equal to that value
 * unless the search was cut. */
static uint64_t explore(exact *e, size_t depth, const float *multiplier,
                        size_t rounds)
{
    level *l = &e->level[depth];
    const size_t left = e->n - e->fixed - depth;
    const murk_constraint_set *set = e->evaluator->set;
    if (set && is_plan(e)) {
        update_incumbent(e, e->fixed + depth, l->value);
    }
    if (left == 0) {
        return e->value;
    }
    if (left == 1) {
        evaluate_leaves(e, l);
        return e->value;
    }
    const uint64_t upper = bound_level(e, l, left, multiplier, rounds);
    uint64_t highest = e->value;
    /* Without constraints fewer than `left` candidates make no plan. With
     * constraints a short plan can be completed by candidates that were fixed
     * out. */
    const size_t needed = set ? 1 : left;
    for (size_t k = 0; k + needed <= l->live_count; ++k) {
        uint64_t rest = rest_of(e, l, k, left);
        rest = rest < upper ? rest : upper;
        if (rest <= e->value) {
            break;
        }
        if (e->is_cut || !level_ready(e, depth + 1)) {
            return rest > highest ? rest : highest;
        }
        /* A child is searched only if the bound allows a better plan. */
        branch(e, depth, k);
        const uint64_t below =
            explore(e, depth + 1, l->multiplier, ROUNDS_BELOW);
        if (set) {
            murk_partial_plan_drop_last(&e->partial);
        }
        highest = below > highest ? below : highest;
    }
    return highest > e->value ? highest : e->value;
}

/* Chooses the fixed sensors at the root. */
static void add_fixed(exact *e)
{
    const murk_constraints *constraints = e->evaluator->set->constraints;
    level *root = &e->level[0];
    murk_partial_plan_clear(&e->partial, e->n);
    for (size_t k = 0; k < constraints->fixed_count; ++k) {
        e->chosen[k] = (uint32_t)constraints->fixed[k];
        add_candidate(e, root, root, e->chosen[k]);
        murk_partial_plan_add(&e->partial, e->chosen[k]);
    }
    e->fixed = constraints->fixed_count;
    keep_feasible(e, root);
}

static bool exact_init(exact *e)
{
    const size_t candidates = e->evaluator->candidates;
    e->level = murk_arena_array(&e->arena, e->n + 1, sizeof *e->level);
    e->chosen = murk_arena_array(&e->arena, e->n, sizeof *e->chosen);
    e->members = murk_arena_array(&e->arena, candidates, sizeof *e->members);
    e->gain = murk_arena_array(&e->arena, candidates, sizeof *e->gain);
    return !e->arena.is_short && level_ready(e, 0);
}

static void exact_release(exact *e)
{
    for (size_t k = 0; e->level && k <= e->n; ++k) {
        murk_cover_release(&e->level[k].cover);
        murk_cover_release(&e->level[k].clarity_cover);
    }
    murk_partial_plan_release(&e->partial);
    murk_arena_release(&e->arena);
}

murk_status murk_exact_search(murk_exact *out, murk_bound *bound,
                              uint32_t *plan, size_t size, size_t n,
                              uint64_t value, uint64_t upper, uint64_t nodes,
                              const murk_exact_callback *callback,
                              murk_error *err)
{
    const murk_evaluator *evaluator = bound->evaluator;
    assert(evaluator->matrix && n >= 1);
    exact e = {.bound = bound,
               .evaluator = evaluator,
               .n = n,
               .plan = plan,
               .size = size,
               .value = value,
               .callback = callback,
               .work_max = nodes < UINT64_MAX / MURK_NODE_WEIGHINGS
                               ? nodes * MURK_NODE_WEIGHINGS
                               : UINT64_MAX};
    murk_status status = MURK_OK;
    *out = (murk_exact){
        .value = value, .upper = upper, .is_cut = true, .size = size};
    /* Nothing to prove, or no work allowed. */
    if (upper <= value || nodes == 0) {
        out->is_cut = upper > value;
        return MURK_OK;
    }
    if (evaluator->set) {
        status = murk_partial_plan_init(&e.partial, evaluator->set, err);
    }
    if (!status && !exact_init(&e)) {
        status = murk_no_memory(err, "", "to search %zu sensors", n);
    }
    if (status) {
        goto done;
    }
    level *root = &e.level[0];
    /* If presolve has left too few candidates for a plan, take the others as
     * well, which follow them in the array. */
    root->live_count = evaluator->presolved_count < n
                           ? evaluator->candidates
                           : evaluator->presolved_count;
    memcpy(root->live, evaluator->presolved,
           root->live_count * sizeof *root->live);
    if (evaluator->set) {
        add_fixed(&e);
    }
    /* Search, and hand the root's multipliers back to the bound. */
    murk_progress_begin("prove", nodes, "nodes at most");
    const uint64_t highest = explore(&e, 0, bound->multiplier, ROUNDS_AT_ROOT);
    murk_progress_end();
    if (n > e.fixed + 1) {
        memcpy(bound->multiplier, root->multiplier,
               evaluator->layout->slots * sizeof *bound->multiplier);
    }
    if (e.lacks_memory) {
        status = murk_no_memory(err, "", "to search %zu sensors", n);
        goto done;
    }
    *out = (murk_exact){.value = e.value,
                        .upper = highest < upper ? highest : upper,
                        .nodes = e.work / MURK_NODE_WEIGHINGS,
                        .is_cut = e.is_cut,
                        .size = e.size};
    if (out->upper < out->value) {
        out->upper = out->value;
    }
done:
    exact_release(&e);
    return status;
}
