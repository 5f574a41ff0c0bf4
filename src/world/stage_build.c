/* Imports the files of a scene, and then builds the world of the photon tracer:
 * phase functions, domain, boundary meshes, surfaces, media, light sources,
 * goals and tallies. The order follows from the steps that use earlier ones:
 * boundary meshes use the domain; media use the phase functions, the domain and
 * the boundary meshes; light sources the media and the domain; goals the
 * surfaces and the domain; and tallies the domain. The checksum of every file
 * that the light depends on is appended to the light key. */
#include "world/stage_build.h"

#include "base/file.h"
#include "base/log.h"
#include "base/position.h"
#include "medium/interfaces.h"
#include "world/extent.h"
#include "world/file_sums.h"
#include "world/light_shares.h"
#include "world/mesh_files.h"
#include "world/scene_tallies.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Warn if the step of single precision is more than this share of the longest
 * edge of the bounding box of a mesh. The step is 2^-24 to 2^-23 of the largest
 * coordinate, so the step reaches this share if the largest coordinate is 84 to
 * 168 times the longest edge. */
#define STEP_WARNED 1e-5

static murk_status append_sum(murk_stage *stage, const uint64_t sum[2],
                              const char *where, murk_error *err)
{
    const size_t old = strlen(stage->light_key), added = 64;
    char *key = realloc(stage->light_key, old + added);
    if (!key) {
        return murk_no_memory(err, where, "for its sum");
    }
    snprintf(key + old, added, "checksum: %016" PRIx64 "%016" PRIx64 "\n",
             sum[1], sum[0]);
    stage->light_key = key;
    return MURK_OK;
}

/* Appends the checksum of a file to the light key. The key already contains the
 * name of the file without the folder, so a scene that is moved together with
 * its files keeps its key. Fails at `where` as murk_file_checksum() does, also
 * for a file larger than MURK_SUM_BYTES_MAX (world/file_sums.h), or with
 * MURK_NO_MEMORY. */
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
    return append_sum(stage, sum, where, err);
}

/* The vertices of a mesh are stored in single precision. Fails if the rounding
 * step at the largest coordinate exceeds the clearance that candidate sites of
 * sensors must keep from surfaces, because visibility is then unknown; not if
 * the scene has no sensors or the clearance is 0. Otherwise warns if the step
 * is more than STEP_WARNED of the extent of the mesh. */
static murk_status check_step(const murk_scene_desc *scene,
                              const murk_mesh *mesh, const murk_mesh_file *file,
                              murk_error *err)
{
    /* The clearance, the step and the longest edge of the bounding box, all
     * after the scale of the mesh. */
    const double clearance_m =
        scene->sensors.given ? scene->sensors.candidates.clearance_m : 0;
    const double step_m = mesh->step_m * file->scale;
    const murk_vec3 size = murk_sub(mesh->bounds_m.max, mesh->bounds_m.min);
    const double longest_m = fmax(size.x, fmax(size.y, size.z)) * file->scale;
    /* Refuse or warn. */
    if (clearance_m > 0 && step_m > clearance_m) {
        return murk_fail(err, MURK_BAD_VALUE, file->where,
                         "%s is read in single precision, whose step at its "
                         "coordinates is %.3g m, more than clearance_m, %g m: "
                         "bring the mesh nearer to 0 and give translate_m, or "
                         "write it as OBJ or PLY with text or doubles",
                         file->path, step_m, clearance_m);
    }
    if (step_m > STEP_WARNED * longest_m) {
        murk_warn(file->where,
                  "%s is read in single precision, whose step at its "
                  "coordinates is %.3g m: bring the mesh nearer to 0 and give "
                  "translate_m, or write it as OBJ or PLY with text or doubles",
                  file->path, step_m);
    }
    return MURK_OK;
}

/* The number of those items in the list of mesh files (world/mesh_files.h) that
 * the light depends on, geometry and regions; these items come first. */
static size_t lit_meshes(const murk_scene_desc *scene)
{
    return scene->geometries + scene->n_regions;
}

/* Imports the mesh files of the items [first, last) of the list of
 * world/mesh_files.h. For files that the light depends on, the checksum is
 * appended to the light key, and the step of single precision is checked. */
static murk_status import_meshes(murk_stage *stage, size_t first, size_t last,
                                 murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    murk_status status = MURK_OK;
    for (size_t i = first; i < last && !status; ++i) {
        const murk_mesh_file f = murk_mesh_file_at(scene, i);
        const bool is_lit = i < lit_meshes(scene);
        if (f.path && is_lit) {
            status = add_checksum(stage, f.path, f.where, err);
        }
        if (f.path && !status) {
            status = murk_mesh_read(&stage->mesh[i], f.path, &f.import, f.where,
                                    err);
        }
        if (f.path && !status && is_lit) {
            status = check_step(scene, stage->mesh[i], &f, err);
        }
    }
    return status;
}

/* Imports the meshes and grids that the light depends on and appends the
 * checksums of their files to the light key. make_phases() appends the
 * checksums of tables of phase functions. */
static murk_status import_world(murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    murk_status status = import_meshes(stage, 0, lit_meshes(scene), err);
    /* Files of media: checksums first, then the grids themselves. */
    for (size_t i = 0; i < scene->n_media && !status; ++i) {
        const char *file[MURK_FILLING_FILES] = {NULL};
        const char *where = scene->media[i].where;
        status = murk_fillings_files(scene, i, file, err);
        for (int k = 0; k < MURK_FILLING_FILES && !status; ++k) {
            status =
                file[k] ? add_checksum(stage, file[k], where, err) : MURK_OK;
        }
    }
    return status ? status : murk_fillings_create(&stage->fillings, scene, err);
}

