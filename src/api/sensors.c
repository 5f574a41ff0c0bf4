/* Lists of sensors of a world: from a file, from a plan, or one by one. Those
 * from a file or one by one are checked against the sensor types and the domain
 * of the scene. */
#include "api/handles.h"

#include "plan/placement_in.h"
#include "results/coverage.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static murk_sensors *make(murk_world *world)
{
    murk_sensors *sensors = calloc(1, sizeof *sensors);
    if (sensors) {
        sensors->world = world;
        ++world->references;
    }
    return sensors;
}

murk_status murk_sensors_create(murk_sensors **out, murk_world *world,
                                murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !world) {
        return murk_call_refuse(error, "out or world is NULL");
    }
    murk_call call = murk_call_begin(world->context, NULL, error);
    *out = make(world);
    return murk_call_end(&call, *out ? MURK_OK : MURK_NO_MEMORY);
}

static murk_status read_file(murk_sensors *sensors, const char *path,
                             murk_error *err)
{
    murk_world *world = sensors->world;
    if (!world->desc->sensors.given) {
        return murk_fail(err, MURK_BAD_VALUE, world->desc->path,
                         "sensors: the scene has none");
    }
    const murk_status status = murk_world_build(world, err);
    if (status) {
        return status;
    }
    /* A plan that was made in the dark may have no sensor. */
    const size_t minimum = murk_stage_has_nothing_to_see(world->stage) ? 0 : 1;
    return murk_placement_read(&sensors->pose, &sensors->n, path, minimum,
                               world->desc, &world->stage->world.domain, err);
}

murk_status murk_sensors_read(murk_sensors **out, murk_world *world,
                              const char *path, murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !world || !path) {
        return murk_call_refuse(error, "out, world or path is NULL");
    }
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_sensors *sensors = make(world);
    murk_status status = MURK_NO_MEMORY;
    if (sensors) {
        sensors->path = strdup(path);
        status = sensors->path ? read_file(sensors, path, &call.failure)
                               : MURK_NO_MEMORY;
    }
    status = murk_call_end(&call, status);
    if (status) {
        murk_sensors_destroy(sensors);
        return status;
    }
    *out = sensors;
    return MURK_OK;
}

murk_status murk_plan_sensors(murk_sensors **out, const murk_plan *plan,
                              murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !plan) {
        return murk_call_refuse(error, "out or plan is NULL");
    }
    if (!plan->world) {
        return murk_call_refuse(error,
                                "the plan is for a matrix, whose columns "
                                "are no sensors of a world");
    }
    /* A list with a copy of the poses. */
    murk_call call = murk_call_begin(plan->world->context, NULL, error);
    murk_sensors *sensors = make(plan->world);
    const size_t n = plan->plan.place.count;
    murk_pose *pose = calloc(n + 1, sizeof *pose);
    if (sensors && pose) {
        memcpy(pose, plan->plan.sensor, n * sizeof *pose);
        sensors->pose = pose;
        sensors->n = n;
    } else {
        murk_sensors_destroy(sensors);
        sensors = NULL;
        free(pose);
    }
    *out = sensors;
    return murk_call_end(&call, sensors ? MURK_OK : MURK_NO_MEMORY);
}

void murk_sensors_destroy(murk_sensors *sensors)
{
    if (sensors) {
        free(sensors->path);
        free(sensors->pose);
        murk_world_release(sensors->world);
        free(sensors);
    }
}

/* Sets *out to the pose that a sensor describes. Fails with MURK_BAD_VALUE if
 * the scene has no such type, if a type with a view has no direction, or if the
 * position is outside of the domain. */
