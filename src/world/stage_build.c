/* Imports the files of a scene and builds the world of the photon tracer from
 * it: phase functions, domain, boundary meshes, surfaces, media, light sources,
 * goals and tallies, in this order, because each step uses earlier ones. Every
 * file that the light depends on adds its checksum to the light key. */
#include "world/stage_build.h"

#include "base/file.h"
#include "base/log.h"
#include "base/position.h"
#include "medium/interfaces.h"
#include "world/boundary_files.h"
#include "world/extent.h"
#include "world/file_sums.h"
#include "world/scene_tallies.h"
#include "world/stage_media.h"
#include "world/stage_notes.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Warn if the step of single precision is more than this share of the extent of
 * a mesh. A mesh that lies 160 times its extent from the origin reaches it (160
 * * 2^-24 = 1e-5). */
#define STEP_WARNED 1e-5

/* Appends the checksum of a file to the light key. The key has the name of the
 * file already, without its folder, so that a scene may be moved together with
 * its files. */
static murk_status add_checksum(murk_stage *stage, const char *path,
                                const char *where, murk_error *err)
{
    uint64_t sum[2];
    murk_error cause = {0};
    const murk_status status =
        murk_file_checksum(path, MURK_SUM_BYTES_MAX, sum, &cause);
    if (status) {
        return murk_fail(err, status, where, "%s: %s", path, cause.text);
    }
    const size_t old = strlen(stage->light_key), added = 64;
    char *key = realloc(stage->light_key, old + added);
    if (!key) {
        return murk_fail(err, MURK_NO_MEMORY, where, "no memory for its sum");
    }
    snprintf(key + old, added, "checksum: %016" PRIx64 "%016" PRIx64 "\n",
             sum[1], sum[0]);
    stage->light_key = key;
    return MURK_OK;
}

/* A mesh file is read in single precision. Fails if the rounding step is larger
 * than the clearance that sensors must keep from surfaces, because visibility
 * is then unknown. Warns if the step is a noticeable share of the extent of the
 * mesh. */
static murk_status check_step(const murk_scene_desc *scene,
                              const murk_mesh *mesh, const char *file,
                              double scale, const char *where, murk_error *err)
{
    /* The step, the clearance and the extent, all in world units. */
    const double clearance_m =
        scene->sensors.given ? scene->sensors.candidates.clearance_m : 0;
    const double step_m = mesh->step_m * scale;
    const murk_vec3 size = murk_sub(mesh->bounds_m.max, mesh->bounds_m.min);
    const double longest_m = fmax(size.x, fmax(size.y, size.z)) * scale;
    /* Refuse or warn. */
    if (clearance_m > 0 && step_m > clearance_m) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "%s is read in single precision, whose step at its "
                         "coordinates is %.3g m, more than clearance_m, %g m: "
                         "bring the mesh nearer to 0 and give translate_m, or "
                         "write it as OBJ or PLY with text or doubles",
                         file, step_m, clearance_m);
    }
    if (step_m > STEP_WARNED * longest_m) {
        murk_warn(where,
                  "%s is read in single precision, whose step at its "
                  "coordinates is %.3g m: bring the mesh nearer to 0 and give "
                  "translate_m, or write it as OBJ or PLY with text or doubles",
                  file, step_m);
    }
    return MURK_OK;
}

/* Imports a mesh file, adds it to the light key and checks its precision. */
static murk_status import_mesh(murk_stage *stage, murk_mesh **out,
                               const char *file, const murk_mesh_import *import,
                               double scale, const char *where, murk_error *err)
{
    murk_status status = add_checksum(stage, file, where, err);
    if (!status) {
        status = murk_mesh_read(out, file, import, where, err);
    }
    return status ? status
                  : check_step(stage->scene, *out, file, scale, where, err);
}

