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
#include "scene/medium_preset.h"
#include "scene/print.h"
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

static murk_status append_text(murk_stage *stage, const char *text,
                               const char *where, murk_error *err)
{
    const size_t old = strlen(stage->light_key), added = strlen(text) + 1;
    char *key = realloc(stage->light_key, old + added);
    if (!key) {
        return murk_no_memory(err, where, "for its sum");
    }
    memcpy(key + old, text, added);
    stage->light_key = key;
    return MURK_OK;
}

static murk_status append_sum(murk_stage *stage, const uint64_t sum[2],
                              const char *where, murk_error *err)
{
    char text[64];
    snprintf(text, sizeof text, "checksum: %016" PRIx64 "%016" PRIx64 "\n",
             sum[1], sum[0]);
    return append_text(stage, text, where, err);
}

/* Computes the checksum of a file and appends it to the light key. The key
 * already contains the name of the file without the folder, so a scene that is
 * moved together with its files keeps its key. Fails at `where` as
 * murk_file_checksum() does, also for a file larger than MURK_SUM_BYTES_MAX
 * (world/file_sums.h), or with MURK_NO_MEMORY. */
static murk_status add_checksum(murk_stage *stage, uint64_t sum[2],
                                const char *path, const char *where,
                                murk_error *err)
{
    murk_error cause = {0};
    const murk_status status =
        murk_file_checksum(path, MURK_SUM_BYTES_MAX, sum, &cause);
    if (status) {
        return murk_fail(err, status, where, "%s: %s", path, cause.text);
    }
    return append_sum(stage, sum, where, err);
}

/* Appends the checksum of what was read of a mesh to the light key, if its file
 * names others, which have no checksum in the key. */
static murk_status add_mesh_sum(murk_stage *stage, const murk_mesh *mesh,
                                const char *where, murk_error *err)
{
    uint64_t sum[2];
    if (!mesh->names_others) {
        return MURK_OK;
    }
    murk_mesh_checksum(mesh, sum);
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

static bool is_same_text(const char *a, const char *b)
{
    return a == b || (a && b && strcmp(a, b) == 0);
}

/* The mesh of `earlier`, NULL: none, that was imported from this file with this
 * checksum in the same way, as a further owner. NULL if there is none, or if
 * the mesh may have changed without the file. */
static murk_mesh *share_mesh(const murk_stage *earlier,
                             const murk_mesh_file *file, const uint64_t sum[2])
{
    for (size_t i = 0; earlier && i < lit_meshes(earlier->scene); ++i) {
        const murk_mesh_file f = murk_mesh_file_at(earlier->scene, i);
        if (f.path && is_same_text(f.path, file->path) &&
            memcmp(earlier->mesh_sum[i], sum, 2 * sizeof *sum) == 0 &&
            f.import.unit_m == file->import.unit_m &&
            f.import.up == file->import.up &&
            f.import.is_fds == file->import.is_fds &&
            f.import.fds_time_s == file->import.fds_time_s &&
            f.import.is_geotiff == file->import.is_geotiff &&
            murk_geotiff_is_same(&f.import.geotiff, &file->import.geotiff) &&
            is_same_text(f.import.allow, file->import.allow) &&
            !earlier->mesh[i]->names_others) {
            return murk_mesh_share(earlier->mesh[i]);
        }
    }
    return NULL;
}

/* Imports the mesh files of the items [first, last) of the list of
 * world/mesh_files.h, or shares them with `earlier`. For files that the light
 * depends on, the checksum is appended to the light key, and the step of single
 * precision is checked. */
static murk_status import_meshes(murk_stage *stage, const murk_stage *earlier,
                                 size_t first, size_t last, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    murk_status status = MURK_OK;
    for (size_t i = first; i < last && !status; ++i) {
        const murk_mesh_file f = murk_mesh_file_at(scene, i);
        const bool is_lit = i < lit_meshes(scene);
        uint64_t *sum = stage->mesh_sum[i];
        /* The checksum of the file, then what is in it. */
        if (f.path && is_lit) {
            status = add_checksum(stage, sum, f.path, f.where, err);
        }
        if (f.path && is_lit && !status) {
            stage->mesh[i] = share_mesh(earlier, &f, sum);
        }
        if (f.path && !stage->mesh[i] && !status) {
            status = murk_mesh_read(&stage->mesh[i], f.path, &f.import, f.where,
                                    err);
        }
        if (f.path && !status && is_lit) {
            status = add_mesh_sum(stage, stage->mesh[i], f.where, err);
        }
        if (f.path && !status && is_lit) {
            status = check_step(scene, stage->mesh[i], &f, err);
        }
    }
    return status;
}

/* True if the grids of two media are made in the same way of files that are the
 * same if all checksums are. False for FDS runs, of whose many files none has a
 * checksum here. */
static bool has_same_grids(const murk_scene_medium *m,
                           const murk_scene_medium *of)
{
    return !m->fds && !of->fds && !m->netcdf && !of->netcdf &&
           !m->vdb == !of->vdb && !m->vdb_next == !of->vdb_next &&
           !m->albedo_grid == !of->albedo_grid &&
           is_same_text(m->grid, of->grid) &&
           is_same_text(m->albedo_grid, of->albedo_grid) &&
           (!m->vdb_next || m->next_weight == of->next_weight) &&
           is_same_text(m->albedo_vdb, m->vdb) ==
               is_same_text(of->albedo_vdb, of->vdb);
}

/* The number of the medium of `earlier`, NULL: none, whose grids are those of
 * medium i; MURK_NOT_SHARED if there is none. */
static size_t find_filling(const murk_stage *stage, const murk_stage *earlier,
                           size_t i)
{
    const size_t files = MURK_FILLING_FILES;
    for (size_t k = 0; earlier && k < earlier->scene->n_media; ++k) {
        if (has_same_grids(&stage->scene->media[i],
                           &earlier->scene->media[k]) &&
            memcmp(stage->filling_sum[files * i],
                   earlier->filling_sum[files * k],
                   files * sizeof *stage->filling_sum) == 0) {
            return k;
        }
    }
    return MURK_NOT_SHARED;
}

/* Appends the checksums of rectilinear grids to the light key: those of the
 * values, because the files of a simulation hold many times and quantities. */
static murk_status append_field_sums(murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < scene->n_media && !status; ++i) {
        const murk_grid *grid = stage->fillings->grid[i];
        const murk_grid_facts *facts = grid ? murk_grid_describe(grid) : NULL;
        if (facts && facts->blocks > 0) {
            status =
                append_sum(stage, facts->checksum, scene->media[i].where, err);
        }
    }
    return status;
}

