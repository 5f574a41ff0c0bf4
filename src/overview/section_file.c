/* Checks and writes the PNG file of plan and sections, with texts that say how
 * it was made. */
#include "overview/section_file.h"

#include "base/file.h"
#include "overview/section_picture.h"
#include "render/png.h"
#include "results/ownership.h"
#include "results/version.h"
#include "scene/places.h"

#include <string.h>

#define ENDING ".png"

/* ---- before any long work ---- */

static murk_status check_members(const murk_section_file *picture,
                                 murk_error *err)
{
    const char *path = picture->path;
    const size_t *pixels = picture->pixels;
    const bool has_pixels = pixels[0] > 0 || pixels[1] > 0;
    const size_t length = path ? strlen(path) : 0;
    const size_t ending = sizeof ENDING - 1;
    /* Planes and size mean nothing without a picture. */
    if (!path) {
        return !picture->cut_m && !has_pixels
                   ? MURK_OK
                   : murk_fail(err, MURK_BAD_VALUE,
                               picture->cut_m ? "cut_m" : "pixels",
                               "goes with options->picture only");
    }
    /* The name and the size. */
    if (length <= ending || strcmp(path + length - ending, ENDING) != 0) {
        return murk_fail(err, MURK_BAD_VALUE, "picture",
                         "%s, must be the name of a file that ends in .png",
                         path);
    }
    if (has_pixels && (pixels[0] < MURK_SECTION_WIDTH_MIN ||
                       pixels[1] < MURK_SECTION_HEIGHT_MIN)) {
        return murk_fail(err, MURK_BAD_VALUE, "pixels",
                         "%zux%zu, must be %dx%d or more for plan, sections "
                         "and legend",
                         pixels[0], pixels[1], MURK_SECTION_WIDTH_MIN,
                         MURK_SECTION_HEIGHT_MIN);
    }
    return MURK_OK;
}

murk_status murk_section_file_check(const murk_section_file *picture,
                                    bool replaces, murk_error *err)
{
    murk_status status = check_members(picture, err);
    if (status || !picture->path) {
        return status;
    }
    /* Refuse a file that murk did not write, and a place where no file can be
     * made. */
    murk_file *file = NULL;
    status = murk_file_check_owner(picture->path, MURK_MARK_IMAGE,
                                   sizeof MURK_MARK_IMAGE - 1, replaces, err);
    if (!status) {
        status = murk_file_create(&file, picture->path, err);
    }
    murk_file_discard(file);
    return status;
}

/* ---- the file ---- */

/* Writes a picture with texts that say how it was made. */
static murk_status write_png(murk_canvas *canvas, const char *path,
                             const murk_scene_desc *scene, const char *command,
                             murk_error *err)
{
    const murk_image_text all[] = {{"software", "murk " MURK_VERSION},
                                   {MURK_MARK_IMAGE, murk_version_commit()},
                                   {"murkCommand", command},
                                   {"murkScene", scene->path},
                                   {"murkSceneSha256", scene->sha256}};
    murk_image_text text[sizeof all / sizeof *all];
    size_t n = 0;
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) {
        if (all[i].text) { /* the command may be unknown */
            text[n++] = all[i];
        }
    }
    return murk_png_write(murk_canvas_raster(canvas), text, n, path, err);
}

murk_status murk_section_file_write(const murk_section_file *picture,
                                    murk_section_request *request,
                                    const char *command, murk_error *err)
{
    const murk_stage *stage = request->stage;
    const murk_scene_desc *scene = stage->scene;
    const double *cut_m = picture->cut_m;
    request->has_cut = cut_m != NULL;
    if (cut_m) {
        request->cut =
            murk_scene_local(scene, murk_vec(cut_m[0], cut_m[1], cut_m[2]));
    }
    memcpy(request->pixels, picture->pixels, sizeof request->pixels);
    /* Targets are drawn as points. */
    murk_targets targets = {0};
    murk_canvas *canvas = NULL;
    murk_status status = MURK_OK;
    if (scene->placement.targets.given) {
        status = murk_targets_create(&targets, stage, 0, request->threads, err);
        request->targets = &targets;
    }
    if (!status) {
        status = murk_section_picture_draw(&canvas, request, err);
    }
    if (!status) {
        status = write_png(canvas, picture->path, scene, command, err);
    }
    murk_canvas_destroy(canvas);
    murk_targets_release(&targets);
    request->targets = NULL;
    return status;
}

void murk_section_file_json(cJSON *root, const char *path,
                            const murk_section_request *request)
{
    static const char *const names[MURK_SECTIONS] = {"plan", "front", "side"};
    const murk_scene_desc *scene = request->stage->scene;
    cJSON *picture = cJSON_AddObjectToObject(root, "picture");
    cJSON_AddStringToObject(picture, "image", path);
    murk_json_vector(picture, "cut_m", murk_scene_user(scene, request->cut));
    cJSON *sections = cJSON_AddArrayToObject(picture, "sections");
    for (int i = 0; i < MURK_SECTIONS; ++i) {
        const murk_section_view *v = &request->view[i];
        const double low_m[] = {
            v->low[0] + murk_component(scene->origin, v->right),
            v->low[1] + murk_component(scene->origin, v->up)};
        cJSON *item = murk_json_item(sections);
        cJSON_AddStringToObject(item, "section", names[i]);
        murk_json_number(item, "left", v->left);
        murk_json_number(item, "top", v->top);
        murk_json_number(item, "width", v->width);
        murk_json_number(item, "height", v->height);
        murk_json_numbers(item, "low_m", low_m, 2);
        murk_json_number(item, "pixels_per_m", v->scale);
    }
}
