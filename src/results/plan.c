/* A plan for a scene: fields of plan.json, and lines of the summary. */
#include "results/plan.h"

#include "cases/ahead.h"
#include "results/candidates.h"
#include "results/condition_results.h"
#include "results/coverage.h"
#include "results/explore.h"
#include "results/goals.h"
#include "results/robust.h"
#include "results/summary.h"
#include "results/tallies.h"

#include <math.h>

/* ---- fields of every plan ---- */

static void list_bound(murk_results_fields *f, const void *of)
{
    const murk_place_result *place = of;
    MURK_NUMBER(f, "upper", "1",
                "no plan of as many sensors covers more of this sample; with a "
                "rule on moves, no plan that keeps it covers more, less the "
                "cost of its moves",
                murk_share(place->upper, place->whole));
    MURK_NUMBER(f, "gap", "1",
                "(upper - coverage) / upper; coverage less the cost of moves",
                place->upper || !place->whole
                    ? murk_share(place->upper - murk_place_objective(place),
                                 place->upper)
                    : 0);
    MURK_FLAG(f, "proven_optimal", "true if no plan is better on this sample",
              place->proven_optimal);
    MURK_TEXT(f, "guarantee", "of the method, before it is run",
              place->guarantee);
}

static void list_point(murk_results_fields *f, const void *of, size_t i)
{
    const murk_place_result *place = of;
    MURK_COUNT(f, "count", "sensors", place->curve[i].count);
    MURK_NUMBER(f, "coverage", "1", "of the plan of so many",
                murk_share(place->curve[i].value, place->whole));
    MURK_NUMBER(f, "upper", "1", "bound on such plans",
                murk_share(place->curve[i].upper, place->whole));
}

void murk_results_list_bound(murk_results_fields *f, const void *of)
{
    const murk_place_result *place = of;
    MURK_OBJECT(f, "bound", "the bound on the coverage of plans", list_bound,
                place);
    MURK_LIST(f, "curve", "plans of 1 sensor, 2 sensors, ...", list_point,
              place, place->curve_points);
}

void murk_results_list_cut(murk_results_fields *f, const void *of)
{
    const murk_place_result *place = of;
    MURK_COUNT(f, "nodes", "of branch and bound", place->nodes);
    MURK_TEXT(f, "cut_by",
              "null, or what ended the search: interrupt, or a limit: time, "
              "nodes (of branch and bound, over all counts together) or work",
              place->is_interrupted ? "interrupt"
              : place->is_late      ? "time"
              : place->is_cut       ? "nodes"
              : place->is_work_cut  ? "work"
                                    : NULL);
}

void murk_results_list_budget(murk_results_fields *f, const void *of)
{
    const murk_budget_results *budget = of;
    MURK_NUMBER(f, "asked", "", "the budget", budget->asked);
    MURK_NUMBER(f, "spent", "", "cost of the sensors",
                (double)budget->place->cost * MURK_COST_UNIT);
}

/* ---- fields of a plan for a scene ---- */

static void list_candidates(murk_results_fields *f, const void *of)
{
    const murk_plan_result *plan = of;
    murk_results_list_candidates(f, plan ? plan->candidates : NULL);
    MURK_COUNT(f, "poses", "candidates with heading and tilt",
               plan->poses->count);
    MURK_COUNT(f, "after_presolve", "candidates that no other dominates",
               plan->place.after_presolve);
}

static murk_estimate held_out_of(const murk_plan_result *plan)
{
    return plan->has_held_out ? plan->held_out : (murk_estimate){NAN, NAN};
}

static double ceiling_of(const murk_place_result *place)
{
    return murk_share(place->ceiling, place->whole);
}

/* True if the plan was chosen for later steps as well, so that value and bound
 * are means. */
static bool is_ahead(const murk_plan_result *plan)
{
    return plan->ahead && plan->ahead->n > 1;
}

/* The coverage of all candidates at the time of the plan. */
static double ceiling_at(const murk_plan_result *plan)
{
    return is_ahead(plan) && plan->free.is_there ? plan->free.ceiling
                                                 : ceiling_of(&plan->place);
}

