/* Laws that hold whatever stands in the world, so that they test all of it.
 *
 * - A closed room whose walls all shine alike, by cosine law, and reflect the
 *   share r of what they get, holds the same radiance in every direction at
 *   every place, whatever it contains that does not absorb: the fluence rate
 *   is 4 M / (1 - r) with M = power / area of the walls, and n^2 as much in
 *   glass of index n (Kirchhoff, Ann. Phys. 185 (1860) 275,
 *   doi:10.1002/andp.18601850205; n^2: Nicodemus, Am. J. Phys. 31 (1963) 368,
 *   doi:10.1119/1.1969512).
 * - Inverse square: the fluence rate at r of a point lamp is P / (4 pi r^2).
 * - In that room a path's mean length between two walls is 4 V / A, with fog or
 *   without (Blanco and Fournier, Europhys. Lett. 61 (2003) 168,
 *   doi:10.1209/epl/i2003-00208-x): the first law again, by lengths.
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "chords.h"
#include "worlds.h"

#include <stdlib.h>

#define Z_TESTS       16
#define GLASS_INDEX   1.5
#define WATER_INDEX   1.34
#define FURNACE_WALLS 0.6

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

/* ---- the furnace ---- */

static const murk_box interior = {{0, 0, 0}, {4, 3, 2}};
#define WALLS_AREA_M2 52.0

typedef struct contents {
    const murk_surface_desc *surfaces;
    size_t n_surfaces;
    const murk_medium *media;
    const murk_region *regions;
    size_t n_media;
    double reflectance;
} contents;

#define CONTENTS_MAX 4

/* All walls shine equally, with one watt in all; the chords of the photons
 * are noted. */
static void heat(const contents *in, chords *c, uint64_t photons, uint32_t seed)
{
    /* The walls of the room come first in the list of surfaces, the
     * contents after them. */
    murk_source lamps[TEST_WALLS];
    test_wall_lamps(&interior, lamps);
    const murk_material materials[] = {
        test_material(in->reflectance, 0, 0, 0), test_material(0, 1, 0, 0),
        test_material(0, .08, .92, GLASS_INDEX), test_material(1, 0, 0, 0)};
    murk_surface_desc surfaces[CONTENTS_MAX] = {
        test_box(interior.min, interior.max, 0)};
    for (size_t i = 0; i < in->n_surfaces; ++i) {
        surfaces[i + 1] = in->surfaces[i];
    }
    /* Trace; no photon may be lost. */
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-1, -1, -1}, {5, 4, 3}}, false},
                      .lights = lamps,
                      .n_lights = TEST_WALLS,
                      .surfaces = surfaces,
                      .n_surfaces = in->n_surfaces + 1,
                      .materials = materials,
                      .n_materials = 4,
                      .media = in->media,
                      .n_media = in->n_media,
                      .regions = in->regions,
                      .n_regions = in->n_media});
    test_world_trace(&w, photons, seed, chords_note, c);
    CHECK(test_photons(&w, w.ledger->lost) == 0);
    test_world_unmade(&w);
}

static double furnace_fluence(double reflectance, double index)
{
    return index * index * 4 / WALLS_AREA_M2 / (1 - reflectance);
}

static void check_furnace(const chords *c, size_t place, double index)
{
    const murk_estimate got = chords_fluence(c, place);
    CHECK_WITHIN(limit(), got.value, furnace_fluence(FURNACE_WALLS, index),
                 got.standard_error);
}

static const chord_place *few_places(chords *c)
{
    *c = (chords){.n = 3,
                  .place = {chord_ball(murk_vec(1, 1, 1), .5),
                            chord_ball(murk_vec(3.3, 2.4, .6), .4),
                            chord_box(interior.min, interior.max)}};
    return c->place;
}

static void test_empty_enclosure(uint32_t seed)
{
    chords c;
    few_places(&c);
    heat(&(contents){.reflectance = FURNACE_WALLS}, &c, 40000, seed);
    for (size_t i = 0; i < c.n; ++i) {
        check_furnace(&c, i, 1);
    }
    /* Teeth: walls that reflect a little more. */
    few_places(&c);
    heat(&(contents){.reflectance = FURNACE_WALLS + .02}, &c, 40000, seed);
    const murk_estimate e = chords_fluence(&c, 2);
    CHECK(sigmas_off(e.value, furnace_fluence(FURNACE_WALLS, 1),
                     e.standard_error) > limit());
}

/* Fog that only scatters, denser to one side, and a mirror and a white ball in
 * it: nothing changes. */
static void test_fog_and_mirrors_change_nothing(uint32_t seed)
{
    const murk_medium media[] = {test_medium(2, 1, .8), test_medium(3, 1, -.4)};
    const murk_region regions[] = {
        test_box_region(0, murk_vec(.5, -1, -1), murk_vec(2.2, 4, 1.7)),
        test_ball_region(1, murk_vec(2.2, 1.5, 1), 1.2)};
    const murk_surface_desc things[] = {
        test_sphere(murk_vec(3.2, .6, 1.3), .35, 1),
        test_sphere(murk_vec(.5, 2.4, .5), .3, 3)};
    chords c;
    few_places(&c);
    c.n = 2; /* the whole box has opaque things in it */
    contents in = {things, 2, media, regions, 2, FURNACE_WALLS};
    heat(&in, &c, 40000, seed);
    for (size_t i = 0; i < c.n; ++i) {
        check_furnace(&c, i, 1);
    }
    in.n_surfaces = 0;
    few_places(&c);
    heat(&in, &c, 20000, seed + 1);
    check_furnace(&c, 2, 1);
    /* Teeth: fog that absorbs one photon in 50 that it meets. */
    const murk_medium grey[] = {test_medium(2, .98, .8),
                                test_medium(3, .98, -.4)};
    in.media = grey;
    few_places(&c);
    heat(&in, &c, 20000, seed + 1);
    const murk_estimate e = chords_fluence(&c, 2);
    CHECK(sigmas_off(e.value, furnace_fluence(FURNACE_WALLS, 1),
                     e.standard_error) > limit());
}

