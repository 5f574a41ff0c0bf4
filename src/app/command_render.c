/* murk render: renders a picture of the scene, as one of its cameras or a
 * sensor sees it, and writes the image files. */
#include "api/scene_picture.h"
#include "app/images.h"
#include "app/picture_coverage.h"
#include "app/session.h"
#include "app/viewpoint.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/machine.h"
#include "render/gather.h"
#include "render/render.h"
#include "results/json.h"
#include "results/summary.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* A warning is given if the errors of more than this share of the pixels are
 * unsure (render/render.h), and at least UNSURE_MIN of them: smaller pictures
 * are smaller than the window over which errors are pooled. */
#define UNSURE_SHARE 0.25
#define UNSURE_MIN   50

/* The methods, in the order of the words of --method. */
typedef struct method {
    murk_render_method kind;
    const char *name, *text;
} method;

static const method METHODS[] = {
    {MURK_BY_MAPS, "maps",
     "maps: shadow rays, and density estimate over later records"},
    {MURK_BY_PATHS, "path", "path: path tracing with shadow rays"},
    {MURK_BY_MAPS_ONLY, "maps-only",
     "maps-only: density estimate over all records"}};

typedef struct job {
    const murk_options *options;
    const method *method;
    murk_session session;
    murk_viewpoint viewpoint;
    murk_image_files images;
    murk_image *picture;
    double render_s;
} job;

/* ---- what is asked for ---- */

/* Fails if more memory is needed than is free: for the picture, and once light
 * is traced also for the kernels that are made of the maps. */
static murk_status check_memory(const job *j, murk_error *err)
{
    const murk_camera *c = &j->viewpoint.camera;
    const murk_traced *traced = j->session.traced;
    double wanted = murk_render_bytes(c->width, c->height,
                                      j->session.scene->bands, j->method->kind);
    /* one PNG after the other */
    if (j->images.false_colour) {
        wanted += murk_false_colour_bytes(c->width, c->height);
    } else if (j->images.png) {
        wanted += 3 * (double)c->width * (double)c->height;
    }
    if (j->viewpoint.sensors > 0) {
        wanted += murk_picture_coverage_bytes(c->width, c->height);
    }
    double maps = 0;
    if (traced) {
        maps = murk_gather_memory_for(
            (double)murk_photon_map_count(traced->surface),
            (double)murk_photon_map_count(traced->volume));
    }
    const double spare = murk_machine_memory_bytes();
    if (wanted + maps <= spare) {
        return MURK_OK;
    }
    char also[64] = "";
    if (maps > 0) {
        snprintf(also, sizeof also, ", the photons' kernels %.3g GB",
                 maps * 1e-9);
    }
    return murk_fail(err, MURK_NO_MEMORY, j->viewpoint.where,
                     "pixels are %zu x %zu: the picture takes %.3g GB%s, and "
                     "%.3g GB are free",
                     c->width, c->height, wanted * 1e-9, also, spare * 1e-9);
}

static murk_status check_maps(const job *j, murk_error *err)
{
    static const char *const words[] = {"both", "surface", "volume", "none"};
    const murk_scene_maps maps = j->session.scene->photons.maps;
    if (j->method->kind == MURK_BY_PATHS || maps == MURK_SCENE_MAPS_BOTH) {
        return MURK_OK;
    }
    return murk_fail(err, MURK_BAD_VALUE, "photons.maps",
                     "%s, must be both for --method maps", words[maps]);
}

/* ---- the picture ---- */

static murk_status take_picture(job *j, murk_error *err)
{
    const murk_session *s = &j->session;
    const murk_trace trace = murk_stage_trace(s->stage);
    murk_render render = murk_render_of_stage(
        s->stage, &trace, j->viewpoint.camera, s->traced, s->settings.threads);
    render.samples = j->viewpoint.samples;
    render.method = j->method->kind;
    /* Render, then add the coverage by sensors. */
    const double begun_s = murk_clock_s();
    murk_status status = murk_render_run(&j->picture, &render, err);
    if (!status && j->viewpoint.sensors > 0 && !murk_interrupted()) {
        status = murk_picture_cover(j->picture, &j->viewpoint, s->stage,
                                    s->settings.threads, err);
    }
    j->render_s = murk_clock_s() - begun_s;
    status = status ? status : murk_interrupt_check(err);
    return status;
}

/* Warns of the band and map with the fewest records that have kernels. A band
 * without such records in a map is no reason for a warning: the scene has no
 * medium, or nothing that scatters or reflects light of the band. */