static murk_status pose_of(murk_pose *out, const murk_world *world,
                           const murk_sensor *sensor, murk_error *err)
{
    const murk_scene_sensors *all = &world->desc->sensors;
    size_t type = 0;
    while (type < all->types && sensor->type &&
           strcmp(all->type[type].name, sensor->type) != 0) {
        ++type;
    }
    if (type == all->types || !sensor->type) {
        return murk_call_bad_argument(
            err, "sensor", "type %s is not a sensor type of the scene",
            sensor->type ? sensor->type : "NULL");
    }
    /* A type with a view needs a direction. */
    const bool is_sphere = all->type[type].view == MURK_VIEW_SPHERE;
    if (!is_sphere &&
        !(isfinite(sensor->heading_deg) && fabs(sensor->tilt_deg) <= 90)) {
        return murk_call_bad_argument(
            err, "sensor",
            "heading_deg is %g and tilt_deg %g, must be finite, "
            "tilt -90..90, for a type with a view such as %s",
            sensor->heading_deg, sensor->tilt_deg, sensor->type);
    }
    const double *p = sensor->position_m;
    *out = (murk_pose){
        .type = (uint32_t)type,
        .position = murk_scene_local(world->desc, murk_vec(p[0], p[1], p[2]))};
    if (!is_sphere) {
        out->heading_rad = sensor->heading_deg * MURK_PI / 180;
        out->tilt_rad = sensor->tilt_deg * MURK_PI / 180;
    }
    return murk_box_contains(&world->stage->world.domain.box, out->position)
               ? MURK_OK
               : murk_call_bad_argument(
                     err, "sensor",
                     "position_m [%g, %g, %g] is outside of the domain", p[0],
                     p[1], p[2]);
}

static murk_status add(murk_sensors *sensors, const murk_sensor *given,
                       murk_error *err)
{
    murk_pose pose;
    murk_sensor sensor = {0};
    murk_status status = murk_options_copy(&sensor, sizeof sensor, given,
                                           "sensor", "murk_sensor", err);
    if (!status) {
        status = murk_world_build(sensors->world, err);
    }
    if (!status) {
        status = pose_of(&pose, sensors->world, &sensor, err);
    }
    if (status) {
        return status;
    }
    murk_pose *grown = realloc(sensors->pose, (sensors->n + 1) * sizeof *grown);
    if (!grown) {
        return murk_no_memory(err, "", "for a sensor");
    }
    sensors->pose = grown;
    sensors->pose[sensors->n++] = pose;
    return MURK_OK;
}

murk_status murk_sensors_add(murk_sensors *sensors, const murk_sensor *sensor,
                             murk_error *error)
{
    if (!sensors || !sensor) {
        return murk_call_refuse(error, "sensors or sensor is NULL");
    }
    murk_call call = murk_call_begin(sensors->world->context, NULL, error);
    return murk_call_end(&call, add(sensors, sensor, &call.failure));
}

size_t murk_sensors_count(const murk_sensors *sensors)
{
    return sensors ? sensors->n : 0;
}

murk_status murk_sensors_get(const murk_sensors *sensors, size_t i,
                             murk_sensor *sensor, murk_error *error)
{
    if (!sensors || !sensor || i >= sensors->n) {
        return murk_call_refuse(error, "sensors or sensor is NULL, or there is "
                                       "no sensor of that number");
    }
    /* The struct of the caller, then its members. */
    murk_error failure = {0};
    const murk_status status = murk_struct_check(
        sensor, sizeof *sensor, SIZE_MAX, "sensor", "murk_sensor", &failure);
    if (status) {
        murk_call_report(error, &failure);
        return status;
    }
    const murk_scene_desc *scene = sensors->world->desc;
    const murk_pose *pose = &sensors->pose[i];
    const murk_vec3 at = murk_scene_user(scene, pose->position);
    const bool is_sphere =
        scene->sensors.type[pose->type].view == MURK_VIEW_SPHERE;
    *sensor = (murk_sensor){
        .size = sensor->size,
        .type = scene->sensors.type[pose->type].name,
        .position_m = {at.x, at.y, at.z},
        .heading_deg = is_sphere ? NAN : murk_degrees(pose->heading_rad),
        .tilt_deg = is_sphere ? NAN : murk_degrees(pose->tilt_rad)};
    return MURK_OK;
}
