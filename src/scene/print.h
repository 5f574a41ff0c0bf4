/* Prints a tree as YAML text. */
#ifndef MURK_SCENE_PRINT_H
#define MURK_SCENE_PRINT_H

#include "scene/yaml.h"

#include <stdio.h>

/* Prints a tree in one line: {a: 1, b: [2, 3]}. Returns the text, which the
 * caller frees with free(); NULL when out of memory. */
char *murk_print_flow(const murk_yaml *node);

/* Print a map as a file: one line for each key, and one line for each item of a
 * value that contains maps or lists of lists. Only the keys for which
 * is_wanted() is true (NULL: all) are printed. murk_print_file() returns the
 * text, which the caller frees with free(); NULL when out of memory. */
char *murk_print_file(const murk_yaml *map, bool (*is_wanted)(const char *key));
void murk_print_map(FILE *out, const murk_yaml *map,
                    bool (*is_wanted)(const char *key));

/* Closes a stream of open_memstream() and returns the text, which the caller
 * frees with free(); NULL when out of memory. */
char *murk_print_finish(FILE *out, char **text);

#endif
