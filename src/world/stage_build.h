/* Builds a stage from a scene: the one place in which the scene's structs
 * become surfaces, media and light sources.
 *
 * Meshes and grids are imported first, in subprocesses, before any ray device
 * or thread exists. */
#ifndef MURK_WORLD_STAGE_BUILD_H
#define MURK_WORLD_STAGE_BUILD_H

#include "world/stage.h"

/* *out is the caller's: murk_stage_destroy(). The scene must outlive it. */
murk_status murk_stage_create(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err);
void murk_stage_destroy(murk_stage *stage); /* NULL is fine */

/* The same in two steps, for several worlds at once: all are imported before
 * the first is built, since that makes a ray device. */
murk_status murk_stage_import(murk_stage **out, const murk_scene_desc *scene,
                              murk_error *err);
murk_status murk_stage_build(murk_stage *stage, murk_error *err);

/* As murk_stage_import, of a scene whose world_key and files are those of
 * another imported stage: what fills its world is borrowed from that, which
 * must outlive it. */
murk_status murk_stage_import_beside(murk_stage **out,
                                     const murk_scene_desc *scene,
                                     const murk_stage *other, murk_error *err);

#endif
