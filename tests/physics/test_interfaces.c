/* Boundaries of refractive regions against closed forms: plates clear and
 * absorbing, stacks, a tank of glass that holds water, and the cone of light
 * that leaves water.
 *
 * Source: Born and Wolf, Principles of Optics, 7th ed. (1999), 1.5.2 and 7.6
 * (plates whose beams add without interference: for a lossless stack R/(1 - R)
 * is the sum over its faces of r/(1 - r)).
 *
 * Its z-tests share a 1e-6 chance of a false alarm with those of
 * test_interfaces_bodies.c (Sidak). */
#include "interface_worlds.h"

/* ---- plates ---- */

/* One metre of glass from side to side of a periodic domain. */
static tale through_plate(double degrees, double extinction_per_m, double ior,
                          uint32_t seed)
{
    const double a = degrees * MURK_PI / 180;
    const murk_source beam =
        test_beam(murk_vec(0.1, 0.1, 2), murk_vec(sin(a), 0, -cos(a)));
    const murk_medium glass = test_medium(extinction_per_m, 0, 0);
    const murk_region slab = with_index(
        test_box_region(0, murk_vec(-1, -1, 0), murk_vec(1, 1, 1)), ior);
    return traced(&(test_setup){.domain = {{{-1, -1, -1}, {1, 1, 3}}, true},
                                .lights = &beam,
                                .n_lights = 1,
                                .media = &glass,
                                .n_media = 1,
                                .regions = &slab,
                                .n_regions = 1},
                  seed);
}

static void test_plates(uint32_t seed)
{
    const double degrees[] = {0, 45, 70};
    for (uint32_t i = 0; i < 3; ++i) {
        const double a = degrees[i] * MURK_PI / 180;
        const double r = reflectance(a, 1, GLASS);
        const double path = 1 / sqrt(1 - pow(sin(a) / GLASS, 2));
        ends want = plate(r, 1);
        tale t = through_plate(degrees[i], 0, GLASS, seed + i);
        check_share(t.up, want.back);
        CHECK(t.up + t.down == PHOTONS);
        CHECK(sigmas_from(t.up, r) > limit());
        CHECK(sigmas_from(through_plate(degrees[i], 0, 1.7, seed + i).up,
                          want.back) > limit());
        want = plate(r, exp(-0.7 * path));
        t = through_plate(degrees[i], 0.7, GLASS, seed + i);
        check_share(t.up, want.back);
        check_share(t.down, want.through);
        /* a path not bent */
        if (i > 0) {
            CHECK(sigmas_from(t.down, plate(r, exp(-0.7 / cos(a))).through) >
                  limit());
        }
    }
}

/* Three layers that share faces, turned together, are a stack of four faces
 * and not of six. */
static void test_layers_share_faces(uint32_t seed)
{
    /* Layers with three refractive indices in a turned frame. */
    const murk_vec3 turn = {25, -40, 70}, shift = {0.1, 0.2, 0.3};
    const double z[] = {-0.9, -0.3, 0.1, 0.6}, ior[] = {1.6, 1.34, 2.2};
    murk_region layers[3];
    for (int i = 0; i < 3; ++i) {
        layers[i] = with_index(test_box_region(0, murk_vec(-2, -2, z[i]),
                                               murk_vec(2, 2, z[i + 1])),
                               ior[i]);
        layers[i].to_world = murk_affine_place(turn, 1, shift);
    }
    /* A beam along the normal of the layers. */
    const murk_affine *placed = &layers[0].to_world;
    const murk_source beam =
        test_beam(murk_affine_point(placed, murk_vec(0.1, 0.2, 2)),
                  murk_affine_direction(placed, murk_vec(0, 0, -1)));
    const tale t =
        traced(&(test_setup){.domain = {{{-5, -5, -5}, {5, 5, 5}}, false},
                             .lights = &beam,
                             .n_lights = 1,
                             .media = &clear,
                             .n_media = 1,
                             .regions = layers,
                             .n_regions = 3},
               seed);
    /* The reflected share is that of four faces; six faces, with air
     * between the layers, are refused. */
    const double r[] = {reflectance(0, 1, 2.2), reflectance(0, 2.2, 1.34),
                        reflectance(0, 1.34, 1.6), reflectance(0, 1.6, 1)};
    const double air = reflectance(0, 1, 1.34);
    const double gaps[] = {r[0], r[0], air, air, r[3], r[3]};
    check_share(t.back, stack(r, 4));
    CHECK(sigmas_from(t.back, stack(gaps, 6)) > limit());
}

