/* Chooses the plans over conditions: the plan by the objective that is asked
 * for, and for comparison the plan of each condition alone, the plan for the
 * mean and, in a known environment, the plan for the worst condition. A plan of
 * least regret is made only if it is asked for. Plans for comparison have the
 * same method and the same number of sensors, or the same budget. */
#include "cases/condition_plans.h"

#include "base/progress.h"
#include "cases/ahead.h"
#include "cases/scenarios.h"

#include <stdio.h>
#include <stdlib.h>

/* Plans for comparison with `method: best` get a tenth of the nodes of branch
 * and bound: a choice that saves time. With `method: exact`, which has no other
 * search, they get all nodes. */
#define NODES_TO_COMPARE 10

_Static_assert(MURK_SCENE_CONDITIONS_MAX <= MURK_BLOCKS_MAX,
               "every condition has a block");

typedef struct choosing {
    murk_condition_plans *plans;
    murk_plan_result *plan;
    const murk_scene_desc *scene;
    murk_scenarios *scenarios; /* the conditions with a weight above 0 */
    murk_place_desc desc;
    uint64_t queries; /* of all plans, by all their sights; 0 in a known
                         environment */
} choosing;

/* The candidates as they are in condition c. */
static const murk_pose *poses_in(const choosing *ch, size_t c)
{
    const murk_pose *own = ch->plans->conditions->condition[c].pose;
    return own ? own : ch->plan->poses->pose;
}

static murk_status join(choosing *ch, murk_error *err)
{
    const murk_conditions *all = ch->plans->conditions;
    murk_sight *sight[MURK_SCENE_CONDITIONS_MAX];
    const murk_pose *pose[MURK_SCENE_CONDITIONS_MAX];
    double share[MURK_SCENE_CONDITIONS_MAX];
    const murk_scenarios_rows rows = {.pose = pose};
    size_t n = 0;
    for (size_t c = 0; c < all->n; ++c) {
        if (all->condition[c].settings->weight > 0) {
            sight[n] = all->condition[c].sight;
            pose[n] = poses_in(ch, c);
            share[n++] = all->condition[c].settings->weight;
        }
    }
    const murk_status status =
        murk_scenarios_create_from(&ch->scenarios, ch->scene, sight, share, n,
                                   ch->plan->poses, &rows, err);
    if (!status) {
        ch->plan->sense_s = ch->scenarios->sense_s;
    }
    return status;
}

/* Chooses the plan of condition c alone. */
static murk_status place_alone(choosing *ch, murk_place_result *out, size_t c,
                               const murk_place_desc *desc, murk_error *err)
{
    murk_scenarios *alone = NULL;
    const double weight = 1;
    const murk_pose *const pose = poses_in(ch, c);
    const murk_scenarios_rows rows = {.pose = &pose};
    murk_status status = murk_scenarios_create_from(
        &alone, ch->scene, &ch->plans->conditions->condition[c].sight, &weight,
        1, ch->plan->poses, &rows, err);
    if (!status) {
        status = murk_scenarios_place(out, alone, MURK_SCENE_OBJECTIVE_MEAN,
                                      desc, err);
    }
    murk_scenarios_destroy(alone);
    return status;
}

static murk_status no_memory_for(const murk_place_result *place,
                                 murk_error *err)
{
    return murk_no_memory(err, "", "for a plan of %zu sensors", place->count);
}

/* Keeps a plan that was chosen by so many sights. */
static murk_status keep(choosing *ch, const char *made_for,
                        const murk_place_result *place, size_t sights,
                        murk_error *err)
{
    ch->queries += place->queries * sights;
    /* All plans are searched after one another, so a request to finish that
     * came with any of them concerns the results as a whole. */
    ch->plan->place.is_interrupted |= place->is_interrupted;
    ch->plan->place.is_late |= place->is_late;
    murk_condition_plan *plan = &ch->plans->plan[ch->plans->plans++];
    snprintf(plan->made_for, sizeof plan->made_for, "%s", made_for);
    plan->count = place->count;
    plan->sensor = calloc(place->count + 1, sizeof *plan->sensor);
    if (!plan->sensor) {
        return no_memory_for(place, err);
    }
    for (size_t k = 0; k < place->count; ++k) {
        plan->sensor[k] = ch->plan->poses->pose[place->sensor[k]];
    }
    /* The conditions in which fixed sensors are elsewhere, or absent. */
    const murk_conditions *all = ch->plans->conditions;
    for (size_t c = 0; c < all->n; ++c) {
        if (all->condition[c].pose) {
            plan->sensor_in[c] =
                murk_condition_sensors(&all->condition[c], ch->plan->poses,
                                       place->sensor, place->count);
            if (!plan->sensor_in[c]) {
                return no_memory_for(place, err);
            }
        }
    }
    return MURK_OK;
}

/* Changes the settings for the plans for comparison: the number of sensors of
 * the plan that is asked for (if that plan exists already and the scene has no
 * budget), no target, no curve, less branch and bound. */
static void choose_to_compare(choosing *ch)
{
    murk_place_desc *desc = &ch->desc;
    if (ch->plan->place.count > 0 && !(ch->scene->sensors.budget > 0)) {
        desc->count = ch->plan->place.count;
    }
    desc->target = 0;
    desc->with_curve = false;
    if (desc->method == MURK_PLACE_BEST) {
        desc->nodes /= NODES_TO_COMPARE;
    }
}

