/* From the scene's tree to that of one of its conditions, and back: what a
 * condition sets, as its own scene has it resolved. */
#ifndef MURK_SCENE_CONDITIONS_H
#define MURK_SCENE_CONDITIONS_H

#include "scene/yaml.h"

typedef struct murk_condition_values {
    murk_yaml **value; /* [n] in the condition's tree, borrowed; free() it */
    size_t n;
} murk_condition_values;

/* Turns the tree of a scene, as given, into that of its condition: what it
 * sets is put in its place, and there are no conditions any more. Messages
 * name `where` and the key. */
murk_status murk_condition_apply(murk_condition_values *out, murk_yaml *root,
                                 const char *name, murk_error *err);

/* Leaves one of its conditions in the scene's tree, as given, or with NULL none
 * of them. Refuses a name that is none. */
murk_status murk_condition_leave(murk_yaml *root, const char *name,
                                 murk_error *err);

/* Writes the values, once their tree is walked, over those of the condition in
 * the scene's own tree. False when out of memory. */
bool murk_condition_put_back(murk_yaml *root, const char *name,
                             const murk_condition_values *values);

#endif