/* Imports the meshes and grids that the light depends on, or shares them with
 * `earlier`, and appends the checksums of their files to the light key.
 * make_phases() appends the checksums of tables of phase functions. */
static murk_status import_world(murk_stage *stage, const murk_stage *earlier,
                                murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    size_t *from = calloc(scene->n_media + 1, sizeof *from);
    murk_status status =
        from ? import_meshes(stage, earlier, 0, lit_meshes(scene), err)
             : murk_no_memory(err, scene->path, "for the world");
    /* Files of media: checksums first, then the grids themselves. */
    for (size_t i = 0; i < scene->n_media && !status; ++i) {
        const char *file[MURK_FILLING_FILES] = {NULL};
        const char *where = scene->media[i].where;
        status = murk_fillings_files(scene, i, file, err);
        for (size_t k = 0; k < MURK_FILLING_FILES && !status; ++k) {
            status =
                file[k]
                    ? add_checksum(
                          stage, stage->filling_sum[MURK_FILLING_FILES * i + k],
                          file[k], where, err)
                    : MURK_OK;
        }
        from[i] = find_filling(stage, earlier, i);
    }
    if (!status) {
        status =
            murk_fillings_create(&stage->fillings, scene,
                                 earlier ? earlier->fillings : NULL, from, err);
    }
    free(from);
    return status ? status : append_field_sums(stage, err);
}

/* Shares the meshes of geometry and regions and the grids of the stage `other`,
 * whose scene has the same world_key and the same files. */
static murk_status share_world(murk_stage *stage, const murk_stage *other,
                               murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    const size_t files = MURK_FILLING_FILES * scene->n_media;
    size_t *from = calloc(scene->n_media + 1, sizeof *from);
    murk_status status =
        from ? MURK_OK : murk_no_memory(err, scene->path, "for the world");
    /* Checksums in the order of import_world(), of files alone. */
    for (size_t i = 0; i < lit_meshes(scene) && !status; ++i) {
        const murk_mesh_file f = murk_mesh_file_at(scene, i);
        stage->mesh[i] = murk_mesh_share(other->mesh[i]);
        memcpy(stage->mesh_sum[i], other->mesh_sum[i], sizeof *other->mesh_sum);
        status = f.path ? append_sum(stage, stage->mesh_sum[i], f.where, err)
                        : MURK_OK;
        if (f.path && !status) {
            status = add_mesh_sum(stage, stage->mesh[i], f.where, err);
        }
    }
    for (size_t i = 0; i < files && !status; ++i) {
        const uint64_t *sum = other->filling_sum[i];
        memcpy(stage->filling_sum[i], sum, sizeof *other->filling_sum);
        status = sum[0] | sum[1] ? append_sum(stage, sum, scene->path, err)
                                 : MURK_OK;
    }
    for (size_t i = 0; i < scene->n_media && !status; ++i) {
        from[i] = i;
    }
    if (!status) {
        status = murk_fillings_create(&stage->fillings, scene, other->fillings,
                                      from, err);
    }
    free(from);
    return status ? status : append_field_sums(stage, err);
}

