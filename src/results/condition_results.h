/* Plans over the conditions of a scene (variants of the scene that one plan is
 * to serve), as files, JSON and lines. */
#ifndef MURK_RESULTS_CONDITION_RESULTS_H
#define MURK_RESULTS_CONDITION_RESULTS_H

#include "cases/condition_plans.h"
#include "results/fields.h"
#include "results/session.h"

/* Adds light-NAME.murk, ledger-NAME.json, scene-NAME.yaml and (unless the
 * condition is dark: there is no light to see) plan-NAME.ply of each condition,
 * then scene.resolved.yaml and regret.csv. Does nothing without a folder for
 * results. */
murk_status murk_add_condition_files(murk_session *session,
                                     const murk_condition_plans *plans,
                                     murk_error *err);

/* Lists the columns of regret.csv. `of` points to a murk_condition_plans; item
 * i is plan i / n in lit condition i % n, of n lit conditions. */
void murk_results_list_use(murk_results_fields *f, const void *of, size_t i);

/* The first lists the fields of the object "photons", as sums over all
 * conditions; the second lists the fields "over" to "regret" of plan.json. `of`
 * points to a murk_condition_plans. */
void murk_results_list_condition_photons(murk_results_fields *f,
                                         const void *of);
void murk_results_list_conditions(murk_results_fields *f, const void *of);

/* Prints the tables of conditions. Unless all conditions are dark, also prints
 * the table of regret, and a line that tells whether the lines after it are
 * about one condition, and which, or about the mean of the conditions. */
void murk_print_conditions(const murk_condition_plans *plans);

/* Prints the line "bound" of a plan with placement.over: regret. `sample` is
 * what bounds hold for, such as "sample of photons". */
void murk_print_regret_bound(const murk_condition_plans *plans,
                             const char *sample);

/* For the command check: prints the names of the scene's conditions and how
 * placement combines them (placement.over). Prints nothing if the scene has
 * none. */
void murk_print_asked_conditions(const murk_scene_desc *scene);

#endif
