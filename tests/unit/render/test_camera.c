/* Where a camera's pixels look; and what bands look like. */
#include "check.h"
#include "render/camera.h"
#include "render/colour.h"

static void test_a_picture_is_upright(void)
{
    const murk_camera c =
        murk_camera_aimed(murk_vec(1, 2, 3), murk_vec(1, 9, 3),
                          murk_vec(0, 0, 1), MURK_PI / 2, 200, 100);
    const murk_vec3 middle = murk_camera_sight(&c, 100, 50);
    CHECK_NEAR(middle.y, 1, 1e-15);
    /* north ahead, so east is to the right; half the angle is 45 degrees */
    const murk_vec3 top = murk_camera_sight(&c, 100, 0);
    CHECK_NEAR(top.z, sqrt(0.5), 1e-15);
    const murk_vec3 right = murk_camera_sight(&c, 150, 50);
    CHECK_NEAR(right.x, sqrt(0.5), 1e-15);
}

static murk_camera camera_of(int which)
{
    const murk_vec3 from = {1, 2, 3};
    const double h = 1.2;
    switch (which) {
    case 0:
        return murk_camera_aimed(from, murk_vec(4, -1, 2), murk_vec(0, 0, 1), h,
                                 17, 12);
    case 1:
        return murk_camera_view(from, murk_unit(murk_vec(1, 1, 0)),
                                murk_unit(murk_vec(1, -1, 0)), 2 * h, h, 24,
                                10);
    default:
        return murk_camera_around(from, murk_vec(3, -4, 9), 36, 18);
    }
}

/* Sight and place are each other's inverse, at middles and in corners. */
static void test_what_is_seen_at_a_place_is_found_there(void)
{
    for (int which = 0; which < 3; ++which) {
        const murk_camera c = camera_of(which);
        for (size_t i = 0; i < c.width; ++i) {
            for (size_t k = 0; k < c.height; ++k) {
                const double x = (double)i + 0.5, y = (double)k + 0.01;
                const murk_vec3 d = murk_camera_sight(&c, x, y);
                double found_x, found_y;
                CHECK_NEAR(murk_length(d), 1, 1e-15);
                CHECK(
                    murk_camera_find(&c, murk_scale(7, d), &found_x, &found_y));
                CHECK_NEAR(found_x, x, 1e-11);
                CHECK_NEAR(found_y, y, 1e-11);
            }
        }
    }
    const murk_camera c = camera_of(0);
    double x, y;
    CHECK(!murk_camera_find(&c, murk_vec(-3, 3, 1), &x, &y)); /* behind */
}

/* What is drawn in a pixel is found in it, over all of it. */
static void test_draws_stay_in_their_pixel(void)
{
    for (int which = 0; which < 3; ++which) {
        const murk_camera c = camera_of(which);
        for (int k = 0; k < 16; ++k) {
            const double u = (k % 4 + 0.1) / 4, v = (k / 4 + 0.1) / 4;
            double x, y;
            CHECK(
                murk_camera_find(&c, murk_camera_draw(&c, 5, 2, u, v), &x, &y));
            CHECK_NEAR(x, 5 + u, 1e-11);
            CHECK(y > 2 && y < 3);
            CHECK(c.projection == MURK_EQUIRECTANGULAR ||
                  fabs(y - 2 - v) < 1e-11);
        }
    }
}

/* All round it is 4 pi; a rectangle's is known; and each pixel's is what the
 * slopes of its own sight make it. */
static void test_solid_angles(void)
{
    for (int which = 0; which < 3; ++which) {
        const murk_camera c = camera_of(which);
        double sum = 0;
        for (size_t i = 0; i < c.width; ++i) {
            for (size_t k = 0; k < c.height; ++k) {
                const double x = (double)i + 0.5, y = (double)k + 0.5, h = 1e-3;
                const murk_vec3 across =
                    murk_sub(murk_camera_sight(&c, x + h, y),
                             murk_camera_sight(&c, x - h, y));
                const murk_vec3 down =
                    murk_sub(murk_camera_sight(&c, x, y + h),
                             murk_camera_sight(&c, x, y - h));
                const double dense =
                    murk_length(murk_cross(across, down)) / (4 * h * h);
                const double whole = murk_camera_solid_angle(&c, i, k);
                /* a pixel's middle for all of it, of the second order in its
                 * angle, 0.2 at most */
                CHECK_NEAR(dense / whole, 1, 0.04);
                sum += whole;
            }
        }
        const double a = c.step[0] * (double)c.width / 2;
        const double b = c.step[1] * (double)c.height / 2;
        const double all = c.projection == MURK_EQUIRECTANGULAR
                               ? 4 * MURK_PI
                               : 4 * atan(a * b / sqrt(1 + a * a + b * b));
        CHECK_NEAR(sum, all, 1e-12);
    }
}

