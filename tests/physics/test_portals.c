/* Light of the sky and through windows is as strong as it should be.
 *
 * Over open ground a level plane gets E, whatever the distribution and both in
 * open and in periodic domains; an upright one what quadrature over its half of
 * the sky says (an even sky: E / 2). On black ground nothing comes back.
 *
 * In a room with windows the same light is aimed at them or falls on the whole
 * domain: both estimate one irradiance of the floor, with no constant shared.
 * Something stands before a window, and a skylight is tilted. What aiming is
 * worth is its figure of merit, 1 / (error^2 photons).
 *
 * All z-tests share a 1e-6 false-alarm budget (Sidak); seeds are fixed. Each
 * test shows that a wrong constant fails. */
#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#include <stdlib.h>

#define CHECKS 70

static double limit;

static murk_vec3 sun(void)
{
    return murk_unit(murk_vec(0.6, 0.4, 0.45));
}

static murk_source sky_of(int type)
{
    return (murk_source){.type = MURK_SOURCE_SKY,
                         .dome = murk_dome_cie(type, sun()),
                         .power_w = {{100}},
                         .where = "sky"};
}

/* Power forward through one plane per W of the light, times that power. */
static murk_estimate through(const test_setup *setup,
                             const murk_tally_desc *desc, uint64_t photons,
                             uint32_t seed)
{
    test_world made = test_world_made(setup);
    murk_tallies *tallies = NULL;
    murk_error err = {0};
    CHECK(!murk_tallies_create(&tallies, desc, 1, &setup->domain,
                               setup->n_lights, 1, 1, INFINITY, &err));
    CHECK_TEXT(err.text, "");
    murk_trace trace = murk_trace_defaults();
    trace.world = &made.world;
    trace.seed = seed;
    trace.last = photons;
    trace.tallies = tallies;
    murk_trace_run(&trace, made.ledger);
    CHECK(murk_ledger_imbalance(made.ledger) == 0);
    const double packet_w = murk_sources_power_w(made.lights) / (double)photons;
    const murk_estimate out =
        murk_tallies_read(tallies, 0, 0, 0, made.ledger->emitted, &packet_w);
    murk_tallies_destroy(tallies);
    test_world_unmade(&made);
    return out;
}

static double off(murk_estimate e, double want)
{
    return sigmas_off(e.value, want, e.standard_error);
}

/* ---- open ground ---- */

static const murk_vec3 down = {0, 0, -1}, east = {-1, 0, 0};

/* Irradiance of an upright plane that looks east, for 1 on a level one. */
static double east_share(const murk_dome *dome)
{
    const int rings = 400, sectors = 400;
    double level = 0, upright = 0;
    for (int i = 0; i < rings; ++i) {
        const double zenith = (i + 0.5) / rings * MURK_PI / 2;
        for (int j = 0; j < sectors; ++j) {
            const double phi = (j + 0.5) / sectors * 2 * MURK_PI;
            const murk_vec3 d = {sin(zenith) * cos(phi), sin(zenith) * sin(phi),
                                 cos(zenith)};
            const double part = murk_dome_radiance(dome, d) * sin(zenith);
            level += part * d.z;
            upright += part * fmax(0, d.x);
        }
    }
    return upright / level;
}

static void test_open_ground(uint32_t seed)
{
    const murk_box box = {{-2, -1, 0}, {4, 3, 2}};
    for (int type = 1; type <= MURK_DOME_TYPES; ++type) {
        const murk_source light = sky_of(type);
        for (int periodic = 0; periodic < 2; ++periodic) {
            const test_setup setup = {
                .domain = {box, periodic}, .lights = &light, .n_lights = 1};
            const murk_tally_desc level = {.name = "level",
                                           .type = MURK_TALLY_PLANE,
                                           .point = {0, 0, 0.7},
                                           .normal = down,
                                           .bins = {1, 1},
                                           .angle_bins = 1};
            const murk_estimate e = through(&setup, &level, 20000, seed);
            if (periodic) { /* every photon, and no others */
                CHECK_NEAR(e.value, 100 * 24, 1e-6);
                continue;
            }
            CHECK_WITHIN(limit, e.value, 100 * 24, e.standard_error);
            CHECK(off(e, 1.1 * 100 * 24) > limit);
            const murk_tally_desc upright = {.name = "upright",
                                             .type = MURK_TALLY_PLANE,
                                             .point = {1, 0, 0},
                                             .normal = east,
                                             .bins = {1, 1},
                                             .angle_bins = 1};
            const double want = 100 * 8 * east_share(&light.dome);
            const murk_estimate u = through(&setup, &upright, 20000, seed);
            CHECK_WITHIN(limit, u.value, want, u.standard_error);
            CHECK(off(u, 1.15 * want) > limit);
        }
    }
}

