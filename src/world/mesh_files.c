/* Lists the mesh files of a scene, whatever part of the scene names them. */
#include "world/mesh_files.h"

#include "scene/ground.h"

size_t murk_mesh_files_count(const murk_scene_desc *scene)
{
    const murk_scene_candidates *sites = &scene->sensors.candidates;
    return scene->geometries + scene->n_regions + scene->placement.n_interests +
           1 + sites->avoids + sites->withins;
}

static murk_mesh_file file_of(const murk_scene_solid *solid, const char *where)
{
    return (murk_mesh_file){
        .path = solid->mesh,
        .import = {.unit_m = solid->unit_m, .up = solid->up},
        .scale = solid->scale,
        .where = where};
}

murk_mesh_file murk_mesh_file_at(const murk_scene_desc *scene, size_t i)
{
    const murk_scene_candidates *sites = &scene->sensors.candidates;
    const murk_scene_placement *placement = &scene->placement;
    /* Find the part of the scene that the item belongs to; i becomes the index
     * within this part. */
    if (i < scene->geometries) {
        const murk_scene_geometry *g = &scene->geometry[i];
        murk_mesh_file file = file_of(&g->solid, g->where);
        file.import.allow = g->allow;
        file.import.is_fds = g->is_fds;
        file.import.fds_time_s = g->time_s;
        if (g->is_geotiff) {
            file.import.is_geotiff = true;
            file.import.geotiff = murk_scene_ground_asked(scene, i);
        }
        return file;
    }
    i -= scene->geometries;
    if (i < scene->n_regions) {
        return file_of(&scene->regions[i].solid, scene->regions[i].where);
    }
    i -= scene->n_regions;
    if (i < placement->n_interests) {
        return file_of(&placement->interest[i].solid,
                       placement->interest[i].where);
    }
    i -= placement->n_interests;
    if (i == 0) {
        return file_of(&placement->targets.solid,
                       placement->targets.volume_where);
    }
    const murk_scene_site_zone *zone =
        i - 1 < sites->avoids ? &sites->avoid[i - 1]
                              : &sites->within[i - 1 - sites->avoids];
    return file_of(&zone->solid, zone->where);
}
