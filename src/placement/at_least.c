/* The strict target of placement/at_least.h. The strict weight S is that of the
 * photons seen by k or more sensors; V is the sum of weight times min(k,
 * sensors), and k S <= V. The search by V is called the search by the mean: V /
 * (k W), with the weight W of all photons, is the weighted mean of min(k,
 * sensors) / k. For each count, the best strict plan of one sensor fewer with
 * one more, and the plan that placement/incumbent.h finds by the mean, are
 * tried in turn until one meets the target; MURK_PLACE_BEST also relocates both
 * by the strict weight. If neither meets the target and the bound does not
 * exclude the target, branch and bound (placement/exact.h) runs with a
 * callback, for methods that have it.
 *
 * A cover with k layers of bits holds in the lowest layer the photons seen by k
 * or more sensors, in the next one those seen by k - 1 or more. The strict
 * weight that a candidate adds is the weight of its photons that lie in the
 * second layer and not in the lowest. So it is an ordinary gain over a cover
 * whose lowest layer is full for all other photons. */
#include "placement/at_least.h"

#include "base/interrupt.h"
#include "placement/incumbent.h"

#include <assert.h>
#include <string.h>

/* Evaluations of the bound before branch and bound, which starts at the
 * multipliers that the bound leaves: as many as the last bound of the worst
 * scenario gets (ROUNDS_LAST in placement/worst.c). */
#define ROUNDS 100

typedef struct strict_run {
    murk_place_run run;        /* values are strict weights S */
    murk_place_desc mean_desc; /* of the search by the mean */
    murk_incumbent mean;       /* plans by the mean */
    uint32_t *last_mean_plan;  /* [last] the plan by the mean with one sensor
                                  fewer */
    murk_curve_point mean_point;
    size_t redundancy;      /* sensors that each photon is to have */
    murk_gain_scan scan;    /* the partial plan, and the cover of it */
    murk_cover one_missing; /* one layer: full except for photons that lack
                               exactly one sensor */
    uint32_t *open;         /* [candidates] that can be added */
    uint64_t *strict, *sum; /* [candidates] gains: strict weight S, and V */
    size_t trial_size;
    uint64_t rows, rows_max;
} strict_run;

/* ---- the problem ---- */

static void binary_row(void *context, unsigned worker, size_t candidate,
                       murk_sparse_row *entries)
{
    const murk_at_least *p = context;
    p->of->get_row(p->of->context, worker, candidate, entries);
    entries->clarity = NULL;
}

static void rest(void *context)
{
    const murk_at_least *p = context;
    if (p->of->rest) {
        p->of->rest(p->of->context);
    }
}

static void list_counters(void *context, murk_counters *list)
{
    const murk_at_least *p = context;
    if (p->of->list_counters) {
        p->of->list_counters(p->of->context, list);
    }
}

void murk_at_least_init(murk_at_least *out, const murk_problem *of,
                        unsigned at_least)
{
    *out = (murk_at_least){.problem = *of, .of = of};
    out->problem.get_row = binary_row;
    out->problem.get_part = NULL;
    out->problem.earlier_hash = NULL; /* of rows with their clarities */
    out->problem.patches = (murk_row_patches){0};
    out->problem.rest = rest;
    out->problem.list_counters = list_counters;
    out->problem.context = out;
    out->problem.combining = MURK_COMBINE_CLEAREST;
    out->problem.redundancy = at_least;
}

/* ---- the partial plan ---- */

/* The weight of the photons in the lowest layer of the cover, times
 * MURK_CLEAR. */
static uint64_t strict_of(const murk_cover *cover, const murk_layout *layout)
{
    const murk_cover lowest = {.layers = 1, .full = cover->full};
    return murk_cover_value(&lowest, layout);
}

/* Makes the partial plan equal to plan[size] without the entry `but` (size:
 * all), to be completed to n sensors. */
static void set_all_but(strict_run *r, const uint32_t *plan, size_t size,
                        size_t but, size_t n)
{
    murk_search_begin(&r->scan, NULL, size, n);
    r->scan.is_move = true;
    murk_gain_scan_set_all_but(&r->scan, plan, size, but);
    r->rows += but < size ? size - 1 : size;
}

