/* Random deviations of installed sensors from the planned poses.
 *
 * The position is uniform in a ball of radius step_m around the planned one,
 * and the axis is uniform in a cone of half angle turn_rad around the planned
 * one: limits of a tolerance, not standard deviations. A position must lie
 * within the domain (periodic sides wrap), off all surfaces, and be joined to
 * the planned position by a straight segment that meets no surface and no
 * sheet. The picture of the sensor stays upright. */
#ifndef MURK_SENSING_JITTER_H
#define MURK_SENSING_JITTER_H

#include "geometry/surfaces.h"
#include "sensing/sensor.h"

typedef struct murk_jitter {
    double step_m;   /* >= 0 */
    double turn_rad; /* 0..pi */
    uint32_t seed;
    const murk_surfaces *surfaces;
    const murk_domain *domain;
    murk_vec3 north;
} murk_jitter;

/* out[n]: the deviating poses of draw number `draw`. The random numbers of a
 * pose depend on seed, draw and index in the list alone. Types that see all
 * round are not turned; poses refer to type[]. Returns the number of sensors
 * for which a hundred tries found no free position; these stay at the planned
 * position, and are turned all the same. */
size_t murk_jitter_draw(murk_pose *out, const murk_pose *pose, size_t n,
                        const murk_sensor_type *type, const murk_jitter *jitter,
                        uint64_t draw);

#endif
