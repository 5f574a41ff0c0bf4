/* What check says of the scene's cameras: the memory that their pictures will
 * take, before any light is traced for them. */
#ifndef MURK_APP_CHECK_CAMERAS_H
#define MURK_APP_CHECK_CAMERAS_H

#include "lightmap/lightmap.h"
#include "results/json.h"

/* "cameras": [{name, pixels, samples, memory_bytes}]: of one picture by maps,
 * the maps and their copies included. */
void murk_json_cameras(cJSON *root, const murk_scene_desc *scene,
                       const murk_forecast *forecast);
/* A line a camera. */
void murk_print_cameras(const murk_scene_desc *scene,
                        const murk_forecast *forecast);

/* Of pictures that would not fit into the memory that is free. */
void murk_warn_of_cameras(const murk_scene_desc *scene,
                          const murk_forecast *forecast);

#endif
