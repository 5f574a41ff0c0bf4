/* A medium whose numbers are a preset's: what the scene does not say itself. */
#ifndef MURK_SCENE_MEDIUM_PRESET_H
#define MURK_SCENE_MEDIUM_PRESET_H

#include "scene/walk.h"

/* Of a map that has a `preset`: the preset is there and knows the words that
 * are given, and the defaults of the others join the map. */
murk_status murk_medium_preset_complete(murk_key_reader *walk, murk_yaml *map);

/* Fills extinction, albedo and phase where the map does not give them. */
murk_status murk_medium_preset_fill(murk_key_reader *walk, const murk_yaml *map,
                                    murk_scene_medium *medium);

/* Adds what presets came to in this scene to its light_key: a preset that says
 * something else another day is another light. False when out of memory. */
bool murk_medium_preset_sign(murk_scene_desc *scene);

#endif
