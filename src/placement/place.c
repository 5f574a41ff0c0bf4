/* The frame of every placement: checks the settings, ranks the candidates,
 * finds the plan of each count (placement/incumbent.h), and makes the result.
 * Bounds of one count also bound other counts.
 *
 * The guarantee is that of greedy for the given constraints. Greedy is greedy
 * over sets that are k-extendible: k is 1 for the count and the minimum and
 * maximum counts by class together (a matroid), 1 more for one sensor a site,
 * and 12 more for a spacing (at most 12 sensors that keep the spacing lie
 * closer than it to one point: the kissing number); a plain count is contained
 * in these. The fraction is 1 / (k + 1). The value must be submodular, as it is
 * for every way of combining entries; for detection probabilities up to
 * rounding, 2 / 65535 of what is seen.
 *
 * Source: Nemhauser, Wolsey, Fisher, Math. Program. 14 (1978) 265,
 * doi:10.1007/BF01588971 (count); Calinescu, Chekuri, Pal, Vondrak, SIAM J.
 * Comput. 40 (2011) 1740, doi:10.1137/080733991 (1 / (k + 1)); Tang, Tang, Lim,
 * Han, Li, Yuan, Proc. ACM Meas. Anal. Comput. Syst. 5 (2021) 8,
 * doi:10.1145/3447386 (budget). */
#include "placement/place.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "placement/incumbent.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* True for the last count: the wanted one, or the first that reaches the
 * target. */
static bool is_last(const murk_incumbent *p, size_t k, uint64_t value)
{
    return p->desc->target ? value >= p->desc->target || k == p->last
                           : k == p->last;
}

static murk_status find_all(murk_incumbent *p, murk_error *err)
{
    murk_place_result *result = p->result;
    const murk_place_desc *desc = p->desc;
    if (desc->method != MURK_PLACE_SPOQ && !p->set) {
        murk_incumbent_greedy(p);
    }
    murk_curve_point last = {0};
    const uint32_t *from = NULL;
    murk_status status = MURK_OK;
    /* Each count builds on the plan of the count before. */
    for (size_t k = p->first; !status && !murk_interrupted(); ++k) {
        status = murk_incumbent_count(p, k, from, &last, err);
        if (status) {
            break;
        }
        if (result->curve) {
            result->curve[k - p->first] = last;
            result->curve_points = k - p->first + 1;
        }
        if (desc->target && result->fewest == 0 && last.upper >= desc->target) {
            result->fewest = k;
        }
        memcpy(p->last_plan, p->plan, p->size * sizeof *p->plan);
        from = p->last_plan;
        result->count = p->size;
        if (is_last(p, k, last.value)) {
            break;
        }
    }
    /* Values of the last count, and counters of all. */
    result->value = last.value;
    result->upper = last.upper;
    result->is_work_cut = p->search.is_cut || p->starts.is_cut;
    result->evaluations += p->search.evaluations + p->starts.all_evaluations;
    result->queries += p->search.queries + p->starts.all_queries +
                       p->bound.queries + p->evaluator->queries;
    return status;
}

static uint64_t lesser(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

/* Bounds of one count bound others. By submodularity the best plan of k + 1 is
 * worth at most (k + 1) / k times the best plan of k, if each of the sensors
 * may be left out; `rounding` is the error of detection probabilities. A plan
 * of fewer sensors is worth no more, if every plan can be completed. */
static void join_bounds(murk_curve_point *curve, size_t n,
                        const murk_constraint_set *set, uint64_t rounding)
{
    const bool may_go =
        !set || (!set->has_min && set->constraints->fixed_count == 0);
    for (size_t k = 1; k < n && may_go; ++k) {
        const uint64_t before = curve[k - 1].upper + rounding;
        curve[k].upper =
            lesser(curve[k].upper, before + before / curve[k - 1].count);
    }
    for (size_t k = n - 1; k > 0 && !(set && set->has_conflicts); --k) {
        curve[k - 1].upper = lesser(curve[k - 1].upper, curve[k].upper);
    }
}

static int by_number(const void *a, const void *b)
{
    const size_t x = *(const size_t *)a, y = *(const size_t *)b;
    return (x > y) - (x < y);
}

/* The fraction of the optimum that greedy reaches under a budget. */
static const char *of_budget(const murk_constraint_set *set)
{
    /* Known only if no count can end greedy before the budget does. */
    const bool is_alone = !set->has_min && !set->has_caps &&
                          !set->has_conflicts &&
                          set->max_sensors == set->candidates;
    return is_alone ? ".405" : "none";
}

/* The fraction of the optimum that greedy reaches, by theorem; set NULL: no
 * constraint but a count. "none" if no theorem is known. */
static const char *greedy_guarantee(const murk_constraint_set *set)
{
    static const char *const of_extendible[2][2][2] = {
        /* [spacing][sites][class counts] */
        {{"1 - (1 - 1/n)^n", "1/2"}, {"1/2", "1/3"}},
        {{"1/13", "1/14"}, {"1/14", "1/15"}}};
    if (!set) {
        return of_extendible[0][0][0];
    }
    if (set->has_budget) {
        return of_budget(set);
    }
    if (set->constraints->conflict_first) {
        return "none";
    }
    return of_extendible[set->constraints->spacing_m > 0][set->site != NULL]
                        [set->has_min || set->has_caps];
}

static const char *guarantee_of(const murk_incumbent *p)
{
    /* MURK_PLACE_BEST and MURK_PLACE_EXACT start with greedy's plan and only
     * improve it. Relocation alone assures n / (2n - 1), which is less. */
    const bool is_greedy =
        p->desc->method != MURK_PLACE_SPOQ && (!p->set || p->is_greedy_done);
    return is_greedy ? greedy_guarantee(p->set) : "none";
}

static uint64_t cost_of(const murk_incumbent *p)
{
    uint64_t sum = 0;
    for (size_t k = 0; p->set && k < p->size; ++k) {
        sum += murk_constraint_set_cost(p->set, p->plan[k]);
    }
    return sum;
}

static murk_status miss_target(const murk_incumbent *p, murk_error *err)
{
    const double whole = (double)p->evaluator->layout->whole;
    const double target = (double)p->desc->target / whole;
    if (p->result->upper < p->desc->target) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "target %.6g cannot be reached: %zu sensors, the "
                         "most that the rules allow, see at most %.6g",
                         target, p->last, (double)p->result->upper / whole);
    }
    return murk_fail(err, MURK_RUN_FAILED, "",
                     "no plan found that reaches the target %.6g with at most "
                     "%zu sensors: the best found sees %.6g",
                     target, p->last, (double)p->result->value / whole);
}