static void list_coverage(murk_results_fields *f, const void *of)
{
    const murk_plan_results *r = of;
    const murk_plan_result *plan = r ? r->plan : NULL;
    MURK_NUMBER(f, "in_sample", "1", "on the light that chose the plan",
                plan->in_sample.total.value);
    MURK_ESTIMATE(f, "held_out", "1", "on a second, independent map",
                  held_out_of(plan));
    MURK_NUMBER(f, "in_sample_standard_error", "1",
                "standard error of in_sample",
                plan->in_sample.total.standard_error);
    MURK_ESTIMATE(f, "surface", "1", "of the surface map alone",
                  plan->in_sample.surface);
    MURK_ESTIMATE(f, "volume", "1", "of the volume map alone",
                  plan->in_sample.volume);
    MURK_NUMBER(f, "ceiling", "1", "coverage of all candidates",
                murk_plan_at_least(r->session->scene) > 0 ? NAN
                                                          : ceiling_at(plan));
    MURK_NUMBER(f, "sum_of_views", "1", "sum of the sensors' own coverages",
                plan->in_sample.sum_of_views);
}

/* With placement.at_least: what was asked for, what is reached, and whether the
 * number of sensors is proven to be the fewest. */
static void list_strict(murk_results_fields *f, const murk_plan_results *r)
{
    const murk_plan_result *plan = r ? r->plan : NULL;
    MURK_COUNT(f, "at_least", "sensors that see each photon",
               murk_plan_at_least(r->session->scene));
    MURK_ESTIMATE(f, "reached", "1", "share so seen, in sample",
                  plan->in_sample.at_least);
    MURK_NUMBER(f, "ceiling", "1", "share so seen by all candidates",
                ceiling_of(&plan->place));
    MURK_FLAG(f, "proven_fewest", "true if fewest_possible is met",
              !plan->is_dark && plan->place.count <= plan->place.fewest);
}

static void list_target(murk_results_fields *f, const void *of)
{
    const murk_plan_results *r = of;
    const murk_plan_result *plan = r ? r->plan : NULL;
    MURK_NUMBER(f, "asked", "1", "the target",
                r->session->scene->sensors.target);
    MURK_NUMBER(f, "fewest_possible", "", "no fewer sensors reach the target",
                plan->is_dark ? NAN : (double)plan->place.fewest);
    if (MURK_LISTED_IF(f, murk_plan_at_least(r->session->scene) > 0)) {
        list_strict(f, r);
    }
    MURK_ESTIMATE(f, "confirmed", "1", "on a third map", plan->confirmed);
}

/* The object "moves". */
static void list_moves(murk_results_fields *f, const void *of)
{
    const murk_plan_results *r = of;
    const murk_plan_result *plan = r ? r->plan : NULL;
    const murk_place_result *place = plan ? &plan->place : NULL;
    const murk_scene_placement *asked =
        r ? &r->session->scene->placement : NULL;
    MURK_COUNT(f, "count",
               "pairs of a sensor that left the start plan and one "
               "that came",
               place->moves);
    MURK_NUMBER(f, "at_most", "", "placement.moves_at_most",
                asked->limits_moves ? (double)asked->moves_max : NAN);
    MURK_NUMBER(f, "cost", "1", "of these moves, as coverage",
                murk_share(place->move_cost, place->whole));
    MURK_NUMBER(
        f, "value", "1",
        "coverage (with look_ahead the mean) less cost, in sample, 0 at "
        "least",
        murk_share(murk_place_objective(place), place->whole));
}

/* The object "look_ahead". */
static void list_ahead(murk_results_fields *f, const void *of)
{
    const murk_plan_result *plan = of;
    MURK_COUNT(f, "steps", "with something to see, this one first",
               plan->ahead->seen);
    MURK_NUMBER(
        f, "value", "1",
        "mean coverage of these steps in sample, less the cost of moves, "
        "which bound and curve are of",
        murk_share(murk_place_objective(&plan->place), plan->place.whole));
    MURK_COUNT(f, "photons", "traced in all steps", plan->ahead->photons);
}

