/* The world of a scene: the one place where the scene's structs become
 * surfaces, media and lights.
 *
 * Meshes and grids are imported first, in child processes, before any ray
 * device or thread exists. */
#ifndef MURK_STUDY_STAGE_H
#define MURK_STUDY_STAGE_H

#include "base/status.h"
#include "scene/scene.h"
#include "study/fillings.h"
#include "study/goals.h"
#include "study/phases.h"
#include "study/site_zones.h"
#include "study/sky.h"
#include "transport/trace.h"

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

/* *out is the caller's: murk_stage_destroy(). The scene must outlive it. */
murk_status murk_stage_create(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err);
void murk_stage_destroy(murk_stage *stage); /* NULL is fine */

/* The same in two steps, for several worlds at once: all are imported before
 * the first is built, since that makes a ray device. */
murk_status murk_stage_import(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err);
murk_status murk_stage_build(murk_stage *stage, murk_error *err);

/* As murk_stage_import, of a scene whose world_key and files are those of
 * another imported stage: what fills its world is borrowed from that, which
 * must outlive it. */
murk_status murk_stage_import_beside(murk_stage **out,
                                     const murk_scene_desc *scene,
                                     const murk_stage *other, murk_error *err);

/* A trace of this world as the scene wants it; stream, photons, threads and
 * sink are the caller's to set. */
murk_trace murk_stage_trace(const murk_stage *stage);

#endif
