/* The zones that a scene's sensors avoid or keep within: their meshes, read
 * with the stage, and the zones made of them. */
#ifndef MURK_WORLD_SITE_ZONES_H
#define MURK_WORLD_SITE_ZONES_H

#include "geometry/zones.h"
#include "scene/scene.h"

typedef struct murk_site_meshes murk_site_meshes;

/* Imports in child processes: call before any thread or ray device exists.
 * *out is the caller's: murk_site_meshes_destroy(). */
murk_status murk_site_meshes_read(murk_site_meshes **out,
                                  const murk_scene_desc *scene,
                                  murk_error *err);
void murk_site_meshes_destroy(murk_site_meshes *meshes); /* NULL is fine */

/* NULL where the scene has no such zones. Both are the caller's:
 * murk_zones_destroy(), also when it fails. */
murk_status murk_site_zones_create(murk_zones **avoid, murk_zones **within,
                                   const murk_scene_desc *scene,
                                   const murk_site_meshes *meshes,
                                   murk_error *err);

#endif
