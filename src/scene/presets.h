/* The presets that are built in (media/FAMILY/NAME.yaml): listed, found by
 * name, and read. The format: media/README.md. */
#ifndef MURK_SCENE_PRESETS_H
#define MURK_SCENE_PRESETS_H

#include "preset/preset.h"

#define MURK_PRESET_NAME_SIZE 64

/* How many there are, and the name of one: "fog/kruse", in order. */
size_t murk_presets_count(void);
void murk_presets_name(size_t index, char out[MURK_PRESET_NAME_SIZE]);

/* *out is the caller's: murk_preset_destroy(). An unknown name fails at `where`
 * with the one that was meant, or with all there are. */
murk_status murk_presets_read(murk_preset **out, const char *name,
                              const char *where, murk_error *err);

/* A preset from text; its name is for messages, tables are looked up among the
 * files that are built in. */
murk_status murk_preset_parse(murk_preset **out, const char *name,
                              const char *text, size_t size, murk_error *err);

#endif
