/* Homogeneous media in their places: optical depth and flight against closed
 * forms and against fine steps; refusals. Deterministic. */
#include "base/log.h"
#include "base/rng.h"
#include "check.h"
#include "medium/media.h"

#include <stdlib.h>

static const murk_box DOMAIN = {{-20, -20, -20}, {20, 20, 20}};

static murk_medium even(double extinction_per_m, double albedo)
{
    return (murk_medium){
        .extinction_per_m = murk_spectrum_flat(extinction_per_m, 2),
        .albedo = murk_spectrum_flat(albedo, 2),
        .phase = {murk_phase_hg(albedo / 2), murk_phase_hg(albedo / 2)},
        .where = "m.yaml:1:1: media.m"};
}

static murk_region everywhere(size_t medium)
{
    return (murk_region){.medium = medium,
                         .shape = MURK_REGION_EVERYWHERE,
                         .to_world = murk_affine_identity(),
                         .where = "m.yaml:2:1: regions.0"};
}

static murk_region box(size_t medium, double low, double high)
{
    murk_region region = everywhere(medium);
    region.shape = MURK_REGION_BOX;
    region.box = (murk_box){{low, low, low}, {high, high, high}};
    return region;
}

static murk_region sphere(size_t medium, murk_vec3 center, double radius_m)
{
    murk_region region = everywhere(medium);
    region.shape = MURK_REGION_SPHERE;
    region.center = center;
    region.radius_m = radius_m;
    return region;
}

static murk_media *build(const murk_medium *media, size_t n_media,
                         const murk_region *regions, size_t n_regions)
{
    murk_media *out = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&out, media, n_media, regions, n_regions, &DOMAIN,
                            &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return out;
}

static double depth(const murk_media *media, murk_vec3 from, murk_vec3 to)
{
    const murk_vec3 offset = murk_sub(to, from);
    return murk_media_optical_depth(media, 0, 0, from, murk_unit(offset),
                                    murk_length(offset));
}

static void test_clear_air_does_nothing(void)
{
    murk_media *none = build(NULL, 0, NULL, 0);
    murk_collision c;
    CHECK(!murk_media_any(none));
    CHECK(depth(none, murk_vec(0, 0, 0), murk_vec(1, 2, 3)) == 0);
    CHECK(!murk_media_fly(none, 0, 0, murk_vec(0, 0, 0), murk_vec(1, 0, 0), 9,
                          1e-9, 0.5, &c));
    CHECK(murk_media_bounds(none).min.x > murk_media_bounds(none).max.x);
    CHECK(murk_media_transmittance(none, 0, 0, murk_vec(0, 0, 0),
                                   murk_vec(0, 0, 0)) == 1);
    murk_media_destroy(none);

    const murk_medium zero = even(0, 0.5);
    const murk_region at = everywhere(0);
    murk_media *nothing = build(&zero, 1, &at, 1);
    CHECK(!murk_media_any(nothing));
    CHECK(!murk_media_fly(nothing, 0, 0, murk_vec(0, 0, 0), murk_vec(1, 0, 0),
                          9, 1e-9, 0.5, &c));
    murk_media_destroy(nothing);
}

static void test_depths_are_chords_times_extinction(void)
{
    const murk_medium fog = even(0.25, 0.9);
    const murk_region shapes[] = {everywhere(0), box(0, 1, 5),
                                  sphere(0, murk_vec(3, 3, 3), 2)};
    const double chord[] = {12, 4, 4};
    for (int i = 0; i < 3; ++i) {
        murk_media *media = build(&fog, 1, &shapes[i], 1);
        CHECK_NEAR(depth(media, murk_vec(-3, 3, 3), murk_vec(9, 3, 3)),
                   0.25 * chord[i], 1e-14);
        CHECK_NEAR(depth(media, murk_vec(3, 9, 3), murk_vec(3, -3, 3)),
                   0.25 * chord[i], 1e-14);
        CHECK(murk_media_any(media));
        murk_media_destroy(media);
    }
    murk_media *ball = build(&fog, 1, &shapes[2], 1);
    CHECK_NEAR(depth(ball, murk_vec(-9, 4, 3), murk_vec(9, 4, 3)),
               0.25 * 2 * sqrt(3), 1e-14);
    CHECK_NEAR(depth(ball, murk_vec(3, 3, 3), murk_vec(3, 3, 4)), 0.25, 1e-15);
    CHECK(depth(ball, murk_vec(-9, 5, 3), murk_vec(9, 5, 3)) == 0);
    CHECK(murk_media_bounds(ball).min.x == 1);
    murk_media_destroy(ball);
}

