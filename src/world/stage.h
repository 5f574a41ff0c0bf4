/* The world of a scene: surfaces, media, light sources, tallies and goals,
 * converted from the structs of the scene. stage_build.h makes it; after that
 * it does not change. */
#ifndef MURK_WORLD_STAGE_H
#define MURK_WORLD_STAGE_H

#include "base/status.h"
#include "scene/scene.h"
#include "transport/trace.h"
#include "world/fillings.h"
#include "world/goals.h"
#include "world/phases.h"
#include "world/sky.h"

typedef struct murk_stage {
    const murk_scene_desc *scene; /* borrowed */
    murk_transport_world world;
    murk_fillings *fillings; /* grids and profiles of the media */
    murk_grid **grid;        /* fillings->grid; NULL for a medium without a grid
                              */
    murk_mesh **mesh; /* [murk_mesh_files_count()]: the imported meshes in the
                       * order of world/mesh_files.h, those of the geometry
                       * first; NULL for an item that is not a mesh file */
    murk_mesh **region_mesh; /* [scene->n_regions], in `mesh` */
    murk_mesh **goal_mesh;   /* [n_interests + 1], in `mesh`: of the regions of
                              * interest and of the targets */
    murk_mesh **zone_mesh;   /* [avoids + withins], in `mesh` */
    murk_phases *phases;
    murk_surfaces *surfaces;
    murk_media *media;
    murk_boundary_meshes *boundary_meshes; /* NULL if no region is a mesh */
    murk_sources *lights;
    murk_sky_facts *sky; /* [scene->n_lights]; properties of the light sources
                          */
    murk_goals *goals;
    murk_tally_desc *tally; /* [scene->n_tallies]; NULL if there are none */
    char *light_key; /* light_key of the scene, followed by a checksum of each
                      * file that the light depends on: stages with equal keys
                      * and equal seeds trace equal light */
    bool borrows;    /* the meshes of geometry and regions, and the fillings,
                      * belong to another stage */
} murk_stage;

/* The settings of a trace of this world as the scene gives them. The caller
 * sets the other members: photons, and stream, threads, sinks and tallies where
 * the values of murk_trace_defaults() do not serve. */
murk_trace murk_stage_trace(const murk_stage *stage);

/* True if no light source of the scene has power at the time of the scene, for
 * example because the lamps are off and the sun is below the horizon. */
bool murk_stage_is_dark(const murk_stage *stage);

/* True if plans would count photons although none is emitted: the scene is
 * dark, and either no targets replace the photons or detection is by power. */
bool murk_stage_has_nothing_to_see(const murk_stage *stage);

#endif
