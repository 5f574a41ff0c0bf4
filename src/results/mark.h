/* The shape that stands for a sensor in plan.ply: an octahedron about one that
 * sees all round; else what it sees as far as four times that: a pyramid, or a
 * cone of 16 sides, with its point at the sensor. */
#ifndef MURK_RESULTS_MARK_H
#define MURK_RESULTS_MARK_H

#include "sensing/sensor.h"

#include <stddef.h>

#define MURK_MARK_SIDES 16 /* of a cone */
/* Of a cone: the rim and the point; sides and the cap of the rim. */
#define MURK_MARK_CORNERS_MAX (MURK_MARK_SIDES + 1)
#define MURK_MARK_FACES_MAX   (2 * MURK_MARK_SIDES - 2)

typedef struct murk_mark {
    size_t corners, faces;
    murk_vec3 corner[MURK_MARK_CORNERS_MAX];
    uint8_t face[MURK_MARK_FACES_MAX][3]; /* corners, wound so that normals
                                             point out */
} murk_mark;

/* size_m: half the octahedron's width. */
void murk_mark_make(murk_mark *out, const murk_sensor_type *type,
                    const murk_pose *pose, murk_vec3 north, double size_m);

#endif