/* A clear ball's lines of sight that pass its middle at more than radius / n
 * only ever meet total reflection: no light comes there. Within radius / n all
 * lines are lit, n^2 as bright as outside; of the whole ball's lines, by
 * volume, 1 - (1 - 1/n^2)^(3/2). */
static double clear_ball_fluence(double n)
{
    return furnace_fluence(FURNACE_WALLS, n) * (1 - pow(1 - 1 / (n * n), 1.5));
}

static void test_glass_holds_n_squared(uint32_t seed)
{
    const murk_vec3 center = {1.6, 1.4, .9};
    const murk_surface_desc ball = test_sphere(center, .8, 2);
    chords c = {.n = 3,
                .place = {chord_ball(center, .5), chord_ball(center, .8),
                          chord_ball(murk_vec(3.3, 2.3, 1), .5)}};
    heat(&(contents){.surfaces = &ball,
                     .n_surfaces = 1,
                     .reflectance = FURNACE_WALLS},
         &c, 60000, seed);
    check_furnace(&c, 0, GLASS_INDEX);
    check_furnace(&c, 2, 1);
    const murk_estimate e = chords_fluence(&c, 1);
    CHECK_WITHIN(limit(), e.value, clear_ball_fluence(GLASS_INDEX),
                 e.standard_error);
    /* Teeth: glass of another index; all lines lit. */
    const murk_estimate deep = chords_fluence(&c, 0);
    CHECK(sigmas_off(deep.value, furnace_fluence(FURNACE_WALLS, 1.6),
                     deep.standard_error) > limit());
    CHECK(sigmas_off(e.value, furnace_fluence(FURNACE_WALLS, GLASS_INDEX),
                     e.standard_error) > limit());
}

/* Water that scatters, with a ball of scattering glass in it: scattering leads
 * light into all lines, so each holds its own n^2 in all of its volume. */
static void test_murky_water_holds_n_squared(uint32_t seed)
{
    const murk_medium media[] = {test_medium(2, 1, .8), test_medium(3, 1, 0)};
    const murk_vec3 middle = {1.6, 1.5, 1};
    murk_region regions[] = {
        test_box_region(0, murk_vec(.3, .4, .2), murk_vec(2.9, 2.7, 1.8)),
        test_ball_region(1, middle, .6)};
    regions[0].ior = WATER_INDEX;
    regions[1].ior = GLASS_INDEX;
    contents in = {NULL, 0, media, regions, 2, FURNACE_WALLS};
    chords c = {
        .n = 3,
        .place = {chord_ball(middle, .6),
                  chord_box(murk_vec(.3, .4, .2), murk_vec(.9, 2.7, 1.8)),
                  chord_ball(murk_vec(3.4, 1.5, 1), .45)}};
    const chords empty = c;
    heat(&in, &c, 60000, seed);
    check_furnace(&c, 0, GLASS_INDEX);
    check_furnace(&c, 1, WATER_INDEX);
    check_furnace(&c, 2, 1);
    /* Teeth: water of index 1.4. */
    regions[0].ior = 1.4;
    c = empty;
    heat(&in, &c, 60000, seed);
    const murk_estimate e = chords_fluence(&c, 1);
    CHECK(sigmas_off(e.value, furnace_fluence(FURNACE_WALLS, WATER_INDEX),
                     e.standard_error) > limit());
}

/* ---- inverse square ---- */

/* Mean over a ball of radius a, its centre at d, of 1 / (4 pi r^2). */
static double mean_inverse_square(double d, double a)
{
    const double integral =
        d == 0
            ? 4 * MURK_PI * a
            : 2 * MURK_PI *
                  (a - (d * d - a * a) / (2 * d) * log((d + a) / fabs(d - a)));
    return integral / (4 * MURK_PI) / (4 * MURK_PI / 3 * a * a * a);
}

static void test_inverse_square(uint32_t seed)
{
    const double distance[] = {0, .3, 1, 2, 4};
    const double radius[] = {.2, .1, .3, .5, .9};
    const murk_source lamp = test_point(murk_vec(.1, -.2, .3));
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-5, -5, -5}, {5, 5, 5}}, false},
                      .lights = &lamp,
                      .n_lights = 1});
    chords c = {.n = 5};
    for (size_t i = 0; i < c.n; ++i) {
        const murk_vec3 direction = murk_unit(murk_vec(1, (double)i - 2, .5));
        c.place[i] = chord_ball(
            murk_along(lamp.position, distance[i], direction), radius[i]);
    }
    test_world_trace(&w, 200000, seed, chords_note, &c);
    test_world_unmade(&w);
    for (size_t i = 1; i < c.n; ++i) {
        const murk_estimate e = chords_fluence(&c, i);
        CHECK_WITHIN(limit(), e.value,
                     mean_inverse_square(distance[i], radius[i]),
                     e.standard_error);
        /* Teeth: 10 % too far away. */
        CHECK(sigmas_off(e.value,
                         mean_inverse_square(1.1 * distance[i], radius[i]),
                         e.standard_error) > limit());
    }
    /* About the lamp every photon has the same chord. */
    CHECK_NEAR(chords_fluence(&c, 0).value, mean_inverse_square(0, radius[0]),
               1e-9);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_empty_enclosure(seed);
    test_fog_and_mirrors_change_nothing(seed);
    test_glass_holds_n_squared(seed);
    test_murky_water_holds_n_squared(seed);
    test_inverse_square(seed);
    return check_done();
}
