/* The files of a plan except plan.json: the light with its ledger and tallies,
 * the resolved scene, sensors.csv, coverage.csv, plan.ply, and the files of an
 * exploration and of --export. */
#ifndef MURK_RESULTS_PLAN_FILES_H
#define MURK_RESULTS_PLAN_FILES_H

#include "results/plan.h"

/* Adds the files. conditions: NULL for the scene without conditions; otherwise
 * each condition has its own light, ledger, scene and plan-NAME.ply, regret.csv
 * is added, and the files of --export are not written. If an export cannot be
 * made, *late has the reason, and the other files are added all the same. */
murk_status murk_add_plan_files(murk_session *session,
                                const murk_plan_result *plan,
                                const murk_condition_plans *conditions,
                                murk_error *late, murk_error *err);

#endif