/* The middle looks where it is told, the right is clockwise, the top is up. */
static void test_all_round_is_upright(void)
{
    const murk_camera c = camera_of(2);
    const murk_vec3 middle = murk_camera_sight(&c, 18, 9);
    CHECK_NEAR(middle.x, 0.6, 1e-15);
    CHECK_NEAR(middle.y, -0.8, 1e-15);
    const murk_vec3 right = murk_camera_sight(&c, 27, 9);
    CHECK_NEAR(right.x, -0.8, 1e-15);
    CHECK_NEAR(right.y, -0.6, 1e-15);
    CHECK_NEAR(murk_camera_sight(&c, 3, 0).z, 1, 1e-15);
    const murk_vec3 low = murk_camera_sight(&c, 18, 15);
    CHECK_NEAR(low.z, -sin(MURK_PI / 3), 1e-15);
    /* even over the solid angle: half of the pixel below the zenith lies within
     * cos(angle) = 1 - (1 - cos 10) / 2 */
    const double ten = MURK_PI / 18;
    CHECK_NEAR(murk_camera_draw(&c, 0, 0, 0.5, 0.5).z, 1 - (1 - cos(ten)) / 2,
               1e-15);
}

static void test_even_light_is_about_white(void)
{
    double from[16], to[16], weight[3][MURK_BANDS_MAX];
    for (int b = 0; b < 16; ++b) {
        from[b] = 380 + 25 * b;
        to[b] = from[b] + 25;
    }
    murk_colour_weights(16, from, to, weight);
    double rgb[3] = {0, 0, 0};
    for (int b = 0; b < 16; ++b) {
        for (int k = 0; k < 3; ++k) {
            rgb[k] += weight[k][b];
        }
    }
    /* illuminant E in BT.709: 1.205, 0.948, 0.909; the fits are within 3 % */
    CHECK_NEAR(rgb[0], 1.205, 0.04);
    CHECK_NEAR(rgb[1], 0.948, 0.04);
    CHECK_NEAR(rgb[2], 0.909, 0.04);
}

static void test_one_band_is_grey(void)
{
    const double line = 650, unseen[2] = {1550, 1064};
    double weight[3][MURK_BANDS_MAX];
    murk_colour_weights(1, &line, &line, weight);
    CHECK(weight[0][0] == 1 && weight[1][0] == 1 && weight[2][0] == 1);
    murk_colour_weights(2, unseen, unseen, weight);
    CHECK(weight[0][0] == 0.5 && weight[2][1] == 0.5);
}

/* ---- orthographic cameras and clip planes ---- */

/* Looks along +y from (10, -3, 2), 8 m wide: pixels of 0.5 m. */
static murk_camera parallel(void)
{
    return murk_camera_parallel(murk_vec(10, -3, 2), murk_vec(10, 9, 2),
                                murk_vec(0, 0, 1), 8, 16, 10);
}

static const murk_box DOMAIN = {{0, 0, 0}, {20, 6, 5}};

