/* Makes the plan of a scene as it stands, which is one condition, and the plans
 * over several conditions: lights every condition, chooses the plans, and
 * measures each plan in each condition, on the light that chose it and, if the
 * scene asks for it, on held-out light. The figures of one plan over all
 * conditions are the mean, or the figures of the condition that the objective
 * looks at: the worst one, or the one in which the regret is largest. */
#include "cases/condition_plans.h"

#include "base/machine.h"
#include "base/progress.h"
#include "cases/scenario_mean.h"
#include "plan/few_photons.h"
#include "plan/start_plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Streams of random numbers that one condition takes: one for the light that
 * is held out and one for the light that confirms a target. The streams of the
 * first condition are those of a plan for a single scene. */
#define STREAMS_EACH 2u

/* Of held-out photons the memory for the number in sample is reserved, and for
 * one more in so many: counts of records differ by far less (a choice; memory
 * that stays unused costs nothing). */
#define RESERVE 16

/* ---- before any light ---- */

/* Fails if a condition has a fixed sensor that has failed by the scene's own
 * time, whose fixed sensors are those of the plan. */
static murk_status check_fixed(const murk_scene_desc *scene, murk_error *err)
{
    const murk_scene_sensors *own = &scene->sensors;
    for (size_t c = 0; c < scene->n_conditions; ++c) {
        const murk_scene_sensors *other = &scene->conditions[c].scene->sensors;
        for (size_t i = 0; i < other->n_fixed; ++i) {
            size_t k = 0;
            while (k < own->n_fixed &&
                   own->fixed[k].number != other->fixed[i].number) {
                ++k;
            }
            if (k == own->n_fixed) {
                return murk_fail(
                    err, MURK_BAD_VALUE, scene->conditions[c].where,
                    "sensors.fixed.%zu has failed by the scene's own time, at "
                    "%g s, but not in this condition: a plan over conditions "
                    "needs an earlier timeline.at_s",
                    other->fixed[i].number, scene->timeline.at_s);
            }
        }
    }
    return MURK_OK;
}

murk_status murk_condition_plans_prepare(murk_condition_plans *out,
                                         murk_plan_result *plan,
                                         const murk_scene_desc *scene,
                                         unsigned threads, murk_error *err)
{
    const murk_scene_placement *settings = &scene->placement;
    /* Refuse combinations of keys that have no meaning for several conditions.
     */
    if (settings->knowledge == MURK_SCENE_EXPLORE) {
        return murk_fail(err, MURK_BAD_VALUE, settings->where,
                         "over: knowledge explore goes through the scene as it "
                         "stands, so over must be null");
    }
    if (scene->are_conditions_steps && scene->timeline.has_at) {
        return murk_fail(err, MURK_BAD_VALUE, settings->where,
                         "over: the plan is for all steps of the timeline, so "
                         "a time (--at, timeline.at_s) must not be given");
    }
    const bool is_regret = settings->over == MURK_SCENE_OBJECTIVE_REGRET;
    if (settings->over != MURK_SCENE_OBJECTIVE_MEAN &&
        settings->knowledge != MURK_SCENE_KNOWN) {
        return murk_fail(err, MURK_BAD_VALUE, settings->where,
                         "over: %s needs what every candidate sees, so "
                         "knowledge must be known",
                         is_regret ? "regret" : "worst");
    }
    if (is_regret && scene->sensors.target > 0) {
        return murk_fail(err, MURK_BAD_VALUE, settings->where,
                         "over: regret compares plans of as many sensors, so "
                         "sensors.target must not be given; give sensors.count "
                         "or sensors.budget");
    }
    const murk_status missing = check_fixed(scene, err);
    if (missing) {
        return missing;
    }
    /* Build the world of each condition and check what its plan needs. */
    murk_progress_begin_group("build", 0, "");
    murk_status status = murk_conditions_create(&out->conditions, scene, err);
    murk_progress_end();
    const murk_stage *stage[MURK_SCENE_CONDITIONS_MAX];
    const char *where[MURK_SCENE_CONDITIONS_MAX];
    for (size_t c = 0; !status && c < scene->n_conditions; ++c) {
        stage[c] = out->conditions->condition[c].stage;
        where[c] = out->conditions->condition[c].settings->where;
        status = murk_plan_check(stage[c], threads, err);
    }
    /* Find the candidates that are usable in every condition. */
    if (!status) {
        status = murk_sites_find_common(&plan->candidates, stage, where,
                                        scene->n_conditions, threads, err);
    }
    if (!status) {
        status = murk_poses_create(&plan->poses, scene, &stage[0]->world.domain,
                                   plan->candidates->position,
                                   plan->candidates->usable, err);
    }
    if (!status) {
        status = murk_start_plan_match(plan->poses, scene,
                                       &stage[0]->world.domain, err);
    }
    return status;
}

