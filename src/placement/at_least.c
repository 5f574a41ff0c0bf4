/* The strict target of placement/at_least.h. For each count the search takes
 * the plan that placement/incumbent.h finds for the mean, and the best strict
 * plan of one sensor fewer with one more, and relocates both by the strict
 * weight. If neither meets the target and the bound does not exclude it, branch
 * and bound (placement/exact.h) runs with a callback.
 *
 * A cover with k layers of bits holds in the lowest layer the photons seen by k
 * sensors, in the next one those seen by k - 1 or more. The strict weight that
 * a candidate adds is the weight of its photons that lie in the second layer
 * and not in the lowest. So it is an ordinary gain over a cover whose lowest
 * layer is full for all other photons. */
#include "placement/at_least.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "placement/incumbent.h"
#include "placement/settings.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Evaluations of the bound before branch and bound, which goes on from there:
 * as many as the bound of the worst scenario gets (placement/worst_count.c). */
#define ROUNDS 100

typedef struct run {
    const murk_place_desc *desc;
    const murk_evaluator *evaluator;
    const murk_constraint_set *set; /* NULL: no constraint but a count */
    size_t redundancy;              /* sensors that each photon is to have */
    murk_incumbent mean;            /* plans by the mean */
    murk_partial_plan partial;      /* with constraints */
    murk_cover cover;               /* of the partial plan */
    murk_cover one_missing; /* one layer: full except for photons that lack one
                               sensor */
    uint32_t *open;         /* [candidates] that can be added */
    uint64_t *strict, *sum; /* [candidates] gains: strict weight S, and V */
    uint32_t *plan, *trial; /* [max sensors]; plan: the incumbent of a count */
    size_t size, trial_size;
    uint64_t value; /* strict weight of plan */
    uint64_t rows, rows_max;
    murk_place_result *result;
} run;

/* The objective of a relocation: the strict weight, then V. */
typedef struct objective {
    uint64_t strict, sum;
} objective;

static bool is_greater(objective a, objective b)
{
    return a.strict != b.strict ? a.strict > b.strict : a.sum > b.sum;
}

/* ---- the problem ---- */

static void binary_row(void *context, unsigned worker, size_t candidate,
                       murk_sparse_row *entries)
{
    const murk_at_least *p = context;
    p->of->get_row(p->of->context, worker, candidate, entries);
    entries->clarity = NULL;
}

void murk_at_least_init(murk_at_least *out, const murk_problem *of,
                        unsigned at_least)
{
    *out = (murk_at_least){.problem = *of, .of = of};
    out->problem.get_row = binary_row;
    out->problem.context = out;
    out->problem.combining = MURK_COMBINE_CLEAREST;
    out->problem.redundancy = at_least;
}

/* ---- the partial plan ---- */

/* The weight of the photons in the lowest layer of the cover. */
static uint64_t strict_of(const murk_cover *cover, const murk_layout *layout)
{
    const murk_cover lowest = {.layers = 1, .full = cover->full};
    return murk_cover_value(&lowest, layout);
}

static void add_candidate(run *r, uint32_t candidate)
{
    const murk_row row = murk_evaluator_row(r->evaluator, 0, candidate);
    murk_cover_add(&r->cover, r->evaluator->layout, &row);
    ++r->rows;
}

/* Makes the partial plan equal to plan[size] without the entry `but` (size:
 * all). */
static void set_all_but(run *r, const uint32_t *plan, size_t size, size_t but,
                        size_t wanted)
{
    murk_cover_clear(&r->cover, r->evaluator->layout);
    if (r->set) {
        murk_partial_plan_clear(&r->partial, wanted);
    }
    for (size_t k = 0; k < size; ++k) {
        if (k != but) {
            add_candidate(r, plan[k]);
            if (r->set) {
                murk_partial_plan_add(&r->partial, plan[k]);
            }
        }
    }
}

