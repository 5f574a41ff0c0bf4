/* A wind-blown surface: what no rule for drawing facets may break, and what
 * others computed for the sea.
 *
 * Balance. Light of radiance n^2 on both sides, the same in all directions,
 * must stay so (Kirchhoff; n^2: Nicodemus, Am. J. Phys. 31 (1963) 368,
 * doi:10.1119/1.1969512), and each path of light must have the weight of the
 * reverse path (Helmholtz). The paths here are from a class of directions to
 * another, by side, square of the cosine and turn in azimuth. A walk without
 * hidden heights, which keeps energy just as well, is refused by the same
 * check. Then a whole sea with murk, glass and an island, which absorb nothing.
 *
 * Reflectance. Of the sun: Jin et al. 2011 (sea_surface.h). Models of the
 * surface differ by 10 to 18 % among themselves (Mobley, Appl. Opt. 54 (2015)
 * 4828, doi:10.1364/AO.54.004828): 10 % is asked for where the sun is 20
 * degrees high or more and up to 10 m/s, 18 % down to 2 degrees and up to 20
 * m/s. Of a diffuse sky over level water: Walsh's closed form; over waves it
 * falls with the wind.
 *
 * Bottom. Black, grey and white Lambertian bottoms under clear water send Rs +
 * (1 - Rs) A (1 - Ri) / (1 - A Ri) back, with Rs of the surface for the sun, Ri
 * for diffuse light from below, Ri = 1 - (1 - Re) / n^2 by balance.
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "medium/fresnel.h"
#include "medium/waves.h"
#include "sea_surface.h"
#include "transport/facets.h"
#include "worlds.h"

#include <stdlib.h>

#define PHOTONS 200000
#define Z_TESTS 2000 /* at most */

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

/* ---- balance of one surface ---- */

/* Classes of directions: by side, and by cosine^2, which Lambertian light
 * fills evenly. */
#define STEPS   5
#define CLASSES (2 * STEPS)
#define TURNS   3 /* of azimuth, between 0 and half a turn */

typedef struct outcomes {
    double n[CLASSES][CLASSES][TURNS];
    double from[CLASSES], to[CLASSES];
    double lost;
} outcomes;

typedef bool (*meet_function)(const murk_address *address, double n_from,
                              double n_to, double mean_square_slope,
                              murk_vec3 direction, murk_vec3 normal,
                              murk_bounce *bounce);

/* A wrong walk that looks right: the facet is drawn by the visible area,
 * and light that does not go towards the mean surface leaves. */
static bool meet_without_heights(const murk_address *address, double n_from,
                                 double n_to, double mean_square_slope,
                                 murk_vec3 direction, murk_vec3 normal,
                                 murk_bounce *bounce)
{
    /* The walk begins on the side from which the light comes. */
    const double width = sqrt(mean_square_slope);
    double n[2] = {n_from, n_to};
    double side = 1;
    for (uint32_t k = 0; k < 1000; ++k) {
        /* Light that goes away from the mean surface leaves: no height can
         * hide it. */
        const murk_vec3 up = murk_scale(side, normal);
        const double cosine = -murk_dot(direction, up);
        if (cosine < 0) {
            *bounce = (murk_bounce){side > 0 ? MURK_MIRRORED : MURK_TRANSMITTED,
                                    direction};
            return true;
        }
        /* Draw a facet by the slopes along and across the light, and
         * refract or mirror at the facet. */
        const murk_random4 r = murk_random_at(address, k);
        const murk_slope slope = murk_facet_sample(width, cosine, r.u);
        const murk_vec3 over = murk_unit(murk_along(direction, cosine, up));
        const murk_vec3 facet =
            murk_unit(murk_along(murk_along(up, -slope.along, over),
                                 -slope.across, murk_cross(up, over)));
        const int to = side < 0;
        const murk_bounce met =
            murk_refract(n[to], n[!to], direction, facet, r.u[3]);
        direction = met.direction;
        side = met.outcome == MURK_TRANSMITTED ? -side : side;
    }
    return false;
}

