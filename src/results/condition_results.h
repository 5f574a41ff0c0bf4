/* Plans over conditions, as files, JSON and lines. */
#ifndef MURK_RESULTS_CONDITION_RESULTS_H
#define MURK_RESULTS_CONDITION_RESULTS_H

#include "cases/condition_plans.h"
#include "results/fields.h"
#include "results/session.h"

/* Of each condition light-NAME.murk, ledger-NAME.json, scene-NAME.yaml and
 * plan-NAME.ply; and scene.resolved.yaml and regret.csv. */
murk_status murk_add_condition_files(murk_session *session,
                                     const murk_plan_result *plan,
                                     const murk_condition_plans *plans,
                                     murk_error *err);

/* Columns of regret.csv; of: a murk_condition_plans. */
void murk_results_list_use(murk_results_fields *f, const void *of, size_t i);

/* Rows of "photons", those of all conditions; and rows "over" to "regret"; of:
 * a murk_condition_plans. */
void murk_results_list_condition_photons(murk_results_fields *f,
                                         const void *of);
void murk_results_list_conditions(murk_results_fields *f, const void *of);

/* The tables of conditions and of regret, and which of them what follows is
 * about. */
void murk_print_conditions(const murk_condition_plans *plans);

/* With over: regret, in place of the bound's line. */
void murk_print_regret_bound(const murk_condition_plans *plans,
                             const char *sample);

/* For check: the conditions that the scene names; nothing where it has none. */
void murk_print_asked_conditions(const murk_scene_desc *scene);

#endif
