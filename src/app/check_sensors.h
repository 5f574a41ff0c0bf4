/* What check says of the scene's sensors: their types, and how many candidates
 * they make at the usable sites. */
#ifndef MURK_APP_CHECK_SENSORS_H
#define MURK_APP_CHECK_SENSORS_H

#include "plan/poses.h"
#include "results/json.h"

/* "sensors": [{name, ..}]. poses NULL: none, null. */
void murk_json_sensor_types(cJSON *root, const murk_scene_desc *scene,
                            const murk_poses *poses);
/* A line a type, and one with the number of candidates. */
void murk_print_sensor_types(const murk_scene_desc *scene,
                             const murk_poses *poses);

#endif
