/* Light judged by the place: densities on a plate and in a cloud of known
 * radiance, what is left out of them, and the chance that a sensor notices,
 * by hand.
 *
 * The random tests share a 1e-6 chance of a false alarm (Sidak). */
#include "sensing/power.h"

#include "base/rng.h"
#include "base/stats.h"
#include "sensing/vicinity.h"
#include "world.h"

#define SEED   7
#define CHECKS 7

static const murk_domain interior = {.box = {{-5, -5, -5}, {5, 5, 5}}};
static const murk_domain tiled = {.box = {{-5, -5, -5}, {5, 5, 5}},
                                  .is_periodic = true};

static double limit(void)
{
    return murk_sidak_limit(1e-6, CHECKS);
}

static murk_media *cloud_of(double g)
{
    murk_medium medium = {
        .extinction_per_m = {{0.1, 0.1}}, .albedo = {{1, 1}}, .where = "cloud"};
    medium.phase[0] = medium.phase[1] = murk_phase_hg(g);
    const murk_region region = {.shape = MURK_REGION_EVERYWHERE,
                                .to_world = murk_affine_identity(),
                                .where = "everywhere"};
    murk_media *media = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&media, &medium, 1, &region, 1, &interior.box,
                            &err) == MURK_OK);
    return media;
}

typedef struct place {
    murk_media *media;
    murk_photon_map *surface, *volume;
    murk_power *power;
} place;

