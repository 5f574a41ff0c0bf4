/* The regions of a scene that are meshes: their boundary meshes, from the files
 * as read.
 */
#ifndef MURK_WORLD_BOUNDARY_FILES_H
#define MURK_WORLD_BOUNDARY_FILES_H

#include "geometry/boundary_meshes.h"
#include "scene/scene.h"

/* mesh[n_regions]: NULL for regions of other shapes. *out is the caller's
 * (murk_boundary_meshes_destroy()), NULL where no region is a mesh. Fails at
 * the region's place with MURK_BAD_VALUE where a mesh is open, or where two
 * regions with an index cross, one of them a mesh (pairs of other shapes are
 * the medium room's to check). A box's face in a side of the domain or beyond
 * it is none: there the box goes on. */
murk_status murk_enclose(murk_boundary_meshes **out,
                         const murk_scene_desc *scene, murk_mesh *const *mesh,
                         const murk_box *domain, murk_error *err);

#endif
