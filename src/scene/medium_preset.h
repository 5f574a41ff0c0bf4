/* Computes the optical properties of a medium from a preset. A property that
 * the map of the medium in the scene gives is not computed. Droplets of a file
 * have the properties of a preset whose words are known when the file has been
 * read. */
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

/* Sets *out to the medium with the given effective radius [um], and with the
 * albedo and the phase functions that droplets of that radius and of the
 * effective variance of the medium have in the bands of the scene, by the
 * preset cloud/droplets; their sizes have the gamma distribution (Hansen &
 * Travis, Space Sci. Rev. 16 (1974) 527, doi:10.1007/BF00168069). With a radius
 * of 0 the file has no droplets, and *out scatters isotropically without
 * absorption. *out borrows from the medium and owns its phase functions alone,
 * which murk_medium_droplets_release() releases. Fails at the place of the
 * medium as murk_preset_evaluate(), for example if a band or the radius is
 * outside the range of the preset. */
murk_status murk_medium_droplets_fill(murk_scene_medium *out,
                                      const murk_scene_medium *medium,
                                      double radius_um,
                                      const murk_scene_desc *scene,
                                      murk_error *err);
void murk_medium_droplets_release(murk_scene_medium *medium);

/* Prints one line with the radius, the albedo and the phase functions of
 * *medium, which murk_medium_droplets_fill() made: as a part of the light key
 * of a stage it prevents that traced light is reused after the radius or the
 * preset has changed. */
void murk_medium_droplets_sign(FILE *out, const murk_scene_medium *medium,
                               int bands);

/* Prints the computed properties of presets, one line for each medium that has
 * a preset: as a part of scene->light_key they prevent that traced light is
 * reused after a preset has changed. */
void murk_medium_preset_sign(FILE *out, const murk_scene_desc *scene);

#endif
