/* Moonlight by phase, distance, elevation and extinction. Nothing is random. */
#include "source/moonlight.h"

#include "check.h"
#include "source/night_sky.h"

#define MEAN_M 384400e3

/* Another program's value of the same law (specsim 0.13,
 * krisciunas_schaefer(): line of sight 20, moon 70 degrees from the zenith, 50
 * between them, phase a quarter of the way to new moon, extinction .15 mag),
 * printed to three decimals. The teeth: half a hundredth of a magnitude of
 * extinction, or half a degree of angle or phase, is refused. */
static double other_program(double phase, double separation, double extinction)
{
    const murk_moon moon = {phase, MEAN_M, 20};
    return murk_sky_magnitude(
        murk_moonlit_sky(&moon, 20, separation, extinction));
}

static void test_agrees_with_another_program(void)
{
    CHECK_NEAR(other_program(45, 50, 0.15), 19.855, 0.0005);
    CHECK(fabs(other_program(45.5, 50, 0.15) - 19.855) > 0.0005);
    CHECK(fabs(other_program(45, 50.5, 0.15) - 19.855) > 0.0005);
    CHECK(fabs(other_program(45, 50, 0.155) - 19.855) > 0.0005);
}

static void test_full_moon_stands_out(void)
{
    const double trend = murk_moon_lux(7, MEAN_M);
    CHECK_NEAR(murk_moon_lux(0, MEAN_M) / trend,
               1.35 * pow(10, 0.4 * (0.026 * 7 + 4e-9 * 7 * 7 * 7 * 7)), 1e-12);
    CHECK_NEAR(murk_moon_lux(-90, MEAN_M), murk_moon_lux(90, MEAN_M), 0);
    CHECK_NEAR(murk_moon_lux(60, MEAN_M / 1.1) / murk_moon_lux(60, MEAN_M),
               1.21, 1e-12);
}

/* Turbidity 1 is air alone: molecules and ozone. A turbid sky takes more, a
 * high place less. */
static void test_extinction_follows_turbidity_and_height(void)
{
    CHECK(murk_visual_extinction(3, 0) > murk_visual_extinction(2, 0));
    CHECK(murk_visual_extinction(3, 2000) < murk_visual_extinction(3, 0));
    CHECK_NEAR(murk_visual_extinction(1, 0), 1.0857 * (0.0973 + 0.0274), 1e-4);
}

static void test_moon_rises_without_a_step(void)
{
    murk_moon moon = {0, MEAN_M, -20};
    const murk_moonlight none = murk_moonlight_at(&moon, 0.2);
    CHECK(none.direct_lux == 0 && none.diffuse_lux == 0);
    murk_moonlight before = none;
    for (int i = 0; i <= 440; ++i) {
        moon.elevation_deg = -20 + 0.25 * i;
        const murk_moonlight now = murk_moonlight_at(&moon, 0.2);
        CHECK(now.direct_lux >= before.direct_lux);
        CHECK(now.diffuse_lux >= before.diffuse_lux);
        CHECK(now.direct_lux - before.direct_lux < 0.006);
        CHECK(now.diffuse_lux - before.diffuse_lux < 0.003);
        before = now;
    }
}

/* The scattering function of Krisciunas and Schaefer, Publ. Astron. Soc. Pac.
 * 103 (1991) 1033, doi:10.1086/132921, equations 16 to 20: 10^5.36 (1.06 +
 * cos^2 rho) of molecules, and of aerosol 10^(6.15 - rho / 40) from 10 degrees
 * on, 6.2e7 / rho^2 nearer to the moon. Within the moon's radius (.26 degrees)
 * it stays. Values computed apart from the program,
 * relative to 90 degrees, where it is
 * 10^5.36 1.06 + 10^3.9 = 250775. */
static void test_aureole_and_sky_by_hand(void)
{
    static const double angle[] = {.1, 1, 2, 5, 9.9, 10, 30, 60, 120};
    static const double want[] = {917631681, 62471849, 15971640,
                                  2950179,   1097736,  1259339,
                                  665836,    344772,   301516};
    const murk_moon moon = {0, MEAN_M, 45};
    const double at_90 = murk_moonlit_sky(&moon, 30, 90, .2);
    for (int i = 0; i < 9; ++i) {
        const double sky = murk_moonlit_sky(&moon, 30, angle[i], .2);
        CHECK_NEAR(sky / at_90 / (want[i] / 250775), 1, 1e-4);
    }
}

/* With the moon at the zenith the sum over the sky is one integral in zenith
 * distance, done here by brute force. */
static void test_diffuse_is_the_sum_over_the_sky(void)
{
    const double pi = 3.14159265358979323846;
    const murk_moon moon = {30, MEAN_M, 90};
    double sum = 0;
    const double step = 1e-3;
    for (double z = 0.26 + step / 2; z < 90; z += step) {
        sum += murk_moonlit_sky(&moon, z, z, 0.2) * pi * sin(2 * z * pi / 180) *
               step * pi / 180;
    }
    CHECK_NEAR(murk_moonlight_at(&moon, 0.2).diffuse_lux / sum, 1, 0.01);
}

int main(void)
{
    test_agrees_with_another_program();
    test_full_moon_stands_out();
    test_aureole_and_sky_by_hand();
    test_extinction_follows_turbidity_and_height();
    test_moon_rises_without_a_step();
    test_diffuse_is_the_sum_over_the_sky();
    return check_done();
}
