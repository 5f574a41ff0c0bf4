#include "placement/exact.h"

#include "base/interrupt.h"
#include "base/progress.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Bounds made at the root, and at each node below it. */
#define ROUNDS_AT_ROOT 60
#define ROUNDS_BELOW   30

/* A node whose `k` first are chosen. */
typedef struct level {
    murk_cover cover;  /* of the chosen; bits where all is clear */
    murk_cover graded; /* then, the same as clarities */
    float *threshold;  /* [slots] where its bound was lowest */
    murk_ranked *live; /* [candidates] that may join, by falling gain */
    size_t live_count;
    uint64_t base;  /* what the thresholds are worth */
    uint64_t value; /* of the chosen */
} level;

typedef struct exact {
    murk_bound *bound;
    const murk_evaluator *evaluator;
    size_t n;
    level *level; /* [n + 1 less those fixed], made when first needed */
    size_t fixed; /* sensors that stand at the root */
    murk_partial_plan partial; /* with rules: of the chosen */
    uint32_t *chosen;          /* [n] */
    uint32_t *members;         /* [candidates] of a leaf's parent */
    uint64_t *gain;            /* [candidates] likewise */
    uint32_t *plan;
    size_t size;    /* of the plan */
    uint64_t value; /* of the plan */
    uint64_t weighings, weighings_max;
    const murk_judge *judge; /* NULL: plans are worth their value */
    bool is_cut, lacks_memory;
} exact;

static void count_work(exact *e, uint64_t candidates)
{
    const uint64_t nodes = e->weighings / MURK_NODE_WEIGHINGS;
    e->weighings += murk_evaluator_work(e->evaluator, candidates);
    murk_progress_add(e->weighings / MURK_NODE_WEIGHINGS - nodes);
    e->is_cut |= e->weighings > e->weighings_max || murk_interrupted();
}

/* A plan's value is a multiple of the grain. */
static uint64_t in_grains(const exact *e, uint64_t value)
{
    return value - value % e->evaluator->grain;
}

static void take_if_better(exact *e, size_t size, uint64_t value)
{
    if (value > e->value && e->judge) {
        e->value =
            e->judge->judge(e->judge->context, e->chosen, size, e->value);
        count_work(e, size);
    } else if (value > e->value) {
        e->value = value;
        e->size = size;
        memcpy(e->plan, e->chosen, size * sizeof *e->plan);
    }
}

/* Whether what stands is a plan, or can be made one. */
static bool is_plan(const exact *e)
{
    return !e->evaluator->book->has_conflicts ||
           murk_partial_plan_is_plan(&e->partial);
}

static murk_cover *graded(const exact *e, level *l)
{
    return e->evaluator->all_clear ? &l->graded : &l->cover;
}

/* Of the n members, those that may make a better plan. */
static size_t keep_promising(exact *e, const level *l, size_t n)
{
    if (!e->evaluator->slack) {
        return n;
    }
    murk_evaluator_mosts(e->evaluator, &l->cover, e->members, n,
                         e->evaluator->problem->threads, 0, e->gain);
    size_t kept = 0;
    for (size_t k = 0; k < n; ++k) {
        if (l->value + e->gain[k] > e->value) {
            e->members[kept++] = e->members[k];
        }
    }
    return kept;
}

/* One sensor is left to choose: weighs all that may join. */
static void finish(exact *e, const level *l)
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
        take_if_better(e, e->n, l->value + e->gain[k]);
    }
}

/* Lowers the bound of a level from its parent's thresholds. Its live
 * candidates become those that can still be in a better plan, ranked. */
static uint64_t bound_level(exact *e, level *l, size_t left,
                            const float *threshold, size_t rounds)
{
    murk_bound *b = e->bound;
    const size_t slots = e->evaluator->layout->slots;
    if (threshold != b->threshold) {
        memcpy(b->threshold, threshold, slots * sizeof *threshold);
    }
    for (size_t k = 0; k < l->live_count; ++k) {
        b->live[k] = l->live[k].candidate;
    }
    b->live_count = l->live_count;
    b->partial = e->evaluator->book ? &e->partial : NULL;
    b->evaluations = 0;
    const uint64_t upper =
        murk_bound_tighten_within(b, left, e->value, graded(e, l), rounds);
    count_work(e, b->evaluations);
    memcpy(l->threshold, b->threshold, slots * sizeof *l->threshold);
    for (size_t k = 0; k < b->live_count; ++k) {
        l->live[k] = (murk_ranked){b->gain[k], b->live[k]};
    }
    l->live_count = b->live_count;
    l->base = b->base;
    if (e->evaluator->book) {
        murk_relaxed_sort(&b->relaxed, l->live, l->live_count);
    } else {
        murk_ranked_sort(l->live, l->live_count);
    }
    return upper;
}

