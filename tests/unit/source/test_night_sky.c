/* The scale of sky brightness and the sky's pattern. Nothing here is random. */
#include "source/night_sky.h"

#include "check.h"

#define PI 3.14159265358979323846

/* The makers of sky quality meters convert with 10.8e4 cd/m2 at magnitude 0;
 * a magnitude 0 star gives 2.54e-6 lux (Allen). Three figures, two sources:
 * half a percent between them. */
static void test_magnitudes_are_luminances(void)
{
    CHECK_NEAR(murk_sky_luminance(21.6) / (10.8e4 * pow(10, -0.4 * 21.6)), 1,
               0.005);
    const double square_second = pow(PI / 180 / 3600, 2);
    CHECK_NEAR(murk_sky_luminance(0) / (2.54e-6 / square_second), 1, 0.005);
    for (double m = 16; m < 23; m += 0.7) {
        CHECK_NEAR(murk_sky_magnitude(murk_sky_luminance(m)), m, 1e-12);
    }
}

static void test_path_is_one_above_and_five_at_the_horizon(void)
{
    CHECK_NEAR(murk_sky_path(0), 1, 1e-15);
    CHECK_NEAR(murk_sky_path(90), 5, 1e-12);
    CHECK_NEAR(murk_night_sky_pattern(0, 0.3), 1, 1e-15);
}

/* Without extinction the sum over the sky is closed in s = sin^2: the integral
 * of ds / sqrt(1 - .96 s) over 0..1 is 2 (1 - .2) / .96. */
static void test_illuminance_is_the_sum_over_the_sky(void)
{
    const double level = murk_sky_luminance(21.6);
    CHECK_NEAR(murk_night_sky_lux(21.6, 0) / (PI * level), 2 * 0.8 / 0.96,
               1e-3);
    CHECK(murk_night_sky_lux(21.6, 0.25) < murk_night_sky_lux(21.6, 0.15));
    CHECK_NEAR(murk_night_sky_lux(19.1, 0.2) / murk_night_sky_lux(21.6, 0.2),
               exp(0.92104 * 2.5), 1e-9);
}

int main(void)
{
    test_magnitudes_are_luminances();
    test_path_is_one_above_and_five_at_the_horizon();
    test_illuminance_is_the_sum_over_the_sky();
    return check_done();
}
