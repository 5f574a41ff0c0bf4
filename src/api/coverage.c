/* Coverage: the part of a light that given sensors see, and the rows of these
 * sensors in the coverage matrix. */
#include "api/save.h"

#include "base/progress.h"
#include "results/exports.h"
#include "results/geo.h"
#include "results/plan_ply.h"
#include "results/sense.h"
#include "results/tallies.h"

#include <stdlib.h>
#include <string.h>

static murk_status measure(murk_coverage *coverage, murk_error *err)
{
    const murk_world *world = coverage->light->world;
    const double begun_s = murk_clock_s();
    const murk_status status =
        murk_measured_make(&coverage->measured, &coverage->sight, world->stage,
                           coverage->light->session.traced, coverage->pose,
                           coverage->n, world->context->threads, err);
    coverage->sense_s = murk_clock_s() - begun_s;
    return status;
}

/* Copies the sensors, then measures. */
static murk_status coverage_make(murk_coverage **out, murk_light *light,
                                 const murk_pose *sensor, size_t n,
                                 murk_error *error)
{
    murk_world *world = light->world;
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_coverage *coverage = calloc(1, sizeof *coverage);
    murk_pose *pose = calloc(n + 1, sizeof *pose);
    murk_status status = MURK_NO_MEMORY;
    /* The coverage has a reference to the light. */
    if (coverage && pose) {
        coverage->light = light;
        ++light->references;
        coverage->pose = pose;
        coverage->n = n;
        memcpy(pose, sensor, n * sizeof *pose);
        status = measure(coverage, &call.failure);
    } else {
        free(coverage);
        free(pose);
        coverage = NULL;
    }
    status = murk_call_end_long(&call, status);
    if (status) {
        murk_coverage_destroy(coverage);
        return status;
    }
    *out = coverage;
    return MURK_OK;
}

murk_status murk_coverage_measure(murk_coverage **out, murk_light *light,
                                  const murk_sensors *sensors,
                                  murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !light || !sensors) {
        return murk_call_refuse(error, "out, light or sensors is NULL");
    }
    if (sensors->world != light->world) {
        return murk_call_refuse(
            error, "the sensors are of another world than the light");
    }
    if (sensors->n == 0 &&
        !murk_stage_has_nothing_to_see(light->world->stage)) {
        return murk_call_refuse(error, "there are no sensors");
    }
    return coverage_make(out, light, sensors->pose, sensors->n, error);
}

murk_status murk_coverage_update(murk_coverage **out, murk_coverage *coverage,
                                 murk_light *light, murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !coverage || !light) {
        return murk_call_refuse(error, "out, coverage or light is NULL");
    }
    /* The types of the sensors must be there, and their places. */
    const murk_world *world = light->world;
    if (!murk_worlds_share_origin(world, coverage->light->world)) {
        return murk_call_refuse(error, MURK_OTHER_ORIGIN);
    }
    if (!murk_world_has_poses(world, coverage->pose, coverage->n)) {
        return murk_call_refuse(error, MURK_OTHER_SENSORS);
    }
    return coverage_make(out, light, coverage->pose, coverage->n, error);
}

void murk_coverage_destroy(murk_coverage *coverage)
{
    if (coverage) {
        murk_fields_release(&coverage->fields);
        murk_fields_release(&coverage->saved);
        murk_sight_destroy(coverage->sight);
        murk_measured_release(&coverage->measured);
        free(coverage->matrix);
        free(coverage->pose);
        murk_light_release(coverage->light);
        free(coverage);
    }
}

/* The results of a coverage in the form of results/sense.h. `session` must have
 * the scene and the light of the coverage. */
static murk_sense_results results_of(const murk_coverage *coverage,
                                     const murk_session *session)
{
    return (murk_sense_results){session,
                                {session->scene, coverage->pose, coverage->n,
                                 &coverage->measured.coverage, NULL},
                                &coverage->measured.targets,
                                &coverage->measured.robust};
}

murk_status murk_coverage_fields(murk_coverage *coverage,
                                 const murk_fields **fields, murk_error *error)
{
    if (!coverage || !fields) {
        return murk_call_refuse(error, "coverage or fields is NULL");
    }
    const murk_sense_results results =
        results_of(coverage, &coverage->light->session);
    murk_call call =
        murk_call_begin(coverage->light->world->context, NULL, error);
    *fields = &coverage->fields;
    return murk_call_end(&call, murk_fields_make(&coverage->fields,
                                                 murk_results_list_sense,
                                                 &results, &call.failure));
}

