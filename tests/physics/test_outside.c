/* Light of sun and sky that enters through the sides of a domain whose media
 * continue outside: at every depth it is what an endless level medium lets
 * through. Media here absorb alone, so the answers are closed forms: Beer's law
 * along the slanted beam, with Snell's and Fresnel's laws at a water surface,
 * and 2 E3(tau) under an even sky.
 *
 * The z-tests share a 1e-6 chance of a false alarm (Sidak); the seed is fixed.
 * Each case shows that sides that are left empty fail. */
#include "base/stats.h"
#include "check.h"
#include "medium/fresnel.h"
#include "transport/outside.h"
#include "worlds.h"

#include <math.h>
#include <stdlib.h>

#define CHECKS  8
#define PHOTONS 100000

static const murk_box cube = {{0, 0, 0}, {10, 10, 10}};

static double limit(void)
{
    return murk_sidak_limit(1e-6, CHECKS);
}

static murk_source sun(double zenith_deg, double azimuth_deg)
{
    const double zenith = zenith_deg * MURK_PI / 180,
                 azimuth = azimuth_deg * MURK_PI / 180;
    return (murk_source){.type = MURK_SOURCE_DIRECTIONAL,
                         .direction = {sin(zenith) * cos(azimuth),
                                       sin(zenith) * sin(azimuth),
                                       -cos(zenith)},
                         .power_w = {{1000}},
                         .where = "sun"};
}

/* Returns the power that flows downwards through the level plane at z_m. */
static murk_estimate down_at(const test_setup *setup, bool continues,
                             double z_m, uint32_t seed)
{
    /* A world whose media continue outside or not, with a plane tally. */
    test_world made = test_world_made(setup);
    made.world.continues = continues;
    murk_tallies *tallies = NULL;
    murk_error err = {0};
    const murk_tally_desc plane = {.name = "level",
                                   .type = MURK_TALLY_PLANE,
                                   .point = {0, 0, z_m},
                                   .normal = {0, 0, -1},
                                   .bins = {1, 1},
                                   .angle_bins = 1};
    CHECK(!murk_tallies_create(&tallies, &plane, 1, &setup->domain,
                               setup->n_lights, 1, 1, INFINITY, &err));
    /* Trace the photons; energy is conserved. */
    murk_trace trace = murk_trace_defaults();
    trace.world = &made.world;
    trace.seed = seed;
    trace.last = PHOTONS;
    trace.tallies = tallies;
    murk_trace_run(&trace, made.ledger);
    CHECK(murk_ledger_imbalance(made.ledger) == 0);
    /* Read the forward side of the plane, which is the downward one. */
    const double packet_w = murk_sources_power_w(made.lights) / PHOTONS;
    const murk_estimate out =
        murk_tallies_read(tallies, 0, 0, 0, made.ledger->emitted, &packet_w);
    murk_tallies_destroy(tallies);
    test_world_unmade(&made);
    return out;
}

/* Holds with the media continued, and not with empty sides. */
static void check_at(test_setup setup, double z_m, double want, uint32_t seed)
{
    setup.domain = (murk_domain){.box = cube};
    const murk_estimate e = down_at(&setup, true, z_m, seed);
    CHECK_WITHIN(limit(), e.value, want, e.standard_error);
    const murk_estimate empty = down_at(&setup, false, z_m, seed);
    CHECK(sigmas_off(empty.value, want, empty.standard_error) > limit());
}

static void test_an_even_medium(uint32_t seed)
{
    const murk_source light = sun(60, 20);
    const murk_medium medium = test_medium(0.1, 0, 0);
    const murk_region region = test_everywhere(0);
    const test_setup setup = {.lights = &light,
                              .n_lights = 1,
                              .media = &medium,
                              .n_media = 1,
                              .regions = &region,
                              .n_regions = 1};
    check_at(setup, 5, 1000 * 0.5 * 100 * exp(-0.1 * 5 / 0.5), seed);
    /* the same medium as a box that ends in the sides */
    const murk_region box = test_box_region(0, cube.min, cube.max);
    test_setup boxed = setup;
    boxed.regions = &box;
    check_at(boxed, 2, 1000 * 0.5 * 100 * exp(-0.1 * 8 / 0.5), seed);
}

