/* What plans are to see, as fields of JSON and lines of the summary: regions of
 * interest, and targets in place of photons. */
#ifndef MURK_RESULTS_GOALS_H
#define MURK_RESULTS_GOALS_H

#include "results/coverage.h"

/* Lists the field "regions_of_interest". `of` points to a murk_sensor_results.
 */
void murk_results_list_regions(murk_results_fields *f, const void *of);

/* Prints the table of regions of interest; nothing if there are none. */
void murk_print_regions(const murk_sensor_results *sensors);

/* The values that the field "targets" is made from. */
typedef struct murk_target_results {
    const murk_scene_desc *scene;
    const murk_target_facts *facts;
} murk_target_results;

/* Lists the field "targets", null if the scene has none. `of` points to a
 * murk_target_results. */
void murk_results_list_targets(murk_results_fields *f, const void *of);

/* Prints the line about targets; nothing if there are none. */
void murk_print_targets(const murk_target_facts *facts);

/* For the command check: prints the regions of interest and the targets that
 * the scene asks for; nothing if it asks for none. */
void murk_print_asked_goals(const murk_scene_desc *scene);

/* For messages: what standard errors are counted by ("by target" or "by emitted
 * photon"), and what the sample is ("sample of photons", "sample of targets" or
 * "list of targets"). */
const char *murk_error_by(const murk_scene_desc *scene);
const char *murk_sample_of(const murk_scene_desc *scene);

#endif
