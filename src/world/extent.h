/* Axis-aligned bounding boxes of the geometry and the regions of a scene, and
 * the domain, which follows from these boxes and the lamps if the scene does
 * not give one. */
#ifndef MURK_WORLD_EXTENT_H
#define MURK_WORLD_EXTENT_H

#include "geometry/mesh.h"
#include "medium/grid.h"
#include "scene/scene.h"

/* False if the box is empty: min exceeds max on an axis. */
bool murk_extent_is_box(const murk_box *box);

/* The bounding box of two boxes. Either box may be empty; an empty a must be
 * murk_box_empty(). */
murk_box murk_extent_join(murk_box a, murk_box b);

/* A bounding box in world coordinates of one geometry or one region; the box of
 * a rotated item may be larger than needed. mesh is the imported mesh if the
 * item is a mesh file; it is not read otherwise. grid is the density grid of
 * the medium of a region, NULL if the medium has none. A region whose shape is
 * the grid has the box of the active voxels. A region of another shape has the
 * box of the shape. If the medium of such a region has a profile or a grid,
 * this box is intersected with the box of the layers or of the active voxels,
 * unless the region replaces other media or has an index of refraction. The box
 * is empty if nothing is left, and for an unbounded region. */
murk_box murk_extent_geometry(const murk_scene_geometry *geometry,
                              const murk_mesh *mesh);
murk_box murk_extent_region(const murk_scene_desc *scene,
                            const murk_scene_region *region,
                            const murk_grid *grid, const murk_mesh *mesh);

/* True if the shape of the region is bounded: neither the whole domain nor a
 * half space. */
bool murk_extent_is_bounded(const murk_scene_region *region);

/* Sets *out to the domain that the scene gives. If the scene gives none, the
 * domain is the box of all geometry, bounded regions and lamps, grown on each
 * side by 1 % of the longest edge of this box, and is not periodic.
 * mesh[geometries], grid[n_media] and region_mesh[n_regions] are those of
 * murk_stage (world/stage.h). Fails with MURK_BAD_VALUE if the scene gives no
 * domain and has a half space or distant light but no geometry, or if the box
 * is empty or a single point. */
murk_status murk_extent_domain(murk_domain *out, const murk_scene_desc *scene,
                               murk_mesh *const *mesh, murk_grid *const *grid,
                               murk_mesh *const *region_mesh, murk_error *err);

#endif
