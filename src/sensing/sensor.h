/* Sensors: what a type of them takes up, and where one stands and looks.
 *
 * Headings are clockwise from north as seen from above, tilts upward from the
 * horizon. A sensor looks along its axis; its picture is upright: `right` is
 * level, whatever the tilt. */
#ifndef MURK_SENSING_SENSOR_H
#define MURK_SENSING_SENSOR_H

#include "base/kinds.h"
#include "base/vector.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct murk_sensor_type {
    double least_range_m; /* what is nearer is not seen; 0: none */
    double range_m;       /* above least_range_m, may be INFINITY */
    murk_view view;
    double cone_rad;           /* whole angle, above 0 and at most 2 pi */
    double hfov_rad, vfov_rad; /* frustum: whole angles, above 0, below pi */
    double acceptance_rad; /* light scattered forward by less still counts as
                              not scattered (medium/acceptance.h), 0..pi */
    bool toward;    /* sees only light that travels toward it: against the axis,
                       for a sphere toward its place */
    uint32_t bands; /* bit b: sees band b; 0: all bands */
    /* For detection by power (sensing/power.h). */
    double aperture_m2, quantum_efficiency, exposure_s;
    double target_m2, target_m3; /* what is to be noticed */
} murk_sensor_type;

typedef struct murk_pose {
    uint32_t type; /* of the list of types it goes with */
    murk_vec3 position;
    double heading_rad, tilt_rad; /* 0 for spheres */
} murk_pose;

typedef struct murk_sensor_frame {
    murk_vec3 axis, right, up; /* orthonormal */
} murk_sensor_frame;

/* `north` is level and of length 1. */
murk_sensor_frame murk_pose_frame(const murk_pose *pose, murk_vec3 north);

/* A type's field of view, made ready for one pose. */
typedef struct murk_field {
    murk_view view;
    murk_sensor_frame frame;
    double cosine;           /* of half the cone */
    double h_slope, v_slope; /* tangents of half the frustum's angles */
    double least2_m2;        /* least range, squared */
    bool toward;
} murk_field;

murk_field murk_field_of(const murk_sensor_type *type, const murk_pose *pose,
                         murk_vec3 north);

/* Whether what lies `way` from the sensor is in view, edges included. The
 * farthest range is not asked here. */
bool murk_field_contains(const murk_field *field, murk_vec3 way);

/* Whether light that travels along `travel`, from `way` off the sensor, is
 * such as the type takes up. */
bool murk_field_takes(const murk_field *field, murk_vec3 way, murk_vec3 travel);

#endif