/* Fog over absorbing water: the beam bends at the surface outside, too. */
static void test_fog_over_water(uint32_t seed)
{
    const murk_source light = sun(50, 65);
    const murk_medium media[2] = {test_medium(0.02, 0, 0),
                                  test_medium(0.15, 0, 0)};
    const murk_region regions[2] = {
        test_everywhere(0),
        {.medium = 1, .shape = MURK_REGION_BELOW, .below_z_m = 6, .ior = 1.34}};
    const test_setup setup = {.lights = &light,
                              .n_lights = 1,
                              .media = media,
                              .n_media = 2,
                              .regions = regions,
                              .n_regions = 2};
    const double cosine = cos(50 * MURK_PI / 180);
    double below;
    const double reflected = murk_fresnel(1, 1.34, cosine, &below);
    const double level =
        1000 * cosine * 100 * exp(-0.02 * 4 / cosine) * (1 - reflected);
    check_at(setup, 2, level * exp(-0.15 * 4 / below), seed);
}

/* 2 E3(tau) = 2 integral of mu exp(-tau / mu). */
static void test_an_even_sky(uint32_t seed)
{
    const murk_source light = {.type = MURK_SOURCE_SKY,
                               .dome = {0},
                               .power_w = {{1000}},
                               .where = "sky"};
    const murk_medium medium = test_medium(0.08, 0, 0);
    const murk_region region = test_everywhere(0);
    double e3 = 0;
    for (int i = 0; i < 10000; ++i) {
        const double mu = (i + 0.5) / 10000;
        e3 += mu * exp(-0.08 * 5 / mu) / 10000;
    }
    check_at((test_setup){.lights = &light,
                          .n_lights = 1,
                          .media = &medium,
                          .n_media = 1,
                          .regions = &region,
                          .n_regions = 1},
             5, 1000 * 100 * 2 * e3, seed);
}

/* Light from below crosses the layers below. */
static void test_shares_by_hand(void)
{
    const murk_source light = sun(60, 0);
    const murk_medium medium = test_medium(0.1, 0.5, 0);
    const murk_region region =
        test_box_region(0, murk_vec(0, 0, 0), murk_vec(10, 10, 4));
    test_world made = test_world_made(&(test_setup){.domain = {.box = cube},
                                                    .lights = &light,
                                                    .n_lights = 1,
                                                    .media = &medium,
                                                    .n_media = 1,
                                                    .regions = &region,
                                                    .n_regions = 1});
    made.world.continues = true;
    murk_vec3 down = {sqrt(0.75), 0, -0.5}, up = {sqrt(0.75), 0, 0.5},
              level = {1, 0, 0};
    bool is_bent = true;
    const murk_transport_world *w = &made.world;
    CHECK_NEAR(murk_outside_share(w, 0, murk_vec(0, 5, 3), &down, &is_bent),
               exp(-0.1 * 1 / 0.5), 1e-12);
    CHECK(!is_bent && down.z == -0.5);
    CHECK(murk_outside_share(w, 0, murk_vec(3, 5, 10), &down, NULL) == 1);
    CHECK_NEAR(murk_outside_share(w, 0, murk_vec(0, 5, 6), &up, NULL),
               exp(-0.1 * 4 / 0.5), 1e-12);
    CHECK(murk_outside_share(w, 0, murk_vec(0, 5, 3), &level, NULL) == 0);
    CHECK(murk_outside_share(w, 0, murk_vec(0, 5, 7), &level, NULL) == 1);
    test_world_unmade(&made);

    /* Clear water below 6 m: of a beam at 60 degrees that enters the side
     * below, Fresnel's share is lost, and the side gets the tangent of the
     * bent beam instead of the straight one's. */
    const murk_medium clear = test_medium(0, 0, 0);
    murk_region water = test_everywhere(0);
    water.shape = MURK_REGION_BELOW;
    water.below_z_m = 6;
    water.ior = 1.34;
    made = test_world_made(&(test_setup){.domain = {.box = cube},
                                         .lights = &light,
                                         .n_lights = 1,
                                         .media = &clear,
                                         .n_media = 1,
                                         .regions = &water,
                                         .n_regions = 1});
    made.world.continues = true;
    murk_vec3 bent = {0, sqrt(0.75), -0.5};
    double cosine;
    const double lost = murk_fresnel(1, 1.34, 0.5, &cosine);
    CHECK(lost > 0.05);
    const double sine = sqrt(0.75) / 1.34; /* Snell */
    CHECK_NEAR(cosine, sqrt(1 - sine * sine), 1e-12);
    CHECK_NEAR(murk_outside_share(w, 0, murk_vec(0, 5, 3), &bent, &is_bent),
               (1 - lost) * sine / cosine / (sqrt(0.75) / 0.5), 1e-12);
    CHECK(is_bent && bent.x == 0);
    CHECK_NEAR(bent.y, sine, 1e-12);
    CHECK_NEAR(bent.z, -cosine, 1e-12);
    test_world_unmade(&made);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_an_even_medium(seed);
    test_fog_over_water(seed);
    test_an_even_sky(seed);
    test_shares_by_hand();
    return check_done();
}