/* The object "free". */
static void list_free(murk_results_fields *f, const void *of)
{
    const murk_free_plan *free_plan = of;
    MURK_NUMBER(
        f, "coverage", "1",
        "in sample, of the best plan found for this time alone, wherever "
        "the search begins",
        free_plan->coverage);
    MURK_NUMBER(f, "upper", "1", "bound on such plans", free_plan->upper);
    MURK_TEXT(f, "cut_by",
              "null, or what ended the search of such plans: interrupt or time",
              free_plan->is_interrupted ? "interrupt"
              : free_plan->is_late      ? "time"
                                        : NULL);
}

static void list_placement(murk_results_fields *f, const void *of)
{
    const murk_plan_results *r = of;
    const murk_plan_result *plan = r ? r->plan : NULL;
    const murk_scene_placement *asked =
        r ? &r->session->scene->placement : NULL;
    MURK_TEXT(f, "method", "a word of placement.method",
              asked->knowledge == MURK_SCENE_EXPLORE
                  ? "greedy"
                  : murk_place_method_name(asked->method));
    MURK_TEXT(f, "detection", "a word of placement.detection",
              murk_detection_name(asked->detection));
    /* Settings of the detection and of the sightlines. */
    MURK_NUMBER(
        f, "threshold", "1", "of detection: threshold",
        murk_detection_is(asked->detection, MURK_DETECTION_HAS_THRESHOLD)
            ? asked->threshold
            : NAN);
    MURK_NUMBER(f, "power_radius_m", "m", "of detection: power",
                plan->power_radius_m > 0 ? plan->power_radius_m : NAN);
    MURK_NUMBER(f, "power_neighbours", "", "of detection: power",
                plan->power_neighbours ? (double)plan->power_neighbours : NAN);
    MURK_COUNT(f, "redundancy", "sensors that count for a photon",
               asked->redundancy);
    MURK_TEXT(f, "visibility", "ray or normal",
              asked->by_normal ? "normal" : "ray");
    MURK_TEXT(f, "through", "a word of placement.through",
              murk_scene_word("placement.through", (int)asked->through));
    MURK_TEXT(f, "knowledge", "a word of placement.knowledge",
              murk_scene_word("placement.knowledge", (int)asked->knowledge));
    /* Work of the search. */
    MURK_COUNT(f, "restarts", "starts asked for", asked->restarts);
    MURK_COUNT(f, "starts", "starts made", plan->place.restarts);
    if (MURK_LISTED_IF(f, asked->start_plan ||
                              (plan->poses && plan->poses->start))) {
        MURK_COUNT(f, "started_from",
                   "sensors of the start plan that the search began with",
                   plan->place.started_from);
    }
    MURK_COUNT(f, "evaluations", "of plans", plan->place.evaluations);
    MURK_COUNT(f, "queries", "of the maps, as the paper counts them",
               plan->queries);
    MURK_COUNT(f, "looks", "queries whose row was not remembered", plan->looks);
    MURK_COUNT(f, "shadow_rays", "sightlines followed", plan->shadow_rays);
    MURK_COUNT(f, "sightlines_blocked_by_interfaces",
               "sightlines that end at an interface",
               plan->blocked_by_interfaces);
    MURK_COUNT(f, "sightlines_totally_reflected",
               "sightlines that no refracted way joins",
               plan->totally_reflected);
    murk_results_list_cut(f, plan ? &plan->place : NULL);
}

