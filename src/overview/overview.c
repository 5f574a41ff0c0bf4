/* Looks over a world before its light is traced: takes the facts of surfaces,
 * media, light sources, candidates, sensors and cameras from the stage, and the
 * numbers of photons and the memory of a run from a pilot run of few photons.
 * The facts are given as JSON and as lines of text. */
#include "overview/overview.h"

#include "overview/parts.h"
#include "overview/section_file.h"
#include "plan/few_photons.h"
#include "plan/free_space.h"
#include "plan/start_plan.h"
#include "results/candidates.h"
#include "results/condition_results.h"
#include "results/goals.h"
#include "results/tallies.h"
#include "scene/places.h"

#include <stdlib.h>

static void add_surfaces(cJSON *root, const murk_overview *o)
{
    const murk_scene_desc *scene = o->session->scene;
    cJSON *object = cJSON_AddObjectToObject(root, "surfaces");
    murk_json_number(object, "triangles", (double)o->surfaces.triangles);
    murk_json_number(object, "spheres", (double)o->surfaces.spheres);
    murk_json_number(object, "degenerate", (double)o->surfaces.degenerate);
    murk_json_number(object, "solids", (double)o->surfaces.solids);
    murk_json_number(object, "sheets", (double)o->surfaces.sheets);
    murk_json_number(object, "area_m2", o->surfaces.area_m2);
    /* Bounds are in the coordinates of the user. */
    const murk_box bounds = murk_scene_user_box(scene, o->surfaces.bounds_m);
    murk_json_box(object, "bounds", &bounds);
    /* The materials, with the area that each one has. */
    cJSON *materials = cJSON_AddArrayToObject(object, "materials");
    for (size_t i = 0; i < scene->n_materials; ++i) {
        const murk_scene_material *m = &scene->materials[i];
        cJSON *item = murk_json_item(materials);
        cJSON_AddStringToObject(item, "name", m->name);
        murk_json_number(
            item, "area_m2",
            murk_surfaces_material_area(o->session->stage->surfaces, i));
        murk_json_numbers(item, "diffuse", m->diffuse.band, scene->bands);
        murk_json_numbers(item, "specular", m->specular.band, scene->bands);
        murk_json_numbers(item, "transmit", m->transmit.band, scene->bands);
    }
}