/* Imports the meshes and grids of the scene and completes the light key. */
static murk_status import_world(murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    murk_status status = MURK_OK;
    /* Meshes of geometry. */
    for (size_t i = 0; i < scene->geometries && !status; ++i) {
        const murk_scene_geometry *g = &scene->geometry[i];
        if (g->shape == MURK_SHAPE_MESH) {
            const murk_mesh_import import = {.unit_m = g->solid.unit_m,
                                             .up = g->solid.up,
                                             .allow = g->allow};
            status = import_mesh(stage, &stage->mesh[i], g->solid.mesh, &import,
                                 g->solid.scale, g->where, err);
        }
    }
    /* Meshes of regions. */
    for (size_t i = 0; i < scene->n_regions && !status; ++i) {
        const murk_scene_region *r = &scene->regions[i];
        if (r->shape == MURK_REGION_MESH) {
            const murk_mesh_import import = {.unit_m = r->solid.unit_m,
                                             .up = r->solid.up};
            status = import_mesh(stage, &stage->region_mesh[i], r->solid.mesh,
                                 &import, r->solid.scale, r->where, err);
        }
    }
    /* Files of media: checksums first, then the grids themselves. */
    for (size_t i = 0; i < scene->n_media && !status; ++i) {
        const char *file[2] = {NULL, NULL}, *where = scene->media[i].where;
        status = murk_fillings_files(scene, i, file, err);
        for (int k = 0; k < 2 && !status; ++k) {
            status =
                file[k] ? add_checksum(stage, file[k], where, err) : MURK_OK;
        }
    }
    return status ? status : murk_fillings_create(&stage->fillings, scene, err);
}

/* Takes meshes, grids and checksums from another stage. */
static murk_status borrow_world(murk_stage *stage, const murk_stage *other,
                                murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    const char *sums = other->light_key + strlen(other->scene->light_key);
    const size_t size = strlen(stage->light_key) + strlen(sums) + 1;
    char *key = realloc(stage->light_key, size);
    if (!key) {
        return murk_fail(err, MURK_NO_MEMORY, scene->path,
                         "no memory for the world");
    }
    strcat(key, sums);
    stage->light_key = key;
    stage->borrows = true;
    stage->fillings = other->fillings;
    memcpy(stage->mesh, other->mesh, scene->geometries * sizeof *stage->mesh);
    memcpy(stage->region_mesh, other->region_mesh,
           scene->n_regions * sizeof *stage->region_mesh);
    return MURK_OK;
}

/* Reads the phase functions; tables in files enter the light key. */
static murk_status make_phases(murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < scene->n_media; ++i) {
        const murk_scene_medium *m = &scene->media[i];
        for (size_t k = 0; k < m->n_phases && !status; ++k) {
            if (m->phase[k].table) {
                status = add_checksum(stage, m->phase[k].table,
                                      m->phase[k].where, err);
            }
        }
    }
    return status ? status : murk_phases_create(&stage->phases, scene, err);
}

static murk_surface_desc surface_of(const murk_scene_geometry *g,
                                    const murk_mesh *mesh)
{
    return (murk_surface_desc){.shape = g->shape,
                               .mesh = mesh,
                               .box = g->solid.box,
                               .corner = g->corner,
                               .edge1 = g->edge1,
                               .edge2 = g->edge2,
                               .center = g->solid.center,
                               .radius_m = g->solid.radius_m,
                               .to_world = murk_scene_placed(&g->solid),
                               .material = g->material,
                               .where = g->where};
}

static murk_status build_surfaces(murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    /* Convert geometry and materials. */
    murk_surface_desc *surface = calloc(scene->geometries + 1, sizeof *surface);
    murk_material *material = calloc(scene->n_materials, sizeof *material);
    murk_status status = MURK_OK;
    if (!surface || !material) {
        status = murk_fail(err, MURK_NO_MEMORY, scene->path,
                           "no memory for the surfaces");
        goto done;
    }
    for (size_t i = 0; i < scene->geometries; ++i) {
        surface[i] = surface_of(&scene->geometry[i], stage->mesh[i]);
    }
    for (size_t i = 0; i < scene->n_materials; ++i) {
        const murk_scene_material *m = &scene->materials[i];
        material[i] = (murk_material){.diffuse = m->diffuse,
                                      .specular = m->specular,
                                      .transmit = m->transmit,
                                      .ior = m->ior};
        memcpy(material[i].name, m->name, sizeof material[i].name);
    }
    status = murk_surfaces_create(&stage->surfaces, surface, scene->geometries,
                                  material, scene->n_materials, err);
done:
    free(surface);
    free(material);
    return status;
}