/* Faces: lower ones belong to a region, upper ones do not. */
static void test_neighbours_never_count_twice(void)
{
    const murk_medium fog = even(1, 1);
    murk_region two[] = {box(0, 0, 1), box(0, 0, 1)};
    two[1].box.min.x = 1;
    two[1].box.max.x = 2;
    murk_media *media = build(&fog, 1, two, 2);
    CHECK_NEAR(depth(media, murk_vec(1, 0.5, -1), murk_vec(1, 0.5, 2)), 1,
               1e-15);
    CHECK(murk_media_extinction(media, 0, 0, murk_vec(1, 0.5, 0.5)) == 1);
    CHECK(murk_media_extinction(media, 0, 0, murk_vec(2, 0.5, 0.5)) == 0);
    CHECK(murk_media_extinction(media, 0, 0, murk_vec(0, 0, 0)) == 1);
    CHECK(depth(media, murk_vec(2, 0.5, -1), murk_vec(2, 0.5, 2)) == 0);
    murk_media_destroy(media);
}

static void test_placed_shapes_move_with_their_placement(void)
{
    const murk_medium fog = even(0.5, 1);
    murk_region regions[] = {box(0, -1, 1), sphere(0, murk_vec(1, 0, 0), 1)};
    for (int i = 0; i < 2; ++i) {
        regions[i].to_world =
            murk_affine_place(murk_vec(0, 0, 90), 3, murk_vec(5, 0, 0));
        murk_media *media = build(&fog, 1, &regions[i], 1);
        /* The box is now [2, 8] x [-3, 3]; the sphere is at (5, 3), r 3. */
        CHECK_NEAR(depth(media, murk_vec(5, -15, 0), murk_vec(5, 15, 0)),
                   0.5 * 6, 1e-13);
        const murk_box b = murk_media_bounds(media);
        CHECK_NEAR(b.min.x, 2, 1e-14);
        CHECK_NEAR(b.max.x, 8, 1e-14);
        CHECK_NEAR(b.max.y, i ? 6 : 3, 1e-14);
        murk_media_destroy(media);
    }
}

/* What each of three media adds there. */
static void check_parts(const murk_media *media, murk_vec3 p, double first,
                        double second, double third)
{
    CHECK(murk_media_extinction_of(media, 0, 0, 0, p) == first);
    CHECK(murk_media_extinction_of(media, 1, 0, 0, p) == second);
    CHECK(murk_media_extinction_of(media, 2, 0, 0, p) == third);
}

