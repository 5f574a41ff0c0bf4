/* murk check: reads and builds a scene, and reports surfaces, media, lights,
 * candidates, sensors, cameras, doubtful points and the memory that a run
 * takes. */
#include "app/check.h"
#include "app/section_picture.h"
#include "app/session.h"
#include "base/file.h"
#include "base/machine.h"
#include "plan/few_photons.h"
#include "results/candidates.h"
#include "results/condition_results.h"
#include "results/goals.h"
#include "results/ownership.h"
#include "results/summary.h"
#include "results/tallies.h"
#include "results/version.h"
#include "scene/places.h"
#include "world/mesh_materials.h"

#include <stdlib.h>
#include <string.h>

/* Everything that check finds out, before it is printed one way or another. */
typedef struct findings {
    const murk_session *session;
    murk_surfaces_facts surfaces;
    murk_mesh_material *mesh_name; /* [mesh_names] */
    size_t mesh_names;
    murk_forecast forecast;
    murk_candidates *candidates;  /* NULL without sensors */
    murk_poses *poses;            /* likewise */
    const char *picture;          /* --picture; NULL: none */
    murk_section_request section; /* of the picture */
} findings;

/* The largest memory [bytes] of the coverage matrix for placement in a known
 * environment: for each photon and pose of a sensor one bit, or two bytes if
 * the scene has media. */
static double matrix_bytes(const findings *f)
{
    const double records = f->forecast.surface + f->forecast.volume;
    const double usable = f->poses ? (double)f->poses->count : 0;
    const bool dims = murk_media_any(f->session->stage->media);
    return records * usable * (dims ? 2 : 0.125);
}

static void add_surfaces(cJSON *root, const findings *f)
{
    const murk_scene_desc *scene = f->session->scene;
    cJSON *object = cJSON_AddObjectToObject(root, "surfaces");
    murk_json_number(object, "triangles", (double)f->surfaces.triangles);
    murk_json_number(object, "spheres", (double)f->surfaces.spheres);
    murk_json_number(object, "degenerate", (double)f->surfaces.degenerate);
    murk_json_number(object, "solids", (double)f->surfaces.solids);
    murk_json_number(object, "sheets", (double)f->surfaces.sheets);
    murk_json_number(object, "area_m2", f->surfaces.area_m2);
    /* Bounds are in the coordinates of the user. */
    const murk_box bounds = murk_scene_user_box(scene, f->surfaces.bounds_m);
    murk_json_box(object, "bounds", &bounds);
    /* The materials, with the area that each one has. */
    cJSON *materials = cJSON_AddArrayToObject(object, "materials");
    for (size_t i = 0; i < scene->n_materials; ++i) {
        const murk_scene_material *m = &scene->materials[i];
        cJSON *item = murk_json_item(materials);
        cJSON_AddStringToObject(item, "name", m->name);
        murk_json_number(
            item, "area_m2",
            murk_surfaces_material_area(f->session->stage->surfaces, i));
        murk_json_numbers(item, "diffuse", m->diffuse.band, scene->bands);
        murk_json_numbers(item, "specular", m->specular.band, scene->bands);
        murk_json_numbers(item, "transmit", m->transmit.band, scene->bands);
    }
}

/* The material that each material name in mesh files got. */
static void add_mesh_materials(cJSON *root, const findings *f)
{
    const murk_scene_desc *scene = f->session->scene;
    cJSON *list = cJSON_AddArrayToObject(root, "mesh_materials");
    for (size_t i = 0; i < f->mesh_names; ++i) {
        const murk_mesh_material *m = &f->mesh_name[i];
        cJSON *item = murk_json_item(list);
        murk_json_number(item, "geometry", (double)m->geometry);
        cJSON_AddStringToObject(item, "file",
                                scene->geometry[m->geometry].solid.mesh);
        cJSON_AddStringToObject(item, "name", m->name);
        murk_json_number(item, "area_m2", m->area_m2);
        cJSON_AddStringToObject(item, "material",
                                scene->materials[m->material].name);
    }
}