static uint64_t strict_value(run *r, const uint32_t *plan, size_t size)
{
    murk_cover_clear(&r->cover, r->evaluator->layout);
    for (size_t k = 0; k < size; ++k) {
        add_candidate(r, plan[k]);
    }
    return strict_of(&r->cover, r->evaluator->layout);
}

/* Stores the plan if it is the best of its count. */
static void keep_better(run *r, const uint32_t *plan, size_t size,
                        uint64_t value)
{
    if (r->size == 0 || value > r->value) {
        memcpy(r->plan, plan, size * sizeof *plan);
        r->size = size;
        r->value = value;
    }
}

/* ---- relocation ---- */

static bool contains(const uint32_t *plan, size_t size, size_t but,
                     uint32_t candidate)
{
    for (size_t k = 0; k < size; ++k) {
        if (k != but && plan[k] == candidate) {
            return true;
        }
    }
    return false;
}

/* Finds the candidate that increases the objective of the partial plan
 * (plan[size] without the entry `but`) most. Ties go to `present`, then to the
 * lowest index. False if the constraints allow no candidate. */
static bool find_best(run *r, const uint32_t *plan, size_t size, size_t but,
                      uint32_t *present)
{
    const murk_evaluator *o = r->evaluator;
    const size_t words = o->layout->words;
    size_t n = 0;
    for (uint32_t j = 0; j < o->candidates; ++j) {
        if (!contains(plan, size, but, j) &&
            (!r->set || murk_partial_plan_can_add(&r->partial, j, true))) {
            r->open[n++] = j;
        }
    }
    /* photons that lack exactly one sensor */
    for (size_t i = 0; i < words; ++i) {
        const uint64_t enough = r->cover.full[i];
        const uint64_t nearly =
            r->redundancy > 1 ? r->cover.full[words + i] : UINT64_MAX;
        r->one_missing.full[i] = enough | ~nearly;
    }
    const unsigned threads = o->problem->threads;
    murk_evaluator_gains(o, &r->one_missing, r->open, n, threads, 0, r->strict);
    murk_evaluator_gains(o, &r->cover, r->open, n, threads, 0, r->sum);
    r->rows += 2 * n;
    r->result->evaluations += n;
    size_t best = n;
    for (size_t k = 0; k < n; ++k) {
        const objective w = {r->strict[k], r->sum[k]};
        bool is_better = best == n;
        if (!is_better) { /* on ties the present sensor stays */
            const objective max = {r->strict[best], r->sum[best]};
            is_better = is_greater(w, max) ||
                        (!is_greater(max, w) && r->open[k] == *present);
        }
        if (is_better) {
            best = k;
        }
    }
    if (best < n) {
        *present = r->open[best];
    }
    return best < n;
}

/* Relocates single sensors of trial by the strict weight, then by V, until no
 * sensor moves or the limit on work is reached. */
static void relocate(run *r)
{
    const size_t fixed = r->set ? r->set->constraints->fixed_count : 0;
    const size_t n = r->trial_size, movers = n - fixed;
    size_t still = 0; /* sensors in a row that did not move */
    for (size_t at = 0; still < movers && !murk_interrupted();
         at = (at + 1) % movers) {
        if (r->rows > r->rows_max) {
            r->result->is_work_cut = true;
            return;
        }
        uint32_t *const moved = &r->trial[fixed + at];
        const uint32_t before = *moved;
        set_all_but(r, r->trial, n, fixed + at, n);
        still = find_best(r, r->trial, n, fixed + at, moved) && *moved != before
                    ? 1 /* the sensor just moved is at the best candidate */
                    : still + 1;
    }
}

/* Tries the plan in trial as it is, and relocated. */
static void try_plan(run *r)
{
    keep_better(r, r->trial, r->trial_size,
                strict_value(r, r->trial, r->trial_size));
    if (r->desc->method == MURK_PLACE_BEST && r->value < r->desc->target) {
        relocate(r);
        keep_better(r, r->trial, r->trial_size,
                    strict_value(r, r->trial, r->trial_size));
    }
}

