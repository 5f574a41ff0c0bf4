/* What plans are to see, in results and on the screen: regions of interest,
 * and targets in place of photons. */
#ifndef MURK_RESULTS_GOALS_H
#define MURK_RESULTS_GOALS_H

#include "results/coverage.h"

/* Row "regions_of_interest"; of: a murk_sensor_results. */
void murk_results_list_regions(murk_results_fields *f, const void *of);

/* The table of them; nothing where there are none. */
void murk_print_regions(const murk_sensor_results *sensors);

/* Row "targets"; of: */
typedef struct murk_target_results {
    const murk_scene_desc *scene;
    const murk_target_facts *facts;
} murk_target_results;
void murk_results_list_targets(murk_results_fields *f, const void *of);

/* The line that tells; nothing where photons are seen. */
void murk_print_targets(const murk_target_facts *facts);

/* For check: the regions of interest and targets that are asked for; nothing
 * where there are none. */
void murk_print_asked_goals(const murk_scene_desc *scene);

/* What errors go by, and what a sample is of. */
const char *murk_error_by(const murk_scene_desc *scene);
const char *murk_sample_of(const murk_scene_desc *scene);

#endif
