/* One reading: a line of the file. */
#ifndef MURK_READINGS_LINE_H
#define MURK_READINGS_LINE_H

#include "readings/cells.h"
#include "sensing/sensor.h"

typedef struct murk_reading {
    murk_reading_kind kind;
    size_t line;      /* line of the file, from 1 */
    size_t condition; /* index in the scene, from 0; SIZE_MAX: the scene without
                       * a condition */
    murk_vec3 position;
    murk_vec3 to;          /* transmittance: the other end of the segment;
                            * extinction: the position */
    murk_vec3 direction;   /* irradiance: unit vector, outward normal of the
                            * receiver */
    double radius_m;       /* fluence, irradiance: radius of the sphere of the
                            * receiver */
    double acceptance_rad; /* NaN: not given */
    int band;              /* -1: all bands together */
    murk_pose pose;        /* coverage: the sensor */
    size_t gain;           /* index in murk_readings.gain of the factor;
                            * SIZE_MAX: no factor */
    murk_reading_unit unit;
    double value, standard_error; /* in this unit; the error is above 0 */
    bool is_held_out;
} murk_reading;

/* Reads one line; positions, segments and spheres must lie in the domain. Fails
 * with MURK_BAD_VALUE or MURK_BAD_FILE at line and column. out->gain stays
 * SIZE_MAX. *gain is the name of the factor, to be numbered later, and *group
 * that of the group; both point into the table and are empty if the line has
 * none. */
murk_status murk_reading_read(murk_reading *out, const char **group,
                              const char **gain,
                              const murk_reading_source *source, size_t row,
                              murk_error *err);

#endif