/* ---- measuring ---- */

/* The number of the first earlier plan with the same sensors in the same order
 * as plan p, if neither of the two is the chosen plan; p if there is none. */
static size_t find_same(const murk_condition_plans *plans, size_t p)
{
    for (size_t q = 0; q < p; ++q) {
        if (q != plans->chosen && p != plans->chosen &&
            plans->plan[q].count == plans->plan[p].count &&
            memcmp(plans->plan[q].sensor, plans->plan[p].sensor,
                   plans->plan[p].count * sizeof *plans->plan[p].sensor) == 0) {
            return q;
        }
    }
    return p;
}

/* Measures the total coverage of all plans in one condition; *chosen receives
 * the whole result of the chosen plan. */
static murk_status measure_all(murk_condition_plans *plans, size_t c,
                               murk_sight *sight, bool is_held_out,
                               murk_coverage_result *chosen, murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t p = 0; !status && p < plans->plans; ++p) {
        murk_condition_plan *plan = &plans->plan[p];
        murk_estimate *to =
            is_held_out ? &plan->held_out[c] : &plan->in_sample[c];
        const murk_condition_plan *same = &plans->plan[find_same(plans, p)];
        const murk_pose *sensor = murk_condition_plan_sensors_in(plan, c);
        if (same != plan) {
            *to = is_held_out ? same->held_out[c] : same->in_sample[c];
        } else if (p == plans->chosen) {
            status = murk_coverage_result_measure(chosen, sight, sensor,
                                                  plan->count, err);
            *to = chosen->total;
        } else {
            status = murk_coverage_total_measure(to, sight, sensor, plan->count,
                                                 err);
        }
    }
    return status;
}

/* ---- jitter ---- */

/* The number of draws of jitter for the chosen plan; 0 if the scene has no
 * jitter or the plan has no sensors. */
static size_t draws_of(const murk_condition_plans *plans)
{
    return plans->plan[plans->chosen].count > 0
               ? murk_robust_draws(plans->conditions->scene)
               : 0;
}

/* Measures the chosen plan with jitter in condition c: one coverage for each
 * draw. Sensors are displaced in the world of the first condition, so that the
 * draws are the same in all conditions. */
static murk_status shake(murk_condition_plans *plans, size_t c,
                         murk_sight *sight, murk_error *err)
{
    const murk_condition_plan *chosen = &plans->plan[plans->chosen];
    const size_t draws = draws_of(plans);
    size_t unmoved = 0;
    if (draws == 0) {
        return MURK_OK;
    }
    const murk_status status = murk_robust_draw(
        plans->shaken + c * draws, &unmoved,
        plans->conditions->condition[0].stage, sight,
        murk_condition_plan_sensors_in(chosen, c), chosen->count, err);
    plans->unmoved = unmoved > plans->unmoved ? unmoved : plans->unmoved;
    return status;
}

static murk_status no_memory_for_draws(const murk_condition_plans *plans,
                                       murk_error *err)
{
    return murk_no_memory(err, plans->conditions->scene->path,
                          "for %zu draws of jitter", draws_of(plans));
}

static murk_status allocate_jitter(murk_condition_plans *plans, murk_error *err)
{
    const size_t n = draws_of(plans) * plans->conditions->n;
    plans->shaken = n ? calloc(n, sizeof *plans->shaken) : NULL;
    return plans->shaken || n == 0 ? MURK_OK : no_memory_for_draws(plans, err);
}

/* Turns the coverages of each draw in all conditions into one figure by the
 * objective, and summarises the draws. */
static murk_status sum_up_jitter(murk_condition_plans *plans,
                                 murk_plan_result *plan, murk_error *err)
{
    const murk_conditions *all = plans->conditions;
    const size_t draws = draws_of(plans);
    murk_estimate *covered = malloc(draws * sizeof *covered + 1);
    if (!covered) {
        return no_memory_for_draws(plans, err);
    }
    /* One figure of all conditions for each draw, by the objective. */
    for (size_t d = 0; d < draws; ++d) {
        murk_estimate of[MURK_SCENE_CONDITIONS_MAX];
        size_t worst;
        for (size_t c = 0; c < all->n; ++c) {
            of[c] = plans->shaken[c * draws + d];
        }
        covered[d] = murk_conditions_estimate(
            all, of, all->scene->placement.over, plans->has_held_out, &worst);
    }
    /* The spread of the draws about the figure of the plan without jitter. */
    const murk_status status =
        draws == 0 ? MURK_OK
                   : murk_robust_summarise(
                         &plan->robust, covered, draws, plans->unmoved,
                         plans->has_held_out ? plan->held_out.value
                                             : plan->in_sample.total.value,
                         plans->has_held_out, err);
    free(covered);
    return status;
}

