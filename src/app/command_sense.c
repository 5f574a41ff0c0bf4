#include "app/coverage_out.h"
#include "app/placement_in.h"
#include "app/regions_out.h"
#include "app/robust_out.h"
#include "app/session.h"
#include "app/tallies_out.h"

#include <stdlib.h>

static cJSON *coverage_json(const murk_session *session,
                            const murk_pose *sensor, size_t n,
                            const murk_coverage *coverage,
                            const murk_robust *robust)
{
    cJSON *root = murk_json_begin(session->scene);
    murk_json_photons(root, session->traced);
    murk_json_sensors(root, session->scene, sensor, n, coverage);
    cJSON *object = cJSON_AddObjectToObject(root, "coverage");
    murk_json_number(object, "in_sample", coverage->total.value);
    murk_json_number(object, "standard_error", coverage->total.standard_error);
    cJSON_AddNullToObject(object, "held_out");
    cJSON_AddNullToObject(object, "held_out_standard_error");
    cJSON_AddNullToObject(object, "ceiling"); /* no candidates were asked */
    murk_json_number(object, "surface", coverage->surface.value);
    murk_json_number(object, "surface_standard_error",
                     coverage->surface.standard_error);
    murk_json_number(object, "volume", coverage->volume.value);
    murk_json_number(object, "volume_standard_error",
                     coverage->volume.standard_error);
    murk_json_number(object, "sum_of_views", coverage->sum_of_views);
    murk_json_seen(root, coverage, n);
    murk_json_regions(root, session->scene, coverage->region, NULL);
    murk_json_robust(root, session->scene, robust);
    return root;
}

static murk_status write_coverage(murk_session *session,
                                  const murk_pose *sensor, size_t n,
                                  const murk_coverage *coverage,
                                  const murk_robust *robust, murk_error *err)
{
    murk_status status = murk_session_add_light(session, err);
    if (!status) {
        status = murk_session_add_ledger(session, err);
    }
    if (!status) {
        status = murk_add_tallies(session, err);
    }
    if (!status) {
        status = murk_add_coverage_csv(&session->results, session->scene,
                                       sensor, n, coverage, err);
    }
    if (!status) {
        status = murk_session_finish(
            session, "coverage.json",
            coverage_json(session, sensor, n, coverage, robust), err);
    }
    return status;
}

static void print_coverage(const murk_session *session, const murk_pose *sensor,
                           size_t n, const murk_coverage *coverage,
                           const murk_robust *robust)
{
    murk_print_light(session);
    murk_print_tallies(session);
    murk_print_sensors(session->scene, sensor, n, coverage);
    printf("coverage    %.4f +- %.4f (one standard error, by emitted photon; ",
           coverage->total.value, coverage->total.standard_error);
    murk_print_maps(coverage);
    printf(")\n");
    murk_print_regions(session->scene, coverage->region, NULL);
    murk_print_robust(session->scene, robust);
    printf("time        %.2f s: load %.2f, trace %.2f, maps %.2f, sense "
           "%.2f\n",
           session->run.total_s, session->run.load_s, session->run.trace_s,
           session->run.map_s, session->run.sense_s);
    murk_print_files(session);
}

murk_status murk_command_sense(const murk_options *options, murk_error *err)
{
    murk_session session;
    murk_sight *sight = NULL;
    murk_coverage coverage = {0};
    murk_robust robust = {0};
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
    if (!status) {
        status =
            murk_placement_read(&sensor, &n, options->sensors, session.scene,
                                &session.stage->world.domain, err);
    }
    if (!status) {
        status = murk_session_light(&session, err);
    }
    const double begun_s = murk_clock_s();
    if (!status) {
        status = murk_plan_sight(&sight, session.stage, session.traced,
                                 options->threads, err);
    }
    if (!status) {
        status = murk_coverage_measure(&coverage, sight, sensor, n, err);
    }
    if (!status) {
        status = murk_robust_begin(&robust, session.stage, sensor, n, &coverage,
                                   err);
    }
    if (!status) {
        status = murk_robust_jitter(&robust, session.stage, sight, sensor,
                                    &coverage, false, err);
    }
    session.run.sense_s = murk_clock_s() - begun_s;
    if (!status) {
        status = write_coverage(&session, sensor, n, &coverage, &robust, err);
    }
    if (!status && murk_session_speaks(&session)) {
        print_coverage(&session, sensor, n, &coverage, &robust);
    }
    murk_robust_release(&robust);
    murk_coverage_release(&coverage);
    murk_sight_destroy(sight);
    free(sensor);
    murk_session_end(&session);
    return status;
}
