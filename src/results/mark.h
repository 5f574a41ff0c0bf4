/* The shape that stands for a sensor in plan.ply and in files like it
 * (results/plan_ply.h): an octahedron around a sensor that sees in all
 * directions; for others a pyramid or a cone of 16 sides, with its apex at the
 * sensor, the opening of the view, and edges four times as long as half the
 * width of an octahedron. */
#ifndef MURK_RESULTS_MARK_H
#define MURK_RESULTS_MARK_H

#include "sensing/sensor.h"

#include <stddef.h>

#define MURK_MARK_SIDES 16 /* of a cone */
/* Numbers for a cone: the corners are those of the rim and the apex; the faces
 * are the triangles of the sides and of the cap. */
#define MURK_MARK_CORNERS_MAX (MURK_MARK_SIDES + 1)
#define MURK_MARK_FACES_MAX   (2 * MURK_MARK_SIDES - 2)

typedef struct murk_mark {
    size_t corners, faces;
    murk_vec3 corner[MURK_MARK_CORNERS_MAX];
    uint8_t face[MURK_MARK_FACES_MAX][3]; /* numbers of corners, wound so that
                                             normals point out */
} murk_mark;

/* Makes the mark of a sensor. size_m is half the width of an octahedron. A cone
 * of more than 340 degrees is shown with 340. */
void murk_mark_make(murk_mark *out, const murk_sensor_type *type,
                    const murk_pose *pose, murk_vec3 north, double size_m);

#endif
