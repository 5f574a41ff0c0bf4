/* Sensors and coverage as JSON, CSV and lines of the summary, for the commands
 * place and sense. */
#ifndef MURK_RESULTS_COVERAGE_H
#define MURK_RESULTS_COVERAGE_H

#include "results/fields.h"

/* Sensors, and their measured coverage. All pointers are borrowed. */
typedef struct murk_sensor_results {
    const murk_scene_desc *scene;
    const murk_pose *pose; /* [n] */
    size_t n;
    const murk_coverage_result
        *coverage; /* of these sensors together, measured on the light that
                      chose them (of the command sense, on the light that was
                      traced or read) */
    const murk_region_coverage *held_out_region; /* [regions of interest]; NULL:
                                                    not measured */
} murk_sensor_results;

/* Converts to degrees, rounded to nine decimals: an angle that was given in
 * degrees with up to nine decimals comes back as it was, without the rounding
 * of the conversion to radians. */
double murk_degrees(double rad);

/* Lists the fields of the object "photons". `of` points to a murk_traced. */
void murk_results_list_photons(murk_results_fields *f, const void *of);

/* Lists the field "sensors". `of` points to a murk_sensor_results. */
void murk_results_list_sensors(murk_results_fields *f, const void *of);

/* Lists the fields of sensors[i], or the columns of coverage.csv. `of` points
 * to a murk_sensor_results; NULL: the fields are only described
 * (results/fields.h). */
void murk_results_list_sensor(murk_results_fields *f, const void *of, size_t i);

/* Lists the columns of sensors.csv, which the command sense can read. `of`
 * points to a murk_sensor_results; NULL: the columns are only described. */
void murk_results_list_place(murk_results_fields *f, const void *of, size_t i);

/* Lists the fields from "weights_used" to "seen_by_at_least". `of` points to a
 * murk_sensor_results; NULL: the fields are only described. */
void murk_results_list_shares(murk_results_fields *f, const void *of);

/* A pose and its scene, for the fields of a type, a position or a view
 * direction. Both are NULL if the fields are only described. */
typedef struct murk_posed {
    const murk_scene_desc *scene;
    const murk_pose *pose;
} murk_posed;
void murk_results_list_type(murk_results_fields *f, murk_posed p);
void murk_results_list_position(murk_results_fields *f, murk_posed p);
void murk_results_list_heading(murk_results_fields *f, murk_posed p);

void murk_print_sensors(const murk_sensor_results *sensors, const char *folder);

/* Prints, within a line, the coverage of each map by itself: "surface 0.9134 +-
 * 0.0045, nothing in the volume map". */
void murk_print_maps(const murk_coverage_result *coverage);

/* Prints the line with the weights of the surface map and of the volume map in
 * the coverage. Adds a line if a map is thin (plan/few_photons.h). Prints
 * nothing if one of the maps has no weight. */
void murk_print_weights(const murk_scene_desc *scene,
                        const murk_coverage_result *coverage);

/* Prints, within a line, "0.9134 +- 0.0045", or why there is no such number. */
void murk_print_estimate(murk_estimate of);

#endif
