/* How much of a part of the domain is free, and how much of a plane lies in
 * the domain: shares and areas of solids that geometry knows. Places are drawn
 * one in each of 24^3 cells, so that a share whose border lies between cells is
 * exact but for places nearer to a face than a ray begins, of which two are
 * allowed. Other shares are within .5 / 24^1.5 = .004 in the mean, of which 5
 * are allowed. Seeds are fixed. */
#include "plan/free_space.h"

#include "check.h"
#include "stage_text.h"
#include "world/plane_area.h"

/* Three crates in a hall. */
static const char text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [12, 4, 4]}\n"
    "geometry:\n"
    "  - {box: {min_m: [1, 1, 1], max_m: [1.5, 3, 3]}, material: wall}\n"
    "  - {box: {min_m: [5, 1, 1], max_m: [7, 1.666666666666666, 3]},"
    " material: wall}\n"
    "  - {box: {min_m: [9, 1, 1], max_m: [11, 3, 2]}, material: wall}\n"
    "materials: {wall: {diffuse: 0.5}}\n"
    "lights: [{type: point, position_m: [3.5, 2, 3.8], power_w: 1}]\n";

static murk_part cube(double x)
{
    return (murk_part){.box = {murk_vec(x, 1, 1), murk_vec(x + 2, 3, 3)},
                       .number = 2};
}

static murk_part ball(double x, double y, double z, double r)
{
    return (murk_part){
        .is_ball = true,
        .box = {murk_vec(x - r, y - r, z - r), murk_vec(x + r, y + r, z + r)},
        .center = murk_vec(x, y, z),
        .radius_m = r};
}

static void test_shares(void)
{
    murk_stage *stage = stage_text_create(text, NULL);
    murk_open_space *space = NULL;
    murk_error err = {0};
    if (!stage || murk_stage_free_space(&space, stage, 2, &err) != MURK_OK) {
        CHECK(false);
        return;
    }
    /* a crate fills the lower quarter of x, third of y, half of z */
    const double want[] = {3. / 4, 2. / 3, 1. / 2};
    for (int i = 0; i < 3; ++i) {
        const murk_part part = cube(1 + 4 * i);
        const murk_estimate share = murk_free_share(&part, space, 1, 2);
        CHECK_NEAR(share.value, want[i], 2. / (24 * 24 * 24));
        CHECK_NEAR(share.standard_error,
                   sqrt(want[i] * (1 - want[i]) / (24 * 24 * 24)), 1e-6);
        const murk_estimate whole = murk_free_share(&part, NULL, 1, 2);
        CHECK(whole.value == 1 && whole.standard_error == 0);
    }
    /* A ball of 0.8 m, of which what lies below z = 2, 0.4 m off its middle, is
     * the crate's: a cap of height h = .4, (pi/3) h^2 (3 r - h). Of 24^3 places
     * pi/6 lie in it. */
    const murk_part part = ball(10, 2, 2.4, .8);
    const double cap = .4 * .4 * (3 * .8 - .4) / (4 * .8 * .8 * .8);
    const murk_estimate share = murk_free_share(&part, space, 1, 2);
    CHECK_NEAR(share.value, 1 - cap, 5 * .004);
    CHECK_NEAR(share.standard_error /
                   sqrt(cap * (1 - cap) / (MURK_PI / 6 * 24 * 24 * 24)),
               1, .05);
    /* nothing of what lies within a crate */
    const murk_part inside = ball(10, 2, 1.5, .4);
    const murk_estimate none = murk_free_share(&inside, space, 1, 1);
    CHECK(none.value == 0 && none.standard_error == 0);
    murk_open_space_destroy(space);
    stage_text_destroy(stage);
}

static double area(double x, double y, double z, double nx, double ny,
                   double nz)
{
    const murk_box box = {{0, 0, 0}, {2, 3, 4}};
    return murk_plane_area(&box, murk_vec(x, y, z), murk_vec(nx, ny, nz));
}

/* Of a box of 2 x 3 x 4 m. */
static void test_areas(void)
{
    CHECK_NEAR(area(1, 1, 1, 0, 0, -7), 6, 1e-12);
    CHECK_NEAR(area(1, 1, 1, 2, 0, 0), 12, 1e-12);
    CHECK_NEAR(area(1, 1, 1, 0, 1, 0), 8, 1e-12);
    /* points of the plane that lie far outside; sides of the box; beyond it */
    CHECK_NEAR(area(100, -50, 1, 0, 0, 1), 6, 1e-9);
    CHECK_NEAR(area(1, 70, 90, 1, 0, 0), 12, 1e-9);
    CHECK_NEAR(area(1, 1, 4, 0, 0, 1), 6, 1e-12);
    CHECK_NEAR(area(0, 1, 1, 1, 0, 0), 12, 1e-12);
    CHECK(area(1, 1, 4.01, 0, 0, 1) == 0);
    CHECK(area(-.01, 1, 1, 1, 0, 0) == 0);
    CHECK(area(1, 3.01, 1, 0, 1, 0) == 0);
    /* upright and oblique: 4 m high along x = y */
    CHECK_NEAR(area(1, 1, 1, 1, -1, 0), 8 * sqrt(2), 1e-12);
    /* x + y + z = s is a triangle sqrt(3)/2 s^2, less those beyond each side:
     * three, four, five and six corners */
    const double by = sqrt(3) / 2;
    CHECK_NEAR(area(1, 0, 0, 1, 1, 1), by, 1e-12);
    CHECK_NEAR(area(2.5, 0, 0, 3, 3, 3), by * (6.25 - .25), 1e-12);
    CHECK_NEAR(area(0, 3.5, 0, 1, 1, 1), by * (12.25 - 2.25 - .25), 1e-12);
    CHECK_NEAR(area(0, 0, 4.5, 1, 1, 1), by * (20.25 - 6.25 - 2.25 - .25),
               1e-12);
    CHECK_NEAR(area(2, 3, 3, -1, -1, -1), by, 1e-12);
}

int main(void)
{
    test_shares();
    test_areas();
    return check_done();
}