/* ---- files ---- */

/* A murk_save_work (api/save.h): adds coverage.ply (results/plan_ply.h; only if
 * there is something to see and a folder), the exports, the files of the light,
 * coverage.csv, and last coverage.json. */
static murk_status save(void *of, murk_session *session,
                        const murk_save_options *options, murk_error *late,
                        murk_error *err)
{
    murk_coverage *coverage = of;
    session->run.sense_s = coverage->sense_s;
    const murk_sense_results results = results_of(coverage, session);
    murk_sight *sight = coverage->sight;
    const size_t n = coverage->n;
    /* Judge the folder and the options. */
    murk_status status = murk_save_check(session, "sense", 0, err);
    if (!status) {
        status = murk_save_identify(session, "sense", options, "", err);
    }
    /* Add the files; coverage.json comes last. */
    if (!status && sight && session->results.folder) {
        status =
            murk_add_plan_ply(&session->results, "coverage.ply", session->stage,
                              sight, coverage->pose, n, err);
    }
    if (!status) {
        murk_exports_add_scene(session, sight, coverage->pose, sight ? n : 0,
                               late);
        status = murk_session_add_all_of_light(session, err);
    }
    if (!status) {
        status = murk_results_add_csv(&session->results, "coverage.csv",
                                      murk_results_list_sensor,
                                      &results.sensors, n, err);
    }
    if (!status) {
        status = murk_geo_add(session, &results.sensors, err);
    }
    return status ? status
                  : murk_session_finish(
                        session, "coverage.json",
                        murk_results_json(murk_results_list_sense, &results),
                        murk_print_sense, &results, err);
}

murk_status murk_coverage_save(murk_coverage *coverage, const char *folder,
                               const murk_save_options *options,
                               const murk_fields **fields, murk_error *error)
{
    if (!coverage) {
        return murk_save_refuse(fields, error, "coverage is NULL");
    }
    murk_light *light = coverage->light;
    murk_call call =
        murk_call_begin(light->world->context, &light->world->files, error);
    return murk_save_results(&call, &light->session, &coverage->saved, folder,
                             options, fields, save, coverage);
}

/* ---- the matrix ---- */

/* Makes the matrix with a dense row for each sensor. If there is nothing to
 * see, all entries are 0. */
static murk_status make_matrix(murk_coverage *coverage, murk_error *err)
{
    const murk_traced *traced = coverage->light->session.traced;
    murk_sight *sight = coverage->sight;
    coverage->records = sight ? murk_sight_photons(sight)
                              : murk_photon_map_count(traced->surface) +
                                    murk_photon_map_count(traced->volume);
    /* A row of zeros for each sensor; then the clarity (murk.h) of each record
     * that the sensor sees. */
    coverage->matrix =
        calloc(coverage->n * coverage->records + 1, sizeof *coverage->matrix);
    for (size_t k = 0; sight && coverage->matrix && k < coverage->n; ++k) {
        uint16_t *row = coverage->matrix + k * coverage->records;
        murk_sparse_row seen;
        murk_sight_row(sight, 0, &coverage->pose[k], &seen);
        for (size_t i = 0; i < seen.seen; ++i) {
            row[seen.photon[i]] = seen.clarity ? seen.clarity[i] : MURK_CLEAR;
        }
    }
    return coverage->matrix ? MURK_OK
                            : murk_no_memory(err, "", "for the matrix");
}

murk_status murk_coverage_matrix(murk_coverage *coverage, murk_array *view,
                                 murk_error *error)
{
    if (!coverage) {
        return murk_call_refuse(error, "coverage is NULL");
    }
    murk_world *world = coverage->light->world;
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_status status =
        coverage->matrix ? MURK_OK : make_matrix(coverage, &call.failure);
    if (!status) {
        const size_t shape[2] = {coverage->n, coverage->records};
        status = murk_array_fill(view, coverage->matrix, MURK_TYPE_UINT16, 2,
                                 shape, false, &call.failure);
    }
    return murk_call_end(&call, status);
}