/* Stores the references of the regret in condition c, taken from the own plan
 * of the condition: the value of the best plan known, the upper bound of any
 * plan, and the coverage by all candidates. */
static void refer(choosing *ch, size_t c, size_t block,
                  const murk_place_result *place)
{
    murk_condition *condition = &ch->plans->conditions->condition[c];
    const double whole = (double)place->whole;
    condition->best_known = (double)place->value / whole;
    condition->best_upper = (double)place->upper / whole;
    ch->scenarios->blocks.reference[block] = place->value;
    ch->plans->ceiling_of[c] = murk_share_units(place->ceiling, place->whole);
}

/* Chooses the plan that is asked for, the own plan of each condition, and the
 * plans by the other objectives. */
static murk_status choose_all(choosing *ch, murk_error *err)
{
    const murk_conditions *all = ch->plans->conditions;
    const murk_scene_objective objective = ch->scene->placement.over;
    const bool is_regret = objective == MURK_SCENE_OBJECTIVE_REGRET;
    murk_status status = MURK_OK;
    size_t block = 0;
    /* The plan that is asked for is chosen first, because the plans for
     * comparison take the number of sensors of this plan. A plan of least
     * regret is chosen later: it needs the own plans of the conditions. */
    ch->desc = murk_scenarios_desc(ch->scenarios, objective);
    murk_place_desc asked = ch->desc;
    if (!is_regret) {
        status = murk_scenarios_place(&ch->plan->place, ch->scenarios,
                                      objective, &asked, err);
    }
    /* The own plan of each condition. */
    choose_to_compare(ch);
    for (size_t c = 0; !status && c < all->n; ++c) {
        const murk_scene_condition *settings = all->condition[c].settings;
        const bool has_block = settings->weight > 0;
        murk_place_result place = {0};
        status = has_block && ch->scenarios->matrix
                     ? murk_scenarios_place_one(&place, ch->scenarios, block,
                                                is_regret, &ch->desc, err)
                     : place_alone(ch, &place, c, &ch->desc, err);
        if (!status && is_regret && has_block) {
            refer(ch, c, block, &place);
        }
        block += has_block;
        if (!status) {
            status = keep(ch, settings->name, &place, 1, err);
        }
        murk_place_release(&place);
    }
    /* The plans by each objective, among them the one that is asked for. */
    static const murk_scene_objective objectives[] = {
        MURK_SCENE_OBJECTIVE_MEAN, MURK_SCENE_OBJECTIVE_WORST,
        MURK_SCENE_OBJECTIVE_REGRET};
    for (size_t i = 0; !status && i < (is_regret ? 3 : 2); ++i) {
        const murk_scene_objective k = objectives[i];
        const char *name = murk_scene_word("placement.over", (int)k);
        murk_place_result place = {0};
        if (k == objective && is_regret) {
            asked.with_curve = false; /* the references hold for this number of
                                         sensors only */
            status =
                murk_scenarios_place(&ch->plan->place, ch->scenarios,
                                     MURK_SCENE_OBJECTIVE_REGRET, &asked, err);
        }
        if (status) {
            break;
        }
        if (k == objective) {
            ch->plans->chosen = ch->plans->plans;
            status =
                keep(ch, name, &ch->plan->place, ch->scenarios->blocks.n, err);
        } else if (k == MURK_SCENE_OBJECTIVE_MEAN || ch->scenarios->matrix) {
            status =
                murk_scenarios_place(&place, ch->scenarios, k, &ch->desc, err);
            if (!status) {
                status = keep(ch, name, &place, ch->scenarios->blocks.n, err);
            }
        }
        murk_place_release(&place);
    }
    return status;
}

/* Joins the conditions to one placement problem and chooses the plans. */
static murk_status choose_joined(choosing *ch, murk_error *err)
{
    const murk_conditions *all = ch->plans->conditions;
    murk_status status = join(ch, err);
    const double begun_s = murk_clock_s();
    if (!status) {
        status = choose_all(ch, err);
    }
    if (!status) {
        status = murk_plan_take_sensors(ch->plan, ch->scene, err);
    }
    ch->plan->place_s = murk_clock_s() - begun_s;
    murk_scenarios_destroy(ch->scenarios);
    for (size_t c = 0; !status && c < all->n; ++c) {
        murk_plan_add_work(ch->plan, all->condition[c].sight);
    }
    murk_plan_count_queries(ch->plan, ch->queries);
    if (status && err && !err->where[0]) {
        snprintf(err->where, sizeof err->where, "%s", ch->scene->sensors.where);
    }
    return status;
}

murk_status murk_condition_plans_choose(murk_condition_plans *plans,
                                        murk_plan_result *plan, murk_error *err)
{
    const murk_conditions *all = plans->conditions;
    choosing ch = {.plans = plans, .plan = plan, .scene = all->scene};
    murk_status status =
        murk_conditions_take_poses(plans->conditions, plan->poses, err);
    if (status) {
        return status;
    }
    if (!all->is_scene) {
        return choose_joined(&ch, err);
    }
    murk_sight *sight = all->condition[0].sight;
    status = plan->ahead && plan->ahead->n > 1
                 ? murk_ahead_choose(plan, sight, err)
                 : murk_plan_choose(plan, all->condition[0].stage, sight, err);
    return status ? status : keep(&ch, "", &plan->place, 1, err);
}