static int class_of(bool in_water, double cosine)
{
    const int step = (int)(cosine * cosine * STEPS);
    return (in_water ? STEPS : 0) + (step < STEPS ? step : STEPS - 1);
}

/* Counts paths of Lambertian light of radiance n^2 from either side. */
static outcomes follow(meet_function meet, double mean_square_slope,
                       uint32_t seed)
{
    outcomes w = {.lost = 0};
    const murk_vec3 up = {0, 0, 1};
    for (uint64_t i = 0; i < PHOTONS; ++i) {
        /* A photon comes from the water with a chance of n^2 / (1 + n^2),
         * by the cosine law. */
        const murk_random4 r = murk_random(seed, MURK_TEST, i, 1, 0);
        const bool in_water = r.u[0] > 1 / (1 + SEA_INDEX * SEA_INDEX);
        const double mu = sqrt(r.u[1]), side = in_water ? -1 : 1;
        const murk_vec3 in = murk_about(up, -side * mu, 2 * MURK_PI * r.u[2]);
        const murk_address address = {seed, MURK_TEST, i, 2};
        /* Let the photon meet the surface. */
        murk_bounce out;
        if (!meet(&address, in_water ? SEA_INDEX : 1, in_water ? 1 : SEA_INDEX,
                  mean_square_slope, in, murk_scale(side, up), &out)) {
            w.lost += 1;
            continue;
        }
        /* Count the path by class before, class after, and turn in azimuth. */
        const murk_vec3 d = out.direction;
        const double turned = fabs(
            atan2(in.x * d.y - in.y * d.x, in.x * d.x + in.y * d.y) / MURK_PI);
        const int from = class_of(in_water, mu), to = class_of(d.z < 0, d.z);
        const int turn = (int)fmin(TURNS - 1, turned * TURNS);
        w.from[from] += 1;
        w.to[to] += 1;
        w.n[from][to][turn] += 1;
    }
    return w;
}

/* The most that a class of what leaves differs from what Lambertian light
 * would leave there, in sigmas. */
static double off_lambert(const outcomes *w)
{
    double worst = 0;
    for (int c = 0; c < CLASSES; ++c) {
        const double air = 1 / (1 + SEA_INDEX * SEA_INDEX);
        const double share = (c < STEPS ? air : 1 - air) / STEPS;
        worst = fmax(worst, sigmas_off(w->to[c] / PHOTONS, share,
                                       sqrt(share * (1 - share) / PHOTONS)));
    }
    return worst;
}

/* The largest difference between a path and the reverse path, in sigmas. */
static double off_balance(const outcomes *w)
{
    double worst = 0;
    for (int a = 0; a < CLASSES; ++a) {
        for (int b = 0; b < a; ++b) {
            for (int t = 0; t < TURNS; ++t) {
                const double there = w->n[a][b][t], back = w->n[b][a][t];
                if (there + back >= 100) {
                    worst = fmax(worst,
                                 sigmas_off(there, back, sqrt(there + back)));
                }
            }
        }
    }
    return worst;
}

static void test_isotropic_light_stays_so(uint32_t seed)
{
    /* 5 and 20 m/s, and steeper than any sea */
    const double slope[] = {.0286, .1054, .5};
    for (int i = 0; i < 3; ++i) {
        const outcomes w = follow(murk_meet_facets, slope[i], seed);
        CHECK(w.lost == 0);
        CHECK(off_lambert(&w) < limit());
        CHECK(off_balance(&w) < limit());
    }
    /* Teeth: without hidden heights. */
    const outcomes w = follow(meet_without_heights, .1054, seed);
    CHECK(off_lambert(&w) > limit());
    CHECK(off_balance(&w) > limit());
}

/* ---- reflectance ---- */

