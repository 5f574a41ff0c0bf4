/* Luminaires as light sources: photons follow the intensities, however the
 * luminaire is turned and whatever its size; what is drawn from a place is what
 * is seen; and the point-by-point formula gives the irradiance of a point.
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). */
#include "base/rng.h"
#include "base/stats.h"
#include "check.h"
#include "source/shine.h"

#include <stdlib.h>

#define SAMPLES UINT64_C(100000)
#define Z_TESTS 30

static const murk_domain HALL = {{{-10, -10, -10}, {10, 10, 10}}, false};

/* A distribution without symmetry: light below and a little above. */
enum { VERTICALS = 4, PLANES = 3 };
static murk_intensity *lopsided(void)
{
    static const double gamma_deg[VERTICALS] = {0, 40, 90, 130},
                        c_deg[PLANES + 1] = {0, 100, 200, 360},
                        candela[PLANES * VERTICALS] = {
                            100, 300, 20, 5, 100, 80, 0, 2, 100, 10, 60, 9};
    static const size_t plane[PLANES + 1] = {0, 1, 2, 0};
    const murk_intensity_grid grid = {MURK_GONIOMETER_C, VERTICALS, PLANES + 1,
                                      gamma_deg,         c_deg,     plane,
                                      candela,           1};
    murk_intensity *out = NULL;
    murk_error err = {0};
    CHECK(murk_intensity_create(&out, &grid, "a.ies", &err) == MURK_OK);
    return out;
}

static murk_source lamp_of(const murk_intensity *table)
{
    return (murk_source){.type = MURK_SOURCE_LUMINAIRE,
                         .position = {1, 1, 2},
                         .direction = {0.4, -0.2, -2},
                         .c0 = {1, 0.3, 0},
                         .intensity = table,
                         .power_w = {{50}},
                         .where = "a.yaml:3:5: lights.0"};
}