static uint64_t strict_value(strict_run *r, const uint32_t *plan, size_t size)
{
    set_all_but(r, plan, size, size, r->run.last);
    return strict_of(&r->scan.cover, r->run.evaluator.layout);
}

/* Stores the plan in trial if it is the first or the best so far of its count.
 */
static void keep_trial(strict_run *r)
{
    murk_place_run_keep(&r->run, r->run.trial, r->trial_size,
                        strict_value(r, r->run.trial, r->trial_size));
}

/* ---- relocation ---- */

/* Finds the candidate that adds most strict weight S to the partial plan, then
 * most V, and stores it in *present. Ties go to the candidate that *present
 * had, then to the lowest index. False if no candidate can be added. */
static bool find_best(strict_run *r, uint32_t *present)
{
    const murk_evaluator *o = &r->run.evaluator;
    const murk_cover *cover = &r->scan.cover;
    const size_t words = o->layout->words;
    size_t n = 0;
    for (uint32_t j = 0; j < o->candidates; ++j) {
        if (!r->scan.is_partial[j] && murk_gain_scan_can_add(&r->scan, j)) {
            r->open[n++] = j;
        }
    }
    /* photons that lack exactly one sensor */
    for (size_t i = 0; i < words; ++i) {
        const uint64_t enough = cover->full[i];
        const uint64_t nearly =
            r->redundancy > 1 ? cover->full[words + i] : UINT64_MAX;
        r->one_missing.full[i] = enough | ~nearly;
    }
    const unsigned threads = o->problem->threads;
    murk_evaluator_gains(o, &r->one_missing, r->open, n, threads, 0, r->strict);
    murk_evaluator_gains(o, cover, r->open, n, threads, 0, r->sum);
    r->rows += 2 * n;
    r->run.result.evaluations += n;
    /* The strict weight decides, then V; on ties the present sensor stays. */
    size_t best = n;
    murk_objective_value max = {0};
    for (size_t k = 0; k < n; ++k) {
        const murk_objective_value now = {r->strict[k], r->sum[k]};
        if (best == n || murk_objective_is_greater(now, max) ||
            (!murk_objective_is_greater(max, now) && r->open[k] == *present)) {
            best = k;
            max = now;
        }
    }
    if (best < n) {
        *present = r->open[best];
    }
    return best < n;
}

/* Relocates single sensors of trial by the strict weight, then by V, until no
 * sensor moves, the limit on work is reached, or a request to finish comes. */
static void relocate(strict_run *r)
{
    const size_t fixed = murk_fixed_count(r->run.set);
    const size_t n = r->trial_size, movers = n - fixed;
    size_t still = 0; /* sensors in a row that did not move */
    for (size_t at = 0; still < movers && !murk_must_finish();
         at = (at + 1) % movers) {
        if (r->rows > r->rows_max) {
            r->run.result.is_work_cut = true;
            return;
        }
        uint32_t *const moved = &r->run.trial[fixed + at];
        const uint32_t before = *moved;
        set_all_but(r, r->run.trial, n, fixed + at, n);
        still = find_best(r, moved) && *moved != before
                    ? 1 /* the sensor just moved is at the best candidate */
                    : still + 1;
    }
}

/* Tries the plan in trial; if the method is MURK_PLACE_BEST and no plan meets
 * the target, also relocated. */
static void try_plan(strict_run *r)
{
    keep_trial(r);
    if (r->run.desc->method == MURK_PLACE_BEST &&
        r->run.value < r->run.desc->target) {
        relocate(r);
        keep_trial(r);
    }
}

/* ---- branch and bound ---- */

/* Callback of branch and bound for every plan with enough V. The first plan
 * that meets the target ends the search: the returned cutoff is k times the
 * weight of all photons, times MURK_CLEAR, which V cannot exceed in these
 * units. */
static uint64_t check_plan(void *context, const uint32_t *plan, size_t size,
                           uint64_t known)
{
    strict_run *r = context;
    murk_place_run_keep(&r->run, plan, size, strict_value(r, plan, size));
    return r->run.value >= r->run.desc->target ? r->run.evaluator.layout->whole
                                               : known;
}

/* With constraints: completes the incumbent if branch and bound found it with
 * fewer than n sensors; if there is no incumbent, makes a greedy plan. If the
 * plan cannot be completed, there is no incumbent afterwards. */
