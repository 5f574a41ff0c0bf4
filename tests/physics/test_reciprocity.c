/* Lamp and probe change places: a lamp at A gives to B what one at B gives to
 * A, over n^2 of the place that is lit, whatever stands and drifts between them
 * (Case, Rev. Mod. Phys. 29 (1957) 651, doi:10.1103/RevModPhys.29.651; n^2:
 * Nicodemus, Am. J. Phys. 31 (1963) 368, doi:10.1119/1.1969512).
 *
 * A lamp is a ball's worth of points, the probe a ball: the mean over the eight
 * corners of a cube whose half diagonal is sqrt(3/5) of the ball's radius is
 * that over the ball for all cubics in place, so both directions average alike.
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "chords.h"
#include "worlds.h"

#include <stdlib.h>

#define Z_TESTS        3
#define GLASS_INDEX    1.5
#define WATER_INDEX    1.34
#define BALL_LAMPS     8
#define RECIPROCAL_R_M 0.8

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

static const murk_box yard = {{-5, -5, -5}, {5, 5, 5}};

/* Eight lamps of 1/8 W in a ball. */
static void ball_lamps(murk_vec3 center, murk_source lamp[BALL_LAMPS])
{
    const double half = RECIPROCAL_R_M / sqrt(5);
    for (int i = 0; i < BALL_LAMPS; ++i) {
        lamp[i] = test_point(murk_vec(center.x + (i & 1 ? half : -half),
                                      center.y + (i & 2 ? half : -half),
                                      center.z + (i & 4 ? half : -half)));
        lamp[i].power_w = murk_spectrum_flat(1.0 / BALL_LAMPS, 1);
    }
}

/* Mean fluence rate in the ball at `to` from one watt in that at `from`. */
static murk_estimate given(const test_setup *yard_setup, murk_vec3 from,
                           murk_vec3 to, uint64_t photons, uint32_t seed)
{
    murk_source lamp[BALL_LAMPS];
    ball_lamps(from, lamp);
    test_setup setup = *yard_setup;
    setup.domain.box = yard;
    setup.lights = lamp;
    setup.n_lights = BALL_LAMPS;
    test_world w = test_world_made(&setup);
    chords c = {.n = 1, .place = {chord_ball(to, RECIPROCAL_R_M)}};
    test_world_trace(&w, photons, seed, chords_note, &c);
    test_world_unmade(&w);
    return chords_fluence(&c, 0);
}

static double sigmas_between(murk_estimate a, murk_estimate b, double b_times)
{
    return sigmas_off(a.value, b_times * b.value,
                      hypot(a.standard_error, b_times * b.standard_error));
}

static void test_lamp_and_probe_change_places(uint32_t seed)
{
    const murk_vec3 a = {-1.6, -.5, .3}, b = {1.2, .8, -.3};
    murk_medium media[] = {test_medium(.9, .9, .7), test_medium(1.2, .97, -.3)};
    const murk_region regions[] = {
        test_box_region(0, murk_vec(-5, -5, -5), murk_vec(-.7, 5, 5)),
        test_ball_region(1, murk_vec(1, 1, 0), 1.8)};
    const murk_material materials[] = {test_material(.7, 0, 0, 0),
                                       test_material(.2, .3, .4, 0)};
    const murk_surface_desc things[] = {
        test_rect(murk_vec(-4, 3, -4), murk_vec(0, 0, 8), murk_vec(8, 0, 0), 0),
        test_rect(murk_vec(-.6, -3, -2), murk_vec(0, 3, 0), murk_vec(0, 0, 4),
                  1)};
    test_setup setup = {.materials = materials,
                        .n_materials = 2,
                        .surfaces = things,
                        .n_surfaces = 2,
                        .media = media,
                        .n_media = 2,
                        .regions = regions,
                        .n_regions = 2};
    const uint64_t photons = 600000;
    const murk_estimate there = given(&setup, a, b, photons, seed);
    const murk_estimate back = given(&setup, b, a, photons, seed + 1);
    CHECK(sigmas_between(there, back, 1) <= limit());
    /* Teeth: an albedo lower by .15 on the way back. */
    media[0].albedo.band[0] -= .15;
    const murk_estimate darker = given(&setup, b, a, photons, seed + 1);
    CHECK(sigmas_between(there, darker, 1) > limit());
}

/* A lamp in a glass ball, and one outside of it in fog. */
static void test_glass_gives_n_squared_less(uint32_t seed)
{
    const murk_vec3 a = {-1, 0, 0}, b = {1.6, 1.2, -.4};
    const murk_medium fog = test_medium(.5, .98, .5);
    const murk_region region = test_everywhere(0);
    const murk_material glass[] = {test_material(.7, 0, 0, 0),
                                   test_material(0, .08, .92, GLASS_INDEX)};
    const murk_surface_desc ball = test_sphere(murk_vec(-1.1, .1, 0), 1.2, 1);
    const test_setup setup = {.materials = glass,
                              .n_materials = 2,
                              .surfaces = &ball,
                              .n_surfaces = 1,
                              .media = &fog,
                              .n_media = 1,
                              .regions = &region,
                              .n_regions = 1};
    const uint64_t photons = 200000;
    const murk_estimate out = given(&setup, a, b, photons, seed);
    const murk_estimate in = given(&setup, b, a, photons, seed + 1);
    const double n2 = GLASS_INDEX * GLASS_INDEX;
    CHECK(sigmas_between(in, out, n2) <= limit());
    CHECK(sigmas_between(in, out, 1) > limit());
    CHECK(sigmas_between(in, out, 1.7 * 1.7) > limit());
}

/* Murky water under hazy air, a lamp on either side of its surface. */
static void test_water_gives_n_squared_less(uint32_t seed)
{
    const murk_vec3 air = {-.5, 0, 1.3}, water = {.7, .4, -1.1};
    const murk_medium media[] = {test_medium(.3, .9, .3),
                                 test_medium(.7, .95, .8)};
    const murk_region regions[] = {test_everywhere(0),
                                   {.medium = 1,
                                    .shape = MURK_REGION_BELOW,
                                    .to_world = murk_affine_identity(),
                                    .ior = WATER_INDEX,
                                    .where = "water"}};
    const test_setup setup = {
        .media = media, .n_media = 2, .regions = regions, .n_regions = 2};
    const uint64_t photons = 200000;
    const murk_estimate up = given(&setup, water, air, photons, seed);
    const murk_estimate down = given(&setup, air, water, photons, seed + 1);
    const double n2 = WATER_INDEX * WATER_INDEX;
    CHECK(sigmas_between(down, up, n2) <= limit());
    CHECK(sigmas_between(down, up, 1) > limit());
    CHECK(sigmas_between(down, up, 1.55 * 1.55) > limit());
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_lamp_and_probe_change_places(seed);
    test_glass_gives_n_squared_less(seed);
    test_water_gives_n_squared_less(seed);
    return check_done();
}
