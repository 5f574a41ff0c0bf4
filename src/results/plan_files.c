/* Adds the files of a plan, in the order in which they are moved into the
 * folder. */
#include "results/plan_files.h"

#include "results/condition_results.h"
#include "results/coverage.h"
#include "results/explore.h"
#include "results/exports.h"
#include "results/geo.h"
#include "results/tallies.h"

murk_status murk_add_plan_files(murk_session *session,
                                const murk_plan_result *plan,
                                const murk_condition_plans *conditions,
                                murk_error *late, murk_error *err)
{
    const murk_sensor_results sensors =
        murk_plan_sensor_results(session->scene, plan);
    /* The light of each condition, or that of the scene; then the plan. */
    murk_status status =
        conditions ? murk_add_condition_files(session, conditions, err)
                   : murk_session_add_all_of_light(session, err);
    if (!status && session->settings.own_input) {
        status = murk_results_note(&session->results,
                                   session->settings.own_input, err);
    }
    if (!status) {
        status = murk_results_add_csv(&session->results, "sensors.csv",
                                      murk_results_list_place, &sensors,
                                      sensors.n, err);
    }
    if (!status) {
        status = murk_results_add_csv(&session->results, "coverage.csv",
                                      murk_results_list_sensor, &sensors,
                                      sensors.n, err);
    }
    if (!status) {
        status = murk_geo_add(session, &sensors, err);
    }
    if (!status) {
        status = murk_add_explore(&session->results, session->stage, plan, err);
    }
    if (!status && !conditions) {
        status = murk_exports_add_plan(session, plan, late, err);
    }
    return status;
}
