/* Makes the mark of a sensor for viewers, as corners and triangles: an
 * octahedron if the sensor sees all round, else a pyramid or a cone of the
 * view. */
#include "results/mark.h"

#include <math.h>
#include <string.h>

#define VIEW_LENGTH 4 /* length of the edges, in half widths */

/* Limit on half the opening of a cone, because a wider one would look
 * closed. */
#define WIDEST_RAD (170 * MURK_PI / 180)

/* The corners are those at -x, +x, -y, +y, -z, +z. */
static void make_octahedron(murk_mark *out, murk_vec3 place, double size_m)
{
    static const uint8_t face[8][3] = {{1, 3, 5}, {3, 0, 5}, {0, 2, 5},
                                       {2, 1, 5}, {3, 1, 4}, {0, 3, 4},
                                       {2, 0, 4}, {1, 2, 4}};
    out->corners = 6;
    out->faces = 8;
    for (int c = 0; c < 6; ++c) {
        const double d = c % 2 ? size_m : -size_m;
        out->corner[c] =
            murk_add(place, murk_vec(c / 2 == 0 ? d : 0, c / 2 == 1 ? d : 0,
                                     c / 2 == 2 ? d : 0));
    }
    memcpy(out->face, face, sizeof face);
}

static void add_face(murk_mark *out, size_t a, size_t b, size_t c,
                     bool is_turned)
{
    uint8_t *face = out->face[out->faces++];
    face[0] = (uint8_t)a;
    face[1] = (uint8_t)(is_turned ? c : b);
    face[2] = (uint8_t)(is_turned ? b : c);
}

/* Adds the faces: corner 0 is the apex, corners 1 .. sides are the rim,
 * clockwise as the sensor sees it. is_behind: the rim lies behind the apex,
 * which turns all faces. */
static void join_rim(murk_mark *out, size_t sides, bool is_behind)
{
    out->corners = sides + 1;
    out->faces = 0;
    for (size_t k = 0; k < sides; ++k) {
        add_face(out, 0, 1 + k, 1 + (k + 1) % sides, !is_behind);
    }
    for (size_t k = 1; k + 1 < sides; ++k) {
        add_face(out, 1, 1 + k, 2 + k, is_behind);
    }
}

static murk_vec3 rim(const murk_pose *pose, const murk_sensor_frame *frame,
                     double right, double up, double ahead, double length_m)
{
    const murk_vec3 direction = murk_add(
        murk_scale(ahead, frame->axis),
        murk_add(murk_scale(right, frame->right), murk_scale(up, frame->up)));
    return murk_along(pose->position, length_m, murk_unit(direction));
}

void murk_mark_make(murk_mark *out, const murk_sensor_type *type,
                    const murk_pose *pose, murk_vec3 north, double size_m)
{
    const murk_sensor_frame frame = murk_pose_frame(pose, north);
    const double length_m = VIEW_LENGTH * size_m;
    out->corner[0] = pose->position;
    switch (type->view) {
    case MURK_VIEW_SPHERE:
        make_octahedron(out, pose->position, size_m);
        break;
    case MURK_VIEW_CONE: {
        /* The rim is a circle about the axis. */
        const double half = fmin(type->cone_rad / 2, WIDEST_RAD);
        for (int k = 0; k < MURK_MARK_SIDES; ++k) {
            const double turn = 2 * MURK_PI * k / MURK_MARK_SIDES;
            out->corner[1 + k] =
                rim(pose, &frame, sin(half) * sin(turn), sin(half) * cos(turn),
                    cos(half), length_m);
        }
        join_rim(out, MURK_MARK_SIDES, half > MURK_PI / 2);
        break;
    }
    case MURK_VIEW_FRUSTUM: {
        const double h = tan(type->hfov_rad / 2), v = tan(type->vfov_rad / 2);
        out->corner[1] = rim(pose, &frame, -h, v, 1, length_m);
        out->corner[2] = rim(pose, &frame, h, v, 1, length_m);
        out->corner[3] = rim(pose, &frame, h, -v, 1, length_m);
        out->corner[4] = rim(pose, &frame, -h, -v, 1, length_m);
        join_rim(out, 4, false);
        break;
    }
    }
}
