/* Shared checks of the readers of preset files. Only preset*.c of this room
 * include it. */
#ifndef MURK_SCENE_PRESET_WALK_H
#define MURK_SCENE_PRESET_WALK_H

#include "preset/preset.h"
#include "scene/yaml.h"

typedef struct murk_preset_walk {
    murk_preset *preset;
    murk_error *err;
} murk_preset_walk;

/* Fails at the place of a node: "fog/kruse.yaml:7:3". */
murk_status murk_preset_fail(const murk_preset_walk *walk,
                             const murk_yaml *node, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
murk_status murk_preset_no_memory(const murk_preset_walk *walk);

/* Checks that a node is a map with no other keys than known[]; NULL ends the
 * list. */
murk_status murk_preset_check_keys(const murk_preset_walk *walk,
                                   const murk_yaml *map,
                                   const char *const *known);

/* Reads a number in min..max. */
murk_status murk_preset_number(const murk_preset_walk *walk,
                               const murk_yaml *node, double min, double max,
                               double *out);

/* Reads a list of n numbers; a single number is a list of 1. */
murk_status murk_preset_numbers(const murk_preset_walk *walk,
                                const murk_yaml *node, size_t n, double *out);

/* Reads one part of the preset, after the preset's wavelengths and words. */
murk_status murk_preset_read_part(const murk_preset_walk *walk,
                                  const murk_yaml *map, murk_preset_part *part);

/* Reads the table of coefficients of a part, and a measured phase function
 * (preset_tables.c). */
murk_status murk_preset_read_table(const murk_preset_walk *walk,
                                   const murk_yaml *node,
                                   murk_preset_table *out);
murk_status murk_preset_read_angles(const murk_preset_walk *walk,
                                    const murk_yaml *node,
                                    murk_preset_angles **out);

#endif
