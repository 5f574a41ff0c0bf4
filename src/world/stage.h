/* The world of a scene: the one place where the scene's structs become
 * surfaces, media and lights.
 *
 * Meshes and grids are imported first, in child processes, before any ray
 * device or thread exists. */
#ifndef MURK_WORLD_STAGE_H
#define MURK_WORLD_STAGE_H

#include "base/status.h"
#include "scene/scene.h"
#include "transport/trace.h"
#include "world/fillings.h"
#include "world/goals.h"
#include "world/phases.h"
#include "world/site_zones.h"
#include "world/sky.h"

typedef struct murk_stage {
    const murk_scene_desc *scene; /* borrowed */
    murk_transport_world world;
    murk_fillings *fillings; /* of media */
    murk_grid **grid;        /* fillings->grid: NULL for media without one */
    murk_mesh **mesh; /* [scene->geometries]; NULL for the other shapes */
    murk_mesh **region_mesh;       /* [scene->n_regions]; likewise */
    murk_site_meshes *site_meshes; /* of zones of candidates */
    murk_phases *phases;
    murk_surfaces *surfaces;
    murk_media *media;
    murk_boundary_meshes *boundary_meshes; /* NULL: no region is a mesh */
    murk_sources *lights;
    murk_sky_facts *sky; /* [scene->n_lights] what they were made of */
    murk_goals *goals;
    murk_tally_desc *tally; /* [scene->n_tallies]; NULL for none */
    char *light_key; /* the scene's, and a checksum of each file it names: equal
                        keys trace equal light */
    bool borrows;    /* meshes and fillings are another stage's */
} murk_stage;

/* A trace of this world as the scene wants it; stream, photons, threads and
 * sink are the caller's to set. */
murk_trace murk_stage_trace(const murk_stage *stage);

/* True if no light source of the scene emits: lamps off, the sun below the
 * horizon. */
bool murk_stage_is_dark(const murk_stage *stage);

/* True if plans would count photons although none is emitted: the scene is
 * dark, and no targets take the place of photons. */
bool murk_stage_has_nothing_to_see(const murk_stage *stage);

#endif