/* A tank: panes of glass, as closed meshes, that hold water; their faces lie in
 * each other, or the water reaches into the glass, which counts for more. */
static void test_glass_holds_water(uint32_t seed)
{
    const murk_source beam =
        test_beam(murk_vec(0.13, 0.21, 2), murk_vec(0, 0, -1));
    const murk_material glass = test_material(0, 0, 1, GLASS);
    const murk_surface_desc panes[2] = {
        test_box(murk_vec(-3, -3, 0.7), murk_vec(3, 3, 0.8), 0),
        test_box(murk_vec(-3, -3, -0.9), murk_vec(3, 3, -0.7), 0)};
    const double r[] = {reflectance(0, 1, GLASS), reflectance(0, GLASS, WATER),
                        reflectance(0, GLASS, WATER), reflectance(0, 1, GLASS)};
    const double reaches[] = {0.7, 0.71};
    for (uint32_t i = 0; i < 2; ++i) {
        const double h = reaches[i];
        const murk_region water = with_index(
            test_box_region(0, murk_vec(-2, -2, -h), murk_vec(2, 2, h)), WATER);
        const tale t =
            traced(&(test_setup){.domain = {{{-5, -5, -5}, {5, 5, 5}}, false},
                                 .lights = &beam,
                                 .n_lights = 1,
                                 .surfaces = panes,
                                 .n_surfaces = 2,
                                 .materials = &glass,
                                 .n_materials = 1,
                                 .media = &clear,
                                 .n_media = 1,
                                 .regions = &water,
                                 .n_regions = 1},
                   seed + i);
        CHECK(t.met[0] == 0); /* all of it happens at the glass */
        check_share(t.up, stack(r, 4));
        /* a film of air between them */
        const double air[] = {r[0],
                              r[0],
                              r[0],
                              r[0],
                              reflectance(0, 1, WATER),
                              reflectance(0, 1, WATER)};
        CHECK(sigmas_from(t.up, stack(air, 6)) > limit());
    }
}

/* ---- a region is the same however it is described ---- */

static void test_descriptions_agree(uint32_t seed)
{
    /* Water below z = 0 as a half space, two boxes, and a box that is
     * turned, scaled and moved. */
    const murk_source lamp = test_point(murk_vec(0.2, 0.1, -0.6));
    const murk_medium water = test_medium(1.5, 0.9, 0.6);
    murk_region same[4] = {
        below(0, 0, WATER),
        with_index(test_box_region(0, murk_vec(-2, -2, -2), murk_vec(2, 2, 0)),
                   WATER),
        with_index(test_box_region(0, murk_vec(-9, -30, -9), murk_vec(9, 4, 0)),
                   WATER),
        with_index(test_box_region(0, murk_vec(-1, 0, -1), murk_vec(1, 1, 1)),
                   WATER)};
    same[3].to_world =
        murk_affine_place(murk_vec(90, 0, 90), 2, murk_vec(-2, 0, -2));
    same[3].box = (murk_box){{-3, 0, -3}, {3, 1, 3}};
    /* Photons have the same random numbers, so the counts are equal. */
    tale t[4];
    for (int i = 0; i < 4; ++i) {
        t[i] =
            traced(&(test_setup){.domain = {{{-2, -2, -2}, {2, 2, 1}}, false},
                                 .lights = &lamp,
                                 .n_lights = 1,
                                 .media = &water,
                                 .n_media = 1,
                                 .regions = &same[i],
                                 .n_regions = 1},
                   seed);
        CHECK(t[i].up == t[0].up && t[i].down == t[0].down);
        CHECK(t[i].met[0] == t[0].met[0]);
        CHECK(t[i].mirrored[0] == t[0].mirrored[0]);
    }
    /* The surface was met often enough. */
    CHECK(t[0].met[0] > PHOTONS / 4.);
}

