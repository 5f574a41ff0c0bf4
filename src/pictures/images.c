/* The files of a picture: their names, the texts about the picture in their
 * headers, and the OpenEXR and PNG files themselves. */
#include "pictures/images.h"

#include "base/file.h"
#include "render/exr.h"
#include "render/tone.h"
#include "results/ownership.h"
#include "results/summary.h"
#include "results/version.h"
#include "scene/places.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Lines in the header of a picture, and bytes of a line that is made of
 * numbers. */
#define TEXTS_MAX 24
#define TEXT_SIZE 96

/* ---- names ---- */

/* The length of a path without ".exr" at the end. */
static size_t stem_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *dot = strrchr(slash ? slash : path, '.');
    return dot && strcmp(dot, ".exr") == 0 ? (size_t)(dot - path)
                                           : strlen(path);
}

/* Returns the first `stem` bytes of the path, "-" and `added` unless that is
 * empty, and the extension; "_" replaces each slash after the stem. The caller
 * frees the text. NULL when out of memory. */
static char *path_of(const char *path, size_t stem, const char *added,
                     const char *extension)
{
    const size_t size = stem + strlen(added) + strlen(extension) + 2;
    char *out = malloc(size);
    if (out) {
        snprintf(out, size, "%.*s%s%s%s", (int)stem, path, *added ? "-" : "",
                 added, extension);
        for (char *at = out + stem; *at; ++at) {
            *at = *at == '/' ? '_' : *at;
        }
    }
    return out;
}

static murk_status no_channel(const murk_channel *list, size_t n,
                              const char *wanted, bool has_coverage,
                              murk_error *err)
{
    char known[160] = "";
    size_t length = 0;
    for (size_t i = 0; i < n && length < sizeof known - 48; ++i) {
        length += (size_t)snprintf(known + length, sizeof known - length,
                                   "%s%s", i ? ", " : "", list[i].name);
    }
    const bool lacks = !has_coverage && strncmp(wanted, "coverage", 8) == 0;
    return murk_fail(err, MURK_BAD_VALUE, "false_colour", "%.48s%s%s%s", wanted,
                     lacks ? ", which pictures have with sensors alone"
                           : " is no channel of the picture, or one in several "
                             "bands; there are ",
                     lacks ? "" : known, lacks ? "" : " and others");
}

static murk_status find_channel(murk_image_files *out,
                                const murk_scene_desc *scene, bool has_coverage,
                                murk_error *err)
{
    const char *wanted = out->options.false_colour;
    murk_channel *list = calloc(MURK_CHANNELS_MAX, sizeof *list);
    if (!list) {
        return murk_no_memory(err, "render", "for names");
    }
    const size_t n = murk_channels_list(NULL, scene->bands, scene->band_nm,
                                        has_coverage, list);
    const murk_channel *found = murk_channel_find(list, n, wanted);
    murk_status status = MURK_OK;
    if (found) {
        snprintf(out->channel, sizeof out->channel, "%s", found->name);
    } else {
        /* bands first, which are asked for most */
        const size_t first = 10;
        status = no_channel(list + first, n - first, wanted, has_coverage, err);
    }
    free(list);
    return status;
}

static murk_status check_bands(const murk_scene_desc *scene, murk_error *err)
{
    const int b = murk_channels_clash(scene->bands, scene->band_nm);
    if (b < 0) {
        return MURK_OK;
    }
    return murk_fail(err, MURK_BAD_VALUE,
                     scene->has_edges ? "band_edges_nm" : "bands_nm",
                     "bands %d and %d are at %.12g and %.12g nm, must differ "
                     "within 7 digits: the image's channels are named by them",
                     b + 1, b + 2, scene->band_nm[b], scene->band_nm[b + 1]);
}

/* Checks that each file may be written, so that no picture is rendered and then
 * lost. */
static murk_status check_writable(const murk_image_files *images, bool replaces,
                                  murk_error *err)
{
    const char *const path[] = {images->exr, images->png, images->false_colour};
    murk_status status = MURK_OK;
    for (size_t i = 0; !status && i < sizeof path / sizeof *path; ++i) {
        murk_file *file = NULL;
        if (!path[i]) {
            continue;
        }
        status =
            murk_file_check_owner(path[i], MURK_MARK_IMAGE,
                                  sizeof MURK_MARK_IMAGE - 1, replaces, err);
        if (!status) {
            status = murk_file_create(&file, path[i], err);
        }
        murk_file_discard(file);
    }
    return status;
}

