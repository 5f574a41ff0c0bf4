/* Pictures: a camera of the scene renders the world of a light, from the photon
 * maps or by path tracing (render/render.h). */
#include "api/save.h"

#include "api/scene_picture.h"
#include "base/file.h"
#include "base/machine.h"
#include "render/exr.h"
#include "results/ownership.h"
#include "results/version.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct murk_picture {
    murk_light *light;
    const murk_scene_camera *camera;
    murk_image *image;
};

/* Sets *out to the camera of that name; name NULL: to the first camera. Fails
 * with MURK_BAD_VALUE if there is none. */
static murk_status find_camera(const murk_scene_camera **out,
                               const murk_scene_desc *scene, const char *name,
                               murk_error *err)
{
    for (size_t i = 0; i < scene->n_cameras; ++i) {
        if (!name || strcmp(scene->cameras[i].name, name) == 0) {
            *out = &scene->cameras[i];
            return MURK_OK;
        }
    }
    return murk_fail(err, MURK_BAD_VALUE, scene->path,
                     "cameras: the scene has no camera%s%s", name ? " " : "",
                     name ? name : "");
}

static murk_status check(const murk_scene_desc *scene,
                         const murk_scene_camera *camera,
                         murk_render_method method, murk_error *err)
{
    const size_t width = camera->pixels[0], height = camera->pixels[1];
    const double bytes = murk_render_bytes(width, height, scene->bands, method),
                 spare = murk_machine_memory_bytes();
    if (method != MURK_BY_PATHS &&
        scene->photons.maps != MURK_SCENE_MAPS_BOTH) {
        return murk_fail(err, MURK_BAD_VALUE, "photons.maps",
                         "must be both to render from the maps");
    }
    return bytes <= spare
               ? MURK_OK
               : murk_no_memory(err, camera->where,
                                "for a picture of %zu x %zu pixels: it takes "
                                "%.3g GB, and %.3g GB are free",
                                width, height, bytes * 1e-9, spare * 1e-9);
}

static murk_status render(murk_picture *picture, murk_render_method method,
                          murk_error *err)
{
    const murk_session *session = &picture->light->session;
    const murk_trace trace = murk_stage_trace(session->stage);
    static const size_t own[2] = {0, 0}; /* the camera's own pixels */
    murk_render input = murk_render_of_stage(
        session->stage, &trace,
        murk_camera_of_scene(picture->camera, session->scene, own),
        session->traced, session->settings.threads);
    input.samples = picture->camera->samples;
    input.method = method;
    return murk_render_run(&picture->image, &input, err);
}

murk_status murk_picture_render(murk_picture **out, murk_light *light,
                                const char *camera, murk_method method,
                                murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    static const murk_render_method methods[] = {
        [MURK_METHOD_MAPS] = MURK_BY_MAPS,
        [MURK_METHOD_PATHS] = MURK_BY_PATHS,
        [MURK_METHOD_MAPS_ONLY] = MURK_BY_MAPS_ONLY};
    if (!out || !light ||
        (unsigned)method >= sizeof methods / sizeof *methods) {
        return murk_call_refuse(error, "out or light is NULL, or there is no "
                                       "such method");
    }
    /* Find the camera, then render. */
    murk_world *world = light->world;
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_picture *picture = calloc(1, sizeof *picture);
    murk_status status = MURK_NO_MEMORY;
    if (picture) {
        picture->light = light;
        ++light->references;
        status =
            find_camera(&picture->camera, world->desc, camera, &call.failure);
    }
    if (!status) {
        status =
            check(world->desc, picture->camera, methods[method], &call.failure);
    }
    if (!status) {
        status = render(picture, methods[method], &call.failure);
    }
    status = murk_call_end_long(&call, status);
    if (status) {
        murk_picture_destroy(picture);
        return status;
    }
    *out = picture;
    return MURK_OK;
}

void murk_picture_destroy(murk_picture *picture)
{
    if (picture) {
        murk_image_destroy(picture->image);
        murk_light_release(picture->light);
        free(picture);
    }
}

/* ---- channels ---- */

/* A channel with one array for each band, colour or axis. */
typedef struct group {
    const char *name;
    float *const *array;
    int n;
} group;

/* The array of a channel: "NAME.k" is array k of the group NAME, "distance_m"
 * an array without a group. NULL if the picture has no such channel. */
static float *channel_of(const murk_image *p, const char *channel)
{
    const group groups[] = {
        {"radiance", p->radiance, p->bands}, {"error", p->error, p->bands},
        {"surface", p->surface, p->bands},   {"volume", p->volume, p->bands},
        {"depth", p->depth, p->bands},       {"rgb", p->rgb, 3},
        {"rgb_error", p->rgb_error, 3},      {"position_m", p->position, 3}};
    const char *dot = strchr(channel, '.');
    if (!dot) {
        return strcmp(channel, "distance_m") == 0 ? p->distance_m : NULL;
    }
    const size_t length = (size_t)(dot - channel),
                 digits = strspn(dot + 1, "0123456789");
    for (size_t i = 0; i < sizeof groups / sizeof *groups; ++i) {
        const group *g = &groups[i];
        if (strlen(g->name) == length &&
            strncmp(g->name, channel, length) == 0 && digits > 0 &&
            digits < 4 && dot[1 + digits] == '\0' && atoi(dot + 1) < g->n) {
            return g->array[atoi(dot + 1)];
        }
    }
    return NULL;
}

murk_status murk_picture_array(const murk_picture *picture, const char *channel,
                               murk_array *view, murk_error *error)
{
    if (!picture || !channel) {
        return murk_call_refuse(error, "picture or channel is NULL");
    }
    const murk_image *p = picture->image;
    murk_call call =
        murk_call_begin(picture->light->world->context, NULL, error);
    const float *values = channel_of(p, channel);
    const size_t shape[2] = {p->height, p->width};
    return murk_call_end(
        &call, values ? murk_array_fill(view, values, MURK_TYPE_FLOAT32, 2,
                                        shape, false, &call.failure)
                      : murk_fail(&call.failure, MURK_BAD_VALUE, "",
                                  "the picture has no channel %s", channel));
}

murk_status murk_picture_write(const murk_picture *picture, const char *path,
                               murk_error *error)
{
    if (!picture || !path) {
        return murk_call_refuse(error, "picture or path is NULL");
    }
    const murk_scene_desc *scene = picture->light->session.scene;
    const murk_image *p = picture->image;
    const bool is_all_round =
        picture->camera->projection == MURK_SCENE_EQUIRECTANGULAR;
    /* MURK_MARK_IMAGE is the mark by which murk recognises its own images. */
    const murk_image_text header[] = {{MURK_MARK_IMAGE, murk_version_commit()},
                                      {"murkVersion", MURK_VERSION},
                                      {"murkScene", scene->path},
                                      {"murkCamera", picture->camera->name},
                                      {"emissiveUnits", "W.m^-2.sr^-1"}};
    const murk_exr exr = {.picture = p,
                          .band_nm = scene->band_nm,
                          .is_all_round = is_all_round,
                          .pixel_aspect = is_all_round ? 2 * (double)p->height /
                                                             (double)p->width
                                                       : 1,
                          .header = header,
                          .n_header = sizeof header / sizeof *header};
    murk_world *world = picture->light->world;
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_status status =
        murk_file_check_owner(path, MURK_MARK_IMAGE, sizeof MURK_MARK_IMAGE - 1,
                              false, &call.failure);
    if (!status) {
        status = murk_exr_write(&exr, path, &call.failure);
    }
    return murk_call_end(&call, status);
}
