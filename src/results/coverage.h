/* Sensors and coverage as JSON, CSV and lines: what place and sense share. */
#ifndef MURK_RESULTS_COVERAGE_H
#define MURK_RESULTS_COVERAGE_H

#include "results/results.h"

/* "photons": {emitted, surface, volume} */
void murk_json_photons(cJSON *root, const murk_traced *traced);

/* "sensors": one object a sensor; n poses, coverage of just those. */
void murk_json_sensors(cJSON *root, const murk_scene_desc *scene,
                       const murk_pose *sensor, size_t n,
                       const murk_coverage_result *coverage);

/* "seen_by_at_least": [by 1, by 2, ..] */
void murk_json_seen(cJSON *root, const murk_coverage_result *coverage,
                    size_t n);

murk_status murk_add_sensors_csv(murk_results *results,
                                 const murk_scene_desc *scene,
                                 const murk_pose *sensor, size_t n,
                                 murk_error *err);
murk_status murk_add_coverage_csv(murk_results *results,
                                  const murk_scene_desc *scene,
                                  const murk_pose *sensor, size_t n,
                                  const murk_coverage_result *coverage,
                                  murk_error *err);

/* The shortest decimal that reads back to the same number. */
void murk_number_text(char out[32], double value);

/* heading_deg and tilt_deg; null all round. */
void murk_json_heading(cJSON *object, const murk_scene_desc *scene,
                       const murk_pose *pose);

/* "number,x,y,z,type,heading,tilt", without an end of line; the last two empty
 * all round. */
void murk_write_pose(FILE *to, size_t number, const murk_scene_desc *scene,
                     const murk_pose *pose);

void murk_print_sensors(const murk_scene_desc *scene, const murk_pose *sensor,
                        size_t n, const murk_coverage_result *coverage,
                        const char *folder);

/* "surface 0.91 +- 0.01, no volume photons": each map's own fraction. */
void murk_print_maps(const murk_coverage_result *coverage);

/* Adds "weights_used", what each map has in the total, and "thin_map": null, or
 * the map whose share rests on few photons (plan/few_photons.h). */
void murk_json_weights(cJSON *root, const murk_scene_desc *scene,
                       const murk_coverage_result *coverage);

/* The line that says what a coverage over two maps is; nothing where one map
 * has it all. */
void murk_print_weights(const murk_scene_desc *scene,
                        const murk_coverage_result *coverage);

/* "0.9134 +- 0.0045", or why there is no such number. */
void murk_print_estimate(murk_estimate of);

#endif
