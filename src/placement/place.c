/* Placement by the value of a plan: within the frame of placement/run.h, finds
 * the plan of each count (placement/incumbent.h), and makes the result. Bounds
 * of one count also bound other counts.
 *
 * The guarantee is that of greedy for the given constraints. With a count alone
 * the fraction of the optimum is 1 - (1 - 1/n)^n. With further constraints the
 * sets of candidates that keep all of them are k-extendible, and the fraction
 * is 1 / (k + 1). k is a sum: 1 for minimum and maximum counts by class (a
 * matroid, together with the count), 1 for one sensor a site, and 12 for a
 * spacing (of sensors that keep the spacing from each other, at most 12 lie
 * closer to one point than the spacing: the kissing number). Under a budget
 * another theorem holds in some cases (of_budget()), and with listed conflicts
 * no fraction is known. The value must be submodular, as it is for every way of
 * combining entries; for detection probabilities up to rounding, 2 / 65535 of
 * what is seen.
 *
 * Source: Nemhauser, Wolsey, Fisher, Math. Program. 14 (1978) 265,
 * doi:10.1007/BF01588971 (count); Calinescu, Chekuri, Pal, Vondrak, SIAM J.
 * Comput. 40 (2011) 1740, doi:10.1137/080733991 (1 / (k + 1)); Tang, Tang, Lim,
 * Han, Li, Yuan, Proc. ACM Meas. Anal. Comput. Syst. 5 (2021) 8,
 * doi:10.1145/3447386 (budget). */
#include "placement/place.h"

#include "placement/incumbent.h"

#include <assert.h>

/* Bounds of one count bound others. By submodularity the best plan of k + 1 is
 * worth at most (k + 1) / k times the best plan of k, if each of the sensors
 * may be left out; `rounding` is the error of detection probabilities. */
static void join_bounds(murk_place_run *run)
{
    const murk_layout *layout = run->evaluator.layout;
    const murk_constraint_set *set = run->set;
    const uint64_t rounding =
        layout->doses ? MURK_WORTH_SLACK * (layout->whole / MURK_CLEAR) : 0;
    murk_curve_point *curve = run->result.curve;
    const size_t n = run->result.curve_points;
    const bool may_go =
        !set || (!set->has_min && set->constraints->fixed_count == 0 &&
                 !murk_has_moves(set));
    for (size_t k = 1; k < n && may_go; ++k) {
        const uint64_t before = curve[k - 1].upper + rounding;
        const uint64_t upper = before + before / curve[k - 1].count;
        curve[k].upper = upper < curve[k].upper ? upper : curve[k].upper;
    }
    murk_place_run_join_bounds(run);
    if (n > 0) {
        run->result.upper = curve[n - 1].upper;
    }
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

static murk_status check_target(const murk_place_run *run, murk_error *err)
{
    const double whole = (double)run->evaluator.layout->whole;
    const double target = (double)run->desc->target / whole;
    const murk_place_result *result = &run->result;
    if (result->value >= run->desc->target) {
        return MURK_OK;
    }
    if (result->upper < run->desc->target) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "target %.6g cannot be reached: %zu sensors, the "
                         "most that the rules allow, see at most %.6g",
                         target, run->last, (double)result->upper / whole);
    }
    return murk_fail(err, MURK_RUN_FAILED, "",
                     "no plan found that reaches the target %.6g with at most "
                     "%zu sensors: the best found sees %.6g",
                     target, run->last, (double)result->value / whole);
}

/* Splits the objective of the plan into the value and the moves. */
static void count_moves(murk_place_run *run)
{
    const murk_partial_plan *partial = &run->search.partial;
    murk_place_result *result = &run->result;
    murk_search_begin(&run->search, run->plan, run->size, run->size);
    result->value = murk_gain_scan_set_all_but(&run->search, run->plan,
                                               run->size, run->size);
    result->has_moves = true;
    result->moves = murk_moves_with(partial, partial->newcomers);
    result->move_cost = murk_cost_of_moves(run->set, result->moves);
}

static murk_status find_count(void *context, size_t n, const uint32_t *from,
                              murk_curve_point *point, murk_error *err)
{
    murk_incumbent *p = context;
    const bool is_greedy = p->desc->method != MURK_PLACE_SPOQ && !p->run->set;
    if (!from && is_greedy) {
        murk_incumbent_greedy(p);
    }
    const murk_status status = murk_incumbent_count(p, n, from, point, err);
    p->run->size = p->size;
    return status;
}

murk_status murk_place_sensors(murk_place_result *out,
                               const murk_problem *problem,
                               const murk_matrix *matrix,
                               const murk_place_desc *desc, murk_error *err)
{
    assert(out && problem && desc);
    assert(!matrix || matrix->candidates == problem->candidates);
    murk_place_run run;
    murk_incumbent p = {0};
    murk_status status = murk_place_run_begin(&run, problem, matrix, desc, err);
    if (!status) {
        status = murk_incumbent_init(&p, &run, desc, run.plan, err);
    }
    /* Refuse a target beyond the ceiling. */
    const murk_evaluator *evaluator = &run.evaluator;
    if (!status && desc->target > evaluator->ceiling) {
        const double whole = (double)evaluator->layout->whole;
        status = murk_fail(err, MURK_BAD_VALUE, "",
                           "target %.6g cannot be reached: all %zu usable "
                           "candidates together see %.6g",
                           (double)desc->target / whole, evaluator->candidates,
                           (double)evaluator->ceiling / whole);
    }
    /* Find the plans, and make the result. */
    if (!status) {
        status = murk_place_run_counts(&run, find_count, &p, err);
    }
    if (!status) {
        status = check_target(&run, err);
    }
    if (!status) {
        murk_incumbent_count_work(&p);
        join_bounds(&run);
        /* MURK_PLACE_BEST and MURK_PLACE_EXACT start with greedy's plan and
         * only improve it. Relocation alone assures n / (2n - 1), which is
         * less. */
        if (desc->method != MURK_PLACE_SPOQ && !murk_has_moves(run.set) &&
            (!run.set || p.is_greedy_done)) {
            run.result.guarantee = greedy_guarantee(run.set);
        }
        if (murk_has_moves(run.set)) {
            count_moves(&run);
        }
        run.result.ceiling = evaluator->ceiling;
        run.result.whole = evaluator->layout->whole;
    }
    murk_incumbent_release(&p);
    return murk_place_run_end(out, &run, status);
}