void murk_results_list_plan(murk_results_fields *f, const void *of)
{
    const murk_plan_results *r = of;
    const murk_plan_result *plan = r ? r->plan : NULL;
    const murk_scene_desc *scene = r ? r->session->scene : NULL;
    const murk_sensor_results sensors =
        r ? murk_plan_sensor_results(scene, plan) : (murk_sensor_results){0};
    const murk_target_results targets = {scene, plan ? &plan->targets : NULL};
    const murk_robust_results robust = {scene, plan ? &plan->robust : NULL};
    const murk_place_result *place = plan ? &plan->place : NULL;
    const murk_budget_results budget = {scene ? scene->sensors.budget : 0,
                                        place};
    /* The light or targets, the candidates, the sensors and their coverage. */
    murk_results_list_head(f, scene);
    if (r && r->conditions) {
        MURK_OBJECT(f, "photons", "", murk_results_list_condition_photons,
                    r->conditions);
    } else {
        MURK_OBJECT(f, "photons", "photons of the light",
                    murk_results_list_photons, r->session->traced);
    }
    murk_results_list_targets(f, &targets);
    MURK_OBJECT(f, "candidates", "places for sensors", list_candidates, plan);
    murk_results_list_sensors(f, &sensors);
    MURK_OBJECT(f, "coverage", "coverage of the plan", list_coverage, r);
    murk_results_list_shares(f, &sensors);
    murk_results_list_regions(f, &sensors);
    murk_results_list_robust(f, &robust);
    murk_results_list_bound(f, place);
    /* Fields that only some plans have. */
    if (MURK_LISTED_IF(f, place->has_moves)) {
        MURK_OBJECT(f, "moves", "with a rule on moves", list_moves, r);
    }
    if (MURK_LISTED_IF(f, is_ahead(plan))) {
        MURK_OBJECT(f, "look_ahead", "with placement.look_ahead", list_ahead,
                    plan);
    }
    if (MURK_LISTED_IF(f, plan->free.is_there)) {
        MURK_OBJECT(f, "free", "plans without a rule on moves and later steps",
                    list_free, &plan->free);
    }
    if (MURK_LISTED_IF(f, scene->sensors.target > 0)) {
        MURK_OBJECT(f, "target", "with a target", list_target, r);
    }
    if (MURK_LISTED_IF(f, budget.asked > 0)) {
        MURK_OBJECT(f, "budget", "with a budget", murk_results_list_budget,
                    &budget);
    }
    murk_results_list_explore(f, scene, plan);
    MURK_OBJECT(f, "placement", "how the plan was found", list_placement, r);
    if (MURK_LISTED_IF(f, r->conditions)) {
        murk_results_list_conditions(f, r ? r->conditions : NULL);
    }
    if (MURK_LISTED_IF(f, r->repeat)) {
        MURK_OBJECT(f, "repeat", "with --repeat", murk_results_list_repeat,
                    r->repeat);
    }
}

murk_sensor_results murk_plan_sensor_results(const murk_scene_desc *scene,
                                             const murk_plan_result *plan)
{
    return (murk_sensor_results){scene, plan->sensor, plan->place.count,
                                 &plan->in_sample, plan->held_out_region};
}

/* ---- the summary ---- */

static void print_interrupt(const murk_place_result *place)
{
    if (place->is_interrupted || place->is_late) {
        murk_print("            the search %s: the plan and the bound are "
                   "those reached so far, and another run may give others\n",
                   place->is_interrupted ? "was interrupted"
                                         : "ended by placement.time_limit_s");
    }
}

void murk_print_bound(const murk_place_result *place, bool has_budget,
                      const char *sample)
{
    if (place->proven_optimal) {
        murk_print("bound       proven optimal for this %s\n", sample);
    } else {
        char what[40] = "no plan within the budget covers";
        if (!has_budget) {
            snprintf(what, sizeof what, "no %zu candidates cover",
                     place->count);
        }
        murk_print("bound       %s more than %.4f of this %s; guarantee: %s\n",
                   what, murk_share(place->upper, place->whole), sample,
                   place->guarantee);
    }
    /* What ended the search. */
    print_interrupt(place);
    if (place->is_cut && !place->is_interrupted && !place->is_late) {
        murk_print("            branch and bound ended by placement.nodes "
                   "after %llu: the bound is the one reached so far\n",
                   (unsigned long long)place->nodes);
    }
    if (place->is_work_cut) {
        murk_print(
            "            the search ended by its limit of work: the plan "
            "and the bound are those reached so far\n");
    }
}

