/* A picture of the scene, by one of its cameras. */
#include "app/session.h"
#include "app/version.h"
#include "base/interrupt.h"
#include "render/exr.h"
#include "scene/words.h"
#include "study/machine.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct job {
    const murk_options *options;
    murk_session session;
    const murk_scene_camera *camera;
    char *path; /* of the image */
    murk_picture *picture;
    double render_s;
} job;

/* ---- what is asked for ---- */

static murk_status find_camera(job *j, murk_error *err)
{
    const murk_scene *scene = j->session.scene;
    const char *wanted = j->options->camera;
    if (scene->n_cameras == 0) {
        return murk_fail(err, MURK_BAD_VALUE, scene->path,
                         "cameras: the scene has none, must have one to be "
                         "rendered: {name, from_m, to_m}");
    }
    const char **known = calloc(scene->n_cameras, sizeof *known);
    for (size_t i = 0; i < scene->n_cameras; ++i) {
        const murk_scene_camera *camera = &scene->cameras[i];
        if (!wanted || strcmp(camera->name, wanted) == 0) {
            j->camera = camera;
            break;
        }
        if (known) {
            known[i] = camera->name;
        }
    }
    murk_status status = MURK_OK;
    if (!j->camera) {
        char shown[64];
        murk_words_show(shown, sizeof shown, wanted);
        const char *meant =
            known ? murk_words_meant(wanted, known, scene->n_cameras) : NULL;
        status =
            murk_fail(err, MURK_BAD_VALUE, "--camera",
                      "%s is no camera of the scene, %s %s%s", shown,
                      meant ? "did you mean" : "the first of them is",
                      meant ? meant : scene->cameras[0].name, meant ? "?" : "");
    }
    free(known);
    return status;
}

static murk_status check_place(const job *j, murk_error *err)
{
    const murk_vec3 p = j->camera->from;
    const murk_box *box = &j->session.stage->world.domain.box;
    if (murk_box_contains(box, p)) {
        return MURK_OK;
    }
    return murk_fail(err, MURK_BAD_VALUE, j->camera->where,
                     "from_m is [%g, %g, %g] m, must be within the domain, "
                     "[%g, %g, %g]..[%g, %g, %g] m",
                     p.x, p.y, p.z, box->min.x, box->min.y, box->min.z,
                     box->max.x, box->max.y, box->max.z);
}

static murk_status check_memory(const job *j, murk_error *err)
{
    const murk_scene_camera *c = j->camera;
    const double wanted =
        murk_picture_bytes(c->pixels[0], c->pixels[1], j->session.scene->bands);
    const double spare = murk_machine_memory_bytes();
    if (wanted <= spare) {
        return MURK_OK;
    }
    return murk_fail(err, MURK_NO_MEMORY, c->where,
                     "pixels are %zu x %zu: the picture takes %.3g GB, and "
                     "%.3g GB are free",
                     c->pixels[0], c->pixels[1], wanted * 1e-9, spare * 1e-9);
}

static murk_status check_maps(const job *j, murk_error *err)
{
    static const char *const words[] = {"both", "surface", "volume", "none"};
    const murk_scene_maps maps = j->session.scene->photons.maps;
    if (j->options->by_path || maps == MURK_SCENE_MAPS_BOTH) {
        return MURK_OK;
    }
    return murk_fail(err, MURK_BAD_VALUE, "photons.maps",
                     "%s, must be both for --method maps", words[maps]);
}

/* Beside the scene, under its name (and the camera's, where that is asked
 * for). */
static murk_status name_image(job *j, murk_error *err)
{
    const char *input = j->options->input;
    const char *out = j->options->out;
    const char *camera = j->options->camera;
    const size_t size =
        strlen(out ? out : input) + (camera ? strlen(camera) : 0) + 16;
    j->path = malloc(size);
    if (!j->path) {
        return murk_fail(err, MURK_NO_MEMORY, "render", "no memory for a name");
    }
    if (out) {
        snprintf(j->path, size, "%s", out);
        return MURK_OK;
    }
    const char *slash = strrchr(input, '/');
    const char *dot = strrchr(slash ? slash : input, '.');
    const int stem = (int)(dot ? (size_t)(dot - input) : strlen(input));
    const int n = snprintf(j->path, size, "%.*s%s%s.exr", stem, input,
                           camera ? "-" : "", camera ? camera : "");
    for (int i = stem; i < n; ++i) {
        j->path[i] = j->path[i] == '/' ? '_' : j->path[i];
    }
    return MURK_OK;
}

/* ---- the picture ---- */