/* What the level's candidates from number k on can make together. */
static uint64_t rest_of(const exact *e, const level *l, size_t k, size_t left)
{
    if (e->evaluator->book) {
        const uint64_t rest = murk_relaxed_rest(&e->bound->relaxed, &e->partial,
                                                l->live + k, l->live_count - k);
        return in_grains(e, murk_sum_saturated(l->base, rest));
    }
    uint64_t sum = l->base;
    for (size_t i = k; i < l->live_count && i < k + left; ++i) {
        sum += l->live[i].bound;
    }
    return in_grains(e, sum);
}

static bool level_init(level *l, const murk_evaluator *evaluator)
{
    const size_t slots = evaluator->layout->slots + 1;
    if (!murk_cover_init(&l->cover, evaluator->layout, evaluator->all_clear) ||
        (evaluator->all_clear &&
         !murk_cover_init(&l->graded, evaluator->layout, false))) {
        return false;
    }
    l->threshold = calloc(slots, sizeof *l->threshold);
    l->live = calloc(evaluator->candidates + 1, sizeof *l->live);
    return l->threshold && l->live;
}

static void level_release(level *l)
{
    murk_cover_release(&l->cover);
    murk_cover_release(&l->graded);
    free(l->threshold);
    free(l->live);
    *l = (level){0};
}

/* False when out of memory: then the search ends. */
static bool level_ready(exact *e, size_t depth)
{
    level *l = &e->level[depth];
    if (!l->live && !level_init(l, e->evaluator)) {
        level_release(l);
        e->lacks_memory = e->is_cut = true;
    }
    return !e->lacks_memory;
}

/* The candidate joins what the level's cover sees. */
static void join(const exact *e, level *to, const level *from,
                 uint32_t candidate)
{
    const murk_layout *layout = e->evaluator->layout;
    const murk_row row = murk_evaluator_row(e->evaluator, 0, candidate);
    to->value = from->value + murk_row_gain(layout, &row, &from->cover);
    if (to != from) {
        murk_cover_copy(&to->cover, layout, &from->cover);
    }
    murk_cover_add(&to->cover, layout, &row);
    if (e->evaluator->all_clear) {
        if (to != from) {
            murk_cover_copy(&to->graded, layout, &from->graded);
        }
        murk_cover_add(&to->graded, layout, &row);
    }
}

/* Keeps those whom the chosen admit. */
static void keep_admitted(const exact *e, level *l)
{
    size_t kept = 0;
    for (size_t k = 0; k < l->live_count; ++k) {
        if (murk_partial_plan_admits(&e->partial, l->live[k].candidate,
                                     false)) {
            l->live[kept++] = l->live[k];
        }
    }
    l->live_count = kept;
}

static void descend(exact *e, size_t depth, size_t k)
{
    const level *from = &e->level[depth];
    level *to = &e->level[depth + 1];
    const uint32_t candidate = from->live[k].candidate;
    e->chosen[e->fixed + depth] = candidate;
    join(e, to, from, candidate);
    to->live_count = from->live_count - k - 1;
    memcpy(to->live, from->live + k + 1, to->live_count * sizeof *to->live);
    if (e->evaluator->book) {
        murk_partial_plan_add(&e->partial, candidate);
        keep_admitted(e, to);
    }
}

/* No plan below this node is worth more than what it returns, and none that
 * was passed over is worth more than the plan kept. */
static uint64_t explore(exact *e, size_t depth, const float *threshold,
                        size_t rounds)
{
    level *l = &e->level[depth];
    const size_t left = e->n - e->fixed - depth;
    const murk_rulebook *book = e->evaluator->book;
    if (book && is_plan(e)) {
        take_if_better(e, e->fixed + depth, l->value);
    }
    if (left == 0) {
        return e->value;
    }
    if (left == 1) {
        finish(e, l);
        return e->value;
    }
    const uint64_t upper = bound_level(e, l, left, threshold, rounds);
    uint64_t highest = e->value;
    /* Fewer than `left` make no plan, but under rules those left out may fill
     * it up. */
    const size_t needed = book ? 1 : left;
    for (size_t k = 0; k + needed <= l->live_count; ++k) {
        uint64_t rest = rest_of(e, l, k, left);
        rest = rest < upper ? rest : upper;
        if (rest <= e->value) {
            break;
        }
        if (e->is_cut || !level_ready(e, depth + 1)) {
            return rest > highest ? rest : highest;
        }
        descend(e, depth, k);
        const uint64_t below =
            explore(e, depth + 1, l->threshold, ROUNDS_BELOW);
        if (book) {
            murk_partial_plan_drop_last(&e->partial);
        }
        highest = below > highest ? below : highest;
    }
    return highest > e->value ? highest : e->value;
}

