/* Sensors and coverage as JSON, CSV and lines: what place and sense share. */
#ifndef MURK_RESULTS_COVERAGE_H
#define MURK_RESULTS_COVERAGE_H

#include "results/fields.h"

/* Sensors, and the coverage that was measured of them. */
typedef struct murk_sensor_results {
    const murk_scene_desc *scene;
    const murk_pose *pose; /* [n] */
    size_t n;
    const murk_coverage_result *coverage;        /* of just these */
    const murk_region_coverage *held_out_region; /* NULL: not held out */
} murk_sensor_results;

/* An angle as it was asked for: turning to radians and back leaves rounding
 * behind, beyond nine decimals. */
double murk_degrees(double rad);

/* Rows of "photons"; of: a murk_traced. */
void murk_results_list_photons(murk_results_fields *f, const void *of);

/* Row "sensors"; of: a murk_sensor_results. */
void murk_results_list_sensors(murk_results_fields *f, const void *of);

/* Rows of sensors[], and columns of coverage.csv; of: a murk_sensor_results. */
void murk_results_list_sensor(murk_results_fields *f, const void *of, size_t i);

/* Columns of sensors.csv, which sense reads; of: a murk_sensor_results. */
void murk_results_list_place(murk_results_fields *f, const void *of, size_t i);

/* Rows from "weights_used" to "seen_by_at_least"; of: a murk_sensor_results. */
void murk_results_list_shares(murk_results_fields *f, const void *of);

/* Rows of one pose; scene and pose are NULL in a description. */
typedef struct murk_posed {
    const murk_scene_desc *scene;
    const murk_pose *pose;
} murk_posed;
void murk_results_list_type(murk_results_fields *f, murk_posed p);
void murk_results_list_position(murk_results_fields *f, murk_posed p);
void murk_results_list_heading(murk_results_fields *f, murk_posed p);

void murk_print_sensors(const murk_sensor_results *sensors, const char *folder);

/* "surface 0.91 +- 0.01, no volume photons": each map's own fraction. */
void murk_print_maps(const murk_coverage_result *coverage);

/* Prints the line with the weights of the surface map and of the volume map in
 * the coverage. Prints nothing if one of the maps has no weight. */
void murk_print_weights(const murk_scene_desc *scene,
                        const murk_coverage_result *coverage);

/* "0.9134 +- 0.0045", or why there is no such number. */
void murk_print_estimate(murk_estimate of);

#endif
