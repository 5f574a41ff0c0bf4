/* Light aimed at portals, and the sun's disc: what falls on an opening, where
 * its photons start, and that no ray counts twice. The z-tests of a run share a
 * 1e-6 chance of a false alarm (Sidak); the seed is fixed, so the verdict
 * repeats. */
#include "base/stats.h"
#include "check.h"
#include "source/disc.h"
#include "source/sources.h"

#include <stdlib.h>

#define SAMPLES UINT64_C(40000)
#define Z_TESTS 24

static const murk_domain hall = {{{-2, -1, 0}, {4, 3, 5}}, false};
static const murk_domain slab = {{{-2, -1, 0}, {4, 3, 5}}, true};

/* Upright, 1 m by 2 m, in the plane x = 1; light passes towards +x. */
static const murk_portal window = {{1, 0, 1}, {0, 1, 0}, {0, 0, 2}};

static double limit;

static murk_source aimed(murk_source_type type, const murk_portal *portal,
                         size_t portals)
{
    return (murk_source){.type = type,
                         .direction = {2, -1, -2}, /* unit: 2/3, -1/3, -2/3 */
                         .portal = portal,
                         .portals = portals,
                         .power_w = {{100}},
                         .where = "a.yaml:3:5: lights.0"};
}

static murk_sources *made(const murk_source *light)
{
    murk_sources *lights = NULL;
    murk_error err = {0};
    CHECK(murk_sources_create(&lights, light, 1, 1, &hall, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return lights;
}

/* Where the ray meets the portal's plane, in shares of its edges. */
static void place_on(const murk_portal *p, const murk_ray *ray, double *s,
                     double *t)
{
    const murk_vec3 n = murk_cross(p->edge1, p->edge2);
    const double distance = murk_dot(murk_sub(p->corner, ray->origin), n) /
                            murk_dot(ray->direction, n);
    const murk_vec3 on =
        murk_sub(murk_along(ray->origin, distance, ray->direction), p->corner);
    *s = murk_dot(on, p->edge1) / murk_dot(p->edge1, p->edge1);
    *t = murk_dot(on, p->edge2) / murk_dot(p->edge2, p->edge2);
}

static bool is_through(const murk_portal *p, const murk_ray *ray)
{
    double s, t;
    place_on(p, ray, &s, &t);
    return s >= 0 && s < 1 && t >= 0 && t < 1;
}

static bool is_on_boundary(murk_vec3 p)
{
    const murk_box *b = &hall.box;
    return murk_box_contains(b, p) &&
           (p.x == b->min.x || p.x == b->max.x || p.y == b->min.y ||
            p.y == b->max.y || p.z == b->min.z || p.z == b->max.z);
}

/* Light is uniform over the window and starts at the boundary. An upright
 * plane receives half of the irradiance E of a uniform sky, and 2/3 of that
 * of this sun. */
static void test_light_comes_through_its_portal(uint32_t seed)
{
    /* The same window for sky and sun. */
    const murk_source light[2] = {aimed(MURK_SOURCE_SKY, &window, 1),
                                  aimed(MURK_SOURCE_DIRECTIONAL, &window, 1)};
    const double share[2] = {1. / 2, 2. / 3};
    for (int k = 0; k < 2; ++k) {
        /* The power is irradiance times area times this share. */
        murk_sources *lights = made(&light[k]);
        CHECK_NEAR(murk_sources_power_w(lights), 100 * 2 * share[k], 1e-12);
        /* Each photon starts at the boundary and passes the window. */
        double sum_s = 0, sum_t = 0, product = 0;
        bool right = true;
        for (uint64_t i = 0; i < SAMPLES; ++i) {
            const murk_ray ray = murk_sources_emit(lights, seed, 0, i);
            double s, t;
            place_on(&window, &ray, &s, &t);
            right = right && is_on_boundary(ray.origin) && !ray.is_spent &&
                    ray.direction.x > 0 && s > -1e-9 && s < 1 + 1e-9 &&
                    t > -1e-9 && t < 1 + 1e-9;
            sum_s += s;
            sum_t += t;
            product += s * t;
        }
        CHECK(right);
        /* Both coordinates are uniform and independent. */
        const double n = (double)SAMPLES, sigma = sqrt(1 / (12 * n));
        CHECK_WITHIN(limit, sum_s / n, 0.5, sigma);
        CHECK_WITHIN(limit, sum_t / n, 0.5, sigma);
        CHECK_WITHIN(limit, product / n, 0.25, sqrt((1. / 9 - 1. / 16) / n));
        murk_sources_destroy(lights);
    }
}

/* A tilted skylight under an even sky: E (1 + cos tilt) / 2, as of the sky's
 * share that a tilted plane sees (Liu and Jordan, Sol. Energy 4 (1960) 1). */
static void test_tilted_plane_sees_its_share_of_the_sky(void)
{
    const double tilt_deg[] = {0, 0.5, 20, 60, 89.7, 90, 90.3, 130, 179};
    for (size_t i = 0; i < sizeof tilt_deg / sizeof *tilt_deg; ++i) {
        const double tilt = tilt_deg[i] * MURK_PI / 180;
        /* Looks out to the tilted zenith, so light goes against it. */
        const murk_portal p = {
            {0, 0, 2}, {0, 1, 0}, {cos(tilt), 0, -sin(tilt)}};
        const murk_source light = aimed(MURK_SOURCE_SKY, &p, 1);
        murk_sources *lights = made(&light);
        CHECK_NEAR(murk_sources_power_w(lights), 100 * (1 + cos(tilt)) / 2,
                   1e-9);
        const murk_vec3 n = murk_cross(p.edge1, p.edge2);
        bool right = true;
        for (uint64_t k = 0; k < 2000; ++k) {
            const murk_vec3 d = murk_sources_emit(lights, 1, 0, k).direction;
            right = right && murk_dot(d, n) > 0 && d.z < 1e-15;
        }
        CHECK(right);
        murk_sources_destroy(lights);
    }
}

/* Three windows of which rays pass two, or one. What passes both is kept where
 * it is drawn from the first, and as much is spent where it is drawn from the
 * second. */
static void test_a_ray_belongs_to_the_first_portal(uint32_t seed)
{
    const murk_portal p[3] = {
        {{2, 0, 0.5}, {0, 1, 0}, {0, 0, 2}}, /* behind the window */
        window,
        {{3, 2, 1}, {0, 0, 2}, {0, 1, 0}}}; /* the other way round */
    const murk_source light = aimed(MURK_SOURCE_SKY, p, 3);
    murk_sources *lights = made(&light);
    CHECK_NEAR(murk_sources_power_w(lights), 100. / 2 * 6, 1e-9);
    double both = 0, spent = 0;
    bool right = true;
    for (uint64_t i = 0; i < SAMPLES; ++i) {
        const murk_ray ray = murk_sources_emit(lights, seed, 0, i);
        const bool through = ray.direction.x > 0 && is_through(&p[0], &ray) &&
                             is_through(&p[1], &ray);
        right = right && (!ray.is_spent || through);
        spent += ray.is_spent;
        both += through && !ray.is_spent;
    }
    CHECK(right);
    CHECK(spent > 1000);
    CHECK_WITHIN(limit, both - spent, 0, sqrt(both + spent));
    CHECK(sigmas_off(1.2 * both - spent, 0, sqrt(both + spent)) > limit);
    murk_sources_destroy(lights);
}

/* Two that overlap in one plane count as one and a half. */
static void test_portals_may_overlap(uint32_t seed)
{
    const murk_portal p[2] = {window, {{1, 0.5, 1}, {0, 1, 0}, {0, 0, 2}}};
    const murk_source light = aimed(MURK_SOURCE_DIRECTIONAL, p, 2);
    murk_sources *lights = made(&light);
    double accepted = 0;
    for (uint64_t i = 0; i < SAMPLES; ++i) {
        accepted += !murk_sources_emit(lights, seed, 0, i).is_spent;
    }
    const double n = (double)SAMPLES;
    CHECK_WITHIN(limit, accepted / n, 0.75, sqrt(0.75 * 0.25 / n));
    murk_sources_destroy(lights);
}

/* Portals that no light passes are dark, and so is a light that has no other.
 */
static void test_dark_portals_are_known(void)
{
    const murk_portal p[2] = {window, {{1, 0, 1}, {0, 0, 2}, {0, 1, 0}}};
    murk_source light = aimed(MURK_SOURCE_DIRECTIONAL, p, 2);
    murk_sources *lights = made(&light);
    CHECK(murk_sources_portal_is_lit(lights, 0, 0));
    CHECK(!murk_sources_portal_is_lit(lights, 0, 1));
    CHECK(murk_sources_lit(lights) == 1);
    murk_sources_destroy(lights);
    light.portal = p + 1;
    light.portals = 1;
    lights = made(&light);
    CHECK(!murk_sources_portal_is_lit(lights, 0, 0));
    CHECK(murk_sources_lit(lights) == 0);
    murk_sources_destroy(lights);
    const murk_portal floor = {{1, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    light = aimed(MURK_SOURCE_SKY, &floor, 1);
    lights = made(&light);
    CHECK(!murk_sources_portal_is_lit(lights, 0, 0));
    CHECK(murk_sources_power_w(lights) == 0);
    murk_sources_destroy(lights);
}

/* ---- the disc ---- */

/* Mean cosine over the disc by its rows: sum of chords times the part above 0.
 */
static double cosine_by_rows(double middle, double tilt)
{
    const int n = 200000;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double x = -1 + (i + 0.5) * 2 / n;
        sum += fmax(0, middle + tilt * x) * sqrt(1 - x * x);
    }
    return sum * 2 / n * 2 / MURK_PI;
}

static void test_disc_has_its_cosine_and_its_mean(uint32_t seed)
{
    const double radius = tan(0.02);
    const murk_vec3 inward = {0, 0, -1};
    const double up_deg[] = {90, 30, 1.2, 1, 0.4, 0, -0.3, -1};
    for (size_t k = 0; k < sizeof up_deg / sizeof *up_deg; ++k) {
        const double up = up_deg[k] * MURK_PI / 180;
        const murk_vec3 d = murk_unit(murk_vec(-cos(up), 0, -sin(up)));
        const double tilt = radius * fabs(d.x);
        const double cosine = murk_disc_cosine(d, radius, inward);
        CHECK_NEAR(cosine, cosine_by_rows(-d.z, tilt), 1e-8);
        /* By that cosine c the mean of 1/c is the disc's lit area over it. */
        double mean_z = 0, mean_y2 = 0, square_z = 0;
        bool right = true;
        for (uint64_t i = 0; i < SAMPLES; ++i) {
            const double u[3] = {
                ((double)i + 0.5) / (double)SAMPLES,
                fmod((double)i * 0.618033988749895 + 0.3, 1),
                fmod((double)(i + seed) * 0.7548776662466927, 1)};
            const murk_vec3 ray = murk_disc_draw(d, radius, inward, u);
            right =
                right && ray.z <= 0 && murk_dot(ray, d) >= cos(0.02) - 1e-12;
            /* Back onto the disc across d. */
            const murk_vec3 on = murk_scale(1 / murk_dot(ray, d), ray);
            mean_z -= on.z;
            square_z += on.z * on.z;
            mean_y2 += on.y * on.y / (radius * radius);
        }
        CHECK(right);
        /* E(c) under density c over the disc is mean c^2 over mean c. */
        const int n = 200000;
        double want = 0, want_y2 = 0;
        for (int i = 0; i < n; ++i) {
            const double x = -1 + (i + 0.5) * 2 / n, y2 = 1 - x * x;
            const double c = fmax(0, -d.z + tilt * x);
            want += c * c * sqrt(y2);
            want_y2 += c * sqrt(y2) * y2 / 3;
        }
        want *= 4 / (n * MURK_PI * cosine);
        want_y2 *= 4 / (n * MURK_PI * cosine);
        const double all = (double)SAMPLES;
        const double spread =
            fmax(0, square_z / all - mean_z * mean_z / all / all);
        CHECK_WITHIN(limit, mean_z / all, want, sqrt(spread / all) + 1e-8);
        CHECK_WITHIN(limit, mean_y2 / all, want_y2, sqrt(0.1 / all));
    }
    CHECK(murk_disc_cosine(murk_vec(0, 0, 1), radius, inward) == 0);
}

/* The sun's disc has the beam's power where all of it is in front, and spreads
 * its rays: mean of the squared tangent is half of the radius squared. */
static void test_sun_s_disc_over_the_domain(uint32_t seed)
{
    murk_source light = aimed(MURK_SOURCE_DIRECTIONAL, NULL, 0);
    light.angular_radius_rad = 0.2665 * MURK_PI / 180;
    murk_sources *lights = made(&light);
    const double area = 20 * 2. / 3 + 30 * 1. / 3 + 24 * 2. / 3;
    CHECK_NEAR(murk_sources_power_w(lights), 100 * area, 1e-9);
    const murk_vec3 d = murk_vec(2. / 3, -1. / 3, -2. / 3);
    double square = 0;
    bool right = true;
    for (uint64_t i = 0; i < SAMPLES; ++i) {
        const murk_ray ray = murk_sources_emit(lights, seed, 0, i);
        const double cosine = murk_dot(ray.direction, d);
        const double tangent =
            murk_length(murk_cross(ray.direction, d)) / cosine;
        right = right && is_on_boundary(ray.origin) &&
                tangent <= tan(light.angular_radius_rad) * (1 + 1e-12);
        square += tangent * tangent / pow(tan(light.angular_radius_rad), 2);
    }
    CHECK(right);
    const double n = (double)SAMPLES;
    CHECK_WITHIN(limit, square / n, 0.5, sqrt(1 / (12 * n)));
    CHECK(sigmas_off(square / n, 2. / 3, sqrt(1 / (12 * n))) > limit);
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

static void test_bad_portals_are_named(void)
{
    murk_portal p[2] = {window, window};
    murk_source light = aimed(MURK_SOURCE_SKY, p, 2);
    refused(&light, &slab, "aimed at portals in a periodic domain");
    p[1].corner.z = 3.5;
    refused(&light, &hall,
            "portal 1: corner at [1, 0, 5.5] m is outside the domain");
    p[1] = window;
    p[1].edge2 = murk_vec(0, 2, 0);
    refused(&light, &hall, "portal 1: edge1_m [0, 1, 0] and edge2_m [0, 2, 0]");
    p[1].edge2 = murk_vec(0, 0, NAN);
    refused(&light, &hall, "span no area");
    p[1].edge2 = murk_vec(0, 0, INFINITY);
    refused(&light, &hall, "portal 1:");
    static murk_portal many[MURK_PORTALS_MAX + 1];
    light.portal = many;
    light.portals = MURK_PORTALS_MAX + 1;
    refused(&light, &hall, "257 portals, must be 256 or less");
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    limit = murk_sidak_limit(1e-6, Z_TESTS);
    test_light_comes_through_its_portal(seed);
    test_tilted_plane_sees_its_share_of_the_sky();
    test_a_ray_belongs_to_the_first_portal(seed);
    test_portals_may_overlap(seed);
    test_dark_portals_are_known();
    test_disc_has_its_cosine_and_its_mean(seed);
    test_sun_s_disc_over_the_domain(seed);
    test_bad_portals_are_named();
    return check_done();
}
