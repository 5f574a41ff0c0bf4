/* Finds keys that the user has set and that have no effect, because they are
 * used only together with a certain value of another key, or belong to a medium
 * that no region uses. Such keys are reported, because they are often mistakes.
 *
 * For use inside src/scene only; doc/reference/scene-file.md shows the same
 * table. */
#ifndef MURK_SCENE_IDLE_H
#define MURK_SCENE_IDLE_H

#include "scene/scene.h"
#include "scene/yaml.h"

/* One row of the table. */
typedef struct murk_idle_key {
    const char *key;  /* "sensors.types.*.cost": * stands for any item */
    int use;          /* the feature of a scene with which the key has an
                       * effect: a constant of idle.c */
    const char *text; /* "has no effect without sensors.budget" */
} murk_idle_key;

extern const murk_idle_key murk_idle_keys[]; /* key NULL ends it */

/* Fills scene->idle from the resolved tree `root`: keys that the user has
 * set to another value than the default, and that have an effect neither in
 * the scene nor in any condition, nor may have one at another time; and media
 * that no region uses. False when out of memory. */
bool murk_idle_find(murk_scene_desc *scene, murk_yaml *root);

/* True if the light of the scene depends on the time of its site. */
bool murk_idle_asks_time(const murk_scene_desc *scene);

#endif
