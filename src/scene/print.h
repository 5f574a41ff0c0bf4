/* Prints a tree as YAML text. */
#ifndef MURK_SCENE_PRINT_H
#define MURK_SCENE_PRINT_H

#include "scene/yaml.h"

#include <stdio.h>

#include <stdio.h>

/* Prints a text as a scalar, in quotes if it could be read as anything else. */
void murk_print_text(FILE *out, const char *text);

/* Prints in one line: {a: 1, b: [2, 3]}. NULL when out of memory; the caller
 * frees the text with free(). */
char *murk_print_flow(const murk_yaml *node);

/* Prints a map as a file: one line for each key, and one line for each map
 * within a list or a map of maps. Prints only the keys for which is_wanted()
 * is true (NULL: all). */
char *murk_print_file(const murk_yaml *map, bool (*is_wanted)(const char *key));
void murk_print_map(FILE *out, const murk_yaml *map,
                    bool (*is_wanted)(const char *key));

/* Closes a stream of open_memstream() and returns the text, which the caller
 * frees with free(); NULL when out of memory. */
char *murk_print_finish(FILE *out, char **text);

#endif
