/* The results of a picture: the JSON and the lines of the summary. Both are
 * written side by side and not from a table of results/fields.h, because a line
 * joins several fields in a sentence. */
#include "pictures/results.h"

#include <math.h>

static bool is_all_round(const murk_picture_results *r)
{
    return r->rendering->viewpoint.camera.projection == MURK_EQUIRECTANGULAR;
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
static void print_radiance(const murk_picture_results *r)
{
    const murk_image *p = r->rendering->image;
    const double *nm = r->session->scene->band_nm;
    const double sphere_sr = 4 * MURK_PI;
    if (is_all_round(r)) {
        murk_print("radiance    mean over the sphere, and with it the scalar "
                   "irradiance:\n");
    }
    for (int b = 0; b < p->bands; ++b) {
        const double mean = p->mean[b], error = p->mean_error[b];
        if (is_all_round(r)) {
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

static void print_images(const murk_picture_results *r)
{
    const murk_image_files *images = r->images;
    if (!images->exr) {
        murk_print("files       none\n");
        return;
    }
    murk_print("files       %s\n", images->exr);
    if (images->png) {
        murk_print("            %s: exposure %.2f stops%s\n", images->png,
                   images->stops,
                   images->options.has_exposure ? "" : ", by the picture");
    }
    if (images->false_colour) {
        const murk_false_colour *c = &images->colours;
        murk_print("            %s: %s, %.5g to %.5g, %s\n",
                   images->false_colour, images->channel, c->low, c->high,
                   c->is_log ? "logarithmic" : "linear");
    }
}

void murk_picture_print(const void *of)
{
    const murk_picture_results *r = of;
    const murk_session *s = r->session;
    const murk_viewpoint *v = &r->rendering->viewpoint;
    const murk_image *p = r->rendering->image;
    if (s->traced) {
        murk_print_light(s);
    }
    /* The camera and the method. */
    murk_print("camera      %s: %zu x %zu pixels, %zu sample%s; ", v->name,
               p->width, p->height, v->samples, v->samples == 1 ? "" : "s");
    if (is_all_round(r)) {
        murk_print("all round, heading %.1f degrees in the middle\n",
                   v->heading_deg);
    } else {
        murk_print("heading %.1f, tilt %.1f degrees\n", v->heading_deg,
                   v->tilt_deg);
    }
    murk_print("method      %s\n", r->rendering->method->text);
    /* The radiance, and what limits it. */
    print_radiance(r);
    if (p->lost > 0) {
        murk_print("lost        %llu of %llu rays, by caps or rounding\n",
                   (unsigned long long)p->lost, (unsigned long long)p->rays);
    }
    if (v->sensors > 0) {
        murk_print("coverage    by %zu sensor%s, in coverage.count and "
                   "coverage.clarity\n",
                   v->sensors, v->sensors == 1 ? "" : "s");
    }
    murk_print_time(&s->run, "render", r->rendering->render_s);
    print_images(r);
}

static void add_images(cJSON *root, const murk_picture_results *r)
{
    const murk_image_files *images = r->images;
    if (images->exr) {
        cJSON_AddStringToObject(root, "image", images->exr);
    } else {
        cJSON_AddNullToObject(root, "image");
    }
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

cJSON *murk_picture_json(const murk_picture_results *r)
{
    const murk_image *p = r->rendering->image;
    const murk_viewpoint *v = &r->rendering->viewpoint;
    cJSON *root = murk_json_begin(r->session->scene);
    add_images(root, r);
    /* The camera. */
    cJSON_AddStringToObject(root, "camera", v->name);
    cJSON_AddStringToObject(root, "projection",
                            murk_projection_name(v->camera.projection));
    murk_json_vector(root, "from_m",
                     murk_scene_user(r->session->scene, v->camera.from));
    murk_json_number(root, "heading_deg", v->heading_deg);
    murk_json_number(root, "tilt_deg", v->tilt_deg);
    cJSON_AddStringToObject(root, "method", r->rendering->method->name);
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
                            is_all_round(r) ? "solid angle" : "pixels");
    murk_json_numbers(root, "mean_radiance", p->mean, p->bands);
    murk_json_numbers(root, "mean_radiance_standard_error", p->mean_error,
                      p->bands);
    murk_json_file(root, r->images->exr);
    murk_json_file(root, r->images->png);
    murk_json_file(root, r->images->false_colour);
    return root;
}