/* The root, with the fixed sensors. */
static void stand_fixed(exact *e)
{
    const murk_constraints *constraints = e->evaluator->book->constraints;
    level *root = &e->level[0];
    murk_partial_plan_clear(&e->partial, e->n);
    for (size_t k = 0; k < constraints->fixed_count; ++k) {
        e->chosen[k] = (uint32_t)constraints->fixed[k];
        join(e, root, root, e->chosen[k]);
        murk_partial_plan_add(&e->partial, e->chosen[k]);
    }
    e->fixed = constraints->fixed_count;
    keep_admitted(e, root);
}

static bool exact_init(exact *e)
{
    const size_t candidates = e->evaluator->candidates + 1;
    e->level = calloc(e->n + 1, sizeof *e->level);
    e->chosen = calloc(e->n, sizeof *e->chosen);
    e->members = calloc(candidates, sizeof *e->members);
    e->gain = calloc(candidates, sizeof *e->gain);
    return e->level && e->chosen && e->members && e->gain && level_ready(e, 0);
}

static void exact_release(exact *e)
{
    for (size_t k = 0; e->level && k <= e->n; ++k) {
        level_release(&e->level[k]);
    }
    murk_partial_plan_release(&e->partial);
    free(e->level);
    free(e->chosen);
    free(e->members);
    free(e->gain);
}

murk_status murk_exact_search(murk_exact *out, murk_bound *bound,
                              uint32_t *plan, size_t size, size_t n,
                              uint64_t value, uint64_t upper, uint64_t nodes,
                              const murk_judge *judge, murk_error *err)
{
    const murk_evaluator *evaluator = bound->evaluator;
    assert(evaluator->matrix && n >= 1);
    exact e = {.bound = bound,
               .evaluator = evaluator,
               .n = n,
               .plan = plan,
               .size = size,
               .value = value,
               .judge = judge,
               .weighings_max = nodes < UINT64_MAX / MURK_NODE_WEIGHINGS
                                    ? nodes * MURK_NODE_WEIGHINGS
                                    : UINT64_MAX};
    murk_status status = MURK_OK;
    *out = (murk_exact){
        .value = value, .upper = upper, .is_cut = true, .size = size};
    if (upper <= value || nodes == 0) {
        out->is_cut = upper > value;
        return MURK_OK;
    }
    if (evaluator->book) {
        status = murk_partial_plan_init(&e.partial, evaluator->book, err);
    }
    if (!status && !exact_init(&e)) {
        status = murk_fail(err, MURK_NO_MEMORY, "",
                           "no memory to search %zu sensors", n);
    }
    if (status) {
        goto done;
    }
    level *root = &e.level[0];
    /* where they are too few for a plan, anyone may fill it */
    root->live_count = evaluator->needed_count < n ? evaluator->candidates
                                                   : evaluator->needed_count;
    memcpy(root->live, evaluator->needed,
           root->live_count * sizeof *root->live);
    if (evaluator->book) {
        stand_fixed(&e);
    }
    murk_progress_begin("prove", nodes, "nodes at most");
    const uint64_t highest = explore(&e, 0, bound->threshold, ROUNDS_AT_ROOT);
    murk_progress_end();
    if (n > e.fixed + 1) {
        memcpy(bound->threshold, root->threshold,
               evaluator->layout->slots * sizeof *bound->threshold);
    }
    if (e.lacks_memory) {
        status = murk_fail(err, MURK_NO_MEMORY, "",
                           "no memory to search %zu sensors", n);
        goto done;
    }
    *out = (murk_exact){.value = e.value,
                        .upper = highest < upper ? highest : upper,
                        .nodes = e.weighings / MURK_NODE_WEIGHINGS,
                        .is_cut = e.is_cut,
                        .size = e.size};
    if (out->upper < out->value) {
        out->upper = out->value;
    }
done:
    exact_release(&e);
    return status;
}
