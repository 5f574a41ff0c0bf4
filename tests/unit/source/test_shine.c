/* Lights as places see them: what is drawn is what is seen, and as bright as
 * its power says.
 *
 * Eight z-tests share a 1e-6 chance of a false alarm (Sidak). */
#include "base/rng.h"
#include "base/stats.h"
#include "check.h"
#include "source/shine.h"

#include <stdlib.h>

#define DRAWS  20000
#define ZTESTS 8

static const murk_domain OPEN = {{{-10, -10, -10}, {10, 10, 10}}, false};

static murk_sources *one(const murk_source *light)
{
    murk_sources *lights = NULL;
    murk_error err = {0};
    if (murk_sources_create(&lights, light, 1, 1, &OPEN, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    return lights;
}

static murk_source ball(void)
{
    return (murk_source){.type = MURK_SOURCE_SPHERE,
                         .position = {1, 2, 3},
                         .radius_m = 0.7,
                         .power_w = {{5}}};
}

static murk_source sheet(void)
{
    return (murk_source){.type = MURK_SOURCE_RECT,
                         .position = {-1, -1, 4},
                         .edge1 = {0, 2, 0},
                         .edge2 = {2, 0.5, 0},
                         .power_w = {{5}}};
}

static murk_source wide_beam(void)
{
    return (murk_source){.type = MURK_SOURCE_BEAM,
                         .position = {0, 0, 5},
                         .direction = {0, 0.1, -1},
                         .radius_m = 0.5,
                         .divergence_rad = 0.4,
                         .power_w = {{5}}};
}

static murk_source sun(void)
{
    return (murk_source){.type = MURK_SOURCE_DIRECTIONAL,
                         .direction = {0.2, 0.1, -1},
                         .angular_radius_rad = 0.05,
                         .power_w = {{700}}};
}

static murk_source sky(void)
{
    return (murk_source){.type = MURK_SOURCE_SKY,
                         .dome = murk_dome_cie(12, murk_vec(0, 1, 1)),
                         .power_w = {{100}}};
}

static void draw(uint64_t i, double u[MURK_SHINE_NUMBERS])
{
    const murk_random4 r = murk_random(1, MURK_TEST, i, 0, 0);
    for (int k = 0; k < MURK_SHINE_NUMBERS; ++k) {
        u[k] = r.u[k];
    }
}

/* Each draw is seen where it comes from, with radiance and density that go with
 * its irradiance. */
static void test_what_is_drawn_is_seen(const murk_source *light)
{
    murk_sources *lights = one(light);
    const murk_vec3 place = {0.3, -0.2, 0.1};
    int shone = 0;
    for (uint64_t i = 0; i < 200; ++i) {
        double u[MURK_SHINE_NUMBERS];
        murk_shine shine;
        draw(i, u);
        if (!murk_sources_shine(lights, 0, 0, place, u, &shine)) {
            continue;
        }
        const murk_glare glare = murk_sources_glare(
            lights, 0, 0, place, murk_scale(-1, shine.direction));
        /* Some draws lie in the lamp's edge to rounding. */
        if (!(glare.radiance > 0)) {
            continue;
        }
        ++shone;
        CHECK(fabs(glare.per_sr / shine.per_sr - 1) < 1e-6);
        CHECK(fabs(glare.radiance / glare.per_sr / shine.irradiance_w_per_m2 -
                   1) < 1e-6);
        CHECK(glare.distance_m == shine.distance_m ||
              fabs(glare.distance_m - shine.distance_m) < 1e-6);
    }
    CHECK(shone > 50);
    murk_sources_destroy(lights);
}

/* Irradiance on a plane with this normal, or (zero) from all sides. */
static double irradiance(const murk_source *light, murk_vec3 place,
                         murk_vec3 normal, double *error)
{
    murk_sources *lights = one(light);
    const bool is_level = murk_length(normal) > 0;
    double sum = 0, squares = 0;
    for (uint64_t i = 0; i < DRAWS; ++i) {
        double u[MURK_SHINE_NUMBERS];
        murk_shine shine;
        draw(i, u);
        if (murk_sources_shine(lights, 0, 0, place, u, &shine)) {
            const double cosine =
                is_level ? fmax(0, -murk_dot(normal, shine.direction)) : 1;
            const double one_draw = shine.irradiance_w_per_m2 * cosine;
            sum += one_draw;
            squares += one_draw * one_draw;
        }
    }
    murk_sources_destroy(lights);
    const double mean = sum / DRAWS;
    *error = sqrt(fmax(0, squares / DRAWS - mean * mean) / DRAWS) +
             1e-9 * mean; /* where all draws are alike */
    return mean;
}

/* A lamp's flux through a far plane's element, the sun's and the sky's by their
 * own definition. */
static void test_power_is_what_arrives(void)
{
    const double limit = murk_sidak_limit(1e-6, ZTESTS);
    const murk_vec3 up = {0, 0, 1}, here = {0.3, -0.2, 0.1};
    murk_source light = ball();
    double error;
    /* a ball's irradiance towards its middle: P / (4 pi d^2), at any distance
     */
    const murk_vec3 to = murk_sub(light.position, here);
    double got = irradiance(&light, here, murk_unit(to), &error);
    const double d2 = murk_dot(to, to);
    CHECK_WITHIN(limit, got, 5 / (4 * MURK_PI * d2), error);
    CHECK(sigmas_off(got, 5.05 / (4 * MURK_PI * d2), error) > 2 * limit);

    light = (murk_source){
        .type = MURK_SOURCE_POINT, .position = {1, 2, 3}, .power_w = {{5}}};
    got = irradiance(&light, here, murk_unit(to), &error);
    CHECK_WITHIN(limit, got, 5 / (4 * MURK_PI * d2), error);

    light = sun();
    got = irradiance(&light, here, murk_scale(-1, murk_unit(light.direction)),
                     &error);
    CHECK_WITHIN(limit, got, 700, error);
    light.angular_radius_rad = 0;
    got = irradiance(&light, here, murk_vec(0, 0, 0), &error);
    CHECK_WITHIN(limit, got, 700, error);

    light = sky();
    got = irradiance(&light, here, up, &error);
    /* the level is a table's, right to some 2e-4: source/dome_table.h */
    CHECK_WITHIN(limit, got, 100, sqrt(error * error + 0.02 * 0.02));

    light = wide_beam();
    light.radius_m = 0;
    got = irradiance(&light, murk_vec(0, 0.4, 1), murk_vec(0, 0, 0), &error);
    CHECK_WITHIN(limit, got,
                 5 / (2 * MURK_PI * (1 - cos(0.4)) * (0.4 * 0.4 + 16)), error);
    light.divergence_rad = 0;
    light.radius_m = 0.5;
    got = irradiance(&light, murk_vec(0, 0.4, 1), murk_vec(0, 0, 0), &error);
    CHECK_WITHIN(limit, got, 5 / (MURK_PI * 0.25), error);
    got = irradiance(&light, murk_vec(0, 1, 1), murk_vec(0, 0, 0), &error);
    CHECK(got == 0);
}

/* Half of a uniform sky enters through a window: the fluence rate at a
 * place is the same by draws on the window and by directions over the whole
 * sphere. */
static void test_a_window_lets_in_its_own_sky(void)
{
    /* A window to one side of the place. */
    const murk_portal window = {{1, -2, 0}, {0, 0, 3}, {0, 4, 0}};
    murk_source light = {.type = MURK_SOURCE_SKY,
                         .portal = &window,
                         .portals = 1,
                         .power_w = {{100}}};
    const murk_vec3 here = {-1, 0.3, 0.5};
    double error;
    /* By draws on the window. */
    const double drawn = irradiance(&light, here, murk_vec(0, 0, 0), &error);
    /* By random directions: the mean radiance times 4 pi. */
    murk_sources *lights = one(&light);
    double seen = 0, squares = 0;
    const int n = 100000;
    for (uint64_t i = 0; i < (uint64_t)n; ++i) {
        const murk_random4 r = murk_random(2, MURK_TEST, i, 0, 0);
        const double mu = 2 * r.u[0] - 1, phi = 2 * MURK_PI * r.u[1];
        const double side = sqrt(1 - mu * mu);
        const murk_vec3 sight = {side * cos(phi), side * sin(phi), mu};
        const double radiance =
            murk_sources_glare(lights, 0, 0, here, sight).radiance * 4 *
            MURK_PI;
        seen += radiance / n;
        squares += radiance * radiance / n;
    }
    murk_sources_destroy(lights);
    /* Both agree within the standard errors. */
    CHECK(drawn > 0);
    CHECK_WITHIN(murk_sidak_limit(1e-6, ZTESTS), drawn, seen,
                 sqrt(error * error + (squares - seen * seen) / n));
}

int main(void)
{
    const murk_source light[] = {ball(), sheet(), wide_beam(), sun(), sky()};
    for (size_t i = 0; i < sizeof light / sizeof *light; ++i) {
        test_what_is_drawn_is_seen(&light[i]);
    }
    test_power_is_what_arrives();
    test_a_window_lets_in_its_own_sky();
    return check_done();
}
