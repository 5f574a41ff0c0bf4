/* "robustness" of plan.json and coverage.json, and its lines. */
#ifndef MURK_RESULTS_ROBUST_H
#define MURK_RESULTS_ROBUST_H

#include "plan/robust.h"
#include "scene/scene.h"

#include <cjson/cJSON.h>

void murk_json_robust(cJSON *root, const murk_scene_desc *scene,
                      const murk_robust *robust);
void murk_print_robust(const murk_scene_desc *scene, const murk_robust *robust);

#endif
