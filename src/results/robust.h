/* Robustness of a plan: "robustness" of plan.json and coverage.json, and lines
 * of the summary. */
#ifndef MURK_RESULTS_ROBUST_H
#define MURK_RESULTS_ROBUST_H

#include "plan/robust.h"
#include "results/fields.h"
#include "scene/scene.h"

/* The values that the field "robustness" is made from. */
typedef struct murk_robust_results {
    const murk_scene_desc *scene;
    const murk_robust *robust;
} murk_robust_results;
void murk_results_list_robust(murk_results_fields *f, const void *of);

void murk_print_robust(const murk_scene_desc *scene, const murk_robust *robust);

#endif
