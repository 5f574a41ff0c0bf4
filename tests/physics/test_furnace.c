/* A closed room full of refractive regions: tilted, nested and stacked ones, a
 * bubble, murky and clear, with glass that stands half in water. If the walls
 * shine alike by cosine law, n^2 as much into a place of index n, and nothing
 * but the walls absorbs, the fluence rate is n^2 4 M / (1 - r) wherever the
 * index is n, with M the power that a square metre sends into air and r the
 * walls' reflectance (Kirchhoff, Ann. Phys. 185 (1860) 275,
 * doi:10.1002/andp.18601850205; n^2: Nicodemus, Am. J. Phys. 31 (1963) 368,
 * doi:10.1119/1.1969512). So one wrong index, side or reflectance at any
 * boundary shows.
 *
 * In clear bodies some lines never meet the outside but by total reflection:
 * the places looked at lie clear of those.
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "chords.h"
#include "worlds.h"

#include <stdlib.h>

#define PHOTONS 150000
#define PLACES  9
#define WATER   1.34
#define GLASS   1.5
#define WALLS   0.6 /* reflectance */
#define LAMPS   10

static const murk_box interior = {{0, 0, 0}, {4, 3, 2}};

static double limit(void)
{
    return murk_sidak_limit(1e-6, PLACES);
}

/* A watt a square metre into air, n^2 as much into water. */
static murk_source wall_lamp(murk_vec3 corner, murk_vec3 edge1, murk_vec3 edge2,
                             double index)
{
    const double area = murk_length(murk_cross(edge1, edge2));
    return (murk_source){.type = MURK_SOURCE_RECT,
                         .position = corner,
                         .edge1 = edge1,
                         .edge2 = edge2,
                         .power_w = {{index * index * area}},
                         .where = "wall"};
}

/* Water stands a metre high. */
static void light_walls(murk_source lamp[LAMPS], double index)
{
    const murk_vec3 x = {4, 0, 0}, y = {0, 3, 0}, z = {0, 0, 1};
    const murk_vec3 far_x = x, far_y = y;
    lamp[0] = wall_lamp(interior.min, x, y, index);
    lamp[1] = wall_lamp(murk_vec(0, 0, 2), y, x, 1);
    for (int i = 0; i < 2; ++i) {
        const murk_vec3 up = murk_scale(i, z);
        const double n = i == 0 ? index : 1;
        murk_source *side = &lamp[2 + 4 * i];
        side[0] = wall_lamp(up, z, x, n);
        side[1] = wall_lamp(murk_add(up, far_y), x, z, n);
        side[2] = wall_lamp(up, y, z, n);
        side[3] = wall_lamp(murk_add(up, far_x), z, y, n);
    }
}

static murk_region with_index(murk_region region, double ior)
{
    region.ior = ior;
    return region;
}

/* Notes the chords that photons fly, for fluence rates per W/m2 that the
 * walls send into air; `water` is the refractive index of the water. */
