/* The search behind placement/at_least.h. For each count: the plan that
 * placement/incumbent.h makes for the mean, and the best strict plan of one
 * sensor fewer with one more, both moved uphill by the strict share; where
 * neither meets the target and the bound leaves it open, branch and bound
 * (placement/exact.h) with a judge.
 *
 * The cover of the k clearest views as bits holds in its lowest layer the
 * photons with k views, in the next one those with k - 1 or more. What a
 * candidate adds to the strict weight is what it sees of the photons in the
 * latter alone, so the ordinary weighing answers it, asked with a cover whose
 * lowest layer is full everywhere else. */
#include "placement/at_least.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "placement/incumbent.h"
#include "placement/settings.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Evaluations of the bound before branch and bound, which goes on from there:
 * as many as the worst condition's bound gets (placement/worst_count.c). */
#define ROUNDS 100

typedef struct run {
    const murk_place_desc *desc;
    const murk_evaluator *evaluator;
    const murk_constraint_set *set; /* NULL: no rules but a count */
    size_t redundancy;              /* that each photon is to have */
    murk_incumbent mean;            /* plans by the mean */
    murk_partial_plan partial;      /* with rules: of what stands */
    murk_cover cover;               /* of what stands */
    murk_cover one_missing; /* one layer: full but where one view lacks */
    uint32_t *open;         /* [candidates] that may join */
    uint64_t *strict, *sum; /* [candidates] what they add: S, and V */
    uint32_t *plan, *trial; /* [most sensors]; plan: the best of a count */
    size_t size, trial_size;
    uint64_t value; /* strict, of plan */
    uint64_t rows, rows_max;
    murk_place_result *result;
} run;

/* What a move is judged by: the strict weight, then the sum of views. */
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

/* ---- what stands ---- */

/* The weight of the photons that the cover has in its lowest layer. */
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

/* All of plan[size] but its entry `but` (size: all). */
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

/* Keeps the plan if it is the best of its count. */
static void keep_better(run *r, const uint32_t *plan, size_t size,
                        uint64_t value)
{
    if (r->size == 0 || value > r->value) {
        memcpy(r->plan, plan, size * sizeof *plan);
        r->size = size;
        r->value = value;
    }
}

/* ---- moves ---- */

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

/* The candidate that increases the value of the partial plan (plan[size]
 * without the entry `but`) most. Ties go to `now`, then to the lowest index.
 * False if the constraints allow no candidate. */
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
    /* photons with just one view less than they are to have */
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
        if (!is_better) { /* of equals, the sensor that stands there stays */
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

/* Moves single sensors of trial to where the strict weight, then the sum of
 * views, is more, until none moves or the work of searching is spent. */
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
                    ? 1 /* the sensor just moved is at its best site */
                    : still + 1;
    }
}

/* Trial, a plan, as it is and moved. */
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

/* Every plan whose sum of views is enough comes here; the first that meets the
 * target ends the search, as no plan has more views than all of them. */
static uint64_t check_plan(void *context, const uint32_t *plan, size_t size,
                           uint64_t known)
{
    run *r = context;
    keep_better(r, plan, size, strict_value(r, plan, size));
    return r->value >= r->desc->target ? r->evaluator->layout->whole : known;
}

/* Under rules: the best plan, found with fewer than n, filled up by whoever may
 * join. Where one admits nobody, it stays short and does not count. */
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

/* Looks for a plan of n that meets the target among all whose sum of views,
 * `upper` at most, is enough; lowers *upper to what is left. */
static murk_status branch_and_bound(run *r, size_t n, uint64_t *upper,
                                    murk_error *err)
{
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

/* The best plan of n, from that of one fewer (n - 1 in r->plan, if `from`), and
 * in *point its strict value and bound. */
static murk_status find_count(run *r, size_t n, bool from,
                              const uint32_t *mean_from, murk_curve_point *mean,
                              murk_curve_point *point, murk_error *err)
{
    murk_incumbent *p = &r->mean;
    const bool was_cut = r->result->is_cut;
    murk_status status = murk_incumbent_count(p, n, mean_from, mean, err);
    r->result->is_cut = was_cut; /* it was to do without branch and bound */
    if (status || murk_interrupted()) {
        return status;
    }
    if (from) { /* kept before r->plan is written over */
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

/* Counts from the first that may do on, until one's plan meets the target. */
static murk_status find_all(run *r, murk_error *err)
{
    murk_incumbent *p = &r->mean;
    murk_place_result *result = r->result;
    const size_t first = p->first > r->redundancy ? p->first : r->redundancy;
    /* Fewer sensors see no more where each plan can be filled up: then what is
     * proven of a count is proven of all below. */
    const bool may_fill = !(r->set && r->set->has_conflicts);
    murk_curve_point mean = {0}, point = {0};
    bool is_closed = true; /* no count so far was left open */
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

/* ---- the whole ---- */

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
    /* what all see together */
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
    /* Where the mean is this much, so is the strict share; and branch and bound
     * is for the strict one alone. */
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
        murk_progress_begin("place", desc->restarts, "starts at most");
        status = find_all(&r, err);
        murk_progress_end();
    }
    if (!status && murk_interrupted()) {
        status = murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
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
