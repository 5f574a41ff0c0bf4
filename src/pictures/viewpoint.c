/* The camera of a picture: a camera of the scene or the view of a sensor, its
 * place and direction, and doubts about the place. */
#include "pictures/viewpoint.h"

#include "base/log.h"
#include "base/position.h"
#include "base/words.h"
#include "pictures/scene_picture.h"
#include "plan/free_space.h"
#include "render/render.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Degrees in a radian. */
#define DEG_PER_RAD (180 / MURK_PI)

/* Width [pixels] and samples of a picture of a sensor, if neither the request
 * nor a camera gives them. */
#define WIDTH   640
#define SAMPLES 16

/* ---- the camera that is named ---- */

static murk_status no_such_camera(const murk_scene_desc *scene,
                                  const char *wanted, murk_error *err)
{
    char shown[64];
    murk_words_show(shown, sizeof shown, wanted);
    const char **known = calloc(scene->n_cameras, sizeof *known);
    for (size_t i = 0; known && i < scene->n_cameras; ++i) {
        known[i] = scene->cameras[i].name;
    }
    const char *meant =
        known ? murk_words_meant(wanted, known, scene->n_cameras) : NULL;
    const murk_status status = murk_fail(
        err, MURK_BAD_VALUE, "camera", "%s is no camera of the scene, %s %s%s",
        shown, meant ? "did you mean" : "the first of them is",
        meant ? meant : scene->cameras[0].name, meant ? "?" : "");
    free(known);
    return status;
}

murk_status murk_viewpoint_choose(murk_viewpoint *out,
                                  const murk_scene_desc *scene,
                                  const murk_viewpoint_request *request,
                                  murk_error *err)
{
    const char *wanted = request->camera;
    if (request->from_sensor > 0 && !wanted) {
        return MURK_OK;
    }
    if (scene->n_cameras == 0) {
        return murk_fail(err, MURK_BAD_VALUE, scene->path,
                         "cameras: the scene has none, must have one to be "
                         "rendered: {name, from_m, to_m}; or sensors and "
                         "from_sensor");
    }
    /* The camera of that name, or the first one. */
    for (size_t i = 0; i < scene->n_cameras && !out->named; ++i) {
        const murk_scene_camera *camera = &scene->cameras[i];
        if (!wanted || strcmp(camera->name, wanted) == 0) {
            out->named = camera;
        }
    }
    return out->named ? MURK_OK : no_such_camera(scene, wanted, err);
}

/* ---- the place ---- */

static void stand_at_camera(murk_viewpoint *v, const murk_scene_desc *scene,
                            const size_t asked[2])
{
    const murk_scene_camera *c = v->named;
    snprintf(v->name, sizeof v->name, "%s", c->name);
    v->where = c->where;
    v->camera = murk_camera_of_scene(c, scene, asked);
}

/* The number of rows with which the pixels are square, for a picture that is
 * `wider` times as wide as high. */
static size_t rows_for(size_t width, double wider)
{
    const double rows = round((double)width / wider);
    return (size_t)fmax(1, fmin(rows, fmin(MURK_PICTURE_SIDE_MAX,
                                           (double)(MURK_PIXELS_MAX / width))));
}

static void stand_at_sensor(murk_viewpoint *v, const murk_scene_desc *scene,
                            const murk_pose *pose, uint64_t number,
                            const size_t asked[2])
{
    const murk_scene_sensor_type *type = &scene->sensors.type[pose->type];
    const murk_sensor_frame frame = murk_pose_frame(pose, scene->north);
    size_t width = asked[0], height = asked[1];
    if (!width) {
        width = v->named ? v->named->pixels[0] : WIDTH;
        height = rows_for(width, type->view == MURK_VIEW_FRUSTUM
                                     ? tan(type->hfov_rad / 2) /
                                           tan(type->vfov_rad / 2)
                                     : 2);
    }
    snprintf(v->name, sizeof v->name, "sensor %llu (%s)",
             (unsigned long long)number, type->name);
    v->where = "from_sensor";
    if (type->view == MURK_VIEW_FRUSTUM) {
        v->camera =
            murk_camera_view(pose->position, frame.axis, frame.right,
                             type->hfov_rad, type->vfov_rad, width, height);
        return;
    }
    murk_pose level = *pose; /* looking straight up, it has a heading still */
    level.tilt_rad = 0;
    v->camera = murk_camera_around(pose->position,
                                   murk_pose_frame(&level, scene->north).axis,
                                   width, height);
}

