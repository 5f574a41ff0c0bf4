/* murk render: renders a picture of the scene, as one of its cameras or a
 * sensor sees it, and writes the image files. */
#include "app/given.h"
#include "app/show.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct job {
    const murk_options *options;
    murk_world *world;
    murk_sensors *sensors; /* of --sensors; NULL: none */
    murk_picture_options picture;
    murk_image_options images;
    char *path; /* of the OpenEXR image, owned */
    murk_given_save save;
} job;

/* ---- the options ---- */

/* Refuses options that need more of the scene, or of the command line, than is
 * there, and names the options that help. The library refuses the same without
 * the names. has_cameras: the scene has a camera. */
static murk_status check(const murk_options *options, murk_scene *scene,
                         bool has_cameras, murk_error *err)
{
    const murk_render_options *render = &options->render;
    const char *sensors = NULL;
    /* The scene must have types of sensors and a camera. */
    if (options->sensors && murk_scene_get(scene, "sensors", &sensors, NULL)) {
        return murk_fail(err, MURK_BAD_VALUE, options->input,
                         "sensors: the scene has none, so --sensors has no "
                         "types");
    }
    if (!has_cameras && !(render->from_sensor > 0 && !options->camera)) {
        return murk_fail(err, MURK_BAD_VALUE, options->input,
                         "cameras: the scene has none, must have one to be "
                         "rendered: {name, from_m, to_m}; or --sensors FILE "
                         "--from-sensor N");
    }
    /* Files: a channel that the picture has, and a name of an OpenEXR file. */
    if (render->false_colour && !options->sensors &&
        strncmp(render->false_colour, "coverage", 8) == 0) {
        return murk_fail(err, MURK_BAD_VALUE, "--false-colour",
                         "%.48s, which pictures have with --sensors FILE alone",
                         render->false_colour);
    }
    const size_t length = options->out ? strlen(options->out) : 0;
    if (length > 4 && strcmp(options->out + length - 4, ".png") == 0) {
        return murk_fail(err, MURK_BAD_VALUE, "-o",
                         "%s: the image is OpenEXR, must not end in .png; "
                         "--png writes one beside it",
                         options->out);
    }
    return MURK_OK;
}

/* The path of the image: that of -o, or else that of the scene with the name of
 * the camera or the number of the sensor, if one is asked for, and the
 * extension .exr; "_" replaces each slash in the name. The caller frees the
 * text. NULL when out of memory. */
static char *path_of(const murk_options *options)
{
    const uint64_t number = options->render.from_sensor;
    const char *input = options->input, *camera = options->camera;
    char name[80] = "";
    if (options->out) {
        return strdup(options->out);
    }
    if (number > 0) {
        snprintf(name, sizeof name, "-sensor%llu", (unsigned long long)number);
    } else if (camera) {
        snprintf(name, sizeof name, "-%s", camera);
    }
    for (char *at = name; *at; ++at) {
        *at = *at == '/' ? '_' : *at;
    }
    /* The path of the scene without the extension. */
    const char *slash = strrchr(input, '/');
    const char *dot = strrchr(slash ? slash : input, '.');
    const size_t stem = dot ? (size_t)(dot - input) : strlen(input);
    const size_t size = stem + sizeof name + sizeof ".exr";
    char *path = malloc(size);
    if (path) {
        snprintf(path, size, "%.*s%s.exr", (int)stem, input, name);
    }
    return path;
}

/* Turns the options into those of picture and images. */
static void read_options(job *j)
{
    const murk_options *options = j->options;
    const murk_render_options *render = &options->render;
    /* The picture. */
    j->picture = (murk_picture_options){
        .size = sizeof j->picture,
        .camera = options->camera,
        .method = (murk_method)murk_option_number(options, "--method", 0),
        .sensors = j->sensors,
        .from_sensor = render->from_sensor,
        .width = render->pixels[0],
        .height = render->pixels[1],
        .samples = render->samples};
    /* The files beside the OpenEXR image. */
    j->images =
        (murk_image_options){.size = sizeof j->images,
                             .png = render->png,
                             .has_exposure = render->has_exposure,
                             .exposure_stops = render->exposure_stops,
                             .false_colour = render->false_colour,
                             .has_range = render->has_range,
                             .range = {render->range[0], render->range[1]},
                             .scale = MURK_SCALE_AUTO};
    if (murk_option_is_given(options, "--scale")) {
        j->images.scale = murk_option_number(options, "--scale", 0) == 1
                              ? MURK_SCALE_LOG
                              : MURK_SCALE_LINEAR;
    }
}

/* ---- the picture ---- */

/* Makes the world and the sensors, and checks all that can be refused before
 * light is traced. */
static murk_status prepare(job *j, murk_error *err)
{
    const murk_options *options = j->options;
    murk_scene *scene = NULL;
    const char *cameras = NULL;
    /* The scene, its world, and the options of the results. */
    murk_status status = murk_given_scene(&scene, options, err);
    if (!status) {
        status = murk_world_create(&j->world, scene, err);
    }
    if (!status) {
        status = murk_given_save_begin(&j->save, options, err);
    }
    if (!status) {
        status = murk_scene_get(scene, "cameras", &cameras, err);
    }
    if (!status) {
        status = check(options, scene, strcmp(cameras, "[]") != 0, err);
    }
    /* The sensors; then picture and files are checked. */
    if (!status && options->sensors) {
        status =
            murk_sensors_read(&j->sensors, j->world, options->sensors, err);
    }
    if (!status) {
        read_options(j);
        j->path = path_of(options);
        status = j->path ? murk_picture_check(j->world, &j->picture, j->path,
                                              &j->images, &j->save.options, err)
                         : murk_no_memory(err, "render", "for a name");
    }
    murk_scene_destroy(scene);
    return status;
}

murk_status murk_command_render(const murk_options *options, murk_error *err)
{
    job j = {.options = options};
    murk_light *light = NULL;
    murk_picture *picture = NULL;
    const murk_fields *saved = NULL;
    murk_status status = prepare(&j, err);
    if (!status && j.picture.method != MURK_METHOD_PATHS) {
        status = murk_given_light(&light, j.world, options, err);
    }
    /* The picture, then its files and the report. */
    if (!status) {
        status = murk_picture_render(&picture, j.world, light, &j.picture, err);
    }
    if (!status) {
        status = murk_picture_save(picture, j.path, &j.images, &j.save.options,
                                   &saved, err);
    }
    if (!status && options->json) {
        murk_show_results(options, saved);
    } else if (!status && murk_shows_summary(options)) {
        murk_show_lines(saved, "saved.summary");
    }
    murk_picture_destroy(picture);
    murk_light_destroy(light);
    murk_sensors_destroy(j.sensors);
    murk_world_destroy(j.world);
    murk_given_save_end(&j.save);
    free(j.path);
    return status;
}
