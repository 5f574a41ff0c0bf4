/* Turns a scene handle into the struct murk_scene_desc of the room scene. */
#ifndef MURK_API_SCENE_H
#define MURK_API_SCENE_H

#include "api/handles.h"
#include "scene/override.h"

/* The text of a scene without keys. */
#define MURK_EMPTY_SCENE "murk: 1\n"

/* Reads the text of a scene, with the keys that murk_scene_set() gave, into a
 * new struct *out, which the caller of this function releases by
 * murk_scene_desc_destroy(). */
murk_status murk_scene_describe(murk_scene_desc **out, const murk_scene *scene,
                                murk_error *err);

/* Gives the note on units, and a warning for each key without effect. */
void murk_scene_tell(const murk_scene_desc *scene);

#endif
