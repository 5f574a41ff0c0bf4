/* Pictures: a camera of the scene or the view of a sensor, rendered from the
 * light of a world, as channels and as image files with their results. */
#include "api/picture_options.h"
#include "api/save.h"

#include "base/ranks.h"
#include "pictures/results.h"

#include <stdlib.h>
#include <string.h>

struct murk_picture {
    murk_world *world;
    murk_light *light; /* NULL: the method uses none */
    murk_rendering rendering;
    murk_fields saved;
};

/* ---- rendering ---- */

/* Builds the world unless it is built, and sets the viewpoint of a rendering
 * whose camera is chosen. */
static murk_status stand(murk_rendering *rendering, murk_world *world,
                         const murk_viewpoint_request *request, murk_error *err)
{
    const murk_status status = murk_world_build(world, err);
    return status ? status
                  : murk_viewpoint_stand(&rendering->viewpoint, world->stage,
                                         request, err);
}

/* Renders the picture and keeps the light, unless the method uses none. */
static murk_status render(murk_picture *picture, murk_light *light,
                          const murk_picture_options *options, murk_error *err)
{
    murk_world *world = picture->world;
    murk_rendering *rendering = &picture->rendering;
    const murk_rendering_method *method = NULL;
    murk_viewpoint_request request;
    murk_status status =
        murk_picture_options_read(&request, &method, world, options, err);
    if (!status && method->kind != MURK_BY_PATHS) {
        picture->light = light;
        if (!light) {
            return murk_call_bad_argument(
                err, "light", "is NULL, must be a light for the method %s",
                method->name);
        }
        ++light->references;
    }
    if (!status) {
        status = murk_rendering_choose(rendering, method, world->desc, &request,
                                       err);
    }
    if (!status) {
        status = stand(rendering, world, &request, err);
    }
    /* Memory, then the picture. */
    const murk_traced *traced =
        picture->light ? picture->light->session.traced : NULL;
    if (!status) {
        status = murk_rendering_check_memory(rendering, world->desc, NULL,
                                             traced, err);
    }
    if (!status) {
        status = murk_rendering_run(rendering, world->stage, traced,
                                    world->context->threads, err);
    }
    rendering->viewpoint.sensor = NULL; /* of the list of the caller */
    return status;
}

murk_status murk_picture_render(murk_picture **out, murk_world *world,
                                murk_light *light,
                                const murk_picture_options *options,
                                murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    /* The arguments; then the picture, which keeps world and light. */
    if (!out || !world) {
        return murk_call_refuse(error, "out or world is NULL");
    }
    if (light && light->world != world) {
        return murk_call_refuse(error, "the light is of another world");
    }
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_picture *picture = calloc(1, sizeof *picture);
    murk_status status = MURK_NO_MEMORY;
    if (picture) {
        picture->world = world;
        ++world->references;
        status = render(picture, light, options, &call.failure);
    }
    status = murk_call_end_long(&call, status);
    if (status) {
        murk_picture_destroy(picture);
        picture = NULL;
    }
    *out = picture;
    return status;
}