/* ---- a room ---- */

#define WALLS 10

/* 4 x 3 x 2.5 m, grey; a window in the west wall, a black screen before it
 * (what a bright one turned to the window would be lost by aiming), and a hole
 * in the roof. */
static size_t build_walls(murk_surface_desc out[WALLS])
{
    size_t n = 0;
    const murk_vec3 x = {4, 0, 0}, y = {0, 3, 0}, z = {0, 0, 2.5};
    out[n++] = test_rect(murk_vec(0, 0, 0), x, y, 0); /* floor */
    out[n++] = test_rect(murk_vec(0, 0, 0), x, z, 0); /* south */
    out[n++] = test_rect(murk_vec(0, 3, 0), x, z, 0); /* north */
    out[n++] = test_rect(murk_vec(4, 0, 0), y, z, 0); /* east */
    out[n++] = test_rect(murk_vec(0, 0, 0), y, murk_vec(0, 0, 1), 0);
    out[n++] = test_rect(murk_vec(0, 0, 2), y, murk_vec(0, 0, 0.5), 0);
    out[n++] =
        test_rect(murk_vec(0, 0, 1), murk_vec(0, 2, 0), murk_vec(0, 0, 1), 0);
    out[n++] = test_rect(murk_vec(0, 0, 2.5), murk_vec(3, 0, 0), y, 0);
    out[n++] = test_rect(murk_vec(3, 0, 2.5), murk_vec(1, 0, 0),
                         murk_vec(0, 2.2, 0), 0);
    out[n++] = test_rect(murk_vec(-1, 1.5, 0), murk_vec(0, 1, 0),
                         murk_vec(0, 0, 2), 1); /* the screen */
    return n;
}

/* The window; the hole in the roof; and, a metre behind the window, a second
 * portal that the same light passes. */
static const murk_portal portals[3] = {
    {{0.9, 1.5, 0.3}, {0, 1.5, 0}, {0, 0, 2}},
    {{0, 2, 1}, {0, 1, 0}, {0, 0, 1}},
    {{3, 2.2, 2.5}, {0, 0.8, 0}, {1, 0, 0}}};

static void compare(const murk_source *light, uint64_t far, uint64_t near,
                    double min_merit, uint32_t seed)
{
    murk_surface_desc wall[WALLS];
    const murk_material material[2] = {test_material(0.5, 0, 0, 0),
                                       test_material(0, 0, 0, 0)};
    murk_source aimed = *light;
    aimed.portal = portals;
    aimed.portals = 3;
    test_setup setup = {.domain = {{{-3, -2, 0}, {5, 5, 4}}, false},
                        .lights = light,
                        .n_lights = 1,
                        .surfaces = wall,
                        .n_surfaces = build_walls(wall),
                        .materials = material,
                        .n_materials = 2};
    /* A ball within the room: a plane would go on outside. */
    const murk_tally_desc ball = {.name = "ball",
                                  .type = MURK_TALLY_SPHERE,
                                  .center = {1.8, 1.6, 1.1},
                                  .radius_m = 0.8};
    const murk_estimate all = through(&setup, &ball, far, seed);
    setup.lights = &aimed;
    const murk_estimate by_window = through(&setup, &ball, near, seed + 1);
    const double sigma = hypot(all.standard_error, by_window.standard_error);
    CHECK_WITHIN(limit, by_window.value - all.value, 0, sigma);
    CHECK(sigmas_off(1.25 * by_window.value, all.value, sigma) > limit);
    const double merit = (double)far / (double)near *
                         pow(all.standard_error / by_window.standard_error, 2);
    printf("aimed %.4g +- %.2g, else %.4g +- %.2g W/m2: figure of merit %.1f\n",
           by_window.value, by_window.standard_error, all.value,
           all.standard_error, merit);
    CHECK(merit > min_merit);
}

static void test_box_with_windows(uint32_t seed)
{
    const murk_source even = sky_of(5), clear = sky_of(12);
    compare(&even, 1200000, 100000, 5, seed);
    compare(&clear, 1200000, 100000, 5, seed);
    murk_source rays = {.type = MURK_SOURCE_DIRECTIONAL,
                        .direction = murk_vec(0.5, 0.1, -0.8),
                        .angular_radius_rad = 0.02,
                        .power_w = {{100}},
                        .where = "sun"};
    compare(&rays, 1200000, 120000, 5, seed);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    limit = murk_sidak_limit(1e-6, CHECKS);
    test_open_ground(seed);
    test_box_with_windows(seed);
    return check_done();
}