static void complete_plan(strict_run *r, size_t n)
{
    murk_place_run *run = &r->run;
    if (run->size == n) {
        return;
    }
    memcpy(run->trial, run->plan, run->size * sizeof *run->plan);
    murk_search_greedy(&run->search, run->trial, run->size, n, UINT64_MAX,
                       NULL);
    r->trial_size = run->search.size;
    run->size = 0;
    if (r->trial_size == n) {
        keep_trial(r);
    }
}

/* Tightens the bound on V, *upper. If the bound still allows a plan of n that
 * meets the target, and the method has branch and bound, searches for such a
 * plan among all plans with enough V; unless the search finds one, *upper
 * becomes the bound that the search leaves. */
static murk_status branch_and_bound(strict_run *r, size_t n, uint64_t *upper,
                                    murk_error *err)
{
    murk_place_run *run = &r->run;
    murk_place_result *result = &run->result;
    const murk_place_desc *desc = run->desc;
    murk_incumbent *p = &r->mean;
    /* The bound on V decides first. */
    const uint64_t below = desc->target * r->redundancy - 1;
    const uint64_t bound =
        murk_bound_tighten(&p->bound, n, below, p->plan, p->size, ROUNDS);
    *upper = bound < *upper ? bound : *upper;
    if (*upper <= below || !murk_place_has_proof(desc) || murk_must_finish()) {
        return MURK_OK;
    }
    /* Branch and bound over V, with the strict weight in the callback. */
    const murk_exact_callback by = {check_plan, r};
    murk_exact exact;
    const murk_status status =
        murk_exact_search(&exact, &p->bound, p->plan, p->size, n, below, *upper,
                          murk_place_run_nodes_left(run, desc), &by, err);
    if (status) {
        return status;
    }
    result->nodes += exact.nodes;
    complete_plan(r, n);
    if (run->value < desc->target || run->size == 0) {
        result->is_cut = result->is_cut || exact.is_cut;
        *upper = exact.upper;
    }
    return MURK_OK;
}

/* ---- counts ---- */

/* Finds the best plan of n: from the best plan of n - 1 sensors, from the plan
 * that is best for the mean, and by branch and bound. */
static murk_status find_count(void *context, size_t n, const uint32_t *from,
                              murk_curve_point *point, murk_error *err)
{
    strict_run *r = context;
    murk_place_run *run = &r->run;
    murk_incumbent *p = &r->mean;
    const uint64_t target = run->desc->target;
    if (!from && !run->set) {
        murk_incumbent_greedy(p);
    }
    /* The plan for the mean, made without branch and bound. */
    const bool was_cut = run->result.is_cut;
    murk_status status = murk_incumbent_count(
        p, n, from ? r->last_mean_plan : NULL, &r->mean_point, err);
    run->result.is_cut = was_cut;
    if (status || murk_interrupted()) {
        return status;
    }
    memcpy(r->last_mean_plan, p->plan, p->size * sizeof *p->plan);
    /* Try the plan of n - 1 with one sensor more. */
    const bool has_from = from && run->size == n - 1;
    run->size = 0;
    run->value = 0;
    if (has_from) {
        memcpy(run->trial, from, (n - 1) * sizeof *from);
        set_all_but(r, from, n - 1, n - 1, n);
        run->trial[n - 1] = UINT32_MAX;
        r->trial_size = n;
        if (find_best(r, &run->trial[n - 1])) {
            try_plan(r);
        }
    }
    /* Try the start plan. */
    if (run->desc->start_plan && run->desc->method != MURK_PLACE_GREEDY &&
        run->value < target) {
        r->trial_size = murk_search_begin_at(
            &run->search, run->trial, n, run->desc->start_plan,
            run->desc->start_size, &run->result.started_from);
        try_plan(r);
    }
    /* Try the plan for the mean. */
    if (run->value < target && p->size == n) {
        memcpy(run->trial, p->plan, n * sizeof *p->plan);
        r->trial_size = n;
        try_plan(r);
    }
    uint64_t upper = r->mean_point.upper;
    if (run->value < target && upper / r->redundancy >= target) {
        status = branch_and_bound(r, n, &upper, err);
    }
    upper /= r->redundancy;
    upper = upper > run->value ? upper : run->value;
    *point = (murk_curve_point){n, run->value, upper};
    return status;
}