/* ---- branch and bound ---- */

/* Callback of branch and bound for every plan with enough V. The first plan
 * that meets the target ends the search: the returned cutoff is V of all
 * sensors. */
static uint64_t check_plan(void *context, const uint32_t *plan, size_t size,
                           uint64_t known)
{
    run *r = context;
    keep_better(r, plan, size, strict_value(r, plan, size));
    return r->value >= r->desc->target ? r->evaluator->layout->whole : known;
}

/* With constraints: completes the incumbent if branch and bound found it with
 * fewer than n sensors. If it cannot be completed, there is no incumbent. */
static void complete_plan(run *r, size_t n)
{
    murk_gain_scan *s = &r->mean.search;
    if (r->size == n) {
        return;
    }
    memcpy(r->trial, r->plan, r->size * sizeof *r->plan);
    murk_search_greedy(s, r->trial, r->size, n, UINT64_MAX, NULL);
    r->trial_size = s->size;
    r->size = 0;
    if (r->trial_size == n) {
        keep_better(r, r->trial, n, strict_value(r, r->trial, n));
    }
}

/* Searches for a plan of n that meets the target among all plans with enough V;
 * *upper is the bound on V, and is lowered to what the search leaves open. */
static murk_status branch_and_bound(run *r, size_t n, uint64_t *upper,
                                    murk_error *err)
{
    /* The bound on V decides first. */
    const uint64_t below = r->desc->target * r->redundancy - 1;
    const uint64_t left = r->desc->nodes > r->result->nodes
                              ? r->desc->nodes - r->result->nodes
                              : 0;
    const bool is_wanted = r->desc->method == MURK_PLACE_BEST ||
                           r->desc->method == MURK_PLACE_EXACT;
    murk_incumbent *p = &r->mean;
    uint64_t bound =
        murk_bound_tighten(&p->bound, n, below, p->plan, p->size, ROUNDS);
    bound = bound < *upper ? bound : *upper;
    *upper = bound;
    if (bound <= below || !is_wanted || murk_interrupted()) {
        return MURK_OK;
    }
    /* Branch and bound over V, with the strict weight in the callback. */
    const murk_exact_callback by = {check_plan, r};
    murk_exact exact;
    const murk_status status = murk_exact_search(
        &exact, &p->bound, p->plan, p->size, n, below, bound, left, &by, err);
    if (status) {
        return status;
    }
    r->result->nodes += exact.nodes;
    complete_plan(r, n);
    if (r->value < r->desc->target || r->size == 0) {
        r->result->is_cut = r->result->is_cut || exact.is_cut;
        *upper = exact.upper;
    }
    return MURK_OK;
}

/* ---- counts ---- */

/* Finds the best plan of n. With `from`, r->plan is the best plan of n - 1
 * sensors. *point receives the strict value and bound. */
static murk_status find_count(run *r, size_t n, bool from,
                              const uint32_t *mean_from, murk_curve_point *mean,
                              murk_curve_point *point, murk_error *err)
{
    murk_incumbent *p = &r->mean;
    const bool was_cut = r->result->is_cut;
    murk_status status = murk_incumbent_count(p, n, mean_from, mean, err);
    r->result->is_cut =
        was_cut; /* the search for the mean is made without branch and bound */
    if (status || murk_interrupted()) {
        return status;
    }
    if (from) { /* copied before r->plan is overwritten */
        memcpy(r->trial, r->plan, (n - 1) * sizeof *r->plan);
        set_all_but(r, r->trial, n - 1, n - 1, n);
        r->trial[n - 1] = UINT32_MAX;
        from = find_best(r, r->trial, n - 1, n - 1, &r->trial[n - 1]);
        r->trial_size = n;
    }
    r->size = 0;
    r->value = 0;
    if (from) {
        try_plan(r);
    }
    if (r->value < r->desc->target && p->size == n) {
        memcpy(r->trial, p->plan, n * sizeof *r->plan);
        r->trial_size = n;
        try_plan(r);
    }
    uint64_t upper = mean->upper;
    if (r->value < r->desc->target &&
        upper / r->redundancy >= r->desc->target) {
        status = branch_and_bound(r, n, &upper, err);
    }
    upper /= r->redundancy;
    *point =
        (murk_curve_point){n, r->value, upper > r->value ? upper : r->value};
    return status;
}

