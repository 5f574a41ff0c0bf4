/* A tree as YAML text. */
#ifndef MURK_SCENE_PRINT_H
#define MURK_SCENE_PRINT_H

#include "scene/yaml.h"

/* In one line: {a: 1, b: [2, 3]}. NULL when out of memory; free() it. */
char *murk_print_flow(const murk_yaml *node);

/* A map as a file: each key on its line, with a line for each map within a
 * list or map of maps. Only the keys that `is_wanted` (NULL: all). */
char *murk_print_file(const murk_yaml *map, bool (*is_wanted)(const char *key));

#endif
