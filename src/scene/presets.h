/* The built-in presets (media/FAMILY/NAME.yaml): list, search by name, and
 * reading. The format is described in media/README.md. */
#ifndef MURK_SCENE_PRESETS_H
#define MURK_SCENE_PRESETS_H

#include "preset/preset.h"

/* Longer than any "FAMILY/NAME". */
#define MURK_PRESET_NAME_SIZE 64

/* The number of presets, and the name of one, such as "fog/kruse", in order. */
size_t murk_presets_count(void);
void murk_presets_name(size_t index, char out[MURK_PRESET_NAME_SIZE]);

/* Reads a built-in preset. The caller owns *out and releases it with
 * murk_preset_destroy(). An unknown name fails at `where`; the message
 * suggests a similar name or lists all. */
murk_status murk_presets_read(murk_preset **out, const char *name,
                              const char *where, murk_error *err);

/* Reads a preset from text. `name` is for messages; tables are looked up
 * among the built-in files. */
murk_status murk_preset_parse(murk_preset **out, const char *name,
                              const char *text, size_t size, murk_error *err);

#endif