static murk_status place(murk_place_result *out, const murk_problem *problem,
                         const murk_matrix *matrix, const murk_place_desc *desc,
                         murk_error *err)
{
    murk_evaluator evaluator = {0};
    murk_constraint_set rulebook = {0};
    const murk_constraint_set *set = desc->constraints ? &rulebook : NULL;
    murk_incumbent p = {0};
    murk_place_result result = {0};
    /* Check settings and constraints, rank the candidates. */
    murk_status status = murk_place_check(problem, matrix != NULL, desc, err);
    if (!status && set) {
        const bool is_max = desc->target || desc->constraints->budget > 0;
        status = murk_constraint_set_init(
            &rulebook, desc->constraints, problem->candidates,
            desc->count > 0 ? desc->count : problem->candidates, is_max, err);
    }
    if (!status) {
        status = murk_evaluator_init(&evaluator, problem, matrix, set,
                                     set ? set->max_sensors : desc->count,
                                     desc->keep_dominated, err);
    }
    evaluator.search_work = desc->search_work;
    if (!status) {
        status = murk_incumbent_init(&p, &evaluator, set, desc, &result, err);
    }
    /* Refuse a target beyond the ceiling. */
    if (!status && desc->target > evaluator.ceiling) {
        status = murk_fail(
            err, MURK_BAD_VALUE, "",
            "target %.6g cannot be reached: all %zu usable "
            "candidates together see %.6g",
            (double)desc->target / (double)evaluator.layout->whole,
            evaluator.candidates,
            (double)evaluator.ceiling / (double)evaluator.layout->whole);
    }
    if (status) {
        goto done;
    }
    /* Find the plans. */
    const bool starts =
        desc->method == MURK_PLACE_BEST || desc->method == MURK_PLACE_SPOQ;
    murk_progress_begin("place", starts ? desc->restarts : 0,
                        starts ? "starts at most" : "");
    status = find_all(&p, err);
    murk_progress_end();
    if (!status && murk_interrupted()) {
        status = murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    if (!status && result.value < desc->target) {
        status = miss_target(&p, err);
    }
    if (status) {
        goto done;
    }
    /* Make the result. */
    for (size_t k = 0; k < result.count; ++k) {
        result.sensor[k] = p.plan[k];
    }
    qsort(result.sensor, result.count, sizeof *result.sensor, by_number);
    if (result.curve) {
        join_bounds(result.curve, result.curve_points, set,
                    evaluator.layout->doses
                        ? MURK_WORTH_SLACK *
                              (evaluator.layout->whole / MURK_CLEAR)
                        : 0);
        result.upper = result.curve[result.curve_points - 1].upper;
    }
    result.proven_optimal = result.value == result.upper;
    result.guarantee = guarantee_of(&p);
    result.cost = cost_of(&p);
    result.ceiling = evaluator.ceiling;
    result.whole = evaluator.layout->whole;
    result.after_presolve = evaluator.undominated;
    *out = result;
    result = (murk_place_result){0};
done:
    murk_incumbent_release(&p);
    murk_evaluator_release(&evaluator);
    murk_constraint_set_release(&rulebook);
    murk_place_release(&result);
    return status;
}

murk_status murk_place_known(murk_place_result *result,
                             const murk_problem *problem,
                             const murk_matrix *matrix,
                             const murk_place_desc *desc, murk_error *err)
{
    assert(result && problem && matrix && desc);
    assert(matrix->candidates == problem->candidates);
    return place(result, problem, matrix, desc, err);
}

murk_status murk_place_unknown(murk_place_result *result,
                               const murk_problem *problem,
                               const murk_place_desc *desc, murk_error *err)
{
    assert(result && problem && desc);
    return place(result, problem, NULL, desc, err);
}