/* Tries one count after another until a plan meets the target. */
static murk_status find_all(run *r, murk_error *err)
{
    murk_incumbent *p = &r->mean;
    murk_place_result *result = r->result;
    const size_t first = p->first > r->redundancy ? p->first : r->redundancy;
    /* If every plan can be completed, a count that cannot meet the target
     * excludes all smaller counts. */
    const bool may_fill = !(r->set && r->set->has_conflicts);
    murk_curve_point mean = {0}, point = {0};
    bool is_closed = true; /* every count so far is excluded */
    result->fewest = first;
    murk_status status = MURK_OK;
    for (size_t n = first; n <= p->last && !status && !murk_interrupted();
         ++n) {
        status =
            find_count(r, n, n > first && r->size == n - 1,
                       n > first ? p->last_plan : NULL, &mean, &point, err);
        if (status || murk_interrupted()) {
            break;
        }
        memcpy(p->last_plan, p->plan, p->size * sizeof *p->plan);
        result->curve[n - first] = point;
        result->curve_points = n - first + 1;
        if (point.upper >= r->desc->target) {
            is_closed = false;
        } else if (is_closed || may_fill) {
            result->fewest = n + 1;
        }
        if (r->size == n && point.value >= r->desc->target) {
            break;
        }
    }
    result->count = r->size;
    result->value = point.value;
    result->upper = point.upper;
    result->is_work_cut |= p->search.is_cut || p->starts.is_cut;
    result->evaluations += p->search.evaluations + p->starts.all_evaluations;
    return status;
}

/* ---- frame ---- */

static murk_status begin(run *r, murk_place_desc *desc, murk_error *err)
{
    const murk_evaluator *o = r->evaluator;
    const size_t n = o->candidates + 1;
    r->open = malloc(n * sizeof *r->open);
    r->strict = malloc(n * sizeof *r->strict);
    r->sum = malloc(n * sizeof *r->sum);
    r->plan = calloc(n, sizeof *r->plan);
    r->trial = calloc(n, sizeof *r->trial);
    r->rows_max = murk_gain_scan_rows_max(o);
    if (!r->open || !r->strict || !r->sum || !r->plan || !r->trial ||
        !murk_cover_init(&r->cover, o->layout, true) ||
        !murk_cover_init_single(&r->one_missing, o->layout, true)) {
        return murk_fail(err, MURK_NO_MEMORY, "",
                         "no memory to search %zu candidates", o->candidates);
    }
    if (r->set) {
        const murk_status status =
            murk_partial_plan_init(&r->partial, r->set, err);
        if (status) {
            return status;
        }
    }
    /* the ceiling: all candidates chosen */
    for (uint32_t j = 0; j < o->candidates; ++j) {
        add_candidate(r, j);
    }
    r->result->ceiling = strict_of(&r->cover, o->layout);
    r->result->whole = o->layout->whole / r->redundancy;
    if (r->desc->target > r->result->ceiling) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "target %.6g cannot be reached: where all %zu usable "
                         "candidates stand, %zu or more see %.6g",
                         (double)r->desc->target / (double)r->result->whole,
                         o->candidates, r->redundancy,
                         (double)r->result->ceiling / (double)r->result->whole);
    }
    /* A plan with this V meets the target for certain. Branch and bound is kept
     * for the strict weight. */
    const uint64_t enough =
        r->desc->target + (r->redundancy - 1) * r->result->whole;
    desc->target = enough < o->ceiling ? enough : o->ceiling;
    desc->nodes = 0;
    const murk_status status =
        murk_incumbent_init(&r->mean, o, r->set, desc, r->result, err);
    if (!status && !r->set) {
        murk_incumbent_greedy(&r->mean);
    }
    return status;
}