static murk_status take_picture(job *j, murk_error *err)
{
    const murk_session *s = &j->session;
    const murk_scene *scene = s->scene;
    const murk_scene_camera *c = j->camera;
    const murk_trace trace = murk_stage_trace(s->stage);
    murk_render render = {
        .trace = &trace,
        .camera = murk_camera_look(c->from, c->to, c->up, c->vfov_rad,
                                   c->pixels[0], c->pixels[1]),
        .samples = c->samples,
        .method = j->options->by_path ? MURK_BY_PATHS : MURK_BY_MAPS,
        .surface = s->traced ? s->traced->surface : NULL,
        .volume = s->traced ? s->traced->volume : NULL,
        .nearest = MURK_RENDER_NEAREST,
        .threads = s->options->threads};
    for (int b = 0; b < scene->bands; ++b) {
        const bool edges = scene->has_edges;
        render.from_nm[b] = edges ? scene->band_edge_nm[b] : scene->band_nm[b];
        render.to_nm[b] =
            edges ? scene->band_edge_nm[b + 1] : scene->band_nm[b];
    }
    const double begun_s = murk_clock_s();
    murk_status status = murk_render_run(&j->picture, &render, err);
    j->render_s = murk_clock_s() - begun_s;
    if (!status && murk_interrupted()) {
        status = murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    return status;
}

static const char *method_of(const job *j)
{
    return j->options->by_path
               ? "path: path tracing with shadow rays"
               : "maps: shadow rays, and density estimate over the nearest "
                 "records";
}

static murk_status write_image(const job *j, murk_error *err)
{
    const murk_scene *scene = j->session.scene;
    char seed[16], samples[16], nearest[16], photons[24];
    snprintf(seed, sizeof seed, "%lu", (unsigned long)scene->seed);
    snprintf(samples, sizeof samples, "%zu", j->camera->samples);
    snprintf(nearest, sizeof nearest, "%d", MURK_RENDER_NEAREST);
    snprintf(photons, sizeof photons, "%llu",
             (unsigned long long)(j->session.traced ? j->session.traced->emitted
                                                    : 0));
    const murk_exr_text header[] = {
        {"software", "murk " MURK_VERSION},
        {"murkCommit", murk_version_commit()},
        {"murkScene", scene->path},
        {"murkSceneSha256", scene->sha256},
        {"murkSeed", seed},
        {"murkCamera", j->camera->name},
        {"murkMethod", method_of(j)},
        {"murkSamples", samples},
        {"murkNearest", j->options->by_path ? "0" : nearest},
        {"murkPhotons", photons},
        {"emissiveUnits", "W.m^-2.sr^-1"},
    };
    const murk_exr exr = {.picture = j->picture,
                          .band_nm = scene->band_nm,
                          .header = header,
                          .n_header = sizeof header / sizeof *header};
    return murk_exr_write(&exr, j->path, err);
}

/* ---- what is told of it ---- */

static void print_summary(const job *j)
{
    const murk_session *s = &j->session;
    const murk_picture *p = j->picture;
    if (s->traced) {
        murk_print_light(s);
    }
    printf("camera      %s: %zu x %zu pixels, %zu samples; %s\n",
           j->camera->name, p->width, p->height, j->camera->samples,
           method_of(j));
    for (int b = 0; b < p->bands; ++b) {
        /* Of the records' noise the pixels have their share, which they have in
         * common. */
        printf("radiance    %.7g nm: %.4g +- %.2g W/m2/sr, mean of the "
               "picture%s\n",
               s->scene->band_nm[b], p->mean[b], p->mean_error[b],
               j->options->by_path ? "" : " (error of the rays alone)");
    }
    if (p->lost > 0) {
        printf("lost        %llu of %llu rays, by caps or rounding\n",
               (unsigned long long)p->lost, (unsigned long long)p->rays);
    }
    printf("time        %.2f s: load %.2f, trace %.2f, maps %.2f, render "
           "%.2f\n",
           s->run.total_s, s->run.load_s, s->run.trace_s, s->run.map_s,
           j->render_s);
    printf("files       %s\n", j->path);
}

static cJSON *facts_json(const job *j)
{
    const murk_picture *p = j->picture;
    cJSON *root = murk_json_begin(j->session.scene);
    cJSON_AddStringToObject(root, "image", j->path);
    cJSON_AddStringToObject(root, "camera", j->camera->name);
    cJSON_AddStringToObject(root, "method",
                            j->options->by_path ? "path" : "maps");
    cJSON *pixels = cJSON_AddArrayToObject(root, "pixels");
    cJSON_AddItemToArray(pixels, cJSON_CreateNumber((double)p->width));
    cJSON_AddItemToArray(pixels, cJSON_CreateNumber((double)p->height));
    murk_json_number(root, "samples", (double)j->camera->samples);
    murk_json_number(root, "rays", (double)p->rays);
    murk_json_number(root, "lost", (double)p->lost);
    murk_spectrum mean = {{0}}, error = {{0}};
    for (int b = 0; b < p->bands; ++b) {
        mean.band[b] = p->mean[b];
        error.band[b] = p->mean_error[b];
    }
    murk_json_spectrum(root, "mean_radiance", &mean, p->bands);
    murk_json_spectrum(root, "mean_radiance_standard_error", &error, p->bands);
    return root;
}

static murk_status tell(job *j, murk_error *err)
{
    murk_session *s = &j->session;
    const murk_status status = murk_session_finish(s, NULL, facts_json(j), err);
    if (!status && murk_session_speaks(s)) {
        print_summary(j);
    }
    return status;
}

murk_status murk_command_render(const murk_options *options, murk_error *err)
{
    /* The image is no folder of results. */
    murk_options inner = *options;
    inner.out = NULL;
    job j = {.options = options};
    murk_status status = murk_session_read(&j.session, &inner, err);
    if (!status) {
        status = find_camera(&j, err);
    }
    if (!status) {
        status = check_maps(&j, err);
    }
    if (!status) {
        status = name_image(&j, err);
    }
    if (!status) {
        status = murk_session_build(&j.session, err);
    }
    if (!status) {
        status = check_place(&j, err);
    }
    if (!status) {
        status = check_memory(&j, err);
    }
    if (!status && !options->by_path) {
        status = murk_session_light(&j.session, err);
    }
    if (!status) {
        status = take_picture(&j, err);
    }
    if (!status) {
        status = write_image(&j, err);
    }
    if (!status) {
        status = tell(&j, err);
    }
    murk_picture_destroy(j.picture);
    free(j.path);
    murk_session_end(&j.session);
    return status;
}
