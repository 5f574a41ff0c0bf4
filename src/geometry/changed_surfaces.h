/* The places at which two sets of surfaces, or of boundary meshes, differ. */
#ifndef MURK_GEOMETRY_CHANGED_SURFACES_H
#define MURK_GEOMETRY_CHANGED_SURFACES_H

#include "base/box_list.h"
#include "base/status.h"
#include "geometry/boundary_meshes.h"
#include "geometry/surfaces.h"

/* Adds the boxes of all triangles and spheres that only one of two sets has, or
 * that are thin sheets of another transmittance. A segment that does not meet
 * the boxes, enlarged by 2 murk_surfaces_leave_step_m(), has the same answers
 * in both sets, in every bit: blocked or not, and the transmittance of sheets.
 * with_materials: faces of a material with other properties count, too, so
 * that the same holds for hits and for what happens there. Sets whose rounding
 * differs (murk_surfaces_create_within()) differ everywhere. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_changed_surfaces(murk_box_list *changed,
                                  const murk_surfaces *a,
                                  const murk_surfaces *b, bool with_materials,
                                  murk_error *err);

/* Adds the bounding boxes of the meshes of regions that differ, in both sets;
 * NULL is a set without meshes. A segment that does not meet the boxes,
 * enlarged as above, lies in the same regions and crosses the same boundaries
 * in both sets, in every bit. Sets of other regions, or of another tolerance,
 * differ everywhere. Fails with MURK_NO_MEMORY. */
murk_status murk_changed_boundary_meshes(murk_box_list *changed,
                                         const murk_boundary_meshes *a,
                                         const murk_boundary_meshes *b,
                                         murk_error *err);

#endif