static void test_regions_add_and_replace(void)
{
    const murk_medium media[] = {even(0.1, 0.5), even(1, 1), even(2, 0)};
    murk_region regions[] = {everywhere(0), box(1, 0, 4),
                             sphere(2, murk_vec(2, 2, 2), 1)};
    const murk_vec3 a = {-5, 2, 2}, b = {5, 2, 2};

    murk_media *sum = build(media, 3, regions, 3);
    CHECK_NEAR(depth(sum, a, b), 1 + 4 + 4, 1e-14);
    CHECK_NEAR(murk_media_extinction(sum, 0, 0, murk_vec(2, 2, 2)), 3.1, 1e-15);
    CHECK_NEAR(murk_media_scattering(sum, 0, 0, murk_vec(2, 2, 2)), 1.05,
               1e-15);
    check_parts(sum, murk_vec(2, 2, 2), 0.1, 1, 2);
    check_parts(sum, murk_vec(-1, 2, 2), 0.1, 0, 0);
    murk_media_destroy(sum);

    regions[1].replaces = true;
    murk_media *box_alone = build(media, 3, regions, 3);
    CHECK_NEAR(depth(box_alone, a, b), 0.6 + 4 + 4, 1e-14);
    CHECK(murk_media_extinction(box_alone, 0, 0, murk_vec(2, 2, 2)) == 3);
    check_parts(box_alone, murk_vec(2, 2, 2), 0, 1, 2);
    murk_media_destroy(box_alone);

    regions[2].replaces = true;
    murk_media *hole = build(media, 3, regions, 3);
    CHECK_NEAR(depth(hole, a, b), 0.6 + 2 + 4, 1e-14);
    CHECK(murk_media_extinction(hole, 0, 0, murk_vec(2, 2, 2)) == 2);
    CHECK(murk_media_extinction(hole, 0, 0, murk_vec(0.1, 2, 2)) == 1);
    check_parts(hole, murk_vec(2, 2, 2), 0, 0, 2);
    check_parts(hole, murk_vec(0.1, 2, 2), 0, 1, 0);
    murk_media_destroy(hole);

    /* A clear region that replaces cuts a hole. */
    murk_medium clear[] = {media[0], media[1], even(0, 0)};
    murk_media *bubble = build(clear, 3, regions, 3);
    CHECK_NEAR(depth(bubble, a, b), 0.6 + 2, 1e-14);
    murk_media_destroy(bubble);
}

/* Random shapes, moved, some replacing: the depth is what fine steps find, it
 * adds up along the ray, and a flight stops where the depth is reached. */
static void test_random_regions_against_fine_steps(uint32_t seed)
{
    murk_medium media[6];
    murk_region regions[6];
    for (uint32_t i = 0; i < 6; ++i) {
        const murk_random4 a = murk_random(seed, MURK_TEST, i, 0, 0);
        const murk_random4 b = murk_random(seed, MURK_TEST, i, 1, 0);
        media[i] = even(a.u[0], a.u[1]);
        const murk_vec3 at = {6 * b.u[0] - 3, 6 * b.u[1] - 3, 6 * b.u[2] - 3};
        regions[i] = i == 0  ? everywhere(0)
                     : i & 1 ? box(i, -1 - a.u[2], 1 + a.u[3])
                             : sphere(i, at, 1 + 3 * a.u[3]);
        if (i > 0) {
            regions[i].to_world = murk_affine_place(
                murk_vec(90 * b.u[0], 360 * b.u[1], 45), 0.5 + a.u[0], at);
        }
        regions[i].replaces = i == 2 || i == 5;
    }
    murk_media *all = build(media, 6, regions, 6);
    const int steps = 2000;
    for (uint32_t i = 0; i < 50; ++i) {
        const murk_random4 p = murk_random(seed, MURK_TEST, i, 2, 0);
        const murk_random4 q = murk_random(seed, MURK_TEST, i, 3, 0);
        const murk_vec3 from = {14 * p.u[0] - 7, 14 * p.u[1] - 7,
                                14 * p.u[2] - 7};
        const murk_vec3 to = {14 * q.u[0] - 7, 14 * q.u[1] - 7,
                              14 * q.u[2] - 7};
        const murk_vec3 offset = murk_sub(to, from);
        const double length = murk_length(offset);
        const murk_vec3 along = murk_unit(offset);
        double stepped = 0;
        for (int k = 0; k < steps; ++k) {
            stepped += murk_media_extinction(
                all, 0, 0, murk_along(from, (k + 0.5) / steps, offset));
        }
        stepped *= length / steps;
        const double got = depth(all, from, to);
        /* Each of at most 12 ends is off by half a step of at most 6 / m. */
        CHECK_NEAR(got, stepped, 12 * 0.5 * length / steps * 6);

        const murk_vec3 middle = murk_along(from, p.u[3], offset);
        CHECK_NEAR(depth(all, from, middle) + depth(all, middle, to), got,
                   1e-12);

        murk_collision c;
        const double tau = q.u[3] * got;
        CHECK(murk_media_fly(all, 0, 0, from, along, length, tau, p.u[3], &c));
        CHECK_NEAR(
            murk_media_optical_depth(all, 0, 0, from, along, c.distance_m), tau,
            1e-12);
        CHECK_NEAR(c.scattering_per_m,
                   murk_media_scattering(all, 0, 0,
                                         murk_along(from, c.distance_m, along)),
                   1e-12);
        CHECK(!murk_media_fly(all, 0, 0, from, along, length, got * 1.000001,
                              p.u[3], &c));
    }
    murk_media_destroy(all);
}

