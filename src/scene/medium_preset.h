/* Computes the optical properties of a medium from a preset, except properties
 * that the scene gives itself. */
#ifndef MURK_SCENE_MEDIUM_PRESET_H
#define MURK_SCENE_MEDIUM_PRESET_H

#include "scene/walk.h"

#include <stdio.h>

/* For a map with a `preset`: checks that the preset exists and knows the
 * given words, and adds the defaults of the other words to the map. */
murk_status murk_medium_preset_complete(murk_key_reader *walk, murk_yaml *map);

/* Computes extinction, albedo and phase function from the preset for those
 * that the map does not give. */
murk_status murk_medium_preset_fill(murk_key_reader *walk, const murk_yaml *map,
                                    murk_scene_medium *medium);

/* Prints the computed properties of presets, one line for each medium that has
 * a preset: as a part of scene->light_key they prevent that traced light is
 * reused after a preset has changed. */
void murk_medium_preset_sign(FILE *out, const murk_scene_desc *scene);

#endif
