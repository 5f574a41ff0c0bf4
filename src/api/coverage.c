/* Coverage of given sensors on a light, and their rows of the coverage
 * matrix. */
#include "api/light.h"

#include "results/sense.h"

#include <stdlib.h>
#include <string.h>

static murk_status measure(murk_coverage *coverage, murk_error *err)
{
    murk_sight *sight = NULL;
    const murk_world *world = coverage->light->world;
    const murk_status status =
        murk_measured_make(&coverage->measured, &sight, world->stage,
                           coverage->light->session.traced, coverage->pose,
                           coverage->n, world->context->threads, err);
    murk_sight_destroy(sight);
    return status;
}

murk_status murk_coverage_measure(murk_coverage **out, murk_light *light,
                                  const murk_sensors *sensors,
                                  murk_error *error)
{
    if (!out || !light || !sensors || sensors->world != light->world ||
        sensors->n == 0) {
        return murk_call_refuse(error, "out, light or sensors is NULL, there "
                                       "are no sensors, or they are of another "
                                       "world than the light");
    }
    /* Copy the sensors, then measure. */
    *out = NULL;
    murk_world *world = light->world;
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_coverage *coverage = calloc(1, sizeof *coverage);
    murk_pose *pose = calloc(sensors->n, sizeof *pose);
    murk_status status = MURK_NO_MEMORY;
    if (coverage && pose) {
        coverage->light = light;
        ++light->references;
        coverage->pose = pose;
        coverage->n = sensors->n;
        memcpy(pose, sensors->pose, sensors->n * sizeof *pose);
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

void murk_coverage_destroy(murk_coverage *coverage)
{
    if (coverage) {
        murk_fields_release(&coverage->fields);
        murk_measured_release(&coverage->measured);
        free(coverage->matrix);
        free(coverage->pose);
        murk_light_release(coverage->light);
        free(coverage);
    }
}

murk_status murk_coverage_fields(murk_coverage *coverage,
                                 const murk_fields **fields, murk_error *error)
{
    if (!coverage || !fields) {
        return murk_call_refuse(error, "coverage or fields is NULL");
    }
    const murk_session *session = &coverage->light->session;
    const murk_sense_results results = {session,
                                        {session->scene, coverage->pose,
                                         coverage->n,
                                         &coverage->measured.coverage, NULL},
                                        &coverage->measured.targets,
                                        &coverage->measured.robust};
    murk_call call =
        murk_call_begin(coverage->light->world->context, NULL, error);
    *fields = &coverage->fields;
    return murk_call_end(&call, murk_fields_make(&coverage->fields,
                                                 murk_results_list_sense,
                                                 &results, &call.failure));
}

/* Looks again, and writes each row densely. */
static murk_status make_matrix(murk_coverage *coverage, murk_error *err)
{
    const murk_world *world = coverage->light->world;
    murk_sight *sight = NULL;
    murk_status status =
        murk_plan_sight(&sight, world->stage, coverage->light->session.traced,
                        world->context->threads, err);
    if (status) {
        return status;
    }
    /* A row of zeros for each sensor, and the clarity of each photon seen. */
    coverage->records = murk_sight_photons(sight);
    coverage->matrix =
        calloc(coverage->n * coverage->records + 1, sizeof *coverage->matrix);
    for (size_t k = 0; coverage->matrix && k < coverage->n; ++k) {
        uint16_t *row = coverage->matrix + k * coverage->records;
        murk_sparse_row seen;
        murk_sight_row(sight, 0, &coverage->pose[k], &seen);
        for (size_t i = 0; i < seen.seen; ++i) {
            row[seen.photon[i]] = seen.clarity[i];
        }
    }
    murk_sight_destroy(sight);
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
