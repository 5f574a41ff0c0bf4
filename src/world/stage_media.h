/* The media of a scene in a stage's world. */
#ifndef MURK_WORLD_STAGE_MEDIA_H
#define MURK_WORLD_STAGE_MEDIA_H

#include "world/stage.h"

/* Those of the stage's own scene, or of one that differs from it in numbers
 * alone: its regions and what they hold, in the stage's domain, with the
 * stage's boundary meshes of regions that are meshes. fillings and phases are
 * the scene's, and must outlive *out as the scene must. *out is the caller's:
 * murk_media_destroy(). */
murk_status murk_stage_media(murk_media **out, const murk_stage *stage,
                             const murk_scene_desc *scene,
                             const murk_fillings *fillings,
                             const murk_phases *phases, murk_error *err);

#endif
