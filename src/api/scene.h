/* Turns a scene handle (api/handles.h) into a murk_scene_desc, the struct of
 * scene/scene.h with all values of the scene. */
#ifndef MURK_API_SCENE_H
#define MURK_API_SCENE_H

#include "api/handles.h"
#include "scene/override.h"

/* The text of a scene of murk_scene_create(): the key `murk` alone. */
#define MURK_EMPTY_SCENE "murk: 1\n"

/* Reads the text of a scene, changed by the keys in scene->set, into a new
 * struct *out, which the caller of this function releases by
 * murk_scene_desc_destroy(). Fails as murk_scene_desc_parse(). */
murk_status murk_scene_describe(murk_scene_desc **out, const murk_scene *scene,
                                murk_error *err);

/* Passes to the log a note if the light of some bands counts 0 in the unit of
 * the scene (murk_units_note()), and a warning for each key without effect. */
void murk_scene_tell(const murk_scene_desc *scene);

#endif