static murk_status build_media(murk_stage *stage, murk_error *err)
{
    const murk_status status =
        murk_stage_media(&stage->media, stage, stage->scene, stage->fillings,
                         stage->phases, err);
    return !status && stage->scene->by_delta
               ? murk_media_prepare_delta(stage->media, err)
               : status;
}

/* The portals of all light sources, one after the other. The caller owns the
 * array. */
static murk_portal *portals_of(const murk_scene_desc *scene)
{
    size_t n = 0;
    for (size_t i = 0; i < scene->n_lights; ++i) {
        n += scene->lights[i].portals;
    }
    murk_portal *portal = calloc(n + 1, sizeof *portal);
    n = 0;
    for (size_t i = 0; portal && i < scene->n_lights; ++i) {
        for (size_t k = 0; k < scene->lights[i].portals; ++k) {
            const murk_scene_portal *p = &scene->lights[i].portal[k];
            portal[n++] = (murk_portal){p->corner, p->edge1, p->edge2};
        }
    }
    return portal;
}

static murk_status build_lights(murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    murk_source *light = calloc(scene->n_lights + 1, sizeof *light);
    murk_portal *portal = portals_of(scene), *next = portal;
    stage->sky = calloc(scene->n_lights + 1, sizeof *stage->sky);
    murk_status status = MURK_OK;
    if (!light || !portal || !stage->sky) {
        status = murk_fail(err, MURK_NO_MEMORY, scene->path,
                           "no memory for the lights");
        goto done;
    }
    /* Convert each light source, with the portals that belong to it. */
    for (size_t i = 0; i < scene->n_lights && !status; ++i) {
        if (scene->lights[i].portals > 0 && scene->continues &&
            murk_media_bends(stage->media)) {
            /* The path to a portal is taken to be straight, but refraction
             * would bend it. */
            status = murk_fail(err, MURK_UNSUPPORTED, scene->lights[i].where,
                               "aim: portals beside a region with an ior do "
                               "not go with domain.outside: continued, use "
                               "outside: empty or sides: periodic, or leave "
                               "aim out");
            break;
        }
        status = murk_sky_light(&light[i], &stage->sky[i], scene, i, err);
        light[i].portal = next;
        light[i].portals = scene->lights[i].portals;
        next += light[i].portals;
    }
    /* Create the sources in the domain. */
    if (!status) {
        status = murk_sources_create(&stage->lights, light, scene->n_lights,
                                     scene->bands, &stage->world.domain, err);
    }
done:
    free(light);
    free(portal);
    return status;
}

/* Imports a scene; other is NULL, or the stage whose meshes and grids are
 * borrowed. */
static murk_status import(murk_stage **out, const murk_scene_desc *scene,
                          const murk_stage *other, murk_error *err)
{
    murk_status status = MURK_OK;
    murk_stage *stage = calloc(1, sizeof *stage);
    if (!stage) {
        return murk_fail(err, MURK_NO_MEMORY, scene->path,
                         "no memory for the world");
    }
    /* Allocate; messages about positions use the origin of the scene. */
    stage->scene = scene;
    murk_position_origin(scene->origin);
    stage->mesh = calloc(scene->geometries + 1, sizeof *stage->mesh);
    stage->region_mesh =
        calloc(scene->n_regions + 1, sizeof *stage->region_mesh);
    stage->light_key = strdup(scene->light_key);
    if (!stage->mesh || !stage->region_mesh || !stage->light_key) {
        status = murk_fail(err, MURK_NO_MEMORY, scene->path,
                           "no memory for the world");
    } else {
        /* Read files, or borrow them. */
        status =
            other ? borrow_world(stage, other, err) : import_world(stage, err);
    }
    /* Read the files of goals and zones. */
    if (!status) {
        status = murk_goals_import(&stage->goals, scene, err);
    }
    if (!status) {
        status = murk_site_meshes_read(&stage->site_meshes, scene, err);
    }
    if (status) {
        murk_stage_destroy(stage);
        return status;
    }
    stage->grid = stage->fillings->grid;
    *out = stage;
    return MURK_OK;
}

