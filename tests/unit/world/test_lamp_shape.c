/* How luminaires stand: the smallest turn from straight down, floodlights
 * upright, c0, roll, and the luminous area. Nothing is random. */
#include "world/lamp_shape.h"

#include "check.h"

static murk_vec3 c0_of(murk_goniometer type, murk_vec3 aim, const murk_vec3 *c0,
                       double roll_deg)
{
    murk_luminaire lamp = {.type = type};
    murk_scene_light light = {.luminaire = &lamp,
                              .direction = aim,
                              .has_c0 = c0 != NULL,
                              .roll_rad = roll_deg * MURK_PI / 180};
    murk_source out = {.direction = aim};
    if (c0) {
        light.c0 = *c0;
    }
    murk_lamp_shape(&out, &light);
    CHECK_NEAR(murk_length(out.c0), 1, 1e-14);
    CHECK_NEAR(murk_dot(out.c0, murk_unit(aim)), 0, 1e-14);
    return out.c0;
}

static void check_is(murk_vec3 got, double x, double y, double z)
{
    CHECK_NEAR(got.x, x, 1e-12);
    CHECK_NEAR(got.y, y, 1e-12);
    CHECK_NEAR(got.z, z, 1e-12);
}

static void test_type_c(void)
{
    const murk_goniometer c = MURK_GONIOMETER_C;
    const double h = sqrt(0.5);
    check_is(c0_of(c, murk_vec(0, 0, -3), NULL, 0), 1, 0, 0);
    check_is(c0_of(c, murk_vec(0, 0, 1), NULL, 0), 1, 0, 0);
    /* Turned about y to x, C = 0 points up; turned about x to y it stays. */
    check_is(c0_of(c, murk_vec(2, 0, 0), NULL, 0), 0, 0, 1);
    check_is(c0_of(c, murk_vec(0, 2, 0), NULL, 0), 1, 0, 0);
    check_is(c0_of(c, murk_vec(1, 0, -1), NULL, 0), h, 0, h);
    /* A small tilt is a small turn, whichever way. */
    for (double a = 0; a < 6; a += 0.5) {
        const murk_vec3 aim = {1e-3 * cos(a), 1e-3 * sin(a), -1};
        CHECK(c0_of(c, aim, NULL, 0).x > 1 - 1e-5);
    }
    /* Roll goes from C = 0 to C = 90 degrees: from x to y, straight down. */
    check_is(c0_of(c, murk_vec(0, 0, -1), NULL, 90), 0, 1, 0);
    check_is(c0_of(c, murk_vec(0, 0, -1), NULL, -45), h, -h, 0);
    /* c0 is made perpendicular to the aim. */
    const murk_vec3 given = {0, 5, 5};
    check_is(c0_of(c, murk_vec(0, 0, -1), &given, 0), 0, 1, 0);
    check_is(c0_of(c, murk_vec(0, 0, -1), &given, 90), -1, 0, 0);
}

static void test_types_a_and_b(void)
{
    for (int type = MURK_GONIOMETER_B; type <= MURK_GONIOMETER_A; ++type) {
        const murk_goniometer t = (murk_goniometer)type;
        /* V rises towards z, wherever the floodlight points. */
        check_is(c0_of(t, murk_vec(1, 0, 0), NULL, 0), 0, 0, 1);
        check_is(c0_of(t, murk_vec(0, -3, 0), NULL, 0), 0, 0, 1);
        check_is(c0_of(t, murk_vec(0, 0, -1), NULL, 0), 1, 0, 0);
        check_is(c0_of(t, murk_vec(0, 0, 1), NULL, 0), -1, 0, 0);
        CHECK(c0_of(t, murk_vec(1, 1, -1), NULL, 0).z > 0.5);
    }
}

/* A disc has a radius; a rectangle has sides along C = 0 and C = 90 degrees. */
static void test_luminous_areas(void)
{
    murk_luminaire lamp = {.type = MURK_GONIOMETER_C,
                           .aperture = MURK_APERTURE_RECT,
                           .along_c0_m = 2,
                           .along_c90_m = 3};
    murk_scene_light light = {.luminaire = &lamp, .direction = {0, 0, -1}};
    murk_source out = {.direction = {0, 0, -1}};
    murk_lamp_shape(&out, &light);
    CHECK(murk_length(out.edge1) == 0 && out.radius_m == 0); /* a point */
    light.has_size = true;
    murk_lamp_shape(&out, &light);
    check_is(out.edge1, 2, 0, 0);
    check_is(out.edge2, 0, 3, 0);
    lamp.aperture = MURK_APERTURE_DISC;
    out = (murk_source){.direction = {0, 0, -1}};
    murk_lamp_shape(&out, &light);
    CHECK(out.radius_m == 1 && murk_length(out.edge1) == 0);
    CHECK(out.height_m == 0);
    lamp.height_m = 0.5;
    murk_lamp_shape(&out, &light);
    CHECK(out.height_m == 0.5);
    light.has_size = false;
    murk_lamp_shape(&out, &light);
    CHECK(out.height_m == 0);
}

int main(void)
{
    test_type_c();
    test_types_a_and_b();
    test_luminous_areas();
    return check_done();
}
