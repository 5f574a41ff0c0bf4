/* Axis-aligned bounding boxes of the geometry, regions and light sources of a
 * scene, and the domain that follows from them. */
#ifndef MURK_WORLD_EXTENT_H
#define MURK_WORLD_EXTENT_H

#include "geometry/mesh.h"
#include "medium/grid.h"
#include "scene/scene.h"

/* False if the box is empty: min exceeds max on an axis. */
bool murk_extent_is_box(const murk_box *box);

/* The bounding box of two boxes. Either may be empty, a only as
 * murk_box_empty(). */
murk_box murk_extent_join(murk_box a, murk_box b);

/* The bounding box of one item in world coordinates. mesh is the imported mesh
 * if the item is a mesh file. grid is the density grid of the medium of a
 * region, NULL if the medium has none. The box of a region is that of its
 * shape. If the medium has a grid or a profile, the box is the intersection
 * with the active voxels or with the layers, unless the region replaces other
 * media or has an index of refraction. An unbounded region has an empty box. */
murk_box murk_extent_geometry(const murk_scene_geometry *geometry,
                              const murk_mesh *mesh);
murk_box murk_extent_region(const murk_scene_desc *scene,
                            const murk_scene_region *region,
                            const murk_grid *grid, const murk_mesh *mesh);

/* True if the box of the region is finite: the region is neither the whole
 * domain nor a half space. */
bool murk_extent_is_bounded(const murk_scene_region *region);

/* Sets *out to the domain that the scene gives. Without one, the domain is the
 * box of all geometry, finite regions and lamps, grown on each side by 1 % of
 * the longest edge. mesh[geometries], grid[n_media] and region_mesh[n_regions]
 * are those of murk_stage. Fails with MURK_BAD_VALUE if nothing finite
 * determines the domain, or if a half space or distant light has no geometry to
 * refer to. */
murk_status murk_extent_domain(murk_domain *out, const murk_scene_desc *scene,
                               murk_mesh *const *mesh, murk_grid *const *grid,
                               murk_mesh *const *region_mesh, murk_error *err);

#endif