/* The partner: u in [0, 1) is shared out in the regions' order by extinction;
 * here 1 : 3, and 2 with extinction 0 never. */
static void test_partner_by_extinction(void)
{
    const murk_medium media[] = {even(0, 1), even(1, 0.25), even(3, 0.5),
                                 even(0, 1)};
    const murk_region regions[] = {everywhere(0), everywhere(1), everywhere(2),
                                   everywhere(3)};
    murk_media *all = build(media, 4, regions, 4);
    const double u[] = {1e-9, 0.2499999, 0.2500001, 1 - 1e-12};
    const size_t want[] = {1, 1, 2, 2};
    for (int i = 0; i < 4; ++i) {
        murk_collision c;
        CHECK(murk_media_fly(all, 1, 0, murk_vec(0, 0, 0), murk_vec(0, 0, 1), 8,
                             2, u[i], &c));
        CHECK_NEAR(c.distance_m, 0.5, 1e-15);
        CHECK(c.medium == want[i]);
        CHECK(c.albedo == media[want[i]].albedo.band[1]);
        CHECK(c.phase->value[0] == media[want[i]].phase[1].value[0]);
        CHECK_NEAR(c.scattering_per_m, 1.75, 1e-15);
    }
    murk_media_destroy(all);
}

/* A flight that uses up its depth exactly at the far face collides there, in
 * the region that it is leaving; from there on nothing is left. */
static void test_a_flight_may_end_on_the_face(void)
{
    const murk_medium fog = even(0.25, 0.5);
    const murk_region region = box(0, 1, 5);
    murk_media *media = build(&fog, 1, &region, 1);
    const murk_vec3 from = {-3, 3, 3}, x = {1, 0, 0};
    murk_collision c;
    CHECK(murk_media_fly(media, 0, 0, from, x, 20, 1, 0.5, &c));
    CHECK(c.distance_m == 8);
    CHECK(c.scattering_per_m == 0.125);
    const murk_vec3 face = murk_along(from, c.distance_m, x);
    CHECK(!murk_media_fly(media, 0, 0, face, x, 20, 1e-300, 0.5, &c));
    CHECK(murk_media_fly(media, 0, 0, face, murk_vec(-1, 0, 0), 20, 0.5, 0.5,
                         &c));
    CHECK(c.distance_m == 2);
    CHECK(!murk_media_fly(media, 0, 0, from, x, 7, 1, 0.5, &c));
    murk_media_destroy(media);
}

static void test_bands_are_independent(void)
{
    murk_medium dye = even(0, 1);
    dye.extinction_per_m.band[1] = 2;
    const murk_region at = everywhere(0);
    murk_media *media = build(&dye, 1, &at, 1);
    const murk_vec3 o = {0, 0, 0}, x = {1, 0, 0};
    CHECK(murk_media_any(media));
    CHECK(murk_media_optical_depth(media, 0, 0, o, x, 3) == 0);
    CHECK(murk_media_optical_depth(media, 1, 0, o, x, 3) == 6);
    CHECK_NEAR(murk_media_transmittance(media, 1, 0, o, murk_vec(0, 2, 0)),
               exp(-4), 1e-16);
    murk_media_destroy(media);
}