/* The material that each material name in mesh files got. */
static void add_mesh_materials(cJSON *root, const murk_overview *o)
{
    const murk_scene_desc *scene = o->session->scene;
    cJSON *list = cJSON_AddArrayToObject(root, "mesh_materials");
    for (size_t i = 0; i < o->mesh_names; ++i) {
        const murk_mesh_material *m = &o->mesh_name[i];
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

cJSON *murk_overview_json(const murk_overview *o)
{
    const murk_stage *stage = o->session->stage;
    cJSON *root = murk_json_begin(o->session->scene);
    cJSON *domain = cJSON_AddObjectToObject(root, "domain");
    const murk_box box =
        murk_scene_user_box(stage->scene, stage->world.domain.box);
    murk_json_vector(domain, "min_m", box.min);
    murk_json_vector(domain, "max_m", box.max);
    cJSON_AddStringToObject(
        domain, "sides", stage->world.domain.is_periodic ? "periodic" : "open");
    /* Surfaces, media and lights. */
    add_surfaces(root, o);
    add_mesh_materials(root, o);
    murk_overview_json_ground(root, stage);
    murk_overview_json_media(root, stage);
    murk_overview_json_lights(root, stage);
    murk_overview_json_weather(root, stage);
    cJSON_AddItemToObject(
        root, "candidates",
        o->candidates
            ? murk_results_json(murk_results_list_candidates, o->candidates)
            : cJSON_CreateNull());
    murk_overview_json_sensor_types(root, o->session->scene, o->poses);
    murk_json_tallies(root, o->session);
    murk_overview_json_cameras(root, o->session->scene, &o->forecast);
    murk_overview_json_timeline(root, o->session->scene);
    murk_overview_json_forecast(root, o->session, o->poses, &o->forecast);
    if (o->ranks > 0) {
        murk_overview_json_ranks(root, o->session, o->poses, &o->forecast,
                                 o->ranks);
    }
    if (o->picture) {
        murk_section_file_json(root, o->picture, &o->section);
        murk_json_file(root, o->picture);
    }
    return root;
}

/* Prints a line for each material name in mesh files: the area with that name,
 * and the material of the scene that it got. */
static void print_mesh_materials(const murk_overview *o)
{
    const murk_scene_desc *scene = o->session->scene;
    for (size_t i = 0; i < o->mesh_names; ++i) {
        const murk_mesh_material *m = &o->mesh_name[i];
        murk_print("mesh name   %s of geometry %zu, %.4g m2: material %s%s\n",
                   *m->name ? m->name : "(none)", m->geometry, m->area_m2,
                   scene->materials[m->material].name,
                   m->is_forced  ? ", as the geometry says"
                   : m->is_named ? ""
                                 : ", as no entry has this name");
    }
}

void murk_overview_print(const void *of)
{
    const murk_overview *o = of;
    const murk_stage *stage = o->session->stage;
    const murk_scene_desc *scene = o->session->scene;
    const murk_domain *domain = &stage->world.domain;
    const murk_surfaces_facts *s = &o->surfaces;
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
    print_mesh_materials(o);
    murk_overview_print_ground(stage);
    murk_overview_print_media(stage);
    murk_overview_print_lights(stage);
    murk_overview_print_weather(stage);
    /* Candidates, sensors, tallies and cameras. */
    if (o->candidates) {
        murk_print_candidates(o->candidates);
        murk_overview_print_sensor_types(scene, o->poses);
    } else {
        murk_print("candidates  none: the scene has no sensors\n");
    }
    murk_print_asked_goals(scene);
    murk_print_asked_conditions(scene);
    murk_print_asked_tallies(o->session);
    murk_overview_print_cameras(scene, &o->forecast);
    murk_overview_print_timeline(scene);
    murk_overview_print_forecast(o->session, o->poses, &o->forecast);
    if (o->ranks > 0) {
        murk_overview_print_ranks(o->session, o->poses, &o->forecast, o->ranks);
    }
    if (o->picture) {
        const murk_vec3 cut = murk_scene_user(scene, o->section.cut);
        murk_print("picture     %s: cuts at x = %.*g, y = %.*g, z = %.*g m\n",
                   o->picture, digits, cut.x, digits, cut.y, digits, cut.z);
    }
}

murk_status murk_overview_make(murk_overview *out, const murk_session *session,
                               const murk_section_file *picture, unsigned ranks,
                               murk_error *err)
{
    const murk_scene_desc *scene = session->scene;
    const murk_stage *stage = session->stage;
    const unsigned threads = session->settings.threads;
    bool is_refused = false;
    *out = (murk_overview){
        .session = session, .ranks = ranks, .picture = picture->path};
    /* A picture that cannot be written is refused before the pilot run. */
    murk_status status =
        murk_section_file_check(picture, session->settings.force, err);
    if (!status) {
        out->surfaces = murk_surfaces_describe(stage->surfaces);
        status =
            murk_mesh_materials(&out->mesh_name, &out->mesh_names, stage, err);
    }
    /* A pilot run of few photons gives the forecast, and warnings. */
    if (!status) {
        status = murk_lightmap_forecast(&out->forecast, stage, 0, threads, err);
    }
    if (!status) {
        murk_overview_warn_of_cameras(scene, &out->forecast);
        murk_overview_warn_of_timeline(stage);
        murk_warn_of_escape(stage, out->forecast.escaped_share);
        murk_warn_of_thin_forecast(scene, &out->forecast);
    }
    /* Targets, candidates and poses, where the scene has them. */
    if (!status && scene->placement.targets.given) {
        status = murk_targets_check(stage, threads, err);
    }
    if (!status && scene->sensors.given) {
        status = murk_sites_find(&out->candidates, stage, threads, err);
        /* A picture may show why the candidates are refused, so it is drawn
         * before the failure is told. */
        is_refused = status == MURK_BAD_VALUE && picture->path;
        status = is_refused ? MURK_OK : status;
    }
    if (!status && out->candidates) {
        status = murk_poses_create(&out->poses, scene, &stage->world.domain,
                                   out->candidates->position,
                                   out->candidates->usable, err);
    }
    if (!status && out->candidates) {
        status = murk_warn_of_fixed_sensors(stage, threads, err);
    }
    if (!status && out->candidates) {
        status =
            murk_start_plan_match(out->poses, scene, &stage->world.domain, err);
    }
    if (!status && picture->path) {
        out->section =
            (murk_section_request){.stage = stage,
                                   .candidates = out->candidates,
                                   .escaped_share = out->forecast.escaped_share,
                                   .threads = threads};
        status = murk_section_file_write(picture, &out->section,
                                         session->run.command, err);
    }
    return is_refused ? MURK_BAD_VALUE : status; /* err has the first failure */
}

void murk_overview_release(murk_overview *overview)
{
    free(overview->mesh_name);
    murk_poses_destroy(overview->poses);
    murk_candidates_destroy(overview->candidates);
    *overview = (murk_overview){0};
}
