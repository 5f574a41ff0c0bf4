/* Converts the zones of candidate sites of a scene (boxes, spheres, meshes)
 * into those of geometry/zones.h. */
#include "world/site_zones.h"

#include <stdlib.h>

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
        return murk_no_memory(err, where, "for its zones");
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
                                   murk_mesh *const *mesh, murk_error *err)
{
    const murk_scene_candidates *settings = &scene->sensors.candidates;
    const murk_status status = create(avoid, settings->avoid, settings->avoids,
                                      mesh, settings->where, err);
    return status ? status
                  : create(within, settings->within, settings->withins,
                           mesh + settings->avoids, settings->where, err);
}
