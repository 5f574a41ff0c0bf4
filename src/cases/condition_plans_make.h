/* Makes a plan over the conditions of a scene, in two steps: all checks before
 * light is traced, and then the main job. */
#ifndef MURK_CASES_CONDITION_PLANS_MAKE_H
#define MURK_CASES_CONDITION_PLANS_MAKE_H

#include "cases/condition_plans.h"

/* Finds all errors of the scene before light is traced: fills the conditions of
 * out, and the candidates and poses of the plan. */
murk_status murk_condition_plans_prepare(murk_condition_plans *out,
                                         murk_plan_result *plan,
                                         const murk_scene_desc *scene,
                                         unsigned threads, murk_error *err);

/* The main job, after murk_condition_plans_prepare(). The fields in_sample,
 * held_out and confirmed of the plan are those of the mean, or of the condition
 * that the objective looks at. The total of in_sample is the value of the
 * problem of all scenarios (cases/scenarios.h), which the bound is about; the
 * error of that total is measured. Release plans and plan also after a
 * failure. */
murk_status murk_condition_plans_make(murk_condition_plans *plans,
                                      murk_plan_result *plan, unsigned threads,
                                      murk_error *err);

/* The plan of the scene as it stands from traced light, after
 * murk_plan_prepare(): chooses sensors, and measures their coverage on the
 * light that chose them, on held-out light, and with a target on light that
 * confirms it. If no light source emits, the result is that of
 * murk_plan_result_make_dark(). Release the plan also after a failure. */
murk_status murk_plan_for_scene(murk_plan_result *plan, const murk_stage *stage,
                                murk_traced *traced, unsigned threads,
                                murk_error *err);

#endif
