/* Where a camera's pixels look; and what bands look like. */
#include "check.h"
#include "render/camera.h"
#include "render/colour.h"

static void test_a_picture_is_upright(void)
{
    const murk_camera c =
        murk_camera_look(murk_vec(1, 2, 3), murk_vec(1, 9, 3),
                         murk_vec(0, 0, 1), MURK_PI / 2, 200, 100);
    const murk_vec3 middle = murk_camera_sight(&c, 100, 50);
    CHECK_NEAR(middle.y, 1, 1e-15);
    /* north ahead, so east is to the right; half the angle is 45 degrees */
    const murk_vec3 top = murk_camera_sight(&c, 100, 0);
    CHECK_NEAR(top.z, sqrt(0.5), 1e-15);
    const murk_vec3 right = murk_camera_sight(&c, 150, 50);
    CHECK_NEAR(right.x, sqrt(0.5), 1e-15);
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

int main(void)
{
    test_a_picture_is_upright();
    test_even_light_is_about_white();
    test_one_band_is_grey();
    return check_done();
}
