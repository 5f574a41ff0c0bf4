/* Clear-sky irradiance against values that pvlib-python publishes. Nothing
 * here is random. */
#include "check.h"
#include "source/clear_sky.h"

/* clearsky_ineichen.csv: Linke 3, sea level, 1364 W/m2 outside; the test
 * values of pvlib-python (tests/test_clearsky.py), as printed there. */
static const struct {
    double zenith_deg, airmass, global, direct, diffuse;
} published[] = {
    {10, 1, 1038.159219, 942.208186, 110.2652929},
    {46.0467599, 1.32355476, 704.6968125, 888.9014703, 87.73601277},
    {10.56413562, 0.93527685, 1044.123068, 953.2492585, 107.031097},
    {34.86074109, 1.12008114, 853.020657, 922.0612471, 96.42909484},
    {72.41687122, 3.01614096, 251.9942769, 655.4492524, 53.9901349},
    {82.85457044, 6.97935524, 65.49426624, 321.1609218, 25.54562017},
};
#define N (sizeof published / sizeof *published)

/* Air masses are printed to 5e-9 or 5e-7, zenith angles to 5e-8: what these
 * can be off by moves irradiance by 1e-6 at most. */
static void test_published_values(void)
{
    for (size_t i = 0; i < N; ++i) {
        const murk_clear_sky sky = murk_clear_sky_at(
            published[i].zenith_deg, published[i].airmass, 3, 0, 1364);
        CHECK_NEAR(sky.global_w_per_m2, published[i].global, 2e-6);
        CHECK_NEAR(sky.direct_w_per_m2, published[i].direct, 2e-6);
        CHECK_NEAR(sky.diffuse_w_per_m2, published[i].diffuse, 2e-6);
    }
}

/* Teeth: a hundredth of a turbidity, or the sun's constant for 1364. */
static void test_would_notice_another_turbidity(void)
{
    for (size_t i = 0; i < N; ++i) {
        const murk_clear_sky hazier = murk_clear_sky_at(
            published[i].zenith_deg, published[i].airmass, 3.01, 0, 1364);
        CHECK(published[i].global - hazier.global_w_per_m2 > 1e-3);
        CHECK(published[i].direct - hazier.direct_w_per_m2 > 1e-3);
    }
}

/* Kasten and Young's own table: 1 at the zenith, 1.9939 at 60 degrees, 5.5841
 * at 80, 10.3164 at 85, 37.9196 at the horizon, to the .1 % or so by which
 * their formula meets it. */
static void test_airmass(void)
{
    CHECK_NEAR(murk_relative_airmass(0), 1, 3e-4);
    CHECK_NEAR(murk_relative_airmass(60), 1.9939, 2e-3);
    CHECK_NEAR(murk_relative_airmass(80), 5.5841, 6e-3);
    CHECK_NEAR(murk_relative_airmass(85), 10.3164, 0.03);
    CHECK_NEAR(murk_relative_airmass(90), 37.9196, 0.2);
    CHECK(isinf(murk_relative_airmass(95)));
    CHECK(isinf(murk_relative_airmass(NAN)));
    CHECK_NEAR(murk_absolute_airmass(60, 1013.25 / 2),
               murk_relative_airmass(60) / 2, 1e-12);
}

/* The earth's orbit has an eccentricity of .0167: 1.034 and .967 of the mean
 * early in January and July. */
static void test_distance(void)
{
    const double au = 149597870700.0;
    CHECK_NEAR(murk_extraterrestrial_w_per_m2(au), 1361.1, 1e-9);
    CHECK_NEAR(murk_extraterrestrial_w_per_m2(0.9833 * au), 1.0343 * 1361.1,
               0.5);
}

static void test_night_is_dark(void)
{
    const double zeniths[] = {90, 91, 120, NAN};
    for (size_t i = 0; i < 4; ++i) {
        const murk_clear_sky sky = murk_clear_sky_at(
            zeniths[i], murk_relative_airmass(zeniths[i]), 3, 0, 1361);
        CHECK(sky.global_w_per_m2 == 0 && sky.direct_w_per_m2 == 0 &&
              sky.diffuse_w_per_m2 == 0);
    }
}

/* No part is ever below 0 or above what comes from outside, and parts add. */
static void test_parts_make_the_whole(void)
{
    for (double zenith = 0; zenith < 90; zenith += 0.5) {
        for (double linke = 1; linke <= 10; linke += 0.5) {
            for (double altitude = 0; altitude <= 4000; altitude += 1000) {
                const murk_clear_sky sky = murk_clear_sky_at(
                    zenith,
                    murk_absolute_airmass(zenith,
                                          1013.25 * exp(-altitude / 8000)),
                    linke, altitude, 1361.1);
                CHECK(sky.direct_w_per_m2 >= 0 && sky.diffuse_w_per_m2 >= 0);
                CHECK(sky.direct_w_per_m2 <= 1361.1);
                CHECK_NEAR(sky.global_w_per_m2,
                           sky.diffuse_w_per_m2 +
                               sky.direct_w_per_m2 *
                                   cos(zenith * 3.14159265358979 / 180),
                           1e-9);
            }
        }
    }
}

int main(void)
{
    test_published_values();
    test_would_notice_another_turbidity();
    test_airmass();
    test_distance();
    test_night_is_dark();
    test_parts_make_the_whole();
    return check_done();
}