/* How far off Jin's value, as a share of it, after what noise may do. */
static double off_jin(double zenith_deg, double wind, double slope_per_wind,
                      uint32_t seed)
{
    const double mean_square = .003 + slope_per_wind * wind;
    const double mu = cos(zenith_deg * MURK_PI / 180);
    const murk_estimate e =
        sea_reflected(1, SEA_INDEX, mean_square, mu, 20000, seed);
    const double jin = sea_sun_by_jin(mu, sqrt(.003 + .00512 * wind));
    return fmax(0, fabs(e.value - jin) - limit() * e.standard_error) / jin;
}

static void test_the_sun_is_reflected_as_computed(uint32_t seed)
{
    const double zenith_deg[] = {0, 30, 50, 60, 70, 75, 80, 85, 88};
    const double wind[] = {1, 5, 10, 15, 20};
    for (int i = 0; i < 9; ++i) {
        for (int k = 0; k < 5; ++k) {
            const bool usual = zenith_deg[i] <= 70 && wind[k] <= 10;
            CHECK(off_jin(zenith_deg[i], wind[k], .00512, seed) <
                  (usual ? .10 : .18));
        }
    }
    /* Teeth: twice the slopes, and a quarter of them. */
    CHECK(off_jin(70, 10, 2 * .00512, seed) > .10);
    CHECK(off_jin(88, 20, .00128, seed) > .18);
}

static double from_below(double from_above)
{
    return 1 - (1 - from_above) / (SEA_INDEX * SEA_INDEX);
}

static void test_the_sky_is_reflected_less_by_more_wind(uint32_t seed)
{
    const murk_estimate level =
        sea_reflected(1, SEA_INDEX, 1e-10, 0, PHOTONS, seed);
    CHECK_WITHIN(limit(), level.value, sea_sky_by_walsh(SEA_INDEX),
                 level.standard_error);
    CHECK(sigmas_off(level.value, sea_sky_by_walsh(1.28),
                     level.standard_error) > limit());
    murk_estimate before = level;
    for (int wind = 5; wind <= 20; wind += 5) {
        const double slope = murk_wind_mean_square_slope(wind);
        const murk_estimate e =
            sea_reflected(1, SEA_INDEX, slope, 0, PHOTONS, seed);
        const murk_estimate below =
            sea_reflected(SEA_INDEX, 1, slope, 0, PHOTONS, seed + 1);
        CHECK(e.value < before.value);
        CHECK_WITHIN(limit(), below.value, from_below(e.value),
                     hypot(below.standard_error,
                           e.standard_error / (SEA_INDEX * SEA_INDEX)));
        before = e;
    }
    CHECK(before.value > .04); /* some .048 at 20 m/s, .066 without wind */
}

/* ---- whole worlds ---- */

static const murk_domain tile = {{{0, 0, -2}, {3, 3, 2}}, true};

static murk_region sea(double mean_square_slope)
{
    murk_region region = test_everywhere(0);
    region.shape = MURK_REGION_BELOW;
    region.below_z_m = 0;
    region.ior = SEA_INDEX;
    region.mean_square_slope = mean_square_slope;
    return region;
}

typedef struct escapes {
    double n[CLASSES]; /* by where the photon left, and how steeply */
} escapes;

static void note_escape(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    escapes *e = context;
    if (event->kind == MURK_EVENT_ESCAPED) {
        const double z = event->direction_out.z;
        e->n[class_of(z < 0, z)] += 1;
    }
}

/* Lambertian light from the top, and n^2 of it from the bottom, of a
 * lossless sea of murky water with a ball of glass, a white island, and
 * mist above. Returns the largest deviation of a class of escaped light, in
 * standard errors. */
