/* Plans over conditions, as files, JSON and lines. */
#ifndef MURK_RESULTS_OVER_H
#define MURK_RESULTS_OVER_H

#include "cases/condition_plans.h"
#include "results/session.h"

/* Of each condition light-NAME.murk, ledger-NAME.json, scene-NAME.yaml and
 * plan-NAME.ply; and scene.resolved.yaml and regret.csv. */
murk_status murk_over_add_files(murk_session *session,
                                const murk_plan_result *plan,
                                const murk_condition_plans *over,
                                murk_error *err);

/* "photons": those of all conditions. */
void murk_over_json_photons(cJSON *root, const murk_condition_plans *over);

/* "over", "conditions" and "regret". */
void murk_over_json(cJSON *root, const murk_condition_plans *over);

/* The tables of conditions and of regret, and which of them what follows is
 * about. */
void murk_over_print(const murk_condition_plans *over);

/* With over: regret, in place of the bound's line. */
void murk_over_print_bound(const murk_condition_plans *over,
                           const char *sample);

/* For check: the conditions that the scene names; nothing where it has none. */
void murk_over_print_asked(const murk_scene_desc *scene);

#endif
