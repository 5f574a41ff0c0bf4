/* The built-in presets (media/FAMILY/NAME.yaml): list, search by name, and
 * reading. The format is described in media/README.md. */
#ifndef MURK_SCENE_PRESETS_H
#define MURK_SCENE_PRESETS_H

#include "preset/preset.h"

/* Longer than any "FAMILY/NAME". */
#define MURK_PRESET_NAME_SIZE 64

/* The number of presets; and the name of preset `index`, such as "fog/kruse",
 * "" if there are fewer. Names are in alphabetical order. */
size_t murk_presets_count(void);
void murk_presets_name(size_t index, char out[MURK_PRESET_NAME_SIZE]);

/* Reads a built-in preset. The caller owns *out and releases it with
 * murk_preset_destroy(). An unknown name fails with MURK_BAD_VALUE at `where`;
 * the message suggests a similar name if there is one. Other failures are those
 * of murk_preset_parse(). */
murk_status murk_presets_read(murk_preset **out, const char *name,
                              const char *where, murk_error *err);

/* Reads a preset from text. `name` becomes the name of the preset; tables are
 * looked up among the built-in files. Fails with MURK_BAD_FILE, MURK_BAD_VALUE
 * or MURK_NO_MEMORY at a place in NAME.yaml or in a table. */
murk_status murk_preset_parse(murk_preset **out, const char *name,
                              const char *text, size_t size, murk_error *err);

#endif