/* Rays of numbers that make no sense end. */
static void test_odd_rays_end(void)
{
    /* One medium in three overlapping regions. */
    const murk_medium fog = even(1, 1);
    murk_region regions[] = {box(0, 0, 1), sphere(0, murk_vec(0, 0, 0), 1),
                             everywhere(0)};
    murk_media *media = build(&fog, 1, regions, 3);
    /* Any result will do, if the calls return. */
    const double odd[] = {NAN, INFINITY, -INFINITY, 1e308, 0, 5e-324};
    murk_collision c;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            (void)murk_media_fly(media, 0, 0, murk_vec(odd[i], 0, 0),
                                 murk_vec(odd[j], 0, 1), odd[(i + j) % 6], 1,
                                 0.5, &c);
            (void)murk_media_optical_depth(media, 0, 0,
                                           murk_vec(0.5, odd[i], 0),
                                           murk_vec(1, odd[j], 0), 5);
        }
    }
    /* A ray with a NaN has an optical depth of 0. */
    for (int i = 0; i < 7; ++i) {
        double number[7] = {0, 0, 0, 1, 0, 0, 5};
        number[i] = NAN;
        CHECK(murk_media_optical_depth(
                  media, 0, 0, murk_vec(number[0], number[1], number[2]),
                  murk_vec(number[3], number[4], number[5]), number[6]) == 0);
    }
    /* An endless ray through endless fog has an infinite optical depth; a
     * ray of length 0 has none. */
    CHECK(murk_media_optical_depth(media, 0, 0, murk_vec(0, 0, 0),
                                   murk_vec(1, 0, 0), INFINITY) == INFINITY);
    CHECK(murk_media_optical_depth(media, 0, 0, murk_vec(0, 0, 0),
                                   murk_vec(1, 0, 0), 0) == 0);
    murk_media_destroy(media);
}

static void refuses(const murk_medium *medium, const murk_region *region,
                    const char *where, const char *part)
{
    murk_media *out = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&out, medium, 1, region, 1, &DOMAIN, &err) ==
          MURK_BAD_VALUE);
    CHECK(out == NULL);
    CHECK_TEXT(err.where, where);
    CHECK_MENTIONS(err.text, part);
}

static void test_bad_values_are_named(void)
{
    const murk_medium good = even(1, 1);
    const murk_region at = everywhere(0);
    murk_medium bad = good;
    bad.extinction_per_m.band[1] = NAN;
    refuses(&bad, &at, good.where, "extinction_per_m is nan (band 1)");
    bad = good;
    bad.albedo.band[0] = 1.2;
    refuses(&bad, &at, good.where, "albedo is 1.2 (band 0), must be 0..1");
    bad = good;
    bad.phase[0].value[0] = -1;
    refuses(&bad, &at, good.where, "mean cosine g is -1");

    murk_region region = box(0, 2, 1);
    refuses(&good, &region, at.where, "min below max");
    double *const high[3] = {&region.box.max.x, &region.box.max.y,
                             &region.box.max.z};
    for (int axis = 0; axis < 3; ++axis) { /* flat, and a little inside out */
        region = box(0, 1, 2);
        *high[axis] = 1;
        refuses(&good, &region, at.where, "min below max");
        *high[axis] = 0.99;
        refuses(&good, &region, at.where, "min below max");
    }
    region = sphere(0, murk_vec(0, 0, 0), 0);
    refuses(&good, &region, at.where, "radius 0 m");
    region = box(1, 0, 1);
    refuses(&good, &region, at.where, "medium number 1, there are 1");
    region = box(0, 0, 1);
    region.to_world = murk_affine_place(murk_vec(0, 0, 0), 0, region.center);
    refuses(&good, &region, at.where, "cannot be inverted");
    const double bad_number[] = {NAN, INFINITY, 1e308};
    for (int i = 0; i < 3; ++i) {
        region = box(0, 0, 1);
        region.to_world.matrix[0][0] = bad_number[i];
        region.to_world.matrix[0][1] = bad_number[i];
        refuses(&good, &region, at.where, "cannot be inverted");
        region = box(0, 0, 1);
        region.to_world.shift.y = 2 * bad_number[i];
        refuses(&good, &region, at.where, "cannot be inverted");
    }
    region.shape = MURK_REGION_GRID;
    refuses(&good, &region, at.where, "has no grid");

    static murk_region many[MURK_REGIONS_MAX + 1];
    murk_media *out = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&out, &good, 1, many, MURK_REGIONS_MAX + 1, &DOMAIN,
                            &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "at most 256 and 64");
}