static void tell_direction(murk_viewpoint *v, murk_vec3 north)
{
    const murk_vec3 east = murk_cross(north, murk_vec(0, 0, 1));
    const murk_vec3 ahead = v->camera.forward;
    const double heading =
        DEG_PER_RAD * atan2(murk_dot(ahead, east), murk_dot(ahead, north));
    v->heading_deg = heading < 0 ? heading + 360 : heading;
    v->tilt_deg = DEG_PER_RAD * asin(fmax(-1, fmin(1, ahead.z)));
}

/* Fails if the list has no sensor of the number from_sensor. */
static murk_status check_number(const murk_viewpoint_request *request,
                                murk_error *err)
{
    const unsigned long long number = request->from_sensor;
    const char *file = request->sensors_file;
    if (number <= request->sensors) {
        return MURK_OK;
    }
    if (request->sensors == 0) {
        return murk_fail(err, MURK_BAD_VALUE, "from_sensor",
                         "%llu, must be 0 without sensors", number);
    }
    return murk_fail(err, MURK_BAD_VALUE, "from_sensor",
                     "%llu, must be 1..%zu: %s has no more sensors", number,
                     request->sensors, file ? file : "the list");
}

murk_status murk_viewpoint_stand(murk_viewpoint *v, const murk_stage *stage,
                                 const murk_viewpoint_request *request,
                                 murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    const murk_box *box = &stage->world.domain.box;
    const murk_status status = check_number(request, err);
    if (status) {
        return status;
    }
    v->sensor = request->sensor;
    v->sensors = request->sensors;
    /* Samples and camera. */
    v->samples = request->samples ? (size_t)request->samples
                 : v->named       ? v->named->samples
                                  : SAMPLES;
    if (request->from_sensor > 0) {
        stand_at_sensor(v, scene, &v->sensor[request->from_sensor - 1],
                        request->from_sensor, request->pixels);
    } else {
        stand_at_camera(v, scene, request->pixels);
    }
    /* The direction for the user, and the check of the place. */
    tell_direction(v, scene->north);
    /* Orthographic rays may come from outside of the domain. */
    const murk_vec3 p = v->camera.from;
    if (v->camera.projection != MURK_ORTHOGRAPHIC &&
        !murk_box_contains(box, p)) {
        return murk_fail(err, MURK_BAD_VALUE, v->where,
                         "from_m is %s m, must be within the domain, %s..%s m",
                         murk_position_show(p).text,
                         murk_position_show(box->min).text,
                         murk_position_show(box->max).text);
    }
    return MURK_OK;
}

/* ---- doubts about the place ---- */

murk_status murk_viewpoint_judge(const murk_viewpoint *v,
                                 const murk_stage *stage, unsigned threads,
                                 murk_error *err)
{
    const murk_vec3 p = v->camera.from;
    if (v->camera.projection == MURK_ORTHOGRAPHIC || v->camera.clip.is_set) {
        return MURK_OK; /* its rays begin elsewhere */
    }
    if (murk_surfaces_solid_at(stage->surfaces, p) > 0) {
        murk_warn(v->where,
                  "%s stands at %s m inside a solid of transmitting material",
                  v->name, murk_position_show(p).text);
        return MURK_OK;
    }
    if (murk_stage_is_dark(stage)) { /* nothing leads to a light */
        return MURK_OK;
    }
    murk_open_space *space = NULL;
    const murk_status status =
        murk_stage_free_space(&space, stage, threads, err);
    if (!status) {
        murk_warn_unless_open(space, v->where, v->name, p);
    }
    murk_open_space_destroy(space);
    return status;
}
