/* The shapes that stand for sensors: where their corners lie, and that every
 * face's normal points out. Nothing here is random. */
#include "check.h"
#include "results/mark.h"

#define SIZE_M 0.25
#define DEG    (MURK_PI / 180)

static const murk_vec3 north = {0, 1, 0};

static void check_place(murk_vec3 got, double x, double y, double z)
{
    CHECK_NEAR(murk_length(murk_sub(got, murk_vec(x, y, z))), 0, 1e-12);
}

/* Normals point away from the middle of the corners, which lies inside. */
static void check_faces_point_out(const murk_mark *m)
{
    murk_vec3 middle = {0, 0, 0};
    for (size_t i = 0; i < m->corners; ++i) {
        middle =
            murk_add(middle, murk_scale(1 / (double)m->corners, m->corner[i]));
    }
    for (size_t f = 0; f < m->faces; ++f) {
        const murk_vec3 a = m->corner[m->face[f][0]];
        const murk_vec3 b = m->corner[m->face[f][1]];
        const murk_vec3 c = m->corner[m->face[f][2]];
        const murk_vec3 normal = murk_cross(murk_sub(b, a), murk_sub(c, a));
        CHECK(murk_dot(normal, murk_sub(a, middle)) > 1e-9);
    }
}

static void test_octahedron(void)
{
    const murk_sensor_type type = {.view = MURK_VIEW_SPHERE};
    const murk_pose pose = {.position = {1, 2, 3}};
    murk_mark m;
    murk_mark_make(&m, &type, &pose, north, SIZE_M);
    CHECK(m.corners == 6 && m.faces == 8);
    check_place(m.corner[0], 1 - SIZE_M, 2, 3);
    check_place(m.corner[1], 1 + SIZE_M, 2, 3);
    check_place(m.corner[2], 1, 2 - SIZE_M, 3);
    check_place(m.corner[5], 1, 2, 3 + SIZE_M);
    check_faces_point_out(&m);
}

/* 90 by 2 atan(1/2) degrees, looking east: corners along (1, -+1, +-1/2). */
static void test_pyramid(void)
{
    const murk_sensor_type type = {.view = MURK_VIEW_FRUSTUM,
                                   .hfov_rad = 90 * DEG,
                                   .vfov_rad = 2 * atan(0.5)};
    const murk_pose pose = {.position = {1, 2, 3}, .heading_rad = 90 * DEG};
    murk_mark m;
    murk_mark_make(&m, &type, &pose, north, SIZE_M);
    const double d = 4 * SIZE_M / 1.5; /* the length of the offset is 3/2 */
    CHECK(m.corners == 5 && m.faces == 6);
    check_place(m.corner[0], 1, 2, 3);
    check_place(m.corner[1], 1 + d, 2 + d, 3 + d / 2); /* left, up */
    check_place(m.corner[2], 1 + d, 2 - d, 3 + d / 2); /* right, up */
    check_place(m.corner[3], 1 + d, 2 - d, 3 - d / 2);
    check_place(m.corner[4], 1 + d, 2 + d, 3 - d / 2);
    check_faces_point_out(&m);
}

static void test_cone(double cone_deg)
{
    const murk_sensor_type type = {.view = MURK_VIEW_CONE,
                                   .cone_rad = cone_deg * DEG};
    const murk_pose pose = {.position = {0, 0, 1}, .tilt_rad = -90 * DEG};
    const double half = fmin(cone_deg / 2, 170) * DEG, length = 4 * SIZE_M;
    murk_mark m;
    murk_mark_make(&m, &type, &pose, north, SIZE_M);
    CHECK(m.corners == MURK_MARK_SIDES + 1);
    CHECK(m.faces == 2 * MURK_MARK_SIDES - 2);
    for (size_t k = 1; k < m.corners; ++k) {
        const murk_vec3 offset = murk_sub(m.corner[k], pose.position);
        CHECK_NEAR(murk_length(offset), length, 1e-12);
        CHECK_NEAR(offset.z, -length * cos(half), 1e-12); /* it looks down */
    }
    if (cone_deg != 180) { /* which is flat */
        check_faces_point_out(&m);
    }
}

int main(void)
{
    test_octahedron();
    test_pyramid();
    test_cone(60);
    test_cone(200);
    test_cone(360);
    return check_done();
}
