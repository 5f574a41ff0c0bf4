/* The weather of a scene: the observation at the time of the scene, and what
 * lights of the sky and media take from it while the scene is read. */
#ifndef MURK_SCENE_WEATHER_H
#define MURK_SCENE_WEATHER_H

#include "scene/walk.h"

#include <stdio.h>

/* The name of the preset and the word of `cover` that stand for the weather. */
#define MURK_SCENE_BY_WEATHER "weather"

/* Chooses the observation: the row of a weather year at the time of the scene
 * (that of the timeline included), or the report. Does nothing if it is chosen.
 * Fails with MURK_BAD_VALUE at the node if the scene has no weather, or a
 * weather year and no time, or if the year has no row of that time. */
murk_status murk_weather_choose(murk_key_reader *walk, const murk_yaml *node);

/* Adds the keys of `site` that the map misses and the weather year states. */
murk_status murk_weather_complete_site(murk_key_reader *walk, murk_yaml *map);

/* Adds `cover: weather` to the map of a light of the sky without the key, if
 * the scene has a weather. */
murk_status murk_weather_complete_light(murk_key_reader *walk, murk_yaml *map);

/* Fails with MURK_BAD_VALUE if a light that takes the weather states a time or
 * a place of its own, because the weather is that of the site. Warns if a
 * report is of another time than the scene. */
murk_status murk_weather_check_light(murk_key_reader *walk,
                                     const murk_yaml *map);

/* Sets the cover of a light of the sky by the clouds of the observation: clear
 * up to a quarter of the sky, overcast above seven eighths; without a statement
 * clear. */
murk_scene_cover murk_weather_cover(const murk_observation *seen);

/* The preset that `preset: weather` stands for: snow, fog or haze by the codes
 * of the report; without a code fog if the visibility is below 1 km and there
 * is no rain. */
const char *murk_weather_preset(const murk_observation *seen);

/* Adds the words that the user has not given: meteorological optical range
 * (without the visibility if the user states another amount), rain. Fails with
 * MURK_BAD_VALUE at the map if the report states no visibility and the user no
 * amount. */
murk_status murk_weather_words(murk_words *words, murk_key_reader *walk,
                               const murk_yaml *map);

/* Releases what is needed only while the scene is read. */
void murk_weather_release(murk_scene_weather *weather);

/* Prints the numbers of the observation that light depends on, if any does: as
 * a part of scene->light_key they prevent that traced light is reused after the
 * file has changed. */
void murk_weather_sign(FILE *out, const murk_scene_desc *scene);

#endif