/* The ends of what is allowed are allowed, and a hundredth beyond is not. */
static void test_ends_of_ranges(void)
{
    const struct {
        double extinction, albedo, ior, slope;
        bool is_allowed;
    } cases[] = {
        {0, 0, 0, 0, true},        {1e30, 1, 1, 0, true},
        {0, 0, 10, 1, true},       {-0.01, 0, 0, 0, false},
        {1.01e30, 0, 0, 0, false}, {1, -0.01, 0, 0, false},
        {1, 1.01, 0, 0, false},    {1, 0, 0.99, 0, false},
        {1, 0, -0.01, 0, false},   {1, 0, 10.1, 0, false},
        {1, 0, 2, -0.01, false},   {1, 0, 2, 1.01, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const murk_medium medium = even(cases[i].extinction, cases[i].albedo);
        murk_region region = everywhere(0);
        region.shape = MURK_REGION_BELOW;
        region.below_z_m = 0;
        region.ior = cases[i].ior;
        region.mean_square_slope = cases[i].slope;
        murk_media *out = NULL;
        CHECK((murk_media_create(&out, &medium, 1, &region, 1, &DOMAIN, NULL) ==
               MURK_OK) == cases[i].is_allowed);
        murk_media_destroy(out);
    }
    /* heights given twice are a jump, three times are a mistake */
    const struct {
        double z_m[4];
        size_t n;
        double value;
        bool is_allowed;
    } profiles[] = {
        {{0, 1, 1, 2}, 4, 1, true},  {{0, 0, 1}, 3, 1, true},
        {{0, 1, 1}, 3, 1, true},     {{0, 1}, 2, 1e30, true},
        {{0, 1}, 2, 0, true},        {{1, 1, 1, 2}, 4, 1, false},
        {{0, 1, 1, 1}, 4, 1, false}, {{0, 2, 1}, 3, 1, false},
        {{1, 0.99}, 2, 1, false},    {{1, 1}, 2, 1, false},
        {{0}, 1, 1, false},          {{0, 1}, 2, -0.01, false},
        {{0, 1}, 2, 1.01e30, false}, {{0, INFINITY}, 2, 1, false},
    };
    for (size_t i = 0; i < sizeof profiles / sizeof *profiles; ++i) {
        murk_spectrum extinction[4];
        for (size_t k = 0; k < 4; ++k) {
            extinction[k] = murk_spectrum_flat(k == 1 ? profiles[i].value : 0.5,
                                               MURK_BANDS_MAX);
        }
        const murk_profile profile = {.n = profiles[i].n,
                                      .z_m = profiles[i].z_m,
                                      .extinction_per_m = extinction};
        murk_medium medium = even(1, 1);
        medium.profile = &profile;
        const murk_region region = everywhere(0);
        murk_media *out = NULL;
        CHECK((murk_media_create(&out, &medium, 1, &region, 1, &DOMAIN, NULL) ==
               MURK_OK) == profiles[i].is_allowed);
        murk_media_destroy(out);
    }
}

static int warnings;

static void count_warning(const char *where, const char *text)
{
    CHECK_TEXT(where, "m.yaml:2:1: regions.0");
    CHECK_MENTIONS(text, "outside of the domain");
    ++warnings;
}

static void test_outside_of_the_domain_is_reported(void)
{
    const murk_medium fog = even(1, 1);
    const murk_region regions[] = {box(0, 30, 31), box(0, 19, 31)};
    murk_warn_to(count_warning);
    murk_media_destroy(build(&fog, 1, regions, 2));
    murk_warn_to(murk_warn_to_stderr);
    CHECK(warnings == 1);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_clear_air_does_nothing();
    test_depths_are_chords_times_extinction();
    test_neighbours_never_count_twice();
    test_placed_shapes_move_with_their_placement();
    test_regions_add_and_replace();
    test_random_regions_against_fine_steps(seed);
    test_partner_by_extinction();
    test_a_flight_may_end_on_the_face();
    test_bands_are_independent();
    test_odd_rays_end();
    test_bad_values_are_named();
    test_ends_of_ranges();
    test_outside_of_the_domain_is_reported();
    return check_done();
}