/* Appends how droplets of files scatter to the light key: their radii are not
 * in the checksums of grids, which hold extinctions. */
static murk_status append_droplets(murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < scene->n_media && !status; ++i) {
        const murk_scene_medium *droplets = stage->phases->droplets[i];
        char *text = NULL;
        size_t size = 0;
        FILE *to = droplets ? open_memstream(&text, &size) : NULL;
        if (to) {
            murk_medium_droplets_sign(to, droplets, scene->bands);
            text = murk_print_finish(to, &text);
        }
        if (droplets) {
            status = text ? append_text(stage, text, droplets->where, err)
                          : murk_no_memory(err, droplets->where, "for its sum");
        }
        free(text);
    }
    return status;
}

/* Builds the phase functions; checksums of tables in files, and the phase
 * functions of droplets, are appended to the light key. */
static murk_status make_phases(murk_stage *stage, murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < scene->n_media; ++i) {
        const murk_scene_medium *m = &scene->media[i];
        for (size_t k = 0; k < m->n_phases && !status; ++k) {
            uint64_t sum[2];
            if (m->phase[k].table) {
                status = add_checksum(stage, sum, m->phase[k].table,
                                      m->phase[k].where, err);
            }
        }
    }
    if (!status) {
        status =
            murk_phases_create(&stage->phases, scene, stage->fillings, err);
    }
    return status ? status : append_droplets(stage, err);
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

/* Imports the files of a scene, or shares them with the stage `other`:
 * has_same_files: without a look at the files. */
static murk_status import(murk_stage **out, const murk_scene_desc *scene,
                          const murk_stage *other, bool has_same_files,
                          murk_error *err)
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
    stage->mesh_sum = calloc(meshes, sizeof *stage->mesh_sum);
    stage->filling_sum = calloc(MURK_FILLING_FILES * scene->n_media + 1,
                                sizeof *stage->filling_sum);
    stage->light_key = strdup(scene->light_key);
    if (!stage->mesh || !stage->mesh_sum || !stage->filling_sum ||
        !stage->light_key) {
        status = murk_no_memory(err, scene->path, "for the world");
    } else {
        stage->region_mesh = stage->mesh + scene->geometries;
        stage->goal_mesh = stage->region_mesh + scene->n_regions;
        stage->zone_mesh = stage->goal_mesh + scene->placement.n_interests + 1;
        /* Read files, or share what was read of them. */
        status = has_same_files ? share_world(stage, other, err)
                                : import_world(stage, other, err);
    }
    /* Read the files of goals and zones. */
    if (!status) {
        status = import_meshes(stage, NULL, lit_meshes(scene), meshes, err);
    }
    if (status) {
        murk_stage_destroy(stage);
        return status;
    }
    stage->grid = stage->fillings->grid;
    *out = stage;
    return MURK_OK;
}

murk_status murk_stage_import_beside(murk_stage **out,
                                     const murk_scene_desc *scene,
                                     const murk_stage *other, murk_error *err)
{
    return import(out, scene, other, other != NULL, err);
}

bool murk_stage_shares_all(const murk_scene_desc *scene)
{
    const size_t n = murk_mesh_files_count(scene);
    bool shares_all = true;
    for (size_t i = lit_meshes(scene); i < n; ++i) {
        shares_all = shares_all && !murk_mesh_file_at(scene, i).path;
    }
    return shares_all;
}

murk_status murk_stage_import_after(murk_stage **out,
                                    const murk_scene_desc *scene,
                                    const murk_stage *earlier, murk_error *err)
{
    return import(out, scene, earlier, false, err);
}

murk_status murk_stage_import(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err)
{
    return import(out, scene, NULL, false, err);
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

murk_status murk_stage_create_after(murk_stage **out,
                                    const murk_scene_desc *scene,
                                    const murk_stage *earlier, murk_error *err)
{
    murk_stage *stage = NULL;
    murk_status status = import(&stage, scene, earlier, false, err);
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

murk_status murk_stage_create(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err)
{
    return murk_stage_create_after(out, scene, NULL, err);
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
    for (size_t i = 0; stage->mesh && i < murk_mesh_files_count(stage->scene);
         ++i) {
        murk_mesh_destroy(stage->mesh[i]);
    }
    murk_fillings_destroy(stage->fillings);
    free(stage->light_key);
    free(stage->mesh_sum);
    free(stage->filling_sum);
    free(stage->tally);
    free(stage->sky);
    free(stage->mesh);
    free(stage);
}
