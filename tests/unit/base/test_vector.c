/* Vectors, frames, boxes and placements: exact where they can be. */
#include "base/vector.h"
#include "check.h"

static void test_frame_is_orthonormal(void)
{
    const murk_vec3 normals[] = {{0, 0, 1},     {0, 0, -1},
                                 {1, 0, 0},     {0, -1, 0},
                                 {0.6, 0, 0.8}, {0.48, -0.6, -0.64}};
    for (size_t i = 0; i < sizeof normals / sizeof *normals; ++i) {
        murk_vec3 t, b;
        murk_frame(normals[i], &t, &b);
        const murk_vec3 n = murk_cross(t, b);
        CHECK_NEAR(murk_length(murk_sub(n, normals[i])), 0, 1e-15);
        CHECK_NEAR(murk_dot(t, normals[i]), 0, 1e-15);
        const murk_vec3 d = murk_about(normals[i], 0.3, 1.1);
        CHECK_NEAR(murk_dot(d, normals[i]), 0.3, 1e-15);
    }
}

static void test_place_rotates_scales_then_moves(void)
{
    const murk_affine a =
        murk_affine_place(murk_vec(90, 0, 90), 2, murk_vec(1, 2, 3));
    /* y turns to z about x, and stays; doubled; moved */
    const murk_vec3 p = murk_affine_point(&a, murk_vec(0, 1, 0));
    CHECK(p.x == 1 && p.y == 2 && p.z == 5);
    /* x stays about x, turns to y about z */
    const murk_vec3 q = murk_affine_point(&a, murk_vec(1, 0, 0));
    CHECK(q.x == 1 && q.y == 4 && q.z == 3);
}

static void test_inverse_undoes(void)
{
    const murk_affine a =
        murk_affine_place(murk_vec(10, 20, 30), 0.25, murk_vec(-7, 8, 9));
    murk_affine back;
    CHECK(murk_affine_invert(&a, &back));
    const murk_affine both = murk_affine_compose(&back, &a);
    const murk_vec3 p = murk_affine_point(&both, murk_vec(3, -4, 5));
    CHECK_NEAR(murk_length(murk_sub(p, murk_vec(3, -4, 5))), 0, 1e-14);
    const murk_affine flat =
        murk_affine_place(murk_vec(0, 0, 0), 0, murk_vec(0, 0, 0));
    CHECK(!murk_affine_invert(&flat, &back));
    const murk_affine endless = {
        .matrix = {{INFINITY, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const murk_affine huge = {
        .matrix = {{1e200, 0, 0}, {0, 1e200, 0}, {0, 0, 1}}};
    CHECK(!murk_affine_invert(&endless, &back));
    CHECK(!murk_affine_invert(&huge, &back));
}

static void test_clip(void)
{
    const murk_box box = {{0, 0, 0}, {1, 2, 3}};
    double t0 = 0, t1 = INFINITY;
    CHECK(murk_box_clip(&box, murk_vec(-1, 1, 1), murk_vec(1, 0, 0), &t0, &t1));
    CHECK(t0 == 1 && t1 == 2);
    t0 = 0;
    t1 = INFINITY;
    CHECK(
        !murk_box_clip(&box, murk_vec(-1, 3, 1), murk_vec(1, 0, 0), &t0, &t1));
    t0 = 0;
    t1 = 0.5;
    CHECK(
        !murk_box_clip(&box, murk_vec(-1, 1, 1), murk_vec(1, 0, 0), &t0, &t1));
    t0 = -INFINITY;
    t1 = INFINITY;
    CHECK(murk_box_clip(&box, murk_vec(0, 0, 0), murk_vec(0, 0, -1), &t0, &t1));
    CHECK(t0 == -3 && t1 == 0);
}

int main(void)
{
    test_frame_is_orthonormal();
    test_place_rotates_scales_then_moves();
    test_inverse_undoes();
    test_clip();
    return check_done();
}
