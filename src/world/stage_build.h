/* Builds a stage from a scene: the one place in which the structs of the scene
 * become surfaces, media and light sources.
 *
 * Meshes and grids are imported first, in subprocesses, before the stage
 * creates a ray device. */
#ifndef MURK_WORLD_STAGE_BUILD_H
#define MURK_WORLD_STAGE_BUILD_H

#include "world/stage.h"

/* Imports the files of the scene and builds the stage. The caller owns *out
 * (murk_stage_destroy()); the scene must outlive *out. Fails as the readers of
 * the files and the functions that build the parts do: with MURK_BAD_FILE,
 * MURK_BAD_VALUE, MURK_UNSUPPORTED, MURK_NO_MEMORY and others. */
murk_status murk_stage_create(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err);
void murk_stage_destroy(murk_stage *stage); /* NULL is fine */

/* murk_stage_create() in two steps, for several stages at once: the files of
 * every stage must be imported before the first stage is built, because
 * importing starts subprocesses, building creates a ray device, and
 * subprocesses must be started before a ray device exists. If
 * murk_stage_build() fails, the caller still destroys the stage. */
murk_status murk_stage_import(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err);
murk_status murk_stage_build(murk_stage *stage, murk_error *err);

/* As murk_stage_import(), for a scene that may have files in common with that
 * of the stage `earlier`, as in murk_stage_create_after(). */
murk_status murk_stage_import_after(murk_stage **out,
                                    const murk_scene_desc *scene,
                                    const murk_stage *earlier, murk_error *err);

/* As murk_stage_import(), for a scene that has the same world_key and the same
 * files as the scene of the stage `other`. The meshes of geometry and regions
 * and the grids are those of `other`; the remaining meshes are imported. other
 * may be NULL: all files are imported then. */
murk_status murk_stage_import_beside(murk_stage **out,
                                     const murk_scene_desc *scene,
                                     const murk_stage *other, murk_error *err);

/* True if murk_stage_import_beside() imports no mesh for the scene, so that it
 * starts no subprocess and may be called after a ray device was created. */
bool murk_stage_shares_all(const murk_scene_desc *scene);

/* As murk_stage_create(), for a scene that may have files in common with that
 * of the stage `earlier`: a mesh of geometry or regions is that of `earlier` if
 * it comes from the same path, the file has the same checksum, names no other
 * files, and is imported in the same way; a grid if its files have the same
 * checksums and the same grids are taken from them. What the readers of shared
 * files warned of is not told again. earlier may be NULL. */
murk_status murk_stage_create_after(murk_stage **out,
                                    const murk_scene_desc *scene,
                                    const murk_stage *earlier, murk_error *err);

/* Creates the media of a scene in the domain of the stage. The scene is that of
 * the stage, or a scene that differs from that of the stage in numbers alone (a
 * fit varies such numbers). Regions that are meshes use the boundary meshes of
 * the stage. fillings and phases are those of the scene that is passed;
 * fillings, phases and this scene must outlive *out. The caller owns *out
 * (murk_media_destroy()). Fails as murk_media_create(). */
murk_status murk_stage_media(murk_media **out, const murk_stage *stage,
                             const murk_scene_desc *scene,
                             const murk_fillings *fillings,
                             const murk_phases *phases, murk_error *err);

/* Prints warnings and notes about settings of the scene that are valid but
 * probably not meant (stage_notes.c). The stage must be complete:
 * murk_stage_build() calls the function at the end. */
void murk_stage_warn(const murk_stage *stage);

/* Builds the boundary meshes of all regions whose shape is a mesh, and checks
 * these meshes and the pairs of regions.
 *
 * mesh[n_regions] holds the imported mesh of each region, NULL for a region of
 * another shape. domain is the domain of the scene. *out is NULL if no region
 * is a mesh; otherwise the caller owns it (murk_boundary_meshes_destroy()).
 *
 * Fails as murk_boundary_meshes_create(), for example if a mesh is not closed,
 * and with MURK_BAD_VALUE at the place of the later region in the scene if two
 * regions with an index of refraction cross and at least one of the two is a
 * mesh. (murk_media_create() checks pairs of other shapes.) A face of a box
 * without rotation that lies in a side of the domain or beyond that side does
 * not count as a boundary: the box is taken to continue outside the domain. */
murk_status murk_stage_boundary_meshes(murk_boundary_meshes **out,
                                       const murk_scene_desc *scene,
                                       murk_mesh *const *mesh,
                                       const murk_box *domain, murk_error *err);

#endif
