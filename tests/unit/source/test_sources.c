/* What each kind of light sends, by its moments and its bounds, and what is
 * refused. The z-tests of a run share a 1e-6 chance of a false alarm (Sidak);
 * the seed is fixed, so the verdict repeats. */
#include "base/rng.h"
#include "base/stats.h"
#include "check.h"
#include "source/sources.h"

#include <stdlib.h>

#define SAMPLES UINT64_C(40000)
#define Z_TESTS 40

static const murk_domain hall = {{{-2, -1, 0}, {4, 3, 5}}, false};
static const murk_domain slab = {{{-2, -1, 0}, {4, 3, 5}}, true};

static murk_source light_of(murk_source_type type)
{
    return (murk_source){.type = type,
                         .position = {1, 1, 2},
                         .edge1 = {1, 0, 0},
                         .edge2 = {0, 0.5, 0},
                         .direction = {0, 0, -1},
                         .radius_m = 0.5,
                         .power_w = {{100}},
                         .where = "a.yaml:3:5: lights.0"};
}

static murk_sources *made(const murk_source *light, const murk_domain *domain)
{
    murk_sources *lights = NULL;
    murk_error err = {0};
    CHECK(murk_sources_create(&lights, light, 1, 1, domain, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return lights;
}

/* A mean over the emitted photons against its expectation, where the quantity
 * has that variance. */
static void check_mean(double sum, double want, double variance)
{
    CHECK_WITHIN(murk_sidak_limit(1e-6, Z_TESTS), sum / (double)SAMPLES, want,
                 sqrt(variance / (double)SAMPLES));
}

static void test_sphere_shines_by_cosine_law_from_every_place(uint32_t seed)
{
    const murk_source light = light_of(MURK_SOURCE_SPHERE);
    murk_sources *lights = made(&light, &hall);
    double mu = 0, mu2 = 0, z = 0, z2 = 0, x = 0;
    bool on_surface = true;
    for (uint64_t i = 0; i < SAMPLES; ++i) {
        const murk_ray ray = murk_sources_emit(lights, seed, 0, i);
        const murk_vec3 r = murk_sub(ray.origin, light.position);
        const murk_vec3 n = murk_scale(1 / light.radius_m, r);
        const double cosine = murk_dot(n, ray.direction);
        on_surface = on_surface && fabs(murk_length(r) - 0.5) < 1e-14 &&
                     cosine > 0 && fabs(murk_length(ray.direction) - 1) < 1e-14;
        mu += cosine;
        mu2 += cosine * cosine;
        z += n.z;
        z2 += n.z * n.z;
        x += n.x;
    }
    CHECK(on_surface);
    check_mean(mu, 2. / 3, 1. / 2 - 4. / 9); /* density 2 mu on 0..1 */
    check_mean(mu2, 1. / 2, 1. / 3 - 1. / 4);
    check_mean(z, 0, 1. / 3);
    check_mean(x, 0, 1. / 3);
    check_mean(z2, 1. / 3, 1. / 5 - 1. / 9);
    /* Teeth: a lamp that shone evenly to its hemisphere has mean 1/2. */
    CHECK(sigmas_off(mu / (double)SAMPLES, 0.5,
                     sqrt((1. / 2 - 4. / 9) / (double)SAMPLES)) > 20);
    murk_sources_destroy(lights);
}

static void test_rect_shines_to_one_side(uint32_t seed)
{
    const murk_source light = light_of(MURK_SOURCE_RECT);
    murk_sources *lights = made(&light, &hall);
    double mu = 0, mu2 = 0, x = 0, xy = 0, side = 0;
    bool on_rect = true;
    for (uint64_t i = 0; i < SAMPLES; ++i) {
        const murk_ray ray = murk_sources_emit(lights, seed, 0, i);
        const murk_vec3 r = murk_sub(ray.origin, light.position);
        on_rect = on_rect && r.z == 0 && r.x >= 0 && r.x <= 1 && r.y >= 0 &&
                  r.y <= 0.5 && ray.direction.z > 0; /* x cross y is z */
        mu += ray.direction.z;
        mu2 += ray.direction.z * ray.direction.z;
        x += r.x;
        xy += r.x * r.y / 0.5;
        side += ray.direction.x;
    }
    CHECK(on_rect);
    check_mean(mu, 2. / 3, 1. / 2 - 4. / 9);
    check_mean(mu2, 1. / 2, 1. / 3 - 1. / 4);
    check_mean(x, 1. / 2, 1. / 12);
    check_mean(xy, 1. / 4, 1. / 9 - 1. / 16);
    check_mean(side, 0, 1. / 4); /* E(1 - mu^2) / 2 */
    murk_sources_destroy(lights);
}

static void test_point_is_isotropic(uint32_t seed)
{
    const murk_source light = light_of(MURK_SOURCE_POINT);
    murk_sources *lights = made(&light, &hall);
    double sum[3] = {0}, square[3] = {0};
    bool at_place = true;
    for (uint64_t i = 0; i < SAMPLES; ++i) {
        const murk_ray ray = murk_sources_emit(lights, seed, 0, i);
        const murk_vec3 d = ray.direction;
        at_place = at_place &&
                   memcmp(&ray.origin, &light.position, sizeof ray.origin) == 0;
        sum[0] += d.x;
        sum[1] += d.y;
        sum[2] += d.z;
        square[0] += d.x * d.x;
        square[1] += d.y * d.y;
        square[2] += d.z * d.z;
    }
    CHECK(at_place);
    for (int k = 0; k < 3; ++k) {
        check_mean(sum[k], 0, 1. / 3);
        check_mean(square[k], 1. / 3, 1. / 5 - 1. / 9);
    }
    murk_sources_destroy(lights);
}

static void test_beam_fills_its_disc_and_cone(uint32_t seed)
{
    murk_source light = light_of(MURK_SOURCE_BEAM);
    light.direction = murk_vec(3, 0, -4);
    light.divergence_rad = 0.3;
    murk_sources *lights = made(&light, &hall);
    const murk_vec3 axis = murk_vec(0.6, 0, -0.8);
    double rho2 = 0, y = 0, w = 0, dy = 0;
    bool inside = true;
    for (uint64_t i = 0; i < SAMPLES; ++i) {
        const murk_ray ray = murk_sources_emit(lights, seed, 0, i);
        const murk_vec3 r = murk_sub(ray.origin, light.position);
        const double cosine = murk_dot(ray.direction, axis);
        inside = inside && fabs(murk_dot(r, axis)) < 1e-15 &&
                 murk_length(r) <= 0.5 * (1 + 1e-15) && cosine >= cos(0.3);
        rho2 += murk_dot(r, r) / 0.25;
        y += r.y / 0.5;
        w += (1 - cosine) / (1 - cos(0.3));
        dy += ray.direction.y;
    }
    CHECK(inside);
    check_mean(rho2, 1. / 2, 1. / 12);
    check_mean(y, 0, 1. / 4);
    check_mean(w, 1. / 2, 1. / 12);
    const double c = cos(0.3);
    check_mean(dy, 0, (1 - (1 + c + c * c) / 3) / 2); /* E(1 - mu^2) / 2 */
    murk_sources_destroy(lights);
}

static void test_pencil_beam_is_exact(void)
{
    murk_source light = light_of(MURK_SOURCE_BEAM);
    light.radius_m = 0;
    murk_sources *lights = made(&light, &hall);
    bool exact = true;
    for (uint64_t i = 0; i < 100; ++i) {
        const murk_ray ray = murk_sources_emit(lights, 1, 0, i);
        exact = exact &&
                memcmp(&ray.origin, &light.position, sizeof ray.origin) == 0 &&
                ray.direction.x == 0 && ray.direction.y == 0 &&
                ray.direction.z == -1;
    }
    CHECK(exact);
    murk_sources_destroy(lights);
}

/* Faces are chosen by projected area: 20, 30 and 24 m2 across x, y, z here. */
static void test_directional_enters_through_lit_faces(uint32_t seed)
{
    murk_source light = light_of(MURK_SOURCE_DIRECTIONAL);
    light.direction = murk_vec(2, -1, -2); /* unit: 2/3, -1/3, -2/3 */
    murk_sources *lights = made(&light, &hall);
    const double area[3] = {20 * 2. / 3, 30 * 1. / 3, 24 * 2. / 3};
    const double all = area[0] + area[1] + area[2];
    CHECK_NEAR(murk_sources_power_w(lights), 100 * all, 1e-9);
    double on[3] = {0}, along = 0;
    bool on_face = true;
    for (uint64_t i = 0; i < SAMPLES; ++i) {
        const murk_vec3 p = murk_sources_emit(lights, seed, 0, i).origin;
        const bool face[3] = {p.x == -2, p.y == 3, p.z == 5};
        on_face = on_face && face[0] + face[1] + face[2] == 1 &&
                  murk_box_contains(&hall.box, p);
        for (int k = 0; k < 3; ++k) {
            on[k] += face[k];
        }
        along += face[2] ? (p.x + 2) / 6 - 0.5 : 0;
    }
    CHECK(on_face);
    for (int k = 0; k < 3; ++k) {
        const double p = area[k] / all;
        check_mean(on[k], p, p * (1 - p));
    }
    check_mean(along, 0, area[2] / all / 12);
    murk_sources_destroy(lights);
}

static void test_directional_enters_a_periodic_domain_at_the_top(void)
{
    murk_source light = light_of(MURK_SOURCE_DIRECTIONAL);
    light.direction = murk_vec(2, -1, -2);
    murk_sources *lights = made(&light, &slab);
    CHECK_NEAR(murk_sources_power_w(lights), 100 * 24 * 2. / 3, 1e-10);
    bool at_top = true;
    for (uint64_t i = 0; i < 1000; ++i) {
        at_top = at_top && murk_sources_emit(lights, 1, 0, i).origin.z == 5;
    }
    CHECK(at_top);
    murk_vec3 place;
    CHECK(!murk_sources_place(lights, 0, &place));
    murk_sources_destroy(lights);
}

/* A beam's disc in the domain's face, slanted so that its edge rounds. */
static void test_positions_stay_inside(void)
{
    murk_source light = light_of(MURK_SOURCE_SPHERE);
    light.position = murk_vec(-1.9, -0.9, 0.1);
    light.radius_m = 0.1;
    murk_sources *lights = made(&light, &hall);
    bool inside = true;
    for (uint64_t i = 0; i < 20000; ++i) {
        inside = inside &&
                 murk_box_contains(&hall.box,
                                   murk_sources_emit(lights, 1, 0, i).origin);
    }
    CHECK(inside);
    murk_sources_destroy(lights);
}

static void test_streams_and_seeds_differ(void)
{
    const murk_source light = light_of(MURK_SOURCE_POINT);
    murk_sources *lights = made(&light, &hall);
    const double a = murk_sources_emit(lights, 1, 0, 7).direction.x;
    CHECK(a == murk_sources_emit(lights, 1, 0, 7).direction.x);
    CHECK(a != murk_sources_emit(lights, 1, 1, 7).direction.x);
    CHECK(a != murk_sources_emit(lights, 2, 0, 7).direction.x);
    CHECK(a != murk_sources_emit(lights, 1, 0, 8).direction.x);
    murk_sources_destroy(lights);
}

/* Two lights in three bands; one band of one light is dark. */
static void test_channels_have_their_power(void)
{
    murk_source both[2] = {light_of(MURK_SOURCE_POINT),
                           light_of(MURK_SOURCE_RECT)};
    both[0].power_w = (murk_spectrum){{10, 0, 30}};
    both[1].power_w = (murk_spectrum){{1, 2, 3}};
    murk_sources *lights = NULL;
    CHECK(murk_sources_create(&lights, both, 2, 3, &hall, NULL) == MURK_OK);
    CHECK(murk_sources_channels(lights) == 6);
    CHECK(murk_sources_channel_power_w(lights, 2) == 30);
    CHECK(murk_sources_channel_power_w(lights, 4) == 2);
    CHECK(murk_sources_power_w(lights) == 46);
    uint64_t dealt[6] = {0}, count[6];
    for (uint64_t i = 0; i < 4600; ++i) {
        const size_t channel = murk_sources_channel_of(lights, i);
        if (i < 5) { /* the dark one is left out */
            CHECK(channel == (i == 0 ? 0 : i + 1));
        }
        ++dealt[channel];
    }
    murk_sources_deal(lights, 4600, count);
    CHECK(memcmp(dealt, count, sizeof count) == 0);
    CHECK(count[1] == 0);
    CHECK(llabs((long long)count[2] - 3000) <= 6);
    CHECK(murk_sources_count(lights) == 2);
    CHECK(murk_sources_get(lights, 1)->type == MURK_SOURCE_RECT);
    murk_vec3 place;
    CHECK(murk_sources_place(lights, 1, &place));
    CHECK(place.x == 1.5 && place.y == 1.25 && place.z == 2);
    murk_sources_destroy(lights);
}

/* Lamps switched off, a sun below a periodic domain: nothing is emitted, and
 * nothing is wrong. */
static void test_all_may_be_dark(void)
{
    murk_source both[2] = {light_of(MURK_SOURCE_POINT),
                           light_of(MURK_SOURCE_DIRECTIONAL)};
    both[0].power_w.band[0] = both[1].power_w.band[0] = 0;
    both[1].direction = murk_vec(1, 0, 0.1);
    murk_sources *lights = NULL;
    CHECK(murk_sources_create(&lights, both, 2, 1, &slab, NULL) == MURK_OK);
    CHECK(murk_sources_channels(lights) == 2);
    CHECK(murk_sources_lit(lights) == 0);
    CHECK(murk_sources_power_w(lights) == 0);
    uint64_t count[2] = {7, 7};
    murk_sources_deal(lights, 0, count);
    CHECK(count[0] == 0 && count[1] == 0);
    murk_sources_destroy(lights);
    both[0].power_w.band[0] = 1;
    CHECK(murk_sources_create(&lights, both, 2, 1, &slab, NULL) == MURK_OK);
    CHECK(murk_sources_lit(lights) == 1);
    CHECK(murk_sources_channel_of(lights, 0) == 0);
    murk_sources_destroy(lights);
}

static void refused(const murk_source *light, const murk_domain *domain,
                    const char *part)
{
    murk_sources *lights = NULL;
    murk_error err = {0};
    CHECK(murk_sources_create(&lights, light, 1, 1, domain, &err) ==
          MURK_BAD_VALUE);
    CHECK(lights == NULL);
    CHECK_TEXT(err.where, light->where);
    CHECK_MENTIONS(err.text, part);
}

static void test_bad_lights_are_named(void)
{
    murk_source l = light_of(MURK_SOURCE_POINT);
    l.power_w.band[0] = -5;
    refused(&l, &hall, "power_w is -5 W in band 0, must be 0 W or more");
    l.power_w.band[0] = NAN;
    refused(&l, &hall, "must be 0 W or more");
    l.power_w.band[0] = INFINITY;
    refused(&l, &hall, "must be 0 W or more");

    l = light_of(MURK_SOURCE_POINT);
    l.position.z = 5.001;
    refused(&l, &hall,
            "the lamp at [1, 1, 5.001] m is outside the domain [-2, -1, 0] .. "
            "[4, 3, 5] m, must be inside");
    l.position.z = NAN;
    refused(&l, &hall, "is outside the domain");
    /* past each face of the hall in turn, and upon it */
    const murk_box *box = &hall.box;
    const double face[3][2] = {{box->min.x, box->max.x},
                               {box->min.y, box->max.y},
                               {box->min.z, box->max.z}};
    for (int i = 0; i < 6; ++i) {
        l = light_of(MURK_SOURCE_POINT);
        const double at = face[i / 2][i % 2], past = i % 2 ? 0.01 : -0.01;
        double *const axis[3] = {&l.position.x, &l.position.y, &l.position.z};
        *axis[i / 2] = at + past;
        refused(&l, &hall, "is outside the domain");
        *axis[i / 2] = at;
        murk_sources *lights = NULL;
        CHECK(murk_sources_create(&lights, &l, 1, 1, &hall, NULL) == MURK_OK);
        murk_sources_destroy(lights);
    }

    l = light_of(MURK_SOURCE_SPHERE);
    l.position.z = 0.4;
    refused(&l, &hall, "the lamp at [1, 1, 0.4] m reaches out of the domain");
    l.radius_m = 0;
    refused(&l, &hall, "radius_m is 0 m, must be above 0 m");
    l.radius_m = NAN;
    refused(&l, &hall, "must be above 0 m");

    l = light_of(MURK_SOURCE_RECT);
    l.edge2 = murk_vec(2, 0, 0);
    refused(&l, &hall, "span no area");
    l.edge2 = murk_vec(0, 0, 0);
    refused(&l, &hall, "span no area");
    l.edge2 = murk_vec(0, 2.5, 0);
    refused(&l, &hall, "the lamp's corner at [1, 3.5, 2] m is outside");

    l = light_of(MURK_SOURCE_BEAM);
    l.direction = murk_vec(0, 0, 0);
    refused(&l, &hall, "direction is [0, 0, 0], must be finite and not zero");
    l = light_of(MURK_SOURCE_BEAM);
    l.divergence_rad = 4;
    refused(&l, &hall, "divergence is 4 rad, must be 0..pi rad");
    l.divergence_rad = 0;
    l.position.x = 3.6;
    refused(&l, &hall, "the beam's disc at [3.6, 1, 2] m reaches out");

    l = light_of(MURK_SOURCE_DIRECTIONAL);
    l.direction = murk_vec(1, 0, 0.1);
    refused(&l, &slab, "must go down");
    l.direction = murk_vec(1, 0, 0); /* along the top never comes in */
    refused(&l, &slab, "must go down");
    l.direction = murk_vec(1, 0, INFINITY);
    refused(&l, &hall, "must be finite and not zero");
    l = light_of(MURK_SOURCE_DIRECTIONAL);
    l.angular_radius_rad = 0.2;
    refused(&l, &hall, "angular radius is 0.2 rad, must be 0..0.1 rad");
    l.angular_radius_rad = NAN;
    refused(&l, &hall, "must be 0..0.1 rad");
    l = light_of(MURK_SOURCE_DIRECTIONAL);
    l.power_w.band[0] = -1;
    refused(&l, &hall, "irradiance_w_per_m2 is -1 W/m2");
}

/* The ends of what is allowed are allowed, and a hundredth beyond is not. */
static void test_ends_of_ranges(void)
{
    const struct {
        murk_source_type type;
        double divergence_rad, angular_radius_rad, radius_m;
        bool is_allowed;
    } cases[] = {
        {MURK_SOURCE_BEAM, 0, 0, 0, true},
        {MURK_SOURCE_BEAM, MURK_PI, 0, 0.5, true},
        {MURK_SOURCE_BEAM, 1.01 * MURK_PI, 0, 0, false},
        {MURK_SOURCE_BEAM, -0.01, 0, 0, false},
        {MURK_SOURCE_BEAM, 0, 0, -0.01, false},
        {MURK_SOURCE_DIRECTIONAL, 0, MURK_DISC_RAD_MAX, 0, true},
        {MURK_SOURCE_DIRECTIONAL, 0, 1.01 * MURK_DISC_RAD_MAX, 0, false},
        {MURK_SOURCE_DIRECTIONAL, 0, -0.01, 0, false},
        {MURK_SOURCE_SPHERE, 0, 0, 2, true}, /* touches the hall at y = -1 */
        {MURK_SOURCE_SPHERE, 0, 0, 2.02, false},
        {MURK_SOURCE_SPHERE, 0, 0, -0.01, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        murk_source l = light_of(cases[i].type);
        l.divergence_rad = cases[i].divergence_rad;
        l.angular_radius_rad = cases[i].angular_radius_rad;
        l.radius_m = cases[i].radius_m;
        murk_sources *lights = NULL;
        CHECK((murk_sources_create(&lights, &l, 1, 1, &hall, NULL) ==
               MURK_OK) == cases[i].is_allowed);
        murk_sources_destroy(lights);
    }
}

/* By weights, the channel of a photon stays while powers change, and photons of
 * a channel without power do not count. */
static void test_dealing_by_weights(void)
{
    enum { N = 1000 };
    static const double weight[] = {1, 2, 3};
    murk_source l[3];
    size_t channel[N], changed = 0;
    uint64_t count[3];
    for (int i = 0; i < 3; ++i) {
        l[i] = light_of(MURK_SOURCE_POINT);
    }
    /* The first light is on, then off. */
    for (int off = 0; off < 2; ++off) {
        murk_sources *lights = NULL;
        l[0].power_w.band[0] = off ? 0 : 5;
        CHECK(murk_sources_create(&lights, l, 3, 1, &hall, NULL) == MURK_OK);
        CHECK(murk_sources_deal_by(lights, weight, NULL) == MURK_OK);
        CHECK(murk_sources_dealt(lights) == 3);
        CHECK(murk_sources_lit(lights) == (off ? 2 : 3));
        for (size_t i = 0; i < N; ++i) {
            const size_t now = murk_sources_channel_of(lights, i);
            changed += off && channel[i] != now;
            channel[i] = now;
        }
        murk_sources_deal(lights, N, count);
        CHECK(off ? count[0] == 0 : count[0] >= 160 && count[0] <= 173);
        CHECK(count[1] >= 328 && count[1] <= 338);
        CHECK(count[2] >= 495 && count[2] <= 505);
        murk_sources_destroy(lights);
    }
    CHECK(changed == 0);
}

static void test_no_lights_are_refused(void)
{
    murk_sources *lights = NULL;
    murk_error err = {0};
    CHECK(murk_sources_create(&lights, NULL, 0, 1, &hall, &err) ==
          MURK_BAD_VALUE);
    CHECK_TEXT(err.text, "0 lights, must be 1..256");
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_sphere_shines_by_cosine_law_from_every_place(seed);
    test_rect_shines_to_one_side(seed);
    test_point_is_isotropic(seed);
    test_beam_fills_its_disc_and_cone(seed);
    test_pencil_beam_is_exact();
    test_directional_enters_through_lit_faces(seed);
    test_directional_enters_a_periodic_domain_at_the_top();
    test_positions_stay_inside();
    test_streams_and_seeds_differ();
    test_channels_have_their_power();
    test_all_may_be_dark();
    test_bad_lights_are_named();
    test_ends_of_ranges();
    test_no_lights_are_refused();
    test_dealing_by_weights();
    return check_done();
}
