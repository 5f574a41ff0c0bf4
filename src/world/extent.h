/* How far the things of a scene reach, and the domain that follows. */
#ifndef MURK_WORLD_EXTENT_H
#define MURK_WORLD_EXTENT_H

#include "geometry/mesh.h"
#include "medium/grid.h"
#include "scene/scene.h"

/* World box of one item; mesh for files, the grid of the region's medium or
 * NULL. A shape around a grid reaches as far as both do, unless it replaces. */
murk_box murk_extent_geometry(const murk_scene_geometry *geometry,
                              const murk_mesh *mesh);
murk_box murk_extent_region(const murk_scene_desc *scene,
                            const murk_scene_region *region,
                            const murk_grid *grid, const murk_mesh *mesh);

/* Whether that box is finite: neither everywhere nor a half space. */
bool murk_extent_is_bounded(const murk_scene_region *region);

/* The scene's own domain, else the box of geometry, finite regions and lamps,
 * grown by 1 % of its longest side. mesh[geometries], grid[n_media] and
 * region_mesh[n_regions] as in murk_stage. Fails where nothing finite is there
 * to be lit. */
murk_status murk_extent_domain(murk_domain *out, const murk_scene_desc *scene,
                               murk_mesh *const *mesh, murk_grid *const *grid,
                               murk_mesh *const *region_mesh, murk_error *err);

#endif
