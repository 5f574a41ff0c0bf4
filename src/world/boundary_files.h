/* Boundary meshes of those regions of a scene whose shape is a mesh, made from
 * the imported files. */
#ifndef MURK_WORLD_BOUNDARY_FILES_H
#define MURK_WORLD_BOUNDARY_FILES_H

#include "geometry/boundary_meshes.h"
#include "scene/scene.h"

/* Builds the boundary meshes of all regions whose shape is a mesh, and checks
 * them.
 *
 * mesh[n_regions] holds the imported mesh of each region, NULL for a region of
 * another shape. domain is the domain of the scene. *out is NULL if no region
 * is a mesh; otherwise the caller owns it (murk_boundary_meshes_destroy()).
 *
 * Fails with MURK_BAD_VALUE at the place of a region in the scene if a mesh is
 * open, or if two regions with an index of refraction cross and at least one of
 * them is a mesh. (The room medium checks pairs of other shapes.) A face of a
 * box that lies in a side of the domain or beyond that side does not count as a
 * boundary: the box is taken to continue outside the domain. */
murk_status murk_stage_boundary_meshes(murk_boundary_meshes **out,
                                       const murk_scene_desc *scene,
                                       murk_mesh *const *mesh,
                                       const murk_box *domain, murk_error *err);

#endif