static void warn_of_few_records(const job *j)
{
    const murk_image *p = j->picture;
    const double *nm = j->session.scene->band_nm;
    size_t few = MURK_GATHER_FEW, others = 0;
    int band = 0, map = 0;
    /* Find the map and band with the fewest records. */
    for (int m = 0; m < 2; ++m) {
        for (int b = 0; b < p->bands; ++b) {
            const size_t n = p->records[m][b];
            others += n > 0 && n < MURK_GATHER_FEW;
            if (n > 0 && n < few) {
                few = n;
                band = b;
                map = m;
            }
        }
    }
    if (others > 0) {
        char also[48] = "";
        if (others > 1) {
            snprintf(also, sizeof also, " (and %zu more like it)", others - 1);
        }
        murk_warn("photons",
                  "%zu record%s of %.7g nm count%s in the %s map%s, fewer than "
                  "%d: their kernels mean little; emit more photons",
                  few, few == 1 ? "" : "s", nm[band], few == 1 ? "s" : "",
                  map ? "volume" : "surface", also, MURK_GATHER_FEW);
    }
}

/* Warns if the errors of many pixels follow from a few bright paths. Such
 * errors are right in the mean over the picture, but not for each pixel. */
static void warn_of_unsure_errors(const job *j)
{
    const murk_image *p = j->picture;
    const double share =
        (double)p->unsure / ((double)p->width * (double)p->height);
    if (share > UNSURE_SHARE && p->unsure >= UNSURE_MIN) {
        murk_warn("samples",
                  "the errors of %.0f %% of the pixels rest on a few bright "
                  "paths: they hold in the mean, not for one pixel; take more "
                  "than %zu samples, or --method maps",
                  100 * share, j->viewpoint.samples);
    }
}

static murk_status write_images(job *j, murk_error *err)
{
    const murk_traced *traced = j->session.traced;
    const murk_image_facts facts = {.scene = j->session.scene,
                                    .viewpoint = &j->viewpoint,
                                    .options = j->options,
                                    .method = j->method->text,
                                    .photons = traced ? traced->emitted : 0};
    return murk_images_write(&j->images, j->picture, &facts, err);
}

/* ---- what is told of it ---- */

static bool is_all_round(const job *j)
{
    return j->viewpoint.camera.projection == MURK_EQUIRECTANGULAR;
}

/* "1.2 +- 0.3 W/m2/sr"; the error is left out if it is not finite, as with one
 * sample a pixel. */
static void print_mean(double value, double error, const char *unit)
{
    murk_print("%.4g ", value);
    if (isfinite(error)) {
        murk_print("+- %.2g ", error);
    }
    murk_print("%s", unit);
}

/* Prints a line for each band. */
static void print_radiance(const job *j)
{
    const murk_image *p = j->picture;
    const double *nm = j->session.scene->band_nm;
    const double sphere_sr = 4 * MURK_PI;
    if (is_all_round(j)) {
        murk_print("radiance    mean over the sphere, and with it the scalar "
                   "irradiance:\n");
    }
    for (int b = 0; b < p->bands; ++b) {
        const double mean = p->mean[b], error = p->mean_error[b];
        if (is_all_round(j)) {
            murk_print("            %.7g nm  ", nm[b]);
            print_mean(mean, error, "W/m2/sr  ");
            print_mean(sphere_sr * mean, sphere_sr * error, "W/m2");
        } else {
            murk_print("radiance    %.7g nm: ", nm[b]);
            print_mean(mean, error, "W/m2/sr, mean over the picture's pixels");
        }
        murk_print("\n"); /* arguments are shown with newlines escaped */
    }
    if (!isfinite(p->mean_error[0])) {
        murk_print("            errors are known from 2 samples a pixel on\n");
    }
}

static void print_images(const job *j)
{
    const murk_image_files *images = &j->images;
    murk_print("files       %s\n", images->exr);
    if (images->png) {
        murk_print("            %s: exposure %.2f stops%s\n", images->png,
                   images->stops,
                   j->options->render.has_exposure ? "" : ", by the picture");
    }
    if (images->false_colour) {
        const murk_false_colour *c = &images->colours;
        murk_print("            %s: %s, %.5g to %.5g, %s\n",
                   images->false_colour, images->channel, c->low, c->high,
                   c->is_log ? "logarithmic" : "linear");
    }
}

static void print_summary(const job *j)
{
    const murk_session *s = &j->session;
    const murk_viewpoint *v = &j->viewpoint;
    const murk_image *p = j->picture;
    if (s->traced) {
        murk_print_light(s);
    }
    /* The camera and the method. */
    murk_print("camera      %s: %zu x %zu pixels, %zu sample%s; ", v->name,
               p->width, p->height, v->samples, v->samples == 1 ? "" : "s");
    if (is_all_round(j)) {
        murk_print("all round, heading %.1f degrees in the middle\n",
                   v->heading_deg);
    } else {
        murk_print("heading %.1f, tilt %.1f degrees\n", v->heading_deg,
                   v->tilt_deg);
    }
    murk_print("method      %s\n", j->method->text);
    /* The radiance, and what limits it. */
    print_radiance(j);
    if (p->lost > 0) {
        murk_print("lost        %llu of %llu rays, by caps or rounding\n",
                   (unsigned long long)p->lost, (unsigned long long)p->rays);
    }
    if (v->sensors > 0) {
        murk_print("coverage    by %zu sensor%s, in coverage.count and "
                   "coverage.clarity\n",
                   v->sensors, v->sensors == 1 ? "" : "s");
    }
    murk_print_time(&s->run, "render", j->render_s);
    print_images(j);
}