murk_status murk_stage_import(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err)
{
    return import(out, scene, NULL, err);
}

murk_status murk_stage_import_beside(murk_stage **out,
                                     const murk_scene_desc *scene,
                                     const murk_stage *other, murk_error *err)
{
    return import(out, scene, other, err);
}

murk_status murk_stage_build(murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    murk_position_origin(scene->origin);
    /* Build each part from those before it. */
    murk_status status = make_phases(stage, err);
    if (!status) {
        status = murk_extent_domain(&stage->world.domain, scene, stage->mesh,
                                    stage->grid, stage->region_mesh, err);
    }
    if (!status) {
        status = murk_stage_boundary_meshes(&stage->boundary_meshes, scene,
                                            stage->region_mesh,
                                            &stage->world.domain.box, err);
    }
    if (!status) {
        status = build_surfaces(stage, err);
    }
    if (!status) {
        status = build_media(stage, err);
    }
    if (!status) {
        status = build_lights(stage, err);
    }
    if (!status) {
        status = murk_goals_build(stage->goals, stage->surfaces,
                                  &stage->world.domain, err);
    }
    if (!status) {
        status =
            murk_tallies_asked(&stage->tally, scene, &stage->world.domain, err);
    }
    if (status) {
        return status;
    }
    /* Assemble the world of the photon tracer. */
    stage->world.surfaces = stage->surfaces;
    stage->world.media = stage->media;
    stage->world.boundary_meshes = stage->boundary_meshes;
    stage->world.lights = stage->lights;
    stage->world.bands = scene->bands;
    stage->world.continues = scene->continues && !scene->domain.is_periodic;
    murk_stage_warn(stage);
    return MURK_OK;
}

murk_status murk_stage_create(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err)
{
    murk_stage *stage = NULL;
    murk_status status = murk_stage_import(&stage, scene, err);
    if (!status) {
        status = murk_stage_build(stage, err);
    }
    if (status) {
        murk_stage_destroy(stage);
        return status;
    }
    *out = stage;
    return MURK_OK;
}

/* Frees what a borrowing stage does not own. */
static void destroy_world(murk_stage *stage)
{
    murk_fillings_destroy(stage->fillings);
    for (size_t i = 0; stage->mesh && i < stage->scene->geometries; ++i) {
        murk_mesh_destroy(stage->mesh[i]);
    }
    for (size_t i = 0; stage->region_mesh && i < stage->scene->n_regions; ++i) {
        murk_mesh_destroy(stage->region_mesh[i]);
    }
}

void murk_stage_destroy(murk_stage *stage)
{
    if (!stage) {
        return;
    }
    murk_goals_destroy(stage->goals);
    murk_site_meshes_destroy(stage->site_meshes);
    murk_sources_destroy(stage->lights);
    murk_media_destroy(stage->media);
    murk_phases_destroy(stage->phases);
    murk_boundary_meshes_destroy(stage->boundary_meshes);
    murk_surfaces_destroy(stage->surfaces);
    if (!stage->borrows) {
        destroy_world(stage);
    }
    free(stage->light_key);
    free(stage->tally);
    free(stage->sky);
    free(stage->region_mesh);
    free(stage->mesh);
    free(stage);
}