/* A cube of clear glass as a region and as a closed mesh, lit by an oblique
 * beam, with the same random numbers: nearly every photon has the same
 * path. */
static void test_region_is_like_a_solid(uint32_t seed)
{
    /* One cube by both descriptions. */
    const murk_source beam =
        test_beam(murk_vec(-2, 0.1, 2), murk_vec(1, 0.05, -0.9));
    const murk_vec3 min = {-1, -1, -1}, max = {1, 1, 1};
    const murk_region cube = with_index(test_box_region(0, min, max), GLASS);
    const murk_material glass = test_material(0, 0, 1, GLASS);
    const murk_surface_desc solid = test_box(min, max, 0);
    test_setup setup = {.domain = {{{-4, -4, -4}, {4, 4, 4}}, false},
                        .lights = &beam,
                        .n_lights = 1,
                        .media = &clear,
                        .n_media = 1,
                        .regions = &cube,
                        .n_regions = 1};
    /* Trace the region, then the mesh instead of it. */
    const tale region = traced(&setup, seed);
    setup.n_regions = 0;
    setup.surfaces = &solid;
    setup.n_surfaces = 1;
    setup.materials = &glass;
    setup.n_materials = 1;
    const tale mesh = traced(&setup, seed);
    /* The same numbers of photons go up, down and sideways, and meet the
     * faces. */
    CHECK(region.up == mesh.up && region.down == mesh.down);
    CHECK(region.lateral == mesh.lateral);
    CHECK(region.met[0] == mesh.at_surfaces && mesh.at_surfaces > PHOTONS);
}

/* ---- out of the water ---- */

/* Of a lamp's light the share that leaves water of that index upwards: the
 * integral over the cosine mu up to the critical angle of 1 - r, one half of it
 * going up. Substituting the cosine in air takes the root at the critical angle
 * out of the integrand. */
static double escaping(double index)
{
    const int n = 20000;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double cosine_air = (i + 0.5) / n;
        const double air = acos(cosine_air);
        const double sine = sin(air) / index;
        const double mu = sqrt(1 - sine * sine);
        const double dmu = cosine_air / (index * index * mu) / n;
        sum += (1 - reflectance(air, 1, index)) * dmu;
    }
    return sum / 2;
}

static tale from_under_water(double index, uint32_t seed)
{
    const murk_source lamp = test_point(murk_vec(0, 0, -1));
    const murk_region sea = below(0, 0, index);
    return traced(&(test_setup){.domain = {{{-9, -9, -3}, {9, 9, 3}}, false},
                                .lights = &lamp,
                                .n_lights = 1,
                                .media = &clear,
                                .n_media = 1,
                                .regions = &sea,
                                .n_regions = 1},
                  seed);
}

static void test_light_leaves_water_in_a_cone(uint32_t seed)
{
    const tale t = from_under_water(WATER, seed);
    check_share(t.above, escaping(WATER));
    CHECK(sigmas_from(t.above, escaping(1.4)) > limit());
    const tale u = from_under_water(GLASS, seed + 1);
    check_share(u.above, escaping(GLASS));
    /* the cone alone, without Fresnel */
    CHECK(sigmas_from(u.above, (1 - sqrt(1 - 1 / (GLASS * GLASS))) / 2) >
          limit());
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_plates(seed);
    test_layers_share_faces(seed);
    test_glass_holds_water(seed);
    test_descriptions_agree(seed);
    test_region_is_like_a_solid(seed);
    test_light_leaves_water_in_a_cone(seed);
    return check_done();
}
