/* Shared checks of the readers of preset files. Only preset*.c of this room
 * include it. */
#ifndef MURK_SCENE_PRESET_WALK_H
#define MURK_SCENE_PRESET_WALK_H

#include "preset/preset.h"
#include "scene/yaml.h"

/* The readers return false after a failure, whose status is kept here. */
typedef struct murk_preset_walk {
    murk_preset *preset;
    murk_error *err;
    murk_status status;
} murk_preset_walk;

/* Records an error with the place of a node, such as "fog/kruse.yaml:7:3", and
 * returns false. */
bool murk_preset_fail(murk_preset_walk *walk, const murk_yaml *node,
                      const char *format, ...)
    __attribute__((format(printf, 3, 4)));
bool murk_preset_no_memory(murk_preset_walk *walk);

/* Checks that a node is a map with no other keys than known[]; NULL ends the
 * list. */
bool murk_preset_check_keys(murk_preset_walk *walk, const murk_yaml *map,
                            const char *const *known);

/* The value of a required key; NULL and a failure if the map lacks it. */
const murk_yaml *murk_preset_get(murk_preset_walk *walk, const murk_yaml *map,
                                 const char *key);

/* Reads a number in min..max. */
bool murk_preset_number(murk_preset_walk *walk, const murk_yaml *node,
                        double min, double max, double *out);

/* Reads a list of n numbers; a single number is a list of 1. */
bool murk_preset_numbers(murk_preset_walk *walk, const murk_yaml *node,
                         size_t n, double *out);

/* Reads one part of the preset, after the preset's wavelengths and words. */
bool murk_preset_read_part(murk_preset_walk *walk, const murk_yaml *map,
                           murk_preset_part *part);

/* Reads the table of coefficients of a part, and a measured phase function
 * (preset_tables.c). */
bool murk_preset_read_table(murk_preset_walk *walk, const murk_yaml *node,
                            murk_preset_table *out);
bool murk_preset_read_angles(murk_preset_walk *walk, const murk_yaml *node,
                             murk_preset_angles **out);

#endif
