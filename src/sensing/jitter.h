/* Sensors not quite where and how they were meant to stand.
 *
 * Each is set down somewhere in the ball of radius step_m about its place, all
 * of it alike, and its axis turned to somewhere in the cone of half angle
 * turn_rad about its own, all directions alike: limits that a fitter keeps, not
 * a spread. Where it may be set down: within the domain (periodic sides wrap),
 * not on a surface, and where a straight way leads from its place past no
 * surface, sheets too. Its picture stays upright. */
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

/* out[n]: the sensors of draw number `draw`, a pure function of seed, draw, and
 * the sensor's place in the list. Sensors whose type sees all round are not
 * turned; type[] is what poses name. Returns how many of them found no free
 * place in a hundred tries and stay where they are. */
size_t murk_jitter_draw(murk_pose *out, const murk_pose *pose, size_t n,
                        const murk_sensor_type *type, const murk_jitter *jitter,
                        uint64_t draw);

#endif
