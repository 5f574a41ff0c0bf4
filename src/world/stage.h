/* The world of a scene: surfaces, media, light sources, tallies and goals,
 * converted from the structs of the scene. The functions of world/stage_build.h
 * make a stage; a stage that is built does not change. */
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
    murk_grid **grid;        /* fillings->grid, [scene->n_media]; NULL for a
                              * medium without a grid of densities */
    murk_mesh **mesh; /* [murk_mesh_files_count()]: the imported meshes in the
                       * order of world/mesh_files.h, those of the geometry
                       * first; NULL for an item that is not a mesh file */
    murk_mesh **region_mesh; /* [scene->n_regions], a part of `mesh` */
    murk_mesh **goal_mesh;   /* [n_interests + 1], a part of `mesh`: those of
                              * the regions of interest and of the targets */
    murk_mesh **zone_mesh;   /* [avoids + withins], a part of `mesh`: those of
                              * the zones of candidate sites */
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
                      * file that the light depends on (those of tables of phase
                      * functions and how droplets of files scatter are
                      * appended by murk_stage_build()); with
                      * equal keys, seeds and numbers of photons, stages that
                      * are built trace equal light */
    uint64_t (*mesh_sum)[2];    /* checksums of the files of the meshes, in the
                                 * order of `mesh`; 0 for those that the light
                                 * does not depend on, and without a file */
    uint64_t (*filling_sum)[2]; /* [scene->n_media * MURK_FILLING_FILES] those
                                 * of the files of the media */
} murk_stage;

/* murk_trace_defaults() with the world of the stage and with those settings
 * that the scene gives: seed, least weight and the method of free flight. The
 * caller sets the range of photons, and stream, threads, sinks, tallies and the
 * other members if their defaults do not serve. */
murk_trace murk_stage_trace(const murk_stage *stage);

/* True if no light source of the scene has power at the time of the scene, for
 * example because the lamps are off and the sun is below the horizon. */
bool murk_stage_is_dark(const murk_stage *stage);

/* True if the scene is dark and plans would depend on photons, of which none is
 * emitted: no targets replace the photons, or detection is by power. */
bool murk_stage_has_nothing_to_see(const murk_stage *stage);

#endif
