/* Plans over the conditions of a scene: the plan for the mean coverage, for the
 * worst condition or for the least largest regret, and for comparison the plan
 * of each condition alone. The regret of a plan in a condition is the coverage
 * that the best plan known for that condition has in the condition, less the
 * coverage of the plan.
 *
 * The coverage in each condition is measured in the light of that condition,
 * by fixed sensors as they are at its time; dark conditions are left out. The
 * held-out map of a condition is independent of all other maps, also of those
 * of other conditions. The maps that choose share their random numbers between
 * conditions, so that differences between conditions have less noise. */
#ifndef MURK_CASES_CONDITION_PLANS_H
#define MURK_CASES_CONDITION_PLANS_H

#include "cases/conditions.h"
#include "plan/plan.h"

/* One plan and the coverage that it has in each condition. */
typedef struct murk_condition_plan {
    murk_scene_name made_for; /* name of a condition, or mean, worst, regret;
                               * empty for the scene as it stands */
    size_t count;
    murk_pose *sensor; /* [count] at the scene's own time */
    /* [count] as they are in each condition (murk_condition_sensors()); NULL:
     * as in `sensor` */
    murk_pose *sensor_in[MURK_SCENE_CONDITIONS_MAX];
    murk_estimate in_sample[MURK_SCENE_CONDITIONS_MAX];
    murk_estimate held_out[MURK_SCENE_CONDITIONS_MAX];
} murk_condition_plan;

/* A plan for each condition, and one for each of three objectives. */
#define MURK_CONDITION_PLANS_MAX (MURK_SCENE_CONDITIONS_MAX + 3)

typedef struct murk_condition_plans {
    murk_conditions *conditions;
    /* The plan of each condition that is not dark, in the order of
     * `conditions`; then the plans for the mean, for the worst condition (in a
     * known environment) and for the regret (if it is asked for). The scene as
     * it stands has one plan. */
    murk_condition_plan plan[MURK_CONDITION_PLANS_MAX];
    size_t plans;      /* 0: every condition is dark */
    size_t chosen;     /* number of the plan that is asked for */
    bool has_held_out; /* held_out of the plans is measured */
    /* Of the chosen plan, in sample. */
    murk_coverage_result coverage[MURK_SCENE_CONDITIONS_MAX];
    murk_estimate *shaken; /* [conditions * draws] coverage of the chosen plan
                              with jitter; NULL without jitter */
    size_t unmoved;        /* number of displacements, out of draws times
                            * sensors, for which no free position was found; the
                            * largest of all conditions, which differ if fixed
                            * sensors move */
    /* With the objective regret, on the sample that chose: the largest regret
     * of the chosen plan to the best plans known; a lower bound of the largest
     * regret of any plan, which holds for the true optima too, because these
     * are not less than the best plans known; and an upper bound of the largest
     * regret of the chosen plan to the true optima. */
    double regret, regret_lower, regret_upper;
    /* With the objective regret, for conditions of weight above 0: coverage by
     * all candidates, as a share in units of 1 / MURK_SHARE_ONE
     * (placement/blocks.h). */
    uint64_t ceiling_of[MURK_SCENE_CONDITIONS_MAX];
} murk_condition_plans;

/* The sensors of a plan as they are in condition c, which is not dark: [count],
 * of which absent ones are of MURK_POSE_OF_NONE. */
const murk_pose *murk_condition_plan_sensors_in(const murk_condition_plan *plan,
                                                size_t c);

/* Regret of a plan in condition c, which is not dark: the coverage of the own
 * plan of that condition less the coverage of the plan, from held-out coverages
 * if they were measured, else from those in sample. The difference is absolute,
 * also with placement.regret: relative. */
double murk_condition_plans_regret(const murk_condition_plans *plans,
                                   const murk_condition_plan *plan, size_t c);

/* Releases all plans and the conditions, also after a failure. */
void murk_condition_plans_release(murk_condition_plans *plans);

/* Checks the scene before light is traced, imports and builds the worlds of the
 * conditions of *out, and finds the candidates and poses of the plan. Fails
 * with MURK_BAD_VALUE for keys that have no meaning together with
 * placement.over, and as murk_conditions_create() and the functions that find
 * candidates. */
murk_status murk_condition_plans_prepare(murk_condition_plans *out,
                                         murk_plan_result *plan,
                                         const murk_scene_desc *scene,
                                         unsigned threads, murk_error *err);

/* Traces the light of the conditions, chooses the plans and measures them,
 * after murk_condition_plans_prepare(). The fields in_sample, held_out and
 * confirmed of the plan are those of the mean, or of the condition that the
 * objective looks at. Over conditions and with an objective other than the
 * regret, the total of in_sample is the value of the problem of all scenarios
 * (cases/scenarios.h), because the bound is one of that value; the error of the
 * total is measured. If all conditions are dark, the result is that of
 * murk_plan_result_make_dark(). Release plans and plan also after a failure. */
murk_status murk_condition_plans_make(murk_condition_plans *plans,
                                      murk_plan_result *plan, unsigned threads,
                                      murk_error *err);

/* The plan of the scene as it stands from traced light (NULL: the light is
 * traced first), after murk_plan_prepare(): chooses sensors, and measures their
 * coverage on the light that chose them, on held-out light if the scene asks
 * for that, and with a target on light that confirms it. If there is nothing to
 * see, the result is that of murk_plan_result_make_dark(). Release the plan
 * also after a failure. */
murk_status murk_plan_for_scene(murk_plan_result *plan, const murk_stage *stage,
                                murk_traced *traced, unsigned threads,
                                murk_error *err);

/* Fills plan->place with the plan that is asked for, and plans->plan with that
 * plan and the others. The others are chosen by the same method, with the same
 * number of sensors or the same budget, and without curves. The conditions must
 * have their light (murk_conditions_light()). */
murk_status murk_condition_plans_choose(murk_condition_plans *plans,
                                        murk_plan_result *plan,
                                        murk_error *err);

#endif