static void test_orthographic_rays_are_parallel(void)
{
    const murk_camera c = parallel();
    murk_camera_ray ray;
    for (size_t i = 0; i < 4; ++i) {
        /* The centers of the corner pixels. */
        const double x = i % 2 ? 15.5 : 0.5, y = i / 2 ? 9.5 : 0.5;
        const murk_vec3 sight = murk_camera_sight(&c, x, y);
        CHECK(sight.x == 0 && sight.y == 1 && sight.z == 0);
        CHECK(murk_camera_begin(&ray, &c, x, y, sight, &DOMAIN, 0) ==
              (i / 2 == 0));
        if (i / 2 == 0) { /* the lower row passes below the domain */
            CHECK_NEAR(ray.origin.x, i % 2 ? 13.75 : 6.25, 1e-14);
            CHECK_NEAR(ray.origin.z, 4.25, 1e-14);
            CHECK(ray.origin.y == 0); /* the side of the domain */
            CHECK_NEAR(ray.skipped_m, 3, 1e-15);
        }
    }
    /* The middle of the picture is the axis; the inverse is exact. */
    CHECK(murk_camera_begin(&ray, &c, 8, 5, murk_vec(0, 1, 0), &DOMAIN, 0));
    CHECK(ray.origin.x == 10 && ray.origin.y == 0 && ray.origin.z == 2);
    double x, y;
    CHECK(murk_camera_find(&c, murk_vec(3.75, 7, 2.25), &x, &y));
    CHECK_NEAR(x, 15.5, 1e-14);
    CHECK_NEAR(y, 0.5, 1e-14);
    CHECK(!murk_camera_find(&c, murk_vec(4.25, 7, 2.25), &x, &y));
    CHECK(murk_camera_solid_angle(&c, 3, 3) == 0);
    /* A random point of a pixel changes the origin and not the direction. */
    const murk_vec3 drawn = murk_camera_draw(&c, 3, 4, 0.25, 0.75);
    CHECK(drawn.x == 0 && drawn.y == 1 && drawn.z == 0);
}

static void test_rays_begin_at_the_clip_plane(void)
{
    murk_camera_ray ray;
    murk_camera c = parallel();
    const murk_vec3 sight = {0, 1, 0};
    for (int sign = -1; sign < 2; sign += 2) { /* the normal has no side */
        c.clip = (murk_clip){true, {0, 2.5, 0}, {0, sign, 0}};
        CHECK(murk_camera_begin(&ray, &c, 8, 5, sight, &DOMAIN, 0.125));
        CHECK_NEAR(ray.origin.y, 2.625, 1e-14);
        CHECK_NEAR(ray.skipped_m, 5.625, 1e-14);
    }
    /* Behind the camera, parallel to the ray, beyond the domain: nothing. */
    c.clip.point.y = -3.5;
    CHECK(!murk_camera_begin(&ray, &c, 8, 5, sight, &DOMAIN, 0.125));
    c.clip = (murk_clip){true, {0, 2.5, 0}, {1, 0, 0}};
    CHECK(!murk_camera_begin(&ray, &c, 8, 5, sight, &DOMAIN, 0.125));
    c.clip = (murk_clip){true, {0, 7, 0}, {0, 1, 0}};
    CHECK(!murk_camera_begin(&ray, &c, 8, 5, sight, &DOMAIN, 0.125));
    /* A perspective camera at 45 degrees to the plane; without a clip plane its
     * rays begin at the camera. */
    c = murk_camera_aimed(murk_vec(1, 1, 1), murk_vec(1, 2, 1),
                          murk_vec(0, 0, 1), MURK_PI / 2, 100, 100);
    const murk_vec3 right = murk_camera_sight(&c, 100, 50);
    CHECK(murk_camera_begin(&ray, &c, 100, 50, right, &DOMAIN, 0.125));
    CHECK(ray.origin.x == 1 && ray.origin.y == 1 && ray.skipped_m == 0);
    c.clip = (murk_clip){true, {0, 3, 0}, {0, 1, 0}};
    CHECK(murk_camera_begin(&ray, &c, 100, 50, right, &DOMAIN, 0));
    CHECK_NEAR(ray.origin.x, 3, 1e-14);
    CHECK_NEAR(ray.origin.y, 3, 1e-14);
    CHECK_NEAR(ray.skipped_m, 2 * sqrt(2), 1e-14);
}

int main(void)
{
    test_orthographic_rays_are_parallel();
    test_rays_begin_at_the_clip_plane();
    test_a_picture_is_upright();
    test_what_is_seen_at_a_place_is_found_there();
    test_draws_stay_in_their_pixel();
    test_solid_angles();
    test_all_round_is_upright();
    test_even_light_is_about_white();
    test_one_band_is_grey();
    return check_done();
}
