/* Keys that are given and do nothing, since another key has not the value that
 * they are for: told, as they are often slips of the pen.
 *
 * Inside this room only; the table is in scenes/README.md, too. */
#ifndef MURK_SCENE_IDLE_H
#define MURK_SCENE_IDLE_H

#include "scene/scene.h"
#include "scene/yaml.h"

/* One row of the table. */
typedef struct murk_idle_rule {
    const char *key; /* "sensors.types.*.cost": * is any item */
    bool (*acts)(const murk_scene_desc *scene);
    const char *text; /* "has no effect without sensors.budget" */
} murk_idle_rule;

extern const murk_idle_rule murk_idle_constraints[]; /* key NULL ends it */

/* Fills scene->idle from the walked tree `root`: keys that the user has given,
 * not at their default, that act neither in the scene nor in any of its
 * conditions; and media that lie in no region. False when out of memory. */
bool murk_idle_find(murk_scene_desc *scene, const murk_yaml *root);

#endif