void murk_picture_destroy(murk_picture *picture)
{
    if (picture) {
        murk_fields_release(&picture->saved);
        murk_rendering_release(&picture->rendering);
        murk_light_release(picture->light);
        murk_world_release(picture->world);
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
    const struct {
        const char *name;
        float *array;
    } alone[] = {{"distance_m", p->distance_m},
                 {"coverage.count", p->seen_by},
                 {"coverage.clarity", p->clarity}};
    for (size_t i = 0; i < sizeof alone / sizeof *alone; ++i) {
        if (strcmp(alone[i].name, channel) == 0) {
            return alone[i].array;
        }
    }
    /* The name before the dot, and the number behind it. */
    const char *dot = strchr(channel, '.');
    if (!dot) {
        return NULL;
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
    const murk_image *p = picture->rendering.image;
    murk_call call = murk_call_begin(picture->world->context, NULL, error);
    const float *values = channel_of(p, channel);
    const size_t shape[2] = {p->height, p->width};
    return murk_call_end(
        &call, values ? murk_array_fill(view, values, MURK_TYPE_FLOAT32, 2,
                                        shape, false, &call.failure)
                      : murk_fail(&call.failure, MURK_BAD_VALUE, "",
                                  "the picture has no channel %s", channel));
}

/* ---- files ---- */

/* The session of the light, or of the world if the picture is without light. */
static murk_session session_of(const murk_picture *picture)
{
    return picture->light ? picture->light->session
                          : murk_world_session(picture->world);
}

/* The files of a picture that are asked for. */
typedef struct wanted {
    const murk_picture *picture;
    const char *path;
    const murk_image_options *images;
    cJSON *summary; /* the lines, once the files are written */
} wanted;

/* Names the files and writes them. */
static murk_status write_images(murk_image_files *files, const wanted *of,
                                const murk_save_options *options,
                                murk_error *err)
{
    const murk_picture *picture = of->picture;
    const murk_light *light = picture->light;
    const murk_viewpoint *viewpoint = &picture->rendering.viewpoint;
    const murk_image_facts facts = {
        .scene = picture->world->desc,
        .viewpoint = viewpoint,
        .command = options->command,
        .method = picture->rendering.method->text,
        .photons = light ? light->session.traced->emitted : 0};
    murk_image_options images;
    murk_status status = murk_image_options_read(&images, of->images, err);
    if (!status) {
        status =
            murk_images_name(files, of->path, &images, facts.scene,
                             viewpoint->sensors > 0, options->replaces, err);
    }
    /* Rank 0 writes (base/ranks.h). */
    return status || murk_ranks_number() > 0
               ? status
               : murk_images_write(files, picture->rendering.image, &facts,
                                   err);
}

/* A murk_save_work; of: a wanted. */
static murk_status save(void *of, murk_session *session,
                        const murk_save_options *options, murk_error *late,
                        murk_error *err)
{
    (void)late;
    wanted *w = of;
    const murk_save_options all = murk_save_known(options);
    murk_image_files files = {.exr = NULL};
    const murk_picture_results results = {session, &w->picture->rendering,
                                          &files};
    murk_status status =
        murk_save_identify(session, "render", options, "", err);
    if (!status) {
        status = write_images(&files, w, &all, err);
    }
    if (!status) {
        status = murk_session_finish(session, NULL, murk_picture_json(&results),
                                     NULL, NULL, err);
    }
    if (!status) {
        w->summary = murk_print_collect(murk_picture_print, &results);
    }
    murk_images_release(&files);
    return status;
}

murk_status murk_picture_save(murk_picture *picture, const char *path,
                              const murk_image_options *png,
                              const murk_save_options *options,
                              const murk_fields **fields, murk_error *error)
{
    if (!picture) {
        return murk_save_refuse(fields, error, "picture is NULL");
    }
    wanted of = {picture, path, png, NULL};
    const murk_session session = session_of(picture);
    murk_call call =
        murk_call_begin(picture->world->context, &picture->world->files, error);
    const murk_status status = murk_save_results(
        &call, &session, &picture->saved, NULL, options, fields, save, &of);
    cJSON *saved = cJSON_GetObjectItem(picture->saved.root, "saved");
    if (!cJSON_AddItemToObject(saved, "summary", of.summary)) {
        cJSON_Delete(of.summary);
    }
    return status;
}

/* ---- checks beforehand ---- */

/* Checks picture and files, and warns of doubts about the place. */
static murk_status check(murk_world *world, const murk_picture_options *picture,
                         const char *path,
                         const murk_image_options *wanted_images, bool replaces,
                         murk_error *err)
{
    murk_rendering rendering = {.image = NULL};
    murk_viewpoint_request request;
    const murk_rendering_method *method = NULL;
    murk_image_options images;
    murk_image_files files = {.exr = NULL};
    /* Camera and files, as far as they do not depend on the world. */
    murk_status status =
        murk_picture_options_read(&request, &method, world, picture, err);
    if (!status) {
        status = murk_image_options_read(&images, wanted_images, err);
    }
    if (!status) {
        status = murk_rendering_choose(&rendering, method, world->desc,
                                       &request, err);
    }
    if (!status) {
        status = murk_images_name(&files, path, &images, world->desc,
                                  request.sensors > 0, replaces, err);
    }
    murk_images_release(&files);
    /* The viewpoint in the world, and the memory. */
    if (!status) {
        status = stand(&rendering, world, &request, err);
    }
    if (!status) {
        status = murk_rendering_check_memory(&rendering, world->desc, &images,
                                             NULL, err);
    }
    return status ? status
                  : murk_viewpoint_judge(&rendering.viewpoint, world->stage,
                                         world->context->threads, err);
}

murk_status murk_picture_check(murk_world *world,
                               const murk_picture_options *picture,
                               const char *path, const murk_image_options *png,
                               const murk_save_options *options,
                               murk_error *error)
{
    if (!world) {
        return murk_call_refuse(error, "world is NULL");
    }
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_session session = murk_world_session(world);
    murk_status status = murk_save_set(&session, NULL, options, &call.failure);
    if (!status) {
        status = check(world, picture, path, png, session.settings.force,
                       &call.failure);
    }
    return murk_call_end_long(&call, status);
}
