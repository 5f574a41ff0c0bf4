/* What plans are to see, in results and on the screen: regions of interest,
 * and targets in place of photons. */
#ifndef MURK_RESULTS_GOALS_H
#define MURK_RESULTS_GOALS_H

#include "results/results.h"

/* Adds "regions_of_interest": one item a region of the scene, none where it has
 * none. in_sample and held_out[regions]; held_out NULL: null. */
void murk_json_regions(cJSON *root, const murk_scene_desc *scene,
                       const murk_region_coverage *in_sample,
                       const murk_region_coverage *held_out);

/* The table of them; nothing where there are none. */
void murk_print_regions(const murk_scene_desc *scene,
                        const murk_region_coverage *in_sample,
                        const murk_region_coverage *held_out);

/* Adds "targets": what was drawn or listed; null where photons are seen. */
void murk_json_targets(cJSON *root, const murk_scene_desc *scene,
                       const murk_target_facts *facts);

/* The line that tells; nothing where photons are seen. */
void murk_print_targets(const murk_target_facts *facts);

/* For check: the regions of interest and targets that are asked for; nothing
 * where there are none. */
void murk_print_asked_goals(const murk_scene_desc *scene);

/* What errors go by, and what a sample is of. */
const char *murk_error_by(const murk_scene_desc *scene);
const char *murk_sample_of(const murk_scene_desc *scene);

#endif