static murk_status report_miss(const run *r, murk_error *err)
{
    const double whole = (double)r->result->whole;
    const double target = (double)r->desc->target / whole;
    if (r->result->fewest > r->mean.last) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "target %.6g cannot be reached: with %zu sensors, the "
                         "most that the rules allow, no plan shows so much to "
                         "%zu or more",
                         target, r->mean.last, r->redundancy);
    }
    return murk_fail(err, MURK_RUN_FAILED, "",
                     "no plan found that reaches the target %.6g with at most "
                     "%zu sensors: of the best found %zu or more see %.6g",
                     target, r->mean.last, r->redundancy,
                     (double)r->result->value / whole);
}

static int by_number(const void *a, const void *b)
{
    const size_t x = *(const size_t *)a, y = *(const size_t *)b;
    return (x > y) - (x < y);
}

static void release(run *r)
{
    murk_incumbent_release(&r->mean);
    murk_partial_plan_release(&r->partial);
    murk_cover_release(&r->cover);
    murk_cover_release(&r->one_missing);
    free(r->open);
    free(r->strict);
    free(r->sum);
    free(r->plan);
    free(r->trial);
}

murk_status murk_place_at_least(murk_place_result *out,
                                const murk_problem *problem,
                                const murk_matrix *matrix,
                                const murk_place_desc *desc, murk_error *err)
{
    assert(out && problem && matrix && desc && desc->target > 0);
    murk_evaluator evaluator = {0};
    murk_constraint_set rulebook = {0};
    murk_place_result result = {.guarantee = "none"};
    murk_place_desc of_mean = *desc;
    run r = {.desc = desc,
             .evaluator = &evaluator,
             .set = desc->constraints ? &rulebook : NULL,
             .redundancy = murk_problem_layers(problem),
             .result = &result};
    /* Check settings and constraints, rank the candidates. */
    murk_status status = murk_place_check(problem, true, desc, err);
    if (!status && r.set) {
        status = murk_constraint_set_init(&rulebook, desc->constraints,
                                          problem->candidates, desc->count,
                                          true, err);
    }
    if (!status) {
        status = murk_evaluator_init(&evaluator, problem, matrix, r.set,
                                     r.set ? rulebook.max_sensors : desc->count,
                                     desc->keep_dominated, err);
    }
    evaluator.search_work = desc->search_work;
    if (!status) {
        status = begin(&r, &of_mean, err);
    }
    if (!status) {
        /* Find the plans. */
        murk_progress_begin("place", desc->restarts, "starts at most");
        status = find_all(&r, err);
        murk_progress_end();
    }
    if (!status && murk_interrupted()) {
        status = murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    /* Make the result. */
    if (!status && (result.count == 0 || result.value < desc->target)) {
        status = report_miss(&r, err);
    }
    if (!status) {
        for (size_t k = 0; k < result.count; ++k) {
            result.sensor[k] = r.plan[k];
            result.cost +=
                r.set ? murk_constraint_set_cost(r.set, r.plan[k]) : 0;
        }
        qsort(result.sensor, result.count, sizeof *result.sensor, by_number);
        result.proven_optimal = result.value == result.upper;
        result.after_presolve = evaluator.undominated;
        *out = result;
        result = (murk_place_result){0};
    }
    release(&r);
    murk_evaluator_release(&evaluator);
    murk_constraint_set_release(&rulebook);
    murk_place_release(&result);
    return status;
}