/* ---- other light ---- */

/* Held-out photons are few enough to stay for the next step: they take at most
 * an eighth of the memory for rows, of which two steps share half each. */
#define HELD_SHARE_MAX 0.125

static bool may_hold(const murk_scene_desc *scene, size_t photons)
{
    return (double)(photons * sizeof(murk_photon)) <=
           HELD_SHARE_MAX * scene->placement.memory_mb * MURK_BYTES_PER_MB;
}

/* The coverage of the chosen plan in light of another stream in condition c. In
 * held-out light also the coverage of all plans and the jitter. */
static murk_status measure_in(murk_condition_plans *plans,
                              murk_plan_result *plan, size_t c, uint32_t stream,
                              murk_coverage_result *out, unsigned threads,
                              murk_error *err)
{
    const murk_stage *stage = plans->conditions->condition[c].stage;
    const murk_condition_plan *chosen = &plans->plan[plans->chosen];
    const murk_pose *sensor = murk_condition_plan_sensors_in(chosen, c);
    const bool is_held_out = stream == MURK_HELD_OUT_STREAM;
    const uint32_t numbers = stream + STREAMS_EACH * (uint32_t)c;
    murk_traced *other = NULL;
    murk_sight *sight = NULL;
    murk_status status = MURK_OK;
    /* The search has freed much that the next light may take the place of; the
     * next step of a sequence needs as much again. */
    if (!plan->keeps_matrix) {
        murk_machine_trim();
    }
    /* The photons need not be stored if there is one plan without jitter. */
    if (plans->plans == 1 && murk_plan_can_stream(stage) &&
        (!is_held_out || draws_of(plans) == 0)) {
        const size_t as_in_sample =
            murk_sight_photons(plans->conditions->condition[c].sight);
        const bool holds = is_held_out && plan->keeps_matrix &&
                           may_hold(stage->scene, as_in_sample);
        status = murk_plan_measure_streamed(
            out, &plan->trace_s, stage, numbers, sensor, chosen->count,
            as_in_sample + as_in_sample / RESERVE,
            plan->earlier ? plan->earlier->held_out : NULL,
            holds ? &plan->held : NULL, threads, err);
        if (!status && is_held_out) {
            plans->plan[plans->chosen].held_out[c] = out->total;
        }
        return status;
    }
    /* Trace the light and build the sight onto it. */
    status = murk_plan_trace_stream(&other, stage, numbers, threads, err);
    if (!status) {
        plan->trace_s += other->trace_s;
        plan->map_s += other->map_s;
        status = murk_plan_sight(&sight, stage, other, threads, err);
    }
    /* Measure. */
    if (!status) {
        status = is_held_out ? measure_all(plans, c, sight, true, out, err)
                             : murk_coverage_result_measure(out, sight, sensor,
                                                            chosen->count, err);
    }
    if (!status && is_held_out) {
        status = shake(plans, c, sight, err);
    }
    murk_sight_destroy(sight);
    murk_traced_destroy(other);
    return status;
}

/* Turns the coverages of the chosen plan in all conditions into one coverage:
 * the mean, or for another objective the coverage in the condition that the
 * objective looks at. With the objective regret, stores that condition in
 * regret_at. */
