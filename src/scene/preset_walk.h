/* How the file of a preset is read: checks that its readers share. Only
 * preset*.c of this room include it. */
#ifndef MURK_SCENE_PRESET_WALK_H
#define MURK_SCENE_PRESET_WALK_H

#include "preset/preset.h"
#include "scene/yaml.h"

typedef struct murk_preset_walk {
    murk_preset *preset;
    murk_error *err;
} murk_preset_walk;

/* Fails at a node's place: "fog/kruse.yaml:7:3". */
murk_status murk_preset_fail(const murk_preset_walk *walk,
                             const murk_yaml *node, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
murk_status murk_preset_no_memory(const murk_preset_walk *walk);

/* A map, with no other keys than these; NULL ends them. */
murk_status murk_preset_check_keys(const murk_preset_walk *walk,
                                   const murk_yaml *map,
                                   const char *const *known);

/* A number in least..most. */
murk_status murk_preset_number(const murk_preset_walk *walk,
                               const murk_yaml *node, double min, double max,
                               double *out);

/* A list of n numbers; one number is a list of 1. */
murk_status murk_preset_numbers(const murk_preset_walk *walk,
                                const murk_yaml *node, size_t n, double *out);

/* One of the preset's parts, once its wavelengths and words are known. */
murk_status murk_preset_read_part(const murk_preset_walk *walk,
                                  const murk_yaml *map, murk_preset_part *part);

/* A part's table and its phase function (preset_tables.c). */
murk_status murk_preset_read_table(const murk_preset_walk *walk,
                                   const murk_yaml *node,
                                   murk_preset_table *out);
murk_status murk_preset_read_angles(const murk_preset_walk *walk,
                                    const murk_yaml *node,
                                    murk_preset_angles **out);

#endif
