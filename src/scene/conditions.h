/* Turns the YAML tree of a scene into the tree of one of the scene's
 * conditions, and writes the resolved values of a condition back. */
#ifndef MURK_SCENE_CONDITIONS_H
#define MURK_SCENE_CONDITIONS_H

#include "scene/yaml.h"

typedef struct murk_condition_values {
    murk_yaml **value; /* [n] nodes in the tree of the condition, borrowed; the
                          caller frees the array with free() */
    size_t n;
} murk_condition_values;

/* Turns the tree of a scene, as the user gave it, into the tree of the
 * condition `name`, which must exist: the values of the condition are put in
 * place, and the keys `conditions`, `placement.over` and
 * `placement.condition_weights` are removed. Messages name the place of the
 * value and conditions.NAME.KEY. Fails as murk_override_put()
 * (scene/override.h) does, or with MURK_NO_MEMORY, and leaves *out
 * unchanged. */
murk_status murk_condition_apply(murk_condition_values *out, murk_yaml *root,
                                 const char *name, murk_error *err);

/* As murk_condition_apply(), without returning the values, for a condition that
 * a study names; with name NULL the same keys are removed and no value is put
 * in place. Fails with MURK_BAD_VALUE if the scene has no condition of that
 * name. */
murk_status murk_condition_leave(murk_yaml *root, const char *name,
                                 murk_error *err);

/* Copies the values, after their tree has been resolved, over those of the
 * condition in the scene's own tree. False when out of memory. */
bool murk_condition_put_back(murk_yaml *root, const char *name,
                             const murk_condition_values *values);

#endif
