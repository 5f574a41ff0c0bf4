/* Builds a stage from a scene: the one place in which the structs of the scene
 * become surfaces, media and light sources.
 *
 * Meshes and grids are imported first, in subprocesses, before any ray device
 * or thread exists. */
#ifndef MURK_WORLD_STAGE_BUILD_H
#define MURK_WORLD_STAGE_BUILD_H

#include "world/stage.h"

/* Imports and builds. The caller owns *out (murk_stage_destroy()); the scene
 * must outlive it. */
murk_status murk_stage_create(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err);
void murk_stage_destroy(murk_stage *stage); /* NULL is fine */

/* The same in two steps, for several worlds at once: every world must be
 * imported before the first one is built, because building creates a ray
 * device, and subprocesses must be started before that. */
murk_status murk_stage_import(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err);
murk_status murk_stage_build(murk_stage *stage, murk_error *err);

/* As murk_stage_import(), for a scene that has the same world_key and the same
 * files as another imported stage. Meshes, grids and profiles are borrowed from
 * that stage, which must outlive the new one. */
murk_status murk_stage_import_beside(murk_stage **out,
                                     const murk_scene_desc *scene,
                                     const murk_stage *other, murk_error *err);

#endif