/* Sets the paths of the files. */
static murk_status name_files(murk_image_files *out, const char *path,
                              murk_error *err)
{
    const murk_image_options *options = &out->options;
    const size_t length = strlen(path), stem = stem_length(path);
    if (length > 4 && strcmp(path + length - 4, ".png") == 0) {
        return murk_fail(
            err, MURK_BAD_VALUE, path,
            "the image is OpenEXR, must not end in .png; options->png "
            "writes one beside it");
    }
    out->exr = strdup(path);
    if (options->png) {
        out->png = path_of(path, stem, "", ".png");
    }
    if (options->false_colour) {
        out->false_colour = path_of(path, stem, out->channel, ".png");
    }
    return out->exr && (out->png || !options->png) &&
                   (out->false_colour || !options->false_colour)
               ? MURK_OK
               : murk_no_memory(err, "render", "for a name");
}

murk_status murk_images_name(murk_image_files *out, const char *path,
                             const murk_image_options *options,
                             const murk_scene_desc *scene, bool has_coverage,
                             bool replaces, murk_error *err)
{
    *out = (murk_image_files){.options = *options};
    /* The bands must give different names, and the channel in false colour must
     * exist. */
    murk_status status = check_bands(scene, err);
    if (!status && options->false_colour) {
        status = find_channel(out, scene, has_coverage, err);
    }
    if (!status && path) {
        status = name_files(out, path, err);
    }
    return status ? status : check_writable(out, replaces, err);
}

double murk_images_bytes(const murk_image_options *options, size_t width,
                         size_t height)
{
    /* one PNG after the other */
    return options->false_colour ? murk_false_colour_bytes(width, height)
           : options->png        ? 3 * (double)width * (double)height
                                 : 0;
}

void murk_images_release(murk_image_files *images)
{
    free(images->exr);
    free(images->png);
    free(images->false_colour);
    *images = (murk_image_files){0};
}

/* ---- the texts in the headers ---- */

typedef struct texts {
    murk_image_text of[TEXTS_MAX];
    size_t n;
    char made[TEXTS_MAX][TEXT_SIZE]; /* those that are numbers */
} texts;

static void say(texts *t, const char *name, const char *text)
{
    t->of[t->n++] = (murk_image_text){name, text};
}

__attribute__((format(printf, 3, 4))) static void
say_made(texts *t, const char *name, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    vsnprintf(t->made[t->n], TEXT_SIZE, format, args);
    va_end(args);
    say(t, name, t->made[t->n]);
}

static void say_all(texts *t, const murk_image_facts *facts)
{
    const murk_viewpoint *v = facts->viewpoint;
    const murk_camera *c = &v->camera;
    say(t, "software", "murk " MURK_VERSION);
    say(t, "murkCommit", murk_version_commit());
    if (facts->command) {
        say(t, "murkCommand", facts->command);
    }
    say(t, "murkScene", facts->scene->path);
    say(t, "murkSceneSha256", facts->scene->sha256);
    say_made(t, "murkSeed", "%lu", (unsigned long)facts->scene->seed);
    say(t, "murkCamera", v->name);
    say(t, "murkProjection", murk_projection_name(c->projection));
    const murk_vec3 from = murk_scene_user(facts->scene, c->from);
    const int digits = murk_coordinate_digits(facts->scene, 9);
    say_made(t, "murkFrom", "%.*g %.*g %.*g m", digits, from.x, digits, from.y,
             digits, from.z);
    if (c->projection == MURK_ORTHOGRAPHIC) {
        say_made(t, "murkWidth", "%.9g m", c->step[0] * (double)c->width);
    }
    if (c->clip.is_set) {
        const murk_vec3 at = murk_scene_user(facts->scene, c->clip.point);
        const murk_vec3 n = c->clip.normal;
        say_made(t, "murkClipPoint", "%.*g %.*g %.*g m", digits, at.x, digits,
                 at.y, digits, at.z);
        say_made(t, "murkClipNormal", "%.9g %.9g %.9g", n.x, n.y, n.z);
    }
    const murk_vec3 o = facts->scene->origin; /* of the channels P.X, P.Y,
                                               * P.Z */
    if (o.x != 0 || o.y != 0 || o.z != 0) {
        say_made(t, "murkOrigin", "%.17g %.17g %.17g m", o.x, o.y, o.z);
    }
    say_made(t, "murkHeading", "%.6g degrees", v->heading_deg);
    say_made(t, "murkTilt", "%.6g degrees", v->tilt_deg);
    say(t, "murkMethod", facts->method);
    say_made(t, "murkSamples", "%zu", v->samples);
    say_made(t, "murkPhotons", "%llu", (unsigned long long)facts->photons);
    if (v->sensors > 0) {
        say_made(t, "murkSensors", "%zu", v->sensors);
    }
}

