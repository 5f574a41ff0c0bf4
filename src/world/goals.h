/* The regions of interest of a scene, whose photons or targets plans are to
 * cover, and the boundary mesh of the volume that targets are drawn from, if
 * that volume is bounded by a mesh. */
#ifndef MURK_WORLD_GOALS_H
#define MURK_WORLD_GOALS_H

#include "geometry/mesh.h"
#include "geometry/surfaces.h"
#include "scene/scene.h"
#include "sensing/sight.h"

typedef struct murk_goals murk_goals;

/* Builds the regions of interest and the target mesh of a scene with the given
 * surfaces and domain. mesh[n_interests + 1] are the imported meshes of the
 * regions of interest and of the targets, NULL for other shapes. The caller
 * owns *out (murk_goals_destroy()); the scene must outlive *out. Fails with
 * MURK_BAD_VALUE at the place of a region of interest if two regions have the
 * same name, or if the region lies outside the domain, names a material that no
 * surface has or names a medium that no region of media contains; and at the
 * place of a sensor type that selects light by arrival direction although the
 * scene has targets. For the meshes of the regions and of the targets it fails
 * as murk_boundary_meshes_create(), for example if a mesh is open. Fails with
 * MURK_NO_MEMORY, too. */
murk_status murk_goals_create(murk_goals **out, const murk_scene_desc *scene,
                              murk_mesh *const *mesh,
                              const murk_surfaces *surfaces,
                              const murk_domain *domain, murk_error *err);
void murk_goals_destroy(murk_goals *goals); /* NULL is fine */

/* The regions of interest; NULL if the scene has none. */
const murk_interest *murk_goals_interest(const murk_goals *goals);

/* The mesh that bounds the volume of the targets, as boundary mesh number 0;
 * NULL if the scene has no such mesh. */
const murk_boundary_meshes *murk_goals_target_mesh(const murk_goals *goals);

/* The bounding box of a region of interest or of the volume of the targets: of
 * the box or the sphere of `solid`, or of the boundary mesh `number` of meshes;
 * infinite for any other shape. */
murk_box murk_goals_box(murk_region_shape shape, const murk_scene_solid *solid,
                        const murk_boundary_meshes *meshes, int number);

/* The regions of interest that contain at least one record (photon or target)
 * of the sight: bit i is set for region i. */
uint64_t murk_goals_seen(const murk_sight *sight);

/* Fails with MURK_RUN_FAILED at the place of the first region of interest whose
 * bit is not set in seen. Over several conditions, seen is the union of the
 * bits of all conditions: smoke, for example, may be present in one condition
 * only. */
murk_status murk_goals_check_seen(const murk_goals *goals, uint64_t seen,
                                  murk_error *err);

#endif
