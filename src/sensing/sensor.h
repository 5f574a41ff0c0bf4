/* Sensor types and poses: the directions and photons that a sensor can detect.
 *
 * Headings are clockwise from north as seen from above, tilts are upward from
 * the horizon. A sensor looks along its axis. The picture is upright: `right`
 * is horizontal for every tilt. */
#ifndef MURK_SENSING_SENSOR_H
#define MURK_SENSING_SENSOR_H

#include "base/kinds.h"
#include "base/vector.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct murk_sensor_type {
    double least_range_m; /* nearer photons are not seen; 0: no limit */
    double range_m;       /* above least_range_m, may be INFINITY */
    murk_view view;
    double cone_rad;           /* of cones: whole angle, above 0 and at most 2
                                  pi */
    double hfov_rad, vfov_rad; /* of frusta: whole angles, above 0 and below
                                  pi */
    double acceptance_rad; /* light scattered forward by less than this counts
                              as not scattered (medium/rescaled.h), 0..pi */
    bool toward; /* detects only light that travels toward the sensor: at more
                    than 90 degrees to the axis, or for a sphere to the line
                    from the sensor to the photon (murk_field_takes()) */
    uint32_t bands; /* bit b: detects band b; 0: all bands */
    /* For detection by power only (sensing/power.h). */
    double aperture_m2, quantum_efficiency, exposure_s;
    double target_m2,
        target_m3; /* area and volume of the target to be detected */
} murk_sensor_type;

typedef struct murk_pose {
    uint32_t type; /* index in the list of types */
    murk_vec3 position;
    double heading_rad, tilt_rad; /* 0 for spheres */
} murk_pose;

/* In place of the type of a pose: there is no sensor. Rows, coverage and jitter
 * take such a pose as a sensor that sees nothing and is not displaced; nothing
 * else takes it. */
#define MURK_POSE_OF_NONE UINT32_MAX

typedef struct murk_sensor_frame {
    murk_vec3 axis, right, up; /* orthonormal */
} murk_sensor_frame;

/* The frame of a pose. `north` is horizontal and has length 1. */
murk_sensor_frame murk_pose_frame(const murk_pose *pose, murk_vec3 north);

/* The field of view of a pose. */
typedef struct murk_field {
    murk_view view;
    murk_sensor_frame frame;
    double cosine;           /* of half the cone angle */
    double h_slope, v_slope; /* tangents of half the frustum's angles */
    double least2_m2;        /* minimum range, squared */
    bool toward;
} murk_field;

/* Makes the field of view of a pose. */
murk_field murk_field_of(const murk_sensor_type *type, const murk_pose *pose,
                         murk_vec3 north);

/* True if a point at `offset` from the sensor is in the field of view and not
 * nearer than the minimum range, edges included. The maximum range is not
 * tested. */
bool murk_field_contains(const murk_field *field, murk_vec3 offset);

/* True if the sensor detects light that arrives from a point at `offset` from
 * the sensor and that travelled along `travel` there: always, unless `toward`
 * is set. Then the angle between `travel` and the axis of the sensor (for a
 * sphere `offset`) must exceed 90 degrees. The field of view is not tested. */
bool murk_field_takes(const murk_field *field, murk_vec3 offset,
                      murk_vec3 travel);

#endif