/* ---- the files ---- */

static murk_status write_exr(const murk_image_files *images,
                             const murk_image *picture,
                             const murk_image_facts *facts, murk_error *err)
{
    const murk_camera *c = &facts->viewpoint->camera;
    const bool is_all_round = c->projection == MURK_EQUIRECTANGULAR;
    texts t = {.n = 0};
    say_all(&t, facts);
    say(&t, "emissiveUnits", "W.m^-2.sr^-1");
    const murk_exr exr = {
        .picture = picture,
        .band_nm = facts->scene->band_nm,
        .is_all_round = is_all_round,
        .pixel_aspect = is_all_round ? 2 * (double)c->height / (double)c->width
                                     : c->step[0] / c->step[1],
        .header = t.of,
        .n_header = t.n};
    return murk_exr_write(&exr, images->exr, err);
}

static murk_status write_png(murk_image_files *images,
                             const murk_image *picture,
                             const murk_image_facts *facts, murk_error *err)
{
    const murk_image_options *options = &images->options;
    images->stops = options->exposure_stops;
    murk_status status = options->has_exposure
                             ? MURK_OK
                             : murk_tone_stops(&images->stops, picture, err);
    murk_raster raster = {0};
    if (!status) {
        status = murk_tone_raster(&raster, picture, images->stops, err);
    }
    if (!status) {
        texts t = {.n = 0};
        say_all(&t, facts);
        say_made(&t, "murkExposure", "%.2f stops%s", images->stops,
                 options->has_exposure ? "" : ", by the picture");
        status = murk_png_write(&raster, t.of, t.n, images->png, err);
    }
    free(raster.rgb);
    return status;
}

static murk_status choose_colours(murk_image_files *images,
                                  const murk_channel *channel, size_t n,
                                  murk_error *err)
{
    const murk_image_options *options = &images->options;
    /* A range that begins at 0 or below asks for no logarithm. */
    const bool is_log =
        options->scale != MURK_SCALE_AUTO
            ? options->scale == MURK_SCALE_LOG
            : murk_false_colour_is_log(channel) &&
                  !(options->has_range && !(options->range[0] > 0));
    if (options->has_range) {
        images->colours =
            (murk_false_colour){options->range[0], options->range[1], is_log};
        return MURK_OK;
    }
    return murk_false_colour_range(&images->colours, channel, n, is_log, err);
}

static murk_status write_false_colour(murk_image_files *images,
                                      const murk_image *picture,
                                      const murk_image_facts *facts,
                                      murk_error *err)
{
    murk_channel *list = calloc(MURK_CHANNELS_MAX, sizeof *list);
    if (!list) {
        return murk_no_memory(err, "render", "for names");
    }
    /* The channel and its range. */
    const size_t n =
        murk_channels_list(picture, picture->bands, facts->scene->band_nm,
                           picture->seen_by != NULL, list);
    const murk_channel *channel = murk_channel_find(list, n, images->channel);
    murk_status status =
        choose_colours(images, channel, picture->width * picture->height, err);
    const murk_false_colour *colours = &images->colours;
    /* Draw it, and write it with the texts. */
    murk_raster raster = {0};
    if (!status) {
        status = murk_false_colour_raster(&raster, channel, picture->width,
                                          picture->height, *colours, err);
    }
    if (!status) {
        texts t = {.n = 0};
        say_all(&t, facts);
        say(&t, "murkChannel", channel->name);
        say_made(&t, "murkColours", "viridis, %s, %.9g to %.9g%s%s",
                 colours->is_log ? "logarithmic" : "linear", colours->low,
                 colours->high, *channel->unit ? " " : "", channel->unit);
        status = murk_png_write(&raster, t.of, t.n, images->false_colour, err);
    }
    free(raster.rgb);
    free(list);
    return status;
}

murk_status murk_images_write(murk_image_files *images,
                              const murk_image *picture,
                              const murk_image_facts *facts, murk_error *err)
{
    murk_status status =
        images->exr ? write_exr(images, picture, facts, err) : MURK_OK;
    if (!status && images->png) {
        status = write_png(images, picture, facts, err);
    }
    if (!status && images->false_colour) {
        status = write_false_colour(images, picture, facts, err);
    }
    return status;
}