static void print_coverage(const murk_session *session,
                           const murk_plan_result *plan)
{
    const murk_place_result *place = &plan->place;
    if (plan->is_dark) {
        murk_print("coverage    none: it is dark, and no sensor is better than "
                   "another\n");
    } else {
        murk_print("coverage    %.4f in sample (", plan->in_sample.total.value);
        murk_print_maps(&plan->in_sample);
        murk_print(")");
        if (murk_plan_at_least(session->scene) == 0) {
            murk_print("; all candidates: %.4f", ceiling_at(plan));
        }
        murk_print("\n");
        murk_print_weights(session->scene, &plan->in_sample);
    }
    /* Coverage on maps that did not choose the plan. */
    if (plan->has_held_out) {
        murk_print("held out    ");
        murk_print_estimate(plan->held_out);
        if (isfinite(plan->held_out.standard_error)) {
            murk_print(" (one standard error, %s)",
                       murk_error_by(session->scene));
        }
        murk_print("\n");
    }
    /* The target, and the fewest sensors that can reach it. */
    if (session->scene->sensors.target > 0 && !plan->is_dark) {
        const size_t at_least = murk_plan_at_least(session->scene);
        murk_print("target      %.4f ", session->scene->sensors.target);
        if (at_least > 0) {
            murk_print("seen by %zu or more ", at_least);
        }
        murk_print("takes %zu sensors, and no fewer than %zu", place->count,
                   place->fewest);
        if (at_least > 0) {
            murk_print("; %.4f in sample, of all candidates %.4f",
                       plan->in_sample.at_least.value,
                       murk_share(place->ceiling, place->whole));
        }
        if (isfinite(plan->confirmed.value)) {
            murk_print("; on a third map ");
            murk_print_estimate(plan->confirmed);
        }
        murk_print("\n");
    }
}

static void print_moves(const murk_plan_result *plan)
{
    const murk_place_result *place = &plan->place;
    murk_print("moves       %zu from the start plan", place->moves);
    if (place->move_cost > 0) {
        murk_print(" at a cost of %.4f: the value in sample is %.4f",
                   murk_share(place->move_cost, place->whole),
                   murk_share(murk_place_objective(place), place->whole));
    }
    if (plan->free.is_there) {
        murk_print("; with any number of moves at no cost %.4f, and no plan "
                   "more than %.4f",
                   plan->free.coverage, plan->free.upper);
    }
    if (plan->free.is_late) {
        murk_print(", as far as the search came by placement.time_limit_s");
    }
    murk_print("\n");
}

static void print_plan_bound(const murk_session *session,
                             const murk_plan_result *plan,
                             const murk_condition_plans *conditions)
{
    if (session->scene->placement.over == MURK_SCENE_OBJECTIVE_REGRET) {
        murk_print_regret_bound(conditions, murk_sample_of(session->scene));
        print_interrupt(&plan->place);
    } else {
        const size_t at_least = murk_plan_at_least(session->scene);
        char sample[80];
        snprintf(sample, sizeof sample, at_least ? "%s by %zu or more" : "%s",
                 murk_sample_of(session->scene), at_least);
        murk_print_bound(&plan->place, session->scene->sensors.budget > 0,
                         sample);
    }
}

void murk_print_plan(const void *of)
{
    const murk_plan_results *results = of;
    const murk_session *session = results->session;
    const murk_plan_result *plan = results->plan;
    const murk_condition_plans *conditions = results->conditions;
    const murk_place_result *place = &plan->place;
    if (!conditions) {
        murk_print_light(session);
        murk_print_tallies(session);
    }
    /* Goals, candidates, sensors and coverage. */
    murk_print_targets(&plan->targets);
    murk_print_candidates(plan->candidates);
    if (conditions) {
        murk_print_conditions(conditions);
    }
    const murk_sensor_results sensors =
        murk_plan_sensor_results(session->scene, plan);
    murk_print_sensors(&sensors, session->results.folder);
    print_coverage(session, plan);
    murk_print_regions(&sensors);
    murk_print_robust(session->scene, &plan->robust);
    if (session->scene->sensors.budget > 0) {
        murk_print("budget      %.10g of %.10g spent\n",
                   (double)place->cost * MURK_COST_UNIT,
                   session->scene->sensors.budget);
    }
    /* How good the plan is, and how it was found. */
    if (place->has_moves) {
        print_moves(plan);
    }
    if (is_ahead(plan)) {
        murk_print("look ahead  %zu steps: the mean in sample, less moves, is "
                   "%.4f, and the bound is of it\n",
                   plan->ahead->seen,
                   murk_share(murk_place_objective(place), place->whole));
    }
    if (!plan->is_dark) {
        print_plan_bound(session, plan, conditions);
        murk_print_explore(plan, session->results.folder);
    }
    if (results->repeat) {
        murk_print_repeat(results->repeat);
    }
}