static murk_status sum_up(murk_coverage_result *out,
                          const murk_condition_plans *plans,
                          const murk_coverage_result *of, bool are_independent,
                          murk_error *err)
{
    const murk_conditions *all = plans->conditions;
    const murk_interest *interest =
        murk_goals_interest(all->condition[0].stage->goals);
    murk_estimate total[MURK_SCENE_CONDITIONS_MAX];
    double weight[MURK_SCENE_CONDITIONS_MAX];
    size_t worst;
    /* Find the condition that the objective looks at. */
    for (size_t c = 0; c < all->n; ++c) {
        weight[c] = all->condition[c].settings->weight;
        total[c] = of[c].total;
    }
    murk_conditions_estimate(all, total, all->scene->placement.over, true,
                             &worst);
    if (all->scene->placement.over == MURK_SCENE_OBJECTIVE_REGRET) {
        plans->conditions->regret_at = worst;
        plans->conditions->has_regret_at = true;
    }
    /* An objective other than the mean takes the coverage of that condition
     * alone. */
    if (all->scene->placement.over != MURK_SCENE_OBJECTIVE_MEAN) {
        memset(weight, 0, sizeof weight);
        weight[worst] = 1;
    }
    return murk_scenario_mean_coverage(
        out, of, weight, all->n, plans->plan[plans->chosen].count,
        interest ? interest->n : 0, are_independent, err);
}

static murk_status measure_held_out(murk_condition_plans *plans,
                                    murk_plan_result *plan, unsigned threads,
                                    murk_error *err)
{
    murk_coverage_result held_out[MURK_SCENE_CONDITIONS_MAX] = {0}, sum = {0};
    murk_status status = MURK_OK;
    /* Measure all plans in the held-out light of each condition. */
    for (size_t c = 0; !status && c < plans->conditions->n; ++c) {
        status = measure_in(plans, plan, c, MURK_HELD_OUT_STREAM, &held_out[c],
                            threads, err);
        murk_progress_add_to_group(!status);
    }
    /* Sum the conditions up and hand the result to the plan. */
    if (!status) {
        status = sum_up(&sum, plans, held_out, true, err);
    }
    if (!status) {
        status = murk_robust_hold_out(&plan->robust, &sum, err);
    }
    if (!status) {
        plans->has_held_out = plan->has_held_out = true;
        plan->held_out = sum.total;
        plan->held_out_region = sum.region;
        sum.region = NULL;
    }
    murk_coverage_result_release(&sum);
    for (size_t c = 0; c < plans->conditions->n; ++c) {
        murk_coverage_result_release(&held_out[c]);
    }
    return status;
}

/* Measures the chosen plan in light that confirms a target. If the scene has
 * placement.at_least, the share seen by so many sensors is taken, else the
 * coverage. */
static murk_status confirm(murk_condition_plans *plans, murk_plan_result *plan,
                           unsigned threads, murk_error *err)
{
    const murk_conditions *all = plans->conditions;
    murk_estimate of[MURK_SCENE_CONDITIONS_MAX];
    murk_status status = MURK_OK;
    for (size_t c = 0; !status && c < all->n; ++c) {
        murk_coverage_result coverage = {0};
        status = measure_in(plans, plan, c, MURK_CONFIRM_STREAM, &coverage,
                            threads, err);
        murk_progress_add_to_group(!status);
        of[c] =
            murk_plan_at_least(all->scene) ? coverage.at_least : coverage.total;
        murk_coverage_result_release(&coverage);
    }
    if (!status) {
        size_t worst;
        plan->confirmed = murk_conditions_estimate(
            all, of, all->scene->placement.over, true, &worst);
    }
    return status;
}

/* ---- all ---- */

/* Reads the regrets from the result of the placement, whose value is 1 - the
 * largest regret. Then replaces value and bound of the result: by the coverage
 * in the condition of the largest regret, and by the coverage that the plan
 * would have there if the regret were as small as the bound allows. The ceiling
 * becomes that of the same condition. */
static void read_regret(murk_condition_plans *plans, murk_plan_result *plan)
{
    const murk_conditions *all = plans->conditions;
    const murk_condition_plan *chosen = &plans->plan[plans->chosen];
    murk_place_result *place = &plan->place;
    const double one = (double)place->whole;
    /* The largest regret of the plan, and a lower bound of the largest regret
     * of any plan, both to the best plans that are known. */
    plans->regret = 1 - (double)place->value / one;
    plans->regret_lower = 1 - (double)place->upper / one;
    plans->regret_upper = plans->regret;
    /* The largest regret that the plan can have to the true optima: each best
     * plan known is replaced by the upper bound of its condition. */
    for (size_t c = 0; c < all->n; ++c) {
        murk_condition at = all->condition[c];
        at.best_known = at.best_upper;
        const double max =
            murk_condition_regret(all->scene, &at, chosen->in_sample[c].value);
        if (at.settings->weight > 0 && max > plans->regret_upper) {
            plans->regret_upper = max;
        }
    }
    /* Value and bound of the plan in the condition of the largest regret. */
    size_t at;
    murk_conditions_estimate(all, chosen->in_sample,
                             MURK_SCENE_OBJECTIVE_REGRET, false, &at);
    const double unit = all->scene->placement.relative_regret
                            ? all->condition[at].best_known
                            : 1;
    const double seen = plan->in_sample.total.value;
    const double more = unit * (plans->regret - plans->regret_lower);
    place->value = (uint64_t)(seen * one);
    place->upper = place->value + (uint64_t)(more * one);
    place->ceiling = plans->ceiling_of[at];
}

