/* What a scene's plans are to see: its regions of interest, and the mesh that
 * targets may be drawn from. */
#ifndef MURK_WORLD_GOALS_H
#define MURK_WORLD_GOALS_H

#include "geometry/surfaces.h"
#include "scene/scene.h"
#include "sensing/sight.h"

typedef struct murk_goals murk_goals;

/* Imports the meshes, in child processes: call before any thread or ray device
 * exists. *out is the caller's: murk_goals_destroy(). The scene must outlive
 * it. */
murk_status murk_goals_import(murk_goals **out, const murk_scene_desc *scene,
                              murk_error *err);
void murk_goals_destroy(murk_goals *goals); /* NULL is fine */

/* Makes them ready for these surfaces. Fails with MURK_BAD_VALUE at the place
 * of a region of interest: a name given twice, an open mesh, a place where
 * nothing can be stored; or of targets: an open mesh. */
murk_status murk_goals_build(murk_goals *goals, const murk_surfaces *surfaces,
                             const murk_domain *domain, murk_error *err);

/* Built; NULL where there are no regions of interest. */
const murk_interest *murk_goals_interest(const murk_goals *goals);

/* Built, of one region, number 0; NULL where targets have no mesh. */
const murk_boundary_meshes *murk_goals_target_mesh(const murk_goals *goals);

/* The regions of interest that something seen lies in, bit i for region i. */
uint64_t murk_goals_seen(const murk_sight *sight);

/* Fails with MURK_RUN_FAILED at the place of one that is not among them: by one
 * sight, or several together (over conditions, smoke may be in one only). */
murk_status murk_goals_check_seen(const murk_goals *goals, uint64_t seen,
                                  murk_error *err);

#endif