static murk_sources *made(const murk_source *light)
{
    murk_sources *lights = NULL;
    murk_error err = {0};
    CHECK(murk_sources_create(&lights, light, 1, 1, &HALL, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return lights;
}

/* The direction of (gamma, C) of a light that murk_sources_create() has
 * checked. */
static murk_vec3 direction_of(const murk_source *l, double gamma, double c)
{
    const murk_vec3 c90 = murk_cross(l->c0, l->direction);
    murk_vec3 d = murk_scale(sin(gamma) * cos(c), l->c0);
    d = murk_along(d, sin(gamma) * sin(c), c90);
    return murk_along(d, cos(gamma), l->direction);
}

/* The mean of the three coordinates of the direction in the lamp, and of their
 * squares, by sums over fine steps of the table. */
static void moments_of(const murk_intensity *t, double mean[3],
                       double square[3])
{
    /* Sum over the sphere. */
    enum { STEPS = 400 };
    double all = 0;
    for (int k = 0; k < 3; ++k) {
        mean[k] = square[k] = 0;
    }
    for (int i = 0; i < STEPS; ++i) {
        const double g = MURK_PI * (i + 0.5) / STEPS;
        for (int j = 0; j < STEPS; ++j) {
            const double c = 2 * MURK_PI * (j + 0.5) / STEPS;
            const murk_vec3 d = {sin(g) * cos(c), sin(g) * sin(c), -cos(g)};
            const double flux = murk_intensity_candela(t, d) * sin(g);
            all += flux;
            for (int k = 0; k < 3; ++k) {
                mean[k] += flux * murk_component(d, k);
                square[k] += flux * murk_component(d, k) * murk_component(d, k);
            }
        }
    }
    for (int k = 0; k < 3; ++k) {
        mean[k] /= all;
        square[k] /= all;
    }
}

static void test_photons_follow_the_intensities(void)
{
    const double limit = murk_sidak_limit(1e-6, Z_TESTS);
    murk_intensity *table = lopsided();
    const murk_source light = lamp_of(table);
    murk_sources *lights = made(&light);
    const murk_source *l = murk_sources_get(lights, 0);
    const murk_vec3 axis[3] = {l->c0, murk_cross(l->c0, l->direction),
                               murk_scale(-1, l->direction)};
    double mean[3], square[3], sum[3] = {0}, sum2[3] = {0};
    moments_of(table, mean, square);
    bool at_place = true;
    for (uint64_t i = 0; i < SAMPLES; ++i) {
        const murk_ray ray = murk_sources_emit(lights, 5, 0, i);
        at_place =
            at_place && murk_length(murk_sub(ray.origin, l->position)) == 0;
        for (int k = 0; k < 3; ++k) {
            const double x = murk_dot(ray.direction, axis[k]);
            sum[k] += x;
            sum2[k] += x * x;
        }
    }
    CHECK(at_place);
    for (int k = 0; k < 3; ++k) {
        const double sigma =
            sqrt((square[k] - mean[k] * mean[k]) / (double)SAMPLES);
        CHECK_WITHIN(limit, sum[k] / (double)SAMPLES, mean[k], sigma);
        CHECK_WITHIN(limit, sum2[k] / (double)SAMPLES, square[k],
                     sqrt((1 - square[k]) * square[k] / (double)SAMPLES));
        /* Teeth: the mirrored lamp has another mean along y. */
        CHECK(k != 1 ||
              sigmas_off(-sum[k] / (double)SAMPLES, mean[k], sigma) > 20);
    }
    murk_sources_destroy(lights);
    murk_intensity_destroy(table);
}

/* Photons start evenly on the luminous area. */
static void test_the_luminous_area(void)
{
    const double limit = murk_sidak_limit(1e-6, Z_TESTS);
    murk_intensity *table = lopsided();
    for (int is_disc = 0; is_disc < 2; ++is_disc) {
        murk_source light = lamp_of(table);
        light.direction = murk_vec(0, 0, -1);
        light.c0 = murk_vec(1, 0, 0);
        light.radius_m = is_disc ? 0.5 : 0;
        light.edge1 = murk_vec(is_disc ? 0 : 1, 0, 0);
        light.edge2 = murk_vec(0, is_disc ? 0 : 2, 0);
        murk_sources *lights = made(&light);
        double x2 = 0, y2 = 0;
        bool is_inside = true;
        for (uint64_t i = 0; i < SAMPLES; ++i) {
            const murk_vec3 r = murk_sub(
                murk_sources_emit(lights, 5, 0, i).origin, light.position);
            is_inside = is_inside && r.z == 0 &&
                        (is_disc ? hypot(r.x, r.y) <= 0.5
                                 : fabs(r.x) <= 0.5 && fabs(r.y) <= 1);
            x2 += r.x * r.x / (double)SAMPLES;
            y2 += r.y * r.y / (double)SAMPLES;
        }
        CHECK(is_inside);
        /* E x^2: of a disc r^2 / 4, of a side a a^2 / 12; E x^4: r^4 / 8 and
         * a^4 / 80. */
        const double n = (double)SAMPLES;
        CHECK_WITHIN(limit, x2, is_disc ? 0.0625 : 1. / 12,
                     sqrt((is_disc ? 1. / 128 - 1. / 256 : 1. / 180) / n));
        CHECK_WITHIN(limit, y2, is_disc ? 0.0625 : 4. / 12,
                     sqrt((is_disc ? 1. / 128 - 1. / 256 : 16. / 180) / n));
        const murk_box box = murk_source_box(murk_sources_get(lights, 0));
        CHECK_NEAR(box.max.x - light.position.x, 0.5, 1e-12);
        CHECK_NEAR(box.max.y - light.position.y, is_disc ? 0.5 : 1, 1e-12);
        CHECK_NEAR(box.max.z - light.position.z, 0, 1e-12);
        murk_sources_destroy(lights);
    }
    murk_intensity_destroy(table);
}

/* A point gives exactly E = I / d^2 in every direction. */
static void test_point_by_point(void)
{
    murk_intensity *table = lopsided();
    const murk_source light = lamp_of(table);
    murk_sources *lights = made(&light);
    const murk_source *l = murk_sources_get(lights, 0);
    const double per_lm = 50 / murk_intensity_lumens(table);
    /* Directions between those of the table. */
    for (double g = 5; g < 180; g += 25) {
        for (double c = 10; c < 360; c += 50) {
            const double rad = MURK_PI / 180, d = 0.5 + g / 50;
            const murk_vec3 to = direction_of(l, g * rad, c * rad);
            const double u[MURK_SHINE_NUMBERS] = {0.2, 0.7, 0.5};
            const double candela = murk_intensity_at_angles(table, g, c);
            murk_shine shine = {.irradiance_w_per_m2 = 0};
            const bool shines = murk_sources_shine(
                lights, 0, 0, murk_along(l->position, d, to), u, &shine);
            CHECK(shines == (candela > 0));
            CHECK_NEAR(shines ? shine.irradiance_w_per_m2 : 0,
                       per_lm * candela / d / d, 1e-12 * per_lm * 300);
            CHECK(!shines ||
                  (isinf(shine.per_sr) && fabs(shine.distance_m - d) < 1e-12));
            CHECK_NEAR(
                murk_source_irradiance_near(l, 0, murk_scale(-d, to), false),
                per_lm * candela / d / d, 1e-12 * per_lm * 300);
        }
    }
    murk_sources_destroy(lights);
    murk_intensity_destroy(table);
}

/* Each draw from a luminous area or solid is seen where it comes from, with
 * radiance and density that go with its irradiance. */
static void test_what_is_drawn_is_seen(void)
{
    murk_intensity *table = lopsided();
    for (int shape = 0; shape < 4; ++shape) {
        const bool is_disc = shape & 1;
        murk_source light = lamp_of(table);
        light.direction = murk_vec(0, 0, -1);
        light.c0 = murk_vec(1, 0, 0);
        light.radius_m = is_disc ? 0.5 : 0;
        light.edge1 = murk_vec(is_disc ? 0 : 1, 0, 0);
        light.edge2 = murk_vec(0, is_disc ? 0 : 2, 0);
        light.height_m = shape > 1 ? 0.7 : 0;
        murk_sources *lights = made(&light);
        /* Places below and above the luminaire. */
        int seen = 0;
        for (uint64_t i = 0; i < 400; ++i) {
            const murk_random4 r = murk_random(3, MURK_TEST, i, 0, 0);
            const murk_vec3 place = {2, -1, i % 2 ? -3 : 2.8};
            murk_shine shine;
            if (!murk_sources_shine(lights, 0, 0, place, r.u, &shine)) {
                continue;
            }
            const murk_glare glare = murk_sources_glare(
                lights, 0, 0, place, murk_scale(-1, shine.direction));
            seen += glare.radiance > 0;
            CHECK_NEAR(glare.per_sr / shine.per_sr, 1, 1e-6);
            CHECK_NEAR(glare.radiance / glare.per_sr /
                           shine.irradiance_w_per_m2,
                       1, 1e-6);
            CHECK_NEAR(glare.distance_m, shine.distance_m, 1e-9);
        }
        CHECK(seen > 300);
        murk_sources_destroy(lights);
    }
    murk_intensity_destroy(table);
}

/* Sum of what is seen from a place over a fine grid of directions, which needs
 * nothing of the way in which points are drawn. */
static double seen_in_all(const murk_sources *lights, murk_vec3 place)
{
    enum { STEPS = 1200 };
    double sum = 0;
    for (int i = 0; i < STEPS; ++i) {
        const double mu = 2 * (i + 0.5) / STEPS - 1, s = sqrt(1 - mu * mu);
        for (int k = 0; k < STEPS; ++k) {
            const double phi = 2 * MURK_PI * (k + 0.5) / STEPS;
            sum += murk_sources_glare(lights, 0, 0, place,
                                      murk_vec(s * cos(phi), s * sin(phi), mu))
                       .radiance;
        }
    }
    return sum * 4 * MURK_PI / STEPS / STEPS;
}

/* Near a box or a cylinder the mean of the irradiance that is drawn is the
 * integral of the radiance, and a flat opening gives another one. */
static void test_near_a_solid(void)
{
    murk_intensity *table = lopsided();
    for (int is_disc = 0; is_disc < 2; ++is_disc) {
        murk_source light = lamp_of(table);
        light.radius_m = is_disc ? 0.5 : 0;
        const murk_vec3 aim = murk_unit(light.direction);
        const murk_vec3 c0 =
            murk_unit(murk_along(light.c0, -murk_dot(light.c0, aim), aim));
        light.edge1 = is_disc ? murk_vec(0, 0, 0) : murk_scale(0.4, c0);
        light.edge2 =
            is_disc ? murk_vec(0, 0, 0) : murk_scale(1.1, murk_cross(c0, aim));
        double mean[2] = {0};
        for (int is_flat = 0; is_flat < 2; ++is_flat) {
            light.height_m = is_flat ? 0 : 0.7;
            murk_sources *lights = made(&light);
            const murk_vec3 place = {2, 0.6, 1.2};
            enum { STEPS = 120 };
            for (int i = 0; i < STEPS * STEPS; ++i) {
                const double u[MURK_SHINE_NUMBERS] = {
                    (i % STEPS + 0.5) / STEPS, (i / STEPS + 0.5) / STEPS, 0.5};
                murk_shine shine = {.irradiance_w_per_m2 = 0};
                if (murk_sources_shine(lights, 0, 0, place, u, &shine)) {
                    mean[is_flat] += shine.irradiance_w_per_m2 / STEPS / STEPS;
                }
            }
            if (!is_flat) {
                CHECK_NEAR(mean[0] / seen_in_all(lights, place), 1, 0.005);
            }
            murk_sources_destroy(lights);
        }
        CHECK(fabs(mean[1] / mean[0] - 1) > 0.05); /* teeth */
    }
    murk_intensity_destroy(table);
}

static void check_refused(murk_source light, const char *why)
{
    murk_sources *lights = NULL;
    murk_error err = {0};
    CHECK(murk_sources_create(&lights, &light, 1, 1, &HALL, &err) ==
          MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, why);
    CHECK_TEXT(err.where, "a.yaml:3:5: lights.0");
}

static void test_refusals(void)
{
    murk_intensity *table = lopsided();
    murk_source light = lamp_of(NULL);
    check_refused(light, "no intensities");
    light = lamp_of(table);
    light.c0 = light.direction;
    check_refused(light, "must not be along the aim");
    light = lamp_of(table);
    light.direction = murk_vec(0, 0, 0);
    check_refused(light, "not zero");
    light = lamp_of(table);
    light.position.z = 9.9;
    light.direction = murk_vec(1, 0, 0);
    light.radius_m = 0.3;
    check_refused(light, "the luminaire at");
    light.radius_m = 0;
    light.height_m = 0.3; /* along x, so it is inside */
    murk_sources_destroy(made(&light));
    light.direction = murk_vec(0, 1, 1);
    check_refused(light, "the luminaire at");
    light.height_m = NAN;
    check_refused(light, "height_m is nan");
    murk_intensity_destroy(table);
}

int main(void)
{
    test_photons_follow_the_intensities();
    test_the_luminous_area();
    test_point_by_point();
    test_what_is_drawn_is_seen();
    test_near_a_solid();
    test_refusals();
    return check_done();
}
