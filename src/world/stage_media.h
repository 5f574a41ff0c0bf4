/* The media of a scene, for the world of a stage. */
#ifndef MURK_WORLD_STAGE_MEDIA_H
#define MURK_WORLD_STAGE_MEDIA_H

#include "world/stage.h"

/* Creates the media of a scene in the domain of the stage. The scene is that of
 * the stage, or one that differs from it in numbers alone (a fit varies such
 * numbers). Regions that are meshes use the boundary meshes of the stage.
 * fillings and phases belong to the scene that is passed and must outlive *out,
 * as that scene must. The caller owns *out (murk_media_destroy()). */
murk_status murk_stage_media(murk_media **out, const murk_stage *stage,
                             const murk_scene_desc *scene,
                             const murk_fillings *fillings,
                             const murk_phases *phases, murk_error *err);

#endif