/* The planes of the picture, and of each view the rectangle in pixels with the
 * coordinates of its lower left corner. */
static void add_picture(cJSON *root, const findings *f)
{
    static const char *const names[MURK_SECTIONS] = {"plan", "front", "side"};
    const murk_scene_desc *scene = f->session->scene;
    cJSON *picture = cJSON_AddObjectToObject(root, "picture");
    cJSON_AddStringToObject(picture, "image", f->picture);
    murk_json_vector(picture, "cut_m", murk_scene_user(scene, f->section.cut));
    cJSON *sections = cJSON_AddArrayToObject(picture, "sections");
    for (int i = 0; i < MURK_SECTIONS; ++i) {
        const murk_section_view *v = &f->section.view[i];
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

static cJSON *check_json(const findings *f)
{
    const murk_stage *stage = f->session->stage;
    cJSON *root = murk_json_begin(f->session->scene);
    cJSON *domain = cJSON_AddObjectToObject(root, "domain");
    const murk_box box =
        murk_scene_user_box(stage->scene, stage->world.domain.box);
    murk_json_vector(domain, "min_m", box.min);
    murk_json_vector(domain, "max_m", box.max);
    cJSON_AddStringToObject(
        domain, "sides", stage->world.domain.is_periodic ? "periodic" : "open");
    /* Surfaces, media and lights. */
    add_surfaces(root, f);
    add_mesh_materials(root, f);
    murk_json_media(root, stage);
    murk_json_lights(root, stage);
    cJSON_AddItemToObject(
        root, "candidates",
        f->candidates
            ? murk_results_json(murk_results_list_candidates, f->candidates)
            : cJSON_CreateNull());
    murk_json_sensor_types(root, f->session->scene, f->poses);
    murk_json_tallies(root, f->session);
    murk_json_cameras(root, f->session->scene, &f->forecast);
    /* The forecast of a full run. */
    cJSON *forecast = cJSON_AddObjectToObject(root, "forecast");
    murk_json_number(forecast, "pilot_photons",
                     (double)f->forecast.pilot_photons);
    murk_json_number(forecast, "emitted", f->forecast.emitted);
    murk_json_number(forecast, "surface", f->forecast.surface);
    murk_json_number(forecast, "volume", f->forecast.volume);
    murk_json_number(forecast, "memory_bytes", f->forecast.memory_bytes);
    murk_json_number(forecast, "matrix_bytes_at_most", matrix_bytes(f));
    if (f->picture) {
        add_picture(root, f);
        murk_json_file(root, f->picture);
    }
    return root;
}

/* Prints a line for each material name in mesh files: the area with that name,
 * and the material of the scene that it got. */
static void print_mesh_materials(const findings *f)
{
    const murk_scene_desc *scene = f->session->scene;
    for (size_t i = 0; i < f->mesh_names; ++i) {
        const murk_mesh_material *m = &f->mesh_name[i];
        murk_print("mesh name   %s of geometry %zu, %.4g m2: material %s%s\n",
                   *m->name ? m->name : "(none)", m->geometry, m->area_m2,
                   scene->materials[m->material].name,
                   m->is_forced  ? ", as the geometry says"
                   : m->is_named ? ""
                                 : ", as no entry has this name");
    }
}

static void print_findings(const findings *f)
{
    const murk_stage *stage = f->session->stage;
    const murk_scene_desc *scene = f->session->scene;
    const murk_domain *domain = &stage->world.domain;
    const murk_surfaces_facts *s = &f->surfaces;
    murk_print("scene       %s: %d band%s, seed %u\n", scene->path,
               scene->bands, scene->bands > 1 ? "s" : "", scene->seed);
    const murk_box box = murk_scene_user_box(scene, domain->box);
    const int digits = murk_coordinate_digits(scene, 6);
    murk_print("domain      %.*g %.*g %.*g to %.*g %.*g %.*g m, %s sides\n",
               digits, box.min.x, digits, box.min.y, digits, box.min.z, digits,
               box.max.x, digits, box.max.y, digits, box.max.z,
               domain->is_periodic ? "periodic" : "open");
    if (digits > 6) {
        murk_print("origin      %.*g %.*g %.*g m: the world is computed about "
                   "this point\n",
                   digits, scene->origin.x, digits, scene->origin.y, digits,
                   scene->origin.z);
    }
    murk_print(
        "surfaces    %zu triangles, %zu spheres, %.4g m2; %zu solids, %zu "
        "sheets; %zu degenerate triangles left out\n",
        s->triangles, s->spheres, s->area_m2, s->solids, s->sheets,
        s->degenerate);
    for (size_t i = 0; i < scene->n_materials; ++i) {
        const murk_scene_material *m = &scene->materials[i];
        const double area_m2 = murk_surfaces_material_area(stage->surfaces, i);
        if (!(area_m2 > 0)) {
            continue; /* nothing is of it */
        }
        murk_print("material    %-12s %10.4g m2: diffuse %.3g, specular %.3g, "
                   "transmit %.3g\n",
                   m->name, area_m2, m->diffuse.band[0], m->specular.band[0],
                   m->transmit.band[0]);
    }
    print_mesh_materials(f);
    murk_print_media(stage);
    murk_print_lights(stage);
    /* Candidates, sensors, tallies and cameras. */
    if (f->candidates) {
        murk_print_candidates(f->candidates);
        murk_print_sensor_types(scene, f->poses);
    } else {
        murk_print("candidates  none: the scene has no sensors\n");
    }
    murk_print_asked_goals(scene);
    murk_print_asked_conditions(scene);
    murk_print_asked_tallies(f->session);
    murk_print_cameras(scene, &f->forecast);
    murk_print("forecast    %.3g photons emitted; stored: %.3g surface, %.3g "
               "volume (from a pilot of %llu photons)\n",
               f->forecast.emitted, f->forecast.surface, f->forecast.volume,
               (unsigned long long)f->forecast.pilot_photons);
    if (f->forecast.memory_bytes + matrix_bytes(f) >= 1e5) {
        murk_print("memory      about %.3g GB a map while tracing; to place in "
                   "a known environment at most %.3g GB more\n",
                   f->forecast.memory_bytes / 1e9, matrix_bytes(f) / 1e9);
    }
    if (f->picture) {
        const murk_vec3 cut = murk_scene_user(scene, f->section.cut);
        murk_print("picture     %s: cuts at x = %.*g, y = %.*g, z = %.*g m\n",
                   f->picture, digits, cut.x, digits, cut.y, digits, cut.z);
    }
}

/* ---- the picture ---- */

/* Checks the options of the picture, and whether its file may be written,
 * before the pilot run. */
static murk_status check_picture(const murk_options *options, murk_error *err)
{
    /* Options that mean nothing without a picture, and wrong values. */
    const char *path = murk_option_text(options, "--picture");
    const size_t length = path ? strlen(path) : 0;
    const size_t *pixels = options->render.pixels;
    if (!path) {
        return !options->section.has_cut && pixels[0] == 0
                   ? MURK_OK
                   : murk_fail(err, MURK_BAD_VALUE,
                               options->section.has_cut ? "--cut" : "--pixels",
                               "goes with --picture FILE.png only");
    }
    if (length < 5 || strcmp(path + length - 4, ".png") != 0) {
        return murk_fail(err, MURK_BAD_VALUE, "--picture",
                         "%s, must be the name of a file that ends in .png",
                         path);
    }
    if (pixels[0] > 0 && (pixels[0] < MURK_SECTION_WIDTH_MIN ||
                          pixels[1] < MURK_SECTION_HEIGHT_MIN)) {
        return murk_fail(err, MURK_BAD_VALUE, "--pixels",
                         "%zux%zu, must be %dx%d or more for plan, sections "
                         "and legend",
                         pixels[0], pixels[1], MURK_SECTION_WIDTH_MIN,
                         MURK_SECTION_HEIGHT_MIN);
    }
    /* Refuse a file that murk did not write, and a place where no file can be
     * made. */
    murk_file *file = NULL;
    murk_status status = murk_file_check_owner(
        path, MURK_MARK_IMAGE, sizeof MURK_MARK_IMAGE - 1, options->force, err);
    if (!status) {
        status = murk_file_create(&file, path, err);
    }
    murk_file_discard(file);
    return status;
}

static murk_status write_picture(findings *f, const murk_options *options,
                                 murk_error *err)
{
    const murk_scene_desc *scene = f->session->scene;
    const double *cut_m = options->section.cut_m;
    const murk_vec3 asked = murk_vec(cut_m[0], cut_m[1], cut_m[2]);
    murk_section_request *request = &f->section;
    *request = (murk_section_request){
        .stage = f->session->stage,
        .candidates = f->candidates,
        .has_cut = options->section.has_cut,
        .cut = murk_scene_local(scene, asked),
        .pixels = {options->render.pixels[0], options->render.pixels[1]},
        .escaped_share = f->forecast.escaped_share,
        .threads = options->threads};
    /* Targets are drawn as points. */
    murk_targets targets = {0};
    murk_canvas *canvas = NULL;
    murk_status status = MURK_OK;
    if (scene->placement.targets.given) {
        status = murk_targets_create(&targets, request->stage, 0,
                                     options->threads, err);
        request->targets = &targets;
    }
    /* Draw the picture, and write it with texts that say how it was made. */
    if (!status) {
        status = murk_section_picture_draw(&canvas, request, err);
    }
    if (!status) {
        const murk_image_text text[] = {
            {"software", "murk " MURK_VERSION},
            {MURK_MARK_IMAGE, murk_version_commit()},
            {"murkCommand", options->typed},
            {"murkScene", scene->path},
            {"murkSceneSha256", scene->sha256}};
        status = murk_png_write(murk_canvas_raster(canvas), text,
                                sizeof text / sizeof *text, f->picture, err);
    }
    murk_canvas_destroy(canvas);
    murk_targets_release(&targets);
    return status;
}

murk_status murk_command_check(const murk_options *options, murk_error *err)
{
    murk_session session;
    findings f = {.session = &session,
                  .picture = murk_option_text(options, "--picture")};
    murk_status status = murk_session_begin(&session, options, err);
    status = status ? status : check_picture(options, err);
    if (!status) {
        f.surfaces = murk_surfaces_describe(session.stage->surfaces);
        status = murk_mesh_materials(&f.mesh_name, &f.mesh_names, session.stage,
                                     err);
    }
    /* A pilot run of few photons gives the forecast, and warnings. */
    if (!status) {
        status = murk_lightmap_forecast(&f.forecast, session.stage, 0,
                                        options->threads, err);
    }
    if (!status) {
        murk_warn_of_cameras(session.scene, &f.forecast);
        murk_warn_of_escape(session.stage, f.forecast.escaped_share);
        murk_warn_of_thin_forecast(session.scene, &f.forecast);
    }
    /* Targets, candidates and poses, where the scene has them. */
    if (!status && session.scene->placement.targets.given) {
        status = murk_targets_check(session.stage, options->threads, err);
    }
    if (!status && session.scene->sensors.given) {
        status = murk_sites_find(&f.candidates, session.stage, options->threads,
                                 err);
    }
    if (!status && f.candidates) {
        status = murk_poses_create(
            &f.poses, session.scene, &session.stage->world.domain,
            f.candidates->position, f.candidates->usable, err);
    }
    /* The picture, and the report as JSON or as text. */
    if (!status && f.picture) {
        status = write_picture(&f, options, err);
    }
    if (!status && options->json) {
        status = murk_session_finish(&session, NULL, check_json(&f), NULL, NULL,
                                     err);
    } else if (!status && murk_session_speaks(&session)) {
        print_findings(&f);
    }
    free(f.mesh_name);
    murk_poses_destroy(f.poses);
    murk_candidates_destroy(f.candidates);
    murk_session_end(&session);
    return status;
}