static double off_in_a_whole_sea(double water_ior, bool by_delta, uint32_t seed)
{
    /* Lights at the top and at the bottom. */
    const murk_vec3 x = {3, 0, 0}, y = {0, 3, 0};
    const murk_source lamps[] = {{.type = MURK_SOURCE_RECT,
                                  .position = {0, 0, 2},
                                  .edge1 = y,
                                  .edge2 = x,
                                  .power_w = {{1}},
                                  .where = "sky"},
                                 {.type = MURK_SOURCE_RECT,
                                  .position = {0, 0, -2},
                                  .edge1 = x,
                                  .edge2 = y,
                                  .power_w = {{SEA_INDEX * SEA_INDEX}},
                                  .where = "bottom"}};
    /* The contents of the sea; `water_ior` may be a wrong index. */
    const murk_material materials[] = {test_material(1, 0, 0, 0),
                                       test_material(0, 0, 1, 1.5)};
    const murk_surface_desc surfaces[] = {
        test_sphere(murk_vec(1, 1, -1), .5, 1),
        test_box(murk_vec(2, 2, -.5), murk_vec(2.8, 2.8, .4), 0)};
    const murk_medium media[] = {test_medium(.7, 1, .8), test_medium(.2, 1, 0)};
    murk_region regions[] = {test_everywhere(1), sea(.05)};
    regions[1].medium = 0;
    regions[1].ior = water_ior;
    test_world w = test_world_made(&(test_setup){.domain = tile,
                                                 .lights = lamps,
                                                 .n_lights = 2,
                                                 .surfaces = surfaces,
                                                 .n_surfaces = 2,
                                                 .materials = materials,
                                                 .n_materials = 2,
                                                 .media = media,
                                                 .n_media = 2,
                                                 .regions = regions,
                                                 .n_regions = 2});
    /* Trace; no photon is lost or absorbed. */
    murk_error err = {0};
    CHECK(!murk_media_prepare_delta(w.media, &err));
    escapes e = {{0}};
    murk_trace trace = murk_trace_defaults();
    trace.world = &w.world;
    trace.seed = seed;
    trace.last = 40000;
    trace.by_delta = by_delta;
    trace.sink = note_escape;
    trace.context = &e;
    murk_trace_run(&trace, w.ledger);
    CHECK(murk_ledger_imbalance(w.ledger) == 0);
    CHECK(test_photons(&w, w.ledger->lost) == 0);
    CHECK(test_photons(&w, w.ledger->escaped) == 40000);
    test_world_unmade(&w);
    /* Escaped light must be spread over the classes as the light that
     * enters. */
    double worst = 0;
    for (int c = 0; c < CLASSES; ++c) {
        const double air = 1 / (1 + SEA_INDEX * SEA_INDEX);
        const double share = (c < STEPS ? air : 1 - air) / STEPS;
        worst = fmax(worst, sigmas_off(e.n[c] / 40000, share,
                                       sqrt(share * (1 - share) / 40000)));
    }
    return worst;
}

static void test_a_lossless_sea_keeps_its_light(uint32_t seed)
{
    CHECK(off_in_a_whole_sea(SEA_INDEX, false, seed) < limit());
    CHECK(off_in_a_whole_sea(SEA_INDEX, true, seed + 1) < limit());
    CHECK(off_in_a_whole_sea(1.5, false, seed) > limit()); /* teeth */
}

/* Power that comes up out of a clear sea of 1 m, as a share of the power of
 * the sun; a plane tally in the surface must agree. */
