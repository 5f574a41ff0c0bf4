/* murk sense: measures the coverage of given sensors on the light of a scene,
 * and writes the results. */
#include "app/session.h"
#include "plan/measured.h"
#include "plan/placement_in.h"
#include "plan/plan.h"
#include "results/exports.h"
#include "results/plan_ply.h"
#include "results/sense.h"
#include "results/tallies.h"

#include <math.h>
#include <stdlib.h>

static murk_status write_coverage(murk_session *session,
                                  const murk_sense_results *results,
                                  murk_error *err)
{
    murk_status status = murk_session_add_all_of_light(session, err);
    if (!status) {
        status = murk_results_add_csv(
            &session->results, "coverage.csv", murk_results_list_sensor,
            &results->sensors, results->sensors.n, err);
    }
    if (!status) {
        status = murk_session_finish(
            session, "coverage.json",
            murk_results_json(murk_results_list_sense, results),
            murk_print_sense, results, err);
    }
    return status;
}

/* Measures, and adds who sees what, for viewers and the report, and the
 * exports. */
static murk_status measure(murk_measured *of, murk_session *session,
                           const murk_pose *sensor, size_t n, murk_error *late,
                           murk_error *err)
{
    murk_sight *sight = NULL;
    murk_status status =
        murk_measured_make(of, &sight, session->stage, session->traced, sensor,
                           n, session->settings.threads, err);
    if (!status && sight && session->results.folder) {
        status = murk_add_plan_ply(&session->results, "coverage.ply",
                                   session->stage, sight, sensor, n, err);
    }
    if (!status) {
        murk_exports_add_scene(session, sight, sensor, sight ? n : 0, late);
    }
    murk_sight_destroy(sight);
    return status;
}

murk_status murk_command_sense(const murk_options *options, murk_error *err)
{
    murk_session session;
    murk_measured of = {0};
    murk_error late = {0};
    murk_pose *sensor = NULL;
    size_t n = 0;
    if (!options->sensors) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "sense needs --sensors FILE, a sensors.csv or a "
                         "plan.json");
    }
    murk_status status = murk_session_begin(&session, options, err);
    if (!status && !session.scene->sensors.given) {
        status = murk_fail(err, MURK_BAD_VALUE, options->input,
                           "sensors: the scene has none");
    }
    if (!status && session.scene->placement.over != MURK_SCENE_OBJECTIVE_NONE) {
        status = murk_fail(err, MURK_BAD_VALUE, session.scene->placement.where,
                           "over: sense measures one scene; must be null, or "
                           "give it a scene-NAME.yaml of place");
    }
    if (!status) {
        status = murk_exports_begin(&session, err);
    }
    const bool is_dark =
        !status && murk_stage_has_nothing_to_see(session.stage);
    if (!status) { /* a plan made in the dark may have no sensor */
        status = murk_placement_read(&sensor, &n, options->sensors,
                                     is_dark ? 0 : 1, session.scene,
                                     &session.stage->world.domain, err);
    }
    if (!status) {
        static const char *const names[] = {"coverage.json", "coverage.csv",
                                            "coverage.ply", NULL};
        status = murk_session_expect(&session, names, err);
        status = status ? status : murk_session_expect_light(&session, err);
    }
    if (!status) {
        status = murk_session_light(&session, err);
    }
    const double begun_s = murk_clock_s();
    if (!status) {
        status = measure(&of, &session, sensor, n, &late, err);
    }
    session.run.sense_s = murk_clock_s() - begun_s;
    const murk_sense_results results = {
        &session,
        {session.scene, sensor, n, &of.coverage, NULL},
        &of.targets,
        &of.robust};
    if (!status) {
        status = write_coverage(&session, &results, err);
    }
    if (!status) {
        murk_print_run(&session, NULL, 0);
    }
    if (!status) { /* the coverage is written, what is told late is not */
        status = murk_fail(err, late.code, late.where, "%s", late.text);
    }
    murk_measured_release(&of);
    free(sensor);
    murk_session_end(&session);
    return status;
}
