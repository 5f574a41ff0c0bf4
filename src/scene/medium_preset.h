/* Computes the optical properties of a medium from a preset. A property that
 * the map of the medium in the scene gives is not computed. */
#ifndef MURK_SCENE_MEDIUM_PRESET_H
#define MURK_SCENE_MEDIUM_PRESET_H

#include "scene/walk.h"

#include <stdio.h>

/* For a map with a `preset`: checks that the preset exists and knows the given
 * words, and adds the defaults of the other words to the map. Words that state
 * an amount get no default if the map has another such word. Does nothing for
 * other maps. */
murk_status murk_medium_preset_complete(murk_key_reader *walk, murk_yaml *map);

/* Computes from the preset those of extinction, albedo and phase function that
 * the map does not give, for the bands of walk->scene. */
murk_status murk_medium_preset_fill(murk_key_reader *walk, const murk_yaml *map,
                                    murk_scene_medium *medium);

/* Prints the computed properties of presets, one line for each medium that has
 * a preset: as a part of scene->light_key they prevent that traced light is
 * reused after a preset has changed. */
void murk_medium_preset_sign(FILE *out, const murk_scene_desc *scene);

#endif