static murk_estimate from_a_bottom(double albedo, double mean_square_slope,
                                   uint32_t seed)
{
    /* The sun above a Lambertian bottom. */
    const uint64_t n = 50000;
    const murk_source sun = {.type = MURK_SOURCE_DIRECTIONAL,
                             .direction = {.6, 0, -.8},
                             .power_w = {{1}},
                             .where = "sun"};
    const murk_material sand = test_material(albedo, 0, 0, 0);
    const murk_surface_desc bottom =
        test_rect(murk_vec(0, 0, -1), murk_vec(3, 0, 0), murk_vec(0, 3, 0), 0);
    const murk_medium clear = test_medium(0, 1, 0);
    const murk_region region = sea(mean_square_slope);
    test_world w = test_world_made(&(test_setup){.domain = tile,
                                                 .lights = &sun,
                                                 .n_lights = 1,
                                                 .surfaces = &bottom,
                                                 .n_surfaces = 1,
                                                 .materials = &sand,
                                                 .n_materials = 1,
                                                 .media = &clear,
                                                 .n_media = 1,
                                                 .regions = &region,
                                                 .n_regions = 1});
    /* A plane tally in the mean surface. */
    const murk_tally_desc level = {.name = "level",
                                   .where = "level",
                                   .type = MURK_TALLY_PLANE,
                                   .normal = {0, 0, 1},
                                   .point = {1, 1, 0},
                                   .bins = {1, 1},
                                   .angle_bins = 1};
    murk_tallies *tallies = NULL;
    murk_error err = {0};
    CHECK(!murk_tallies_create(&tallies, &level, 1, &tile, 1, 1, 1, INFINITY,
                               &err));
    /* Trace; no photon is lost. */
    murk_trace trace = murk_trace_defaults();
    trace.world = &w.world;
    trace.seed = seed;
    trace.last = n;
    trace.tallies = tallies;
    murk_trace_run(&trace, w.ledger);
    CHECK(murk_ledger_imbalance(w.ledger) == 0);
    CHECK(test_photons(&w, w.ledger->lost) == 0);
    /* Downward less upward power at the surface is the power of the sun
     * less the escaped power. */
    const double up = test_photons(&w, w.ledger->escaped);
    const double packet_w = 1 / (double)n;
    const murk_estimate forward =
        murk_tallies_read(tallies, 0, 0, 0, w.ledger->emitted, &packet_w);
    const murk_estimate backward =
        murk_tallies_read(tallies, 0, 0, 1, w.ledger->emitted, &packet_w);
    CHECK_NEAR(backward.value - forward.value, 1 - up / (double)n, 1e-9);
    murk_tallies_destroy(tallies);
    test_world_unmade(&w);
    /* The escaped share is binomial. */
    const double share = up / (double)n;
    return (murk_estimate){share, sqrt(share * (1 - share) / (double)n)};
}

static double from_a_bottom_by_hand(double albedo, double sun, double sky)
{
    const double below = from_below(sky);
    return sun + (1 - sun) * albedo * (1 - below) / (1 - albedo * below);
}

static void test_bottoms_of_sand(uint32_t seed)
{
    double unused;
    const double sun = murk_fresnel(1, SEA_INDEX, .8, &unused);
    const double slope = murk_wind_mean_square_slope(10);
    const murk_estimate rough =
        sea_reflected(1, SEA_INDEX, slope, .8, PHOTONS, seed);
    const murk_estimate sky =
        sea_reflected(1, SEA_INDEX, slope, 0, PHOTONS, seed + 7);
    for (int i = 0; i < 4; ++i) {
        const double albedo = (const double[]){0, .25, .7, .95}[i];
        const murk_estimate level = from_a_bottom(albedo, 0, seed);
        CHECK_WITHIN(
            limit(), level.value,
            from_a_bottom_by_hand(albedo, sun, sea_sky_by_walsh(SEA_INDEX)),
            level.standard_error);
        const murk_estimate waves = from_a_bottom(albedo, slope, seed + 1);
        const double hand =
            from_a_bottom_by_hand(albedo, rough.value, sky.value);
        const double by_sun =
            from_a_bottom_by_hand(albedo, rough.value + rough.standard_error,
                                  sky.value) -
            hand;
        const double by_sky =
            from_a_bottom_by_hand(albedo, rough.value,
                                  sky.value + sky.standard_error) -
            hand;
        CHECK_WITHIN(limit(), waves.value, hand,
                     hypot(waves.standard_error, hypot(by_sun, by_sky)));
    }
    const murk_estimate grey = from_a_bottom(.7, 0, seed);
    CHECK(
        sigmas_off(grey.value,
                   from_a_bottom_by_hand(.72, sun, sea_sky_by_walsh(SEA_INDEX)),
                   grey.standard_error) > limit()); /* teeth */
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_isotropic_light_stays_so(seed);
    test_the_sun_is_reflected_as_computed(seed);
    test_the_sky_is_reflected_less_by_more_wind(seed);
    test_a_lossless_sea_keeps_its_light(seed);
    test_bottoms_of_sand(seed);
    return check_done();
}