static void add_images(cJSON *root, const job *j)
{
    const murk_image_files *images = &j->images;
    cJSON_AddStringToObject(root, "image", images->exr);
    if (images->png) {
        cJSON *png = cJSON_AddObjectToObject(root, "png");
        cJSON_AddStringToObject(png, "image", images->png);
        murk_json_number(png, "exposure_stops", images->stops);
    }
    if (images->false_colour) {
        cJSON *png = cJSON_AddObjectToObject(root, "false_colour");
        cJSON_AddStringToObject(png, "image", images->false_colour);
        cJSON_AddStringToObject(png, "channel", images->channel);
        murk_json_number(png, "low", images->colours.low);
        murk_json_number(png, "high", images->colours.high);
        cJSON_AddBoolToObject(png, "logarithmic", images->colours.is_log);
    }
}

static cJSON *facts_json(const job *j)
{
    const murk_image *p = j->picture;
    const murk_viewpoint *v = &j->viewpoint;
    cJSON *root = murk_json_begin(j->session.scene);
    add_images(root, j);
    /* The camera. */
    cJSON_AddStringToObject(root, "camera", v->name);
    cJSON_AddStringToObject(root, "projection",
                            murk_projection_name(v->camera.projection));
    murk_json_vector(root, "from_m",
                     murk_scene_user(j->session.scene, v->camera.from));
    murk_json_number(root, "heading_deg", v->heading_deg);
    murk_json_number(root, "tilt_deg", v->tilt_deg);
    cJSON_AddStringToObject(root, "method", j->method->name);
    /* Size, samples and rays. */
    const double pixels[] = {(double)p->width, (double)p->height};
    murk_json_numbers(root, "pixels", pixels, 2);
    murk_json_number(root, "samples", (double)v->samples);
    murk_json_number(root, "sensors", (double)v->sensors);
    murk_json_number(root, "rays", (double)p->rays);
    murk_json_number(root, "lost", (double)p->lost);
    murk_json_number(root, "unsure_errors", (double)p->unsure);
    /* The mean radiance with its error, and the checksums of the files. */
    cJSON_AddStringToObject(root, "mean_over",
                            is_all_round(j) ? "solid angle" : "pixels");
    murk_json_numbers(root, "mean_radiance", p->mean, p->bands);
    murk_json_numbers(root, "mean_radiance_standard_error", p->mean_error,
                      p->bands);
    murk_json_file(root, j->images.exr);
    murk_json_file(root, j->images.png);
    murk_json_file(root, j->images.false_colour);
    return root;
}

static murk_status tell(job *j, murk_error *err)
{
    murk_session *s = &j->session;
    const murk_status status =
        murk_session_finish(s, NULL, facts_json(j), NULL, NULL, err);
    if (!status && murk_session_speaks(s)) {
        print_summary(j);
    }
    return status;
}

/* Reads the scene, builds the world, and checks all that can be refused before
 * light is traced. */
static murk_status prepare(job *j, murk_error *err)
{
    const murk_options *options = j->options;
    murk_session *s = &j->session;
    murk_options inner = *options;
    inner.out = NULL; /* the image is no folder of results */
    murk_status status = murk_session_read(s, &inner, err);
    if (!status) {
        status = murk_viewpoint_choose(&j->viewpoint, s->scene, options, err);
    }
    if (!status) {
        status = check_maps(j, err);
    }
    if (!status) {
        status = murk_images_name(&j->images, options, s->scene,
                                  j->viewpoint.mark, err);
    }
    if (!status) {
        status = murk_session_build(s, err);
    }
    if (!status) {
        status = murk_viewpoint_stand(&j->viewpoint, s->stage, options, err);
    }
    if (!status) {
        status = check_memory(j, err);
    }
    if (!status) {
        status = murk_viewpoint_judge(&j->viewpoint, s->stage, options->threads,
                                      err);
    }
    return status;
}

murk_status murk_command_render(const murk_options *options, murk_error *err)
{
    job j = {.options = options,
             .method = &METHODS[murk_option_number(options, "--method", 0)]};
    murk_status status = prepare(&j, err);
    if (!status && j.method->kind != MURK_BY_PATHS) {
        status = murk_session_light(&j.session, err);
        status = status ? status : check_memory(&j, err);
    }
    /* The picture, then its files and the report. */
    if (!status) {
        status = take_picture(&j, err);
    }
    if (!status) {
        warn_of_few_records(&j);
        warn_of_unsure_errors(&j);
        status = write_images(&j, err);
    }
    if (!status) {
        status = tell(&j, err);
    }
    murk_image_destroy(j.picture);
    murk_images_release(&j.images);
    murk_viewpoint_release(&j.viewpoint);
    murk_session_end(&j.session);
    return status;
}