static void heat(double water, chords *c, uint32_t seed)
{
    /* Shining walls around a glass sphere and a tilted glass box. */
    murk_source lamps[LAMPS];
    light_walls(lamps, WATER);
    const murk_material materials[] = {test_material(WALLS, 0, 0, 0),
                                       test_material(0, 0, 1, GLASS)};
    murk_surface_desc surfaces[] = {
        test_box(interior.min, interior.max, 0),
        test_sphere(murk_vec(1, 1, 1), .4, 1),
        test_box(murk_vec(-.3, -.25, -.5), murk_vec(.3, .25, .6), 1)};
    surfaces[2].to_world =
        murk_affine_place(murk_vec(3, 5, 7), 1, murk_vec(2.9, 1, .9));
    /* Water below 1 m, a tilted body of index 1.7 around a bubble, and two
     * bodies that share a face. */
    const murk_medium media[] = {test_medium(0, 1, 0), test_medium(1, 1, .5)};
    murk_region regions[] = {
        with_index(test_everywhere(0), water),
        with_index(
            test_box_region(1, murk_vec(-.3, -.2, -.2), murk_vec(.3, .2, .2)),
            1.7),
        with_index(test_ball_region(0, murk_vec(2, 2.3, .5), .15), 1),
        with_index(
            test_box_region(0, murk_vec(.1, .1, 1.5), murk_vec(1, 2.9, 1.9)),
            1.2),
        with_index(
            test_box_region(1, murk_vec(1, .1, 1.5), murk_vec(2, 2.9, 1.9)),
            1.4)};
    regions[0].shape = MURK_REGION_BELOW;
    regions[0].below_z_m = 1;
    regions[1].to_world =
        murk_affine_place(murk_vec(20, 30, 40), 1, murk_vec(2, 2.3, .5));
    /* Only the walls absorb: all photons end there. */
    test_world w = test_world_made(
        &(test_setup){.domain = {interior, false},
                      .lights = lamps,
                      .n_lights = LAMPS,
                      .surfaces = surfaces,
                      .n_surfaces = sizeof surfaces / sizeof *surfaces,
                      .materials = materials,
                      .n_materials = 2,
                      .media = media,
                      .n_media = 2,
                      .regions = regions,
                      .n_regions = sizeof regions / sizeof *regions});
    test_world_trace(&w, PHOTONS, seed, chords_note, c);
    CHECK(test_photons(&w, w.ledger->lost) == 0);
    CHECK(test_photons(&w, w.ledger->absorbed_surfaces) == PHOTONS);
    test_world_unmade(&w);
}

typedef struct place {
    chord_place where;
    double index;
} place;

static chords places_of(double index[PLACES])
{
    const place places[PLACES] = {
        {chord_ball(murk_vec(3.4, 2.3, 1.5), .4), 1},
        {chord_ball(murk_vec(3.4, 2.3, .5), .4), WATER},
        {chord_ball(murk_vec(1, 1, 1.1), .12), GLASS}, /* both sides of the */
        {chord_ball(murk_vec(1, 1, .9), .12), GLASS},  /* water's level */
        {chord_ball(murk_vec(2.9, 1, .7), .17), GLASS},
        {chord_ball(murk_vec(2.9, 1, 1.2), .17), GLASS},
        {chord_ball(murk_vec(2, 2.3, .5), .15), 1}, /* the bubble */
        {chord_box(murk_vec(.1, .1, 1.5), murk_vec(1, 2.9, 1.9)), 1.2},
        {chord_box(murk_vec(1, .1, 1.5), murk_vec(2, 2.9, 1.9)), 1.4}};
    chords c = {.n = PLACES};
    for (int i = 0; i < PLACES; ++i) {
        c.place[i] = places[i].where;
        index[i] = places[i].index;
    }
    return c;
}

/* Sigmas off n^2 4 M / (1 - r). */
static double off(const chords *c, size_t i, double index)
{
    const double power_w = 26 + WATER * WATER * 26; /* of 52 m2 */
    const murk_estimate e = chords_fluence(c, i);
    return sigmas_off(e.value * power_w, index * index * 4 / (1 - WALLS),
                      e.standard_error * power_w);
}

static void test_each_place_holds_n_squared(uint32_t seed)
{
    double index[PLACES];
    chords c = places_of(index);
    heat(WATER, &c, seed);
    for (size_t i = 0; i < c.n; ++i) {
        CHECK(off(&c, i, index[i]) <= limit());
    }
}

/* Teeth: other water than the walls shine into. */
static void test_would_notice_other_water(uint32_t seed)
{
    double index[PLACES];
    chords c = places_of(index);
    heat(GLASS, &c, seed);
    CHECK(off(&c, 0, 1) > limit() || off(&c, 1, WATER) > limit());
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_each_place_holds_n_squared(seed);
    test_would_notice_other_water(seed);
    return check_done();
}
