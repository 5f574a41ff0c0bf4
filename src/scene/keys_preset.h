/* The key table of preset files (media/README.md). */
#ifndef MURK_SCENE_KEYS_PRESET_H
#define MURK_SCENE_KEYS_PRESET_H

#include "scene/walk.h"

/* Reads a preset file into a murk_preset. */
extern const murk_keys murk_preset_keys;

/* Reads a measured phase function, or one for each of several wavelengths, from
 * the csv file in media/ that a node names (scene/preset_angles.c); `angles` is
 * a murk_preset_angles **. */
murk_status murk_preset_read_angles(murk_key_reader *walk, const murk_key *key,
                                    murk_yaml *node, void *angles);

#endif