/* Borrows the meshes of geometry and regions and the fillings of the stage
 * `other`, and copies the checksums of these files from its light key. `other`
 * must not be built yet, because building appends the checksums of tables of
 * phase functions. */
static murk_status borrow_world(murk_stage *stage, const murk_stage *other,
                                murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    const char *sums = other->light_key + strlen(other->scene->light_key);
    const size_t size = strlen(stage->light_key) + strlen(sums) + 1;
    char *key = realloc(stage->light_key, size);
    if (!key) {
        return murk_no_memory(err, scene->path, "for the world");
    }
    strcat(key, sums);
    stage->light_key = key;
    stage->borrows = true;
    stage->fillings = other->fillings;
    memcpy(stage->mesh, other->mesh, lit_meshes(scene) * sizeof *stage->mesh);
    return MURK_OK;
}

/* Builds the phase functions; checksums of tables in files are appended to the
 * light key. */
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
        status = murk_no_memory(err, scene->path, "for the surfaces");
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
    /* Geometry that moves stays within the domain, so that what it does not
     * touch keeps its bits. */
    status = murk_surfaces_create_within(
        &stage->surfaces, surface, scene->geometries, material,
        scene->n_materials,
        scene->timeline.given ? &stage->world.domain.box : NULL, err);
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

/* If powers change in the course of a timeline, deals photons by the shares
 * that light sources have at all times, so that each photon starts from the
 * same light source at all of them. The light depends on these shares, so their
 * checksum is appended to the light key. */
static murk_status deal_over_time(murk_stage *stage, murk_error *err)
{
    double *share = NULL;
    murk_status status = murk_light_shares(&share, stage->scene, stage->lights,
                                           &stage->world.domain, err);
    if (!status && share) {
        uint64_t sum[2];
        murk_checksum(
            share, murk_sources_channels(stage->lights) * sizeof *share, sum);
        status = murk_sources_deal_by(stage->lights, share, err);
        if (!status) {
            status = append_sum(stage, sum, stage->scene->path, err);
        }
    }
    free(share);
    return status;
}

static murk_status build_lights(murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    /* If the media continue outside, light passes through them on the way to a
     * portal. This way is taken to be straight, but a change of the index of
     * refraction would bend it: such scenes are refused. */
    for (size_t i = 0; i < scene->n_lights; ++i) {
        if (scene->lights[i].portals > 0 && scene->continues &&
            murk_media_bends(stage->media)) {
            return murk_fail(err, MURK_UNSUPPORTED, scene->lights[i].where,
                             "aim: portals beside a region with an ior do "
                             "not go with domain.outside: continued, use "
                             "outside: empty or sides: periodic, or leave "
                             "aim out");
        }
    }
    stage->sky = calloc(scene->n_lights + 1, sizeof *stage->sky);
    if (!stage->sky) {
        return murk_no_memory(err, scene->path, "for the lights");
    }
    /* Convert the light sources, and create them in the domain. */
    murk_source *light = NULL;
    murk_status status = murk_sky_lights(&light, stage->sky, scene, err);
    if (!status) {
        status = murk_sources_create(&stage->lights, light, scene->n_lights,
                                     scene->bands, &stage->world.domain, err);
    }
    free(light);
    return status ? status : deal_over_time(stage, err);
}

murk_status murk_stage_import_beside(murk_stage **out,
                                     const murk_scene_desc *scene,
                                     const murk_stage *other, murk_error *err)
{
    murk_status status = MURK_OK;
    murk_stage *stage = calloc(1, sizeof *stage);
    if (!stage) {
        return murk_no_memory(err, scene->path, "for the world");
    }
    /* Allocate. The origin of the scene is set for positions in messages. */
    stage->scene = scene;
    murk_position_origin(scene->origin);
    const size_t meshes = murk_mesh_files_count(scene);
    stage->mesh = calloc(meshes, sizeof *stage->mesh);
    stage->light_key = strdup(scene->light_key);
    if (!stage->mesh || !stage->light_key) {
        status = murk_no_memory(err, scene->path, "for the world");
    } else {
        stage->region_mesh = stage->mesh + scene->geometries;
        stage->goal_mesh = stage->region_mesh + scene->n_regions;
        stage->zone_mesh = stage->goal_mesh + scene->placement.n_interests + 1;
        /* Read files, or borrow them. */
        status =
            other ? borrow_world(stage, other, err) : import_world(stage, err);
    }
    /* Read the files of goals and zones. */
    if (!status) {
        status = import_meshes(stage, lit_meshes(scene), meshes, err);
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
    return murk_stage_import_beside(out, scene, NULL, err);
}

murk_status murk_stage_build(murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    murk_position_origin(scene->origin);
    /* Build each part; later parts use earlier ones. */
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
        status = murk_goals_create(&stage->goals, scene, stage->goal_mesh,
                                   stage->surfaces, &stage->world.domain, err);
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

void murk_stage_destroy(murk_stage *stage)
{
    if (!stage) {
        return;
    }
    murk_goals_destroy(stage->goals);
    murk_sources_destroy(stage->lights);
    murk_media_destroy(stage->media);
    murk_phases_destroy(stage->phases);
    murk_boundary_meshes_destroy(stage->boundary_meshes);
    murk_surfaces_destroy(stage->surfaces);
    /* Of the meshes, a stage that borrows owns only those of goals and zones.
     */
    size_t i = stage->borrows ? lit_meshes(stage->scene) : 0;
    for (; stage->mesh && i < murk_mesh_files_count(stage->scene); ++i) {
        murk_mesh_destroy(stage->mesh[i]);
    }
    if (!stage->borrows) {
        murk_fillings_destroy(stage->fillings);
    }
    free(stage->light_key);
    free(stage->tally);
    free(stage->sky);
    free(stage->mesh);
    free(stage);
}
