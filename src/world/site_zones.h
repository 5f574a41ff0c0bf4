/* The zones that candidate sites of a scene must avoid, or must keep within. */
#ifndef MURK_WORLD_SITE_ZONES_H
#define MURK_WORLD_SITE_ZONES_H

#include "geometry/zones.h"
#include "scene/scene.h"

/* Builds the zones of both kinds. mesh[avoids + withins] are the imported
 * meshes of the zones to avoid, then of the zones to keep within; NULL for a
 * zone of another shape. *avoid or *within keeps its value if the scene has no
 * zones of that kind, so both must be NULL before. The caller owns both
 * (murk_zones_destroy()), also after a failure. Fails as murk_zones_create() or
 * with MURK_NO_MEMORY. */
murk_status murk_site_zones_create(murk_zones **avoid, murk_zones **within,
                                   const murk_scene_desc *scene,
                                   murk_mesh *const *mesh, murk_error *err);

#endif
