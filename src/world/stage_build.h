/* Builds a stage from a scene: the one place in which the structs of the scene
 * become surfaces, media and light sources.
 *
 * Meshes and grids are imported first, in subprocesses, before any ray device
 * or thread exists. */
#ifndef MURK_WORLD_STAGE_BUILD_H
#define MURK_WORLD_STAGE_BUILD_H

#include "world/stage.h"

/* Imports and builds. The caller owns *out (murk_stage_destroy()); the scene
 * must outlive *out. Fails as the readers of the files and the functions that
 * build the parts do: with MURK_BAD_FILE, MURK_BAD_VALUE, MURK_UNSUPPORTED,
 * MURK_NO_MEMORY and others. */
murk_status murk_stage_create(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err);
void murk_stage_destroy(murk_stage *stage); /* NULL is fine */

/* murk_stage_create() in two steps, for several worlds at once: every world
 * must be imported before the first one is built, because building creates a
 * ray device, and subprocesses must be started before that. If
 * murk_stage_build() fails, the caller still destroys the stage. */
murk_status murk_stage_import(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err);
murk_status murk_stage_build(murk_stage *stage, murk_error *err);

/* As murk_stage_import(), for a scene that has the same world_key and the same
 * files as another stage that is imported but not built. The meshes of geometry
 * and regions, grids and profiles are borrowed from that stage, which must
 * outlive the new one. */
murk_status murk_stage_import_beside(murk_stage **out,
                                     const murk_scene_desc *scene,
                                     const murk_stage *other, murk_error *err);

/* Creates the media of a scene in the domain of the stage. The scene is that of
 * the stage, or one that differs from it in numbers alone (a fit varies such
 * numbers). Regions that are meshes use the boundary meshes of the stage.
 * fillings and phases belong to the scene that is passed and must outlive *out,
 * as that scene must. The caller owns *out (murk_media_destroy()). */
murk_status murk_stage_media(murk_media **out, const murk_stage *stage,
                             const murk_scene_desc *scene,
                             const murk_fillings *fillings,
                             const murk_phases *phases, murk_error *err);

/* Prints warnings and notes about settings that are valid but probably not
 * meant (stage_notes.c). murk_stage_build() calls the function at the end,
 * because the stage must be complete. */
void murk_stage_warn(const murk_stage *stage);

/* Builds the boundary meshes of all regions whose shape is a mesh, and checks
 * them.
 *
 * mesh[n_regions] holds the imported mesh of each region, NULL for a region of
 * another shape. domain is the domain of the scene. *out is NULL if no region
 * is a mesh; otherwise the caller owns it (murk_boundary_meshes_destroy()).
 *
 * Fails with MURK_BAD_VALUE at the place of a region in the scene if a mesh is
 * not closed, or if two regions with an index of refraction cross and at least
 * one of them is a mesh. (murk_media_create() checks pairs of other shapes.) A
 * face of a box without rotation that lies in a side of the domain or beyond
 * that side does not count as a boundary: the box is taken to continue outside
 * the domain. */
murk_status murk_stage_boundary_meshes(murk_boundary_meshes **out,
                                       const murk_scene_desc *scene,
                                       murk_mesh *const *mesh,
                                       const murk_box *domain, murk_error *err);

#endif