static place place_of(const murk_photon *photon, size_t n, uint64_t emitted,
                      double radius_m, const murk_domain *domain, double g,
                      unsigned threads)
{
    const bool is_volume = n > 0 && murk_photon_is_volume(photon);
    place p = {.media = cloud_of(g),
               .surface = map_of(photon, is_volume ? 0 : n),
               .volume = map_of(photon, is_volume ? n : 0)};
    const murk_sight_desc desc = {.surface_map = p.surface,
                                  .volume_map = p.volume,
                                  .photons_emitted = emitted,
                                  .media = p.media,
                                  .domain = *domain,
                                  .power = {.radius_m = radius_m},
                                  .threads = threads};
    murk_error err = {0};
    CHECK(murk_power_create(&p.power, &desc, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return p;
}

static void leave(place *p)
{
    murk_power_destroy(p->power);
    murk_photon_map_destroy(p->surface);
    murk_photon_map_destroy(p->volume);
    murk_media_destroy(p->media);
}

/* ---- densities ---- */

/* The mean over places that photons are stored at, of a density that others
 * give there: n places, q others around each. Pairs are counted (2 / (n q)),
 * and how many places there are (1 / n). */
static double relative_error(double n, double q)
{
    return sqrt(1 / n + 2 / (n * q));
}

/* Photons all over a plate of 10 x 10 m that leaves 3 W/m2 by the cosine law:
 * L is 3 / pi. Where more lie around than are looked at, too. */
static void check_plate(uint32_t n, double radius_m)
{
    murk_photon *photon = malloc(n * sizeof *photon);
    for (uint32_t i = 0; i < n; ++i) {
        const murk_random4 u = murk_random(SEED, MURK_SCATTER, i, n, 0);
        photon[i] = a_photon(murk_vec(10 * u.u[0] - 5, 10 * u.u[1] - 5, 0),
                             murk_vec(0, 0, 1), i);
        photon[i].power_w = (float)(300. / n);
    }
    place p = place_of(photon, n, n, radius_m, &interior, 0, 2);
    const murk_photon *stored = murk_photon_map_photons(p.surface);
    double sum = 0, places = 0;
    for (size_t i = 0; i < n; ++i) {
        const float *x = stored[i].position_m;
        if (fmax(fabs((double)x[0]), fabs((double)x[1])) < 5 - radius_m) {
            sum += murk_power_radiance(p.power, i);
            ++places;
        }
    }
    const double q = n * MURK_PI * radius_m * radius_m / 100;
    const double seen = fmin(q, MURK_POWER_SURFACE_MAX / 2.);
    const double error = relative_error(places * seen / q, seen);
    CHECK_WITHIN(limit(), sum / places, 3 / MURK_PI, 3 / MURK_PI * error);
    /* Teeth: a disc too wide by 3 % where all are looked at. */
    CHECK(q > seen || sigmas_off(sum / places * 1.03 * 1.03, 3 / MURK_PI,
                                 3 / MURK_PI * error) > limit());
    leave(&p);
    free(photon);
}

static void test_a_plate_of_known_radiance(void)
{
    check_plate(40000, 0.25);
    check_plate(20000, 1);
}

/* Photons all over a cube fly along +x and scatter by the function of
 * Henyey and Greenstein: the source is the density of power times the phase
 * function. */
static void test_a_cloud_of_known_source(void)
{
    /* Photons with one direction, spread over a cube. */
    enum { N = 40000 };
    const double radius_m = 0.5, g = 0.7;
    murk_photon *photon = malloc(N * sizeof *photon);
    for (uint32_t i = 0; i < N; ++i) {
        const murk_random4 u = murk_random(SEED, MURK_SCATTER, i, 1, 1);
        photon[i] = a_photon(
            murk_vec(10 * u.u[0] - 5, 10 * u.u[1] - 5, 10 * u.u[2] - 5),
            murk_vec(0, 0, 0), i);
        photon[i].direction = murk_direction_pack(murk_vec(1, 0, 0));
        photon[i].power_w = (float)(1000. / N);
    }
    /* The source in two directions at known angles to the flight, averaged over
     * photons away from the sides. */
    place p = place_of(photon, N, N, radius_m, &interior, g, 2);
    const murk_photon *stored = murk_photon_map_photons(p.volume);
    const murk_vec3 toward[2] = {murk_unit(murk_vec(3, 4, 0)),
                                 murk_unit(murk_vec(-3, 0, 4))};
    const double mu[2] = {0.6, -0.6};
    for (int k = 0; k < 2; ++k) {
        double sum = 0, places = 0;
        for (size_t i = 0; i < N; ++i) {
            const float *x = stored[i].position_m;
            const double max = fmax(fabs((double)x[0]), fabs((double)x[1]));
            if (fmax(max, fabs((double)x[2])) < 5 - radius_m) {
                sum += murk_power_source(p.power, i, toward[k]);
                ++places;
            }
        }
        /* The mean is right within the error from the number of independent
         * places; another mean cosine is refused. */
        const double q = 4 / 3. * MURK_PI * pow(radius_m, 3) * N / 1000;
        const double want = murk_hg_density(g, mu[k]);
        const double error = want * relative_error(places, q);
        CHECK_WITHIN(limit(), sum / places, want, error);
        const double off = murk_hg_density(g + 0.04, mu[k]);
        CHECK(sigmas_off(sum / places, off, error) > limit());
    }
    leave(&p);
    free(photon);
}

/* The other path on this side, in this band and radius alone. */
static void test_what_counts_as_light_of_a_place(void)
{
    const murk_vec3 up = {0, 0, 1}, down = {0, 0, -1};
    murk_photon photon[] = {a_photon(murk_vec(0, 0, 0), up, 0),
                            a_photon(murk_vec(.1, 0, 0), up, 0),
                            a_photon(murk_vec(.2, 0, 0), up, 1),
                            a_photon(murk_vec(.3, 0, 0), down, 2),
                            a_photon(murk_vec(.1, .1, 0), up, 3),
                            a_photon(murk_vec(.65, 0, 0), up, 4)};
    photon[4].band = 1;
    const double r = 0.5, area = MURK_PI * MURK_PI * r * r;
    place p = place_of(photon, 6, 10, r, &interior, 0, 1);
    const murk_photon *stored = murk_photon_map_photons(p.surface);
    for (size_t i = 0; i < 6; ++i) {
        const double got = murk_power_radiance(p.power, i) * area;
        const uint32_t e = stored[i].emitted;
        const double x = (double)stored[i].position_m[0];
        /* of ten paths nine are others': each stands for 10 / 9 */
        const double others = e == 0 ? 1 : e == 1 ? 3 : e == 4 ? 1 : 0;
        CHECK_NEAR(got, others * 10 / 9, 1e-6);
        CHECK(x < 1);
    }
    leave(&p);
}

/* Twenty thousand photons in one spot: the search halves the set until few
 * are left, and a part stands for all photons exactly. */
static void test_a_spot_is_looked_at_in_part(void)
{
    /* Photons on one point of a surface. */
    enum { N = 20000 };
    murk_photon *photon = malloc(N * sizeof *photon);
    for (uint32_t i = 0; i < N; ++i) {
        photon[i] = a_photon(murk_vec(1, 2, 0), murk_vec(0, 0, 1), i);
    }
    /* The radiance is that of all photons. */
    place p = place_of(photon, N, N, 0.1, &interior, 0, 1);
    for (size_t i = 0; i < N; i += 97) {
        CHECK_NEAR(murk_power_radiance(p.power, i) * MURK_PI * MURK_PI * 0.01 /
                       N,
                   1, 1e-6);
    }
    /* The search visits only a part of them. */
    murk_vicinity *v = NULL;
    murk_error err = {0};
    CHECK(murk_vicinity_create(&v, p.surface, &interior, N, 0.1, 100, 1,
                               &err) == MURK_OK);
    uint32_t *found = malloc(murk_vicinity_capacity(v) * sizeof *found);
    const murk_around around =
        murk_vicinity_find(v, murk_vec(1, 2, 0), 5, found);
    CHECK(around.n > 40 && around.n <= 100);
    free(found);
    murk_vicinity_destroy(v);
    leave(&p);
    free(photon);
}

/* Ten paths that left two thousand records each, all over a plate. */
static void test_few_paths_with_many_records(void)
{
    enum { N = 20000 };
    murk_photon *photon = malloc(N * sizeof *photon);
    for (uint32_t i = 0; i < N; ++i) {
        const murk_random4 u = murk_random(SEED, MURK_SCATTER, i, 3, 0);
        photon[i] = a_photon(murk_vec(10 * u.u[0] - 5, 10 * u.u[1] - 5, 0),
                             murk_vec(0, 0, 1), i % 10);
    }
    murk_photon_map *map = map_of(photon, N);
    murk_vicinity *v = NULL;
    murk_error err = {0};
    CHECK(murk_vicinity_create(&v, map, &interior, 10, 2, 100, 1, &err) ==
          MURK_OK);
    uint32_t *found = malloc(murk_vicinity_capacity(v) * sizeof *found);
    const murk_around around =
        murk_vicinity_find(v, murk_vec(0, 0, 0), MURK_VICINITY_ALL, found);
    /* The estimate is the number of records within the radius of 2 m. */
    const double want = N * MURK_PI * 4 / 100;
    CHECK(around.n > 20 && around.n < 200);
    CHECK_WITHIN(limit(), (double)around.n * around.factor, want,
                 want / sqrt((double)around.n));
    free(found);
    murk_vicinity_destroy(v);
    murk_photon_map_destroy(map);
    free(photon);
}

/* Places in a map of their own are lit by all photons of the light. */
static void test_places_that_are_no_photons(void)
{
    /* Two photons of light, and two places in another map: one near the
     * photons, one far away. */
    const murk_vec3 up = {0, 0, 1};
    const murk_photon light[] = {a_photon(murk_vec(0, 0, 0), up, 0),
                                 a_photon(murk_vec(.2, 0, 0), up, 1)};
    const murk_photon at[] = {a_photon(murk_vec(.1, 0, 0), up, 0),
                              a_photon(murk_vec(3, 0, 0), up, 1)};
    /* Radiances of the places by the photons. */
    place p = {.media = cloud_of(0),
               .surface = map_of(light, 2),
               .volume = map_of(NULL, 0)};
    murk_photon_map *places = map_of(at, 2);
    const murk_sight_desc desc = {
        .surface_map = places,
        .volume_map = p.volume,
        .media = p.media,
        .domain = interior,
        .power = {.radius_m = 0.5, .light = {p.surface, p.volume, 2}},
        .threads = 1};
    murk_error err = {0};
    CHECK(murk_power_create(&p.power, &desc, &err) == MURK_OK);
    /* The near place has the power of both photons, the far place none. */
    const size_t lit =
        murk_photon_map_photons(places)[0].position_m[0] > 1 ? 1 : 0;
    CHECK_NEAR(murk_power_radiance(p.power, lit) * MURK_PI * MURK_PI * .25, 2,
               1e-6);
    CHECK(murk_power_radiance(p.power, 1 - lit) == 0);
    murk_photon_map_destroy(places);
    leave(&p);
}

static void test_periodic_sides_are_near_each_other(void)
{
    const murk_vec3 up = {0, 0, 1};
    const murk_photon photon[] = {a_photon(murk_vec(-4.9, 0, 0), up, 0),
                                  a_photon(murk_vec(4.9, 0, 0), up, 1)};
    place p = place_of(photon, 2, 2, 0.5, &tiled, 0, 1);
    place q = place_of(photon, 2, 2, 0.5, &interior, 0, 1);
    for (size_t i = 0; i < 2; ++i) {
        CHECK_NEAR(murk_power_radiance(p.power, i) * MURK_PI * MURK_PI * .25, 2,
                   1e-6);
        CHECK(murk_power_radiance(q.power, i) == 0);
    }
    leave(&p);
    leave(&q);
}

static void test_threads_do_not_matter(void)
{
    enum { N = 5000 };
    murk_photon photon[N];
    for (uint32_t i = 0; i < N; ++i) {
        const murk_random4 u = murk_random(SEED, MURK_SCATTER, i, 2, 0);
        photon[i] = a_photon(murk_vec(u.u[0], u.u[1], u.u[2]),
                             murk_vec(0, 0, 0), i / 3);
        photon[i].direction = murk_direction_pack(murk_vec(1, 0, 0));
        photon[i].band = i % 2;
    }
    const murk_vec3 toward = murk_unit(murk_vec(1, 2, 3));
    place one = place_of(photon, N, N / 3 + 1, 0.2, &interior, 0.5, 1);
    place five = place_of(photon, N, N / 3 + 1, 0.2, &interior, 0.5, 5);
    for (size_t i = 0; i < N; ++i) {
        CHECK(murk_power_source(one.power, i, toward) ==
              murk_power_source(five.power, i, toward));
    }
    leave(&one);
    leave(&five);
}

static void test_bad_radii_are_refused(void)
{
    const murk_domain *domain[] = {&interior, &interior, &interior, &tiled};
    const double radius[] = {0, -1, NAN, 5.1};
    for (int i = 0; i < 4; ++i) {
        place p = {.surface = map_of(NULL, 0), .volume = map_of(NULL, 0)};
        const murk_sight_desc desc = {.surface_map = p.surface,
                                      .volume_map = p.volume,
                                      .photons_emitted = 1,
                                      .domain = *domain[i],
                                      .power = {.radius_m = radius[i]},
                                      .threads = 1};
        murk_error err = {0};
        CHECK(murk_power_create(&p.power, &desc, &err) == MURK_BAD_VALUE);
        CHECK(p.power == NULL);
        CHECK_MENTIONS(err.text, "power_radius_m");
        leave(&p);
    }
}

/* ---- signals ---- */

static void test_signals_by_hand(void)
{
    const murk_vec3 up = {0, 0, 1};
    const murk_photon photon[] = {a_photon(murk_vec(0, 0, 0), up, 0),
                                  a_photon(murk_vec(.1, 0, 0), up, 1)};
    place p = place_of(photon, 2, 2, 0.5, &interior, 0, 1);
    const double radiance = 2 / (MURK_PI * MURK_PI * .25);
    const murk_sensor_type type = {.range_m = 9,
                                   .view = MURK_VIEW_CONE,
                                   .cone_rad = 2,
                                   .aperture_m2 = 0.3,
                                   .quantum_efficiency = 0.4,
                                   .exposure_s = 0.02,
                                   .target_m2 = 0.05};
    const murk_pose pose = {.tilt_rad = -MURK_PI / 2};
    murk_sensor_type round = type;
    round.view = MURK_VIEW_SPHERE;
    const murk_field looking = murk_field_of(&type, &pose, murk_vec(0, 1, 0));
    const murk_field all = murk_field_of(&round, &pose, murk_vec(0, 1, 0));
    /* two metres off at 60 degrees from the normal, seen 30 off the axis */
    const murk_sightline line = {.transmittance = 0.7,
                                 .apparent = murk_vec(1, 0, -sqrt(3)),
                                 .leaving = murk_vec(-sqrt(.75), 0, .5),
                                 .gain = 0.5};
    const murk_photon *stored = murk_photon_map_photons(p.surface);
    const double want =
        0.7 * 0.5 * radiance * 0.05 * 0.5 * 0.3 / (4 + 0.3 / MURK_PI);
    CHECK_NEAR(murk_power_signal_w(p.power, &round, &all, stored, 0, &line),
               want, 1e-6 * want);
    CHECK_NEAR(murk_power_signal_w(p.power, &type, &looking, stored, 0, &line),
               want * sqrt(.75), 1e-6 * want);
    /* A joule at 555 nm is 2.794e18 photons (CODATA). */
    const double counts = 0.02 * 0.4 * 2.794e18 * 1e-17;
    CHECK_NEAR(murk_power_chance(&type, 1e-17, 555), 1 - exp(-counts), 1e-5);
    CHECK(fabs(murk_power_chance(&type, 1.01e-17, 555) - 1 + exp(-counts)) >
          1e-5);
    CHECK(murk_power_chance(&type, 0, 555) == 0);
    CHECK(murk_power_chance(&type, 1, 555) == 1);
    leave(&p);
}

/* Right before an aperture a target sends no more than into a half space:
 * pi L a0 where both face each other. */
static void test_nothing_takes_more_than_there_is(void)
{
    const murk_vec3 up = {0, 0, 1};
    const murk_photon photon[] = {a_photon(murk_vec(0, 0, 0), up, 0),
                                  a_photon(murk_vec(.1, 0, 0), up, 1)};
    place p = place_of(photon, 2, 2, 0.5, &interior, 0, 1);
    const murk_sensor_type type = {.aperture_m2 = 0.3, .target_m2 = 0.05};
    const murk_pose pose = {0};
    const murk_field all = murk_field_of(&type, &pose, murk_vec(0, 1, 0));
    const murk_sightline line = {.transmittance = 1,
                                 .apparent = murk_vec(0, 0, -1e-9),
                                 .leaving = up,
                                 .gain = 1};
    const double max = MURK_PI * murk_power_radiance(p.power, 0) * 0.05;
    CHECK_NEAR(murk_power_signal_w(p.power, &type, &all,
                                   murk_photon_map_photons(p.surface), 0,
                                   &line),
               max, 1e-12 * max);
    leave(&p);
}

int main(void)
{
    test_a_plate_of_known_radiance();
    test_a_cloud_of_known_source();
    test_what_counts_as_light_of_a_place();
    test_a_spot_is_looked_at_in_part();
    test_few_paths_with_many_records();
    test_places_that_are_no_photons();
    test_periodic_sides_are_near_each_other();
    test_threads_do_not_matter();
    test_bad_radii_are_refused();
    test_signals_by_hand();
    test_nothing_takes_more_than_there_is();
    return check_done();
}
