/* The zones that candidate sites of a scene must avoid, or must keep within.
 * Their meshes are imported together with the stage. */
#ifndef MURK_WORLD_SITE_ZONES_H
#define MURK_WORLD_SITE_ZONES_H

#include "geometry/zones.h"
#include "scene/scene.h"

typedef struct murk_site_meshes murk_site_meshes;

/* Imports the meshes of the zones in subprocesses; call it before any thread or
 * ray device exists. The caller owns *out (murk_site_meshes_destroy()). */
murk_status murk_site_meshes_read(murk_site_meshes **out,
                                  const murk_scene_desc *scene,
                                  murk_error *err);
void murk_site_meshes_destroy(murk_site_meshes *meshes); /* NULL is fine */

/* Builds the zones of both kinds; *avoid or *within stays unset if the scene
 * has no zones of that kind. The caller owns both (murk_zones_destroy()), also
 * after a failure. */
murk_status murk_site_zones_create(murk_zones **avoid, murk_zones **within,
                                   const murk_scene_desc *scene,
                                   const murk_site_meshes *meshes,
                                   murk_error *err);

#endif