/* With the objective regret, calls read_regret(). With another objective over
 * conditions, takes the total in sample from the problem of all scenarios, on
 * which the bound and the curve rest as well. The mean of the coverages of the
 * conditions differs from that total by the rounding of weights, and the
 * difference may exceed the gap to the bound. */
static void read_in_sample(murk_condition_plans *plans, murk_plan_result *plan)
{
    if (plans->conditions->scene->placement.over ==
        MURK_SCENE_OBJECTIVE_REGRET) {
        read_regret(plans, plan);
    } else if (!plans->conditions->is_scene) {
        plan->in_sample.total.value =
            (double)plan->place.value / (double)plan->place.whole;
    }
}

static murk_status measure(murk_condition_plans *plans, murk_plan_result *plan,
                           unsigned threads, murk_error *err)
{
    const murk_conditions *all = plans->conditions;
    const murk_condition_plan *chosen = &plans->plan[plans->chosen];
    murk_status status = MURK_OK;
    /* Coverage of all plans on the light that chose them. */
    for (size_t c = 0; !status && c < all->n; ++c) {
        status = measure_all(plans, c, all->condition[c].sight, false,
                             &plans->coverage[c], err);
        if (!status) {
            murk_warn_of_thin_map(
                all->scene, &plans->coverage[c],
                all->is_scene ? NULL : all->condition[c].settings->name);
        }
    }
    if (!status) {
        status = sum_up(&plan->in_sample, plans, plans->coverage, false, err);
    }
    plan->confirmed = (murk_estimate){NAN, NAN};
    if (!status) {
        status = murk_robust_begin(&plan->robust, all->condition[0].stage,
                                   plan->sensor, chosen->count,
                                   &plan->in_sample, err);
    }
    if (!status) {
        status = allocate_jitter(plans, err);
    }
    /* Held-out light, jitter and the confirmation of a target. */
    const bool is_more = murk_plan_has_streams(all->scene);
    const bool holds_out = is_more && all->scene->placement.hold_out;
    for (size_t c = 0; !status && !holds_out && c < all->n; ++c) {
        status = shake(plans, c, all->condition[c].sight, err);
    }
    if (!status && holds_out) {
        murk_progress_begin_group("hold out", 0, "lights");
        status = measure_held_out(plans, plan, threads, err);
        murk_progress_end();
    }
    if (!status) {
        status = sum_up_jitter(plans, plan, err);
        read_in_sample(plans, plan); /* this must follow murk_robust_begin(),
                                      * which compares the measured total with
                                      * totals that were measured in the same
                                      * way */
    }
    if (!status && is_more && all->scene->sensors.target > 0) {
        murk_progress_begin_group("hold out", 0, "lights");
        status = confirm(plans, plan, threads, err);
        murk_progress_end();
    }
    return status;
}

murk_status murk_condition_plans_make(murk_condition_plans *plans,
                                      murk_plan_result *plan, unsigned threads,
                                      murk_error *err)
{
    murk_conditions *all = plans->conditions;
    murk_status status = murk_conditions_light(all, threads, err);
    plan->trace_s = all->trace_s;
    plan->map_s = all->map_s;
    if (!status && all->n == 0) {
        return murk_plan_result_make_dark(plan, all->condition[0].stage, err);
    }
    if (!status) {
        status = murk_condition_plans_choose(plans, plan, err);
    }
    plan->targets = all->condition[0].targets;
    return status ? status : measure(plans, plan, threads, err);
}

murk_status murk_plan_for_scene(murk_plan_result *plan, const murk_stage *stage,
                                murk_traced *traced, unsigned threads,
                                murk_error *err)
{
    murk_condition_plans *plans = calloc(1, sizeof *plans);
    if (!plans) {
        return murk_no_memory(err, stage->scene->path, "for the plan");
    }
    murk_status status =
        murk_conditions_of_stage(&plans->conditions, stage, traced, err);
    if (!status) {
        status = murk_condition_plans_make(plans, plan, threads, err);
    }
    murk_condition_plans_release(plans);
    free(plans);
    return status;
}