/* ---- frame ---- */

static murk_status begin(strict_run *r, murk_error *err)
{
    murk_place_run *run = &r->run;
    murk_place_result *result = &run->result;
    const murk_evaluator *o = &run->evaluator;
    const size_t n = o->candidates + 1;
    const uint64_t target = run->desc->target;
    r->open = murk_arena_array(&run->arena, n, sizeof *r->open);
    r->strict = murk_arena_array(&run->arena, n, sizeof *r->strict);
    r->sum = murk_arena_array(&run->arena, n, sizeof *r->sum);
    uint32_t *mean_plan =
        murk_arena_array(&run->arena, run->last, sizeof *mean_plan);
    r->last_mean_plan =
        murk_arena_array(&run->arena, run->last, sizeof *r->last_mean_plan);
    r->rows_max = murk_gain_scan_rows_max(o);
    if (run->arena.is_short ||
        !murk_cover_init_single(&r->one_missing, o->layout, true)) {
        return murk_no_memory(err, "", "to search %zu candidates",
                              o->candidates);
    }
    murk_status status = murk_gain_scan_init(&r->scan, o, 0, 1, err);
    if (status) {
        return status;
    }
    /* the ceiling: all candidates chosen */
    status = murk_evaluator_cover_all(o, &r->scan.cover, err);
    if (status) {
        return status;
    }
    r->rows = o->candidates;
    result->ceiling = strict_of(&r->scan.cover, o->layout);
    result->whole = o->layout->whole / r->redundancy;
    if (target > result->ceiling) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "target %.6g cannot be reached: where all %zu usable "
                         "candidates stand, %zu or more see %.6g",
                         (double)target / (double)result->whole, o->candidates,
                         r->redundancy,
                         (double)result->ceiling / (double)result->whole);
    }
    /* A plan with V = enough meets the target for certain. The search by the
     * mean makes no branch and bound of its own (nodes 0): branch_and_bound()
     * runs for the strict weight. */
    const uint64_t enough = target + (r->redundancy - 1) * result->whole;
    r->mean_desc = *run->desc;
    r->mean_desc.target = enough < o->ceiling ? enough : o->ceiling;
    r->mean_desc.nodes = 0;
    status = murk_incumbent_init(&r->mean, run, &r->mean_desc, mean_plan, err);
    /* fewer sensors than the redundancy never meet the target */
    run->first = run->first > r->redundancy ? run->first : r->redundancy;
    result->fewest = run->first;
    return status;
}

static murk_status check_target(const murk_place_run *run, size_t redundancy,
                                murk_error *err)
{
    const murk_place_result *result = &run->result;
    const double whole = (double)result->whole;
    const double target = (double)run->desc->target / whole;
    if (result->count > 0 && result->value >= run->desc->target) {
        return MURK_OK;
    }
    if (result->fewest > run->last) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "target %.6g cannot be reached: with %zu sensors, the "
                         "most that the rules allow, no plan shows so much to "
                         "%zu or more",
                         target, run->last, redundancy);
    }
    return murk_fail(err, MURK_RUN_FAILED, "",
                     "no plan found that reaches the target %.6g with at most "
                     "%zu sensors: of the best found %zu or more see %.6g",
                     target, run->last, redundancy,
                     (double)result->value / whole);
}

murk_status murk_place_at_least(murk_place_result *out,
                                const murk_problem *problem,
                                const murk_matrix *matrix,
                                const murk_place_desc *desc, murk_error *err)
{
    assert(out && problem && matrix && desc && desc->target > 0);
    strict_run r = {.redundancy = murk_problem_layers(problem)};
    murk_status status =
        murk_place_run_begin(&r.run, problem, matrix, desc, err);
    if (!status) {
        status = begin(&r, err);
    }
    /* Find the plans, and make the result. */
    if (!status) {
        status = murk_place_run_counts(&r.run, find_count, &r, err);
    }
    if (!status) {
        murk_incumbent_count_work(&r.mean);
        status = check_target(&r.run, r.redundancy, err);
    }
    murk_incumbent_release(&r.mean);
    murk_gain_scan_release(&r.scan);
    murk_cover_release(&r.one_missing);
    return murk_place_run_end(out, &r.run, status);
}
