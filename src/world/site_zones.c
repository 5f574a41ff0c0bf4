/* Converts the zones of a scene (boxes, spheres, meshes) into those of
 * geometry/zones.h. Meshes are imported early, before any ray device exists;
 * the zones are built when candidate sites are wanted. */
#include "world/site_zones.h"

#include <stdlib.h>

struct murk_site_meshes {
    size_t n;         /* number of zones to avoid, followed by those to keep
                       * within */
    murk_mesh **mesh; /* [n]; NULL if the zone is not a mesh */
};

/* The i-th zone: zones to avoid come first. */
static const murk_scene_site_zone *
zone_at(const murk_scene_candidates *settings, size_t i)
{
    return i < settings->avoids ? &settings->avoid[i]
                                : &settings->within[i - settings->avoids];
}

murk_status murk_site_meshes_read(murk_site_meshes **out,
                                  const murk_scene_desc *scene, murk_error *err)
{
    /* Allocate. */
    const murk_scene_candidates *settings = &scene->sensors.candidates;
    murk_status status = MURK_OK;
    murk_site_meshes *made = calloc(1, sizeof *made);
    if (made) {
        made->n = settings->avoids + settings->withins;
        made->mesh = calloc(made->n + 1, sizeof *made->mesh);
    }
    if (!made || !made->mesh) {
        status = murk_fail(err, MURK_NO_MEMORY, settings->where,
                           "no memory for its zones");
        goto done;
    }
    /* Import the meshes. */
    for (size_t i = 0; i < made->n && !status; ++i) {
        const murk_scene_site_zone *zone = zone_at(settings, i);
        const murk_mesh_import import = {.unit_m = zone->solid.unit_m,
                                         .up = zone->solid.up};
        if (zone->shape == MURK_REGION_MESH) {
            status = murk_mesh_read(&made->mesh[i], zone->solid.mesh, &import,
                                    zone->where, err);
        }
    }
    if (!status) {
        *out = made;
        made = NULL;
    }
done:
    murk_site_meshes_destroy(made);
    return status;
}

void murk_site_meshes_destroy(murk_site_meshes *meshes)
{
    if (!meshes) {
        return;
    }
    for (size_t i = 0; meshes->mesh && i < meshes->n; ++i) {
        murk_mesh_destroy(meshes->mesh[i]);
    }
    free(meshes->mesh);
    free(meshes);
}

static murk_zone zone_of(const murk_scene_site_zone *z, const murk_mesh *mesh)
{
    return (murk_zone){.shape = z->shape,
                       .box = z->solid.box,
                       .center = z->solid.center,
                       .radius_m = z->solid.radius_m,
                       .mesh = mesh,
                       .to_world = murk_scene_placed(&z->solid),
                       .where = z->where};
}

static murk_status create(murk_zones **out, const murk_scene_site_zone *zones,
                          size_t n, murk_mesh *const *mesh, const char *where,
                          murk_error *err)
{
    if (n == 0) {
        return MURK_OK;
    }
    murk_zone *zone = calloc(n, sizeof *zone);
    if (!zone) {
        return murk_fail(err, MURK_NO_MEMORY, where, "no memory for its zones");
    }
    for (size_t i = 0; i < n; ++i) {
        zone[i] = zone_of(&zones[i], mesh[i]);
    }
    const murk_status status = murk_zones_create(out, zone, n, err);
    free(zone);
    return status;
}

murk_status murk_site_zones_create(murk_zones **avoid, murk_zones **within,
                                   const murk_scene_desc *scene,
                                   const murk_site_meshes *meshes,
                                   murk_error *err)
{
    const murk_scene_candidates *settings = &scene->sensors.candidates;
    const murk_status status = create(avoid, settings->avoid, settings->avoids,
                                      meshes->mesh, settings->where, err);
    return status
               ? status
               : create(within, settings->within, settings->withins,
                        meshes->mesh + settings->avoids, settings->where, err);
}
