/* Boundaries of refractive regions: along a ray the set carried agrees with
 * where the ray is, boundaries are met once and in one step where they lie in
 * each other, and what crosses is refused. Deterministic. */
#include "interface_media.h"

static void test_half_space(void)
{
    const murk_region sea = below(1.5, 1.34);
    murk_media *media = build(&sea, 1);
    murk_boundary b;
    CHECK(murk_media_bends(media));
    CHECK(murk_media_inside(media, murk_vec(3, 4, 1.4999)) == 1);
    CHECK(murk_media_inside(media, murk_vec(3, 4, 1.5)) == 0);
    CHECK(murk_media_index(media, 1) == 1.34);
    CHECK(murk_media_index(media, 0) == 1);
    CHECK(murk_media_boundary(media, 1, murk_vec(0, 0, 0.5), up, 10, &b));
    CHECK(b.distance_m == 1 && b.crossed == 1 && b.region == 0);
    CHECK(b.normal.x == 0 && b.normal.y == 0 && b.normal.z == -1);
    CHECK(murk_media_boundary(media, 0, murk_vec(0, 0, 2), down, 10, &b));
    CHECK(b.distance_m == 0.5 && b.normal.z == 1);
    /* away from it, too far, level */
    CHECK(!murk_media_boundary(media, 1, murk_vec(0, 0, 1), down, 10, &b));
    CHECK(!murk_media_boundary(media, 0, murk_vec(0, 0, 2), up, 10, &b));
    CHECK(!murk_media_boundary(media, 0, murk_vec(0, 0, 2), down, 0.5, &b));
    CHECK(!murk_media_boundary(media, 1, murk_vec(0, 0, 1), murk_vec(1, 0, 0),
                               10, &b));
    /* the set says where it is, not the position */
    CHECK(!murk_media_boundary(media, 1, murk_vec(0, 0, 1.6), down, 10, &b));
    CHECK(murk_media_boundary(media, 1, murk_vec(0, 0, 1.6), up, 10, &b));
    CHECK(b.distance_m == 0);
    murk_media_destroy(media);
}

static void test_box_and_ball_in_their_places(void)
{
    const murk_region regions[2] = {
        moved(box(murk_vec(-1, -1, -1), murk_vec(1, 1, 1), 1.5),
              murk_vec(0, 0, 45), 2, murk_vec(10, 0, 0)),
        moved(ball(murk_vec(1, 0, 0), 1, 1.3), murk_vec(0, 0, 90), 3,
              murk_vec(-10, -3, 0))};
    murk_media *media = build(regions, 2);
    murk_boundary b;
    const double half = sqrt(0.5), far = 2 * sqrt(2);
    CHECK(murk_media_boundary(media, 0, murk_vec(3, 1, 0), murk_vec(1, 0, 0),
                              INFINITY, &b));
    CHECK_NEAR(b.distance_m, 7 - far + 1, 1e-14);
    CHECK_NEAR(b.normal.x, -half, 1e-15);
    CHECK_NEAR(b.normal.y, half, 1e-15);
    CHECK(b.crossed == 1);
    CHECK(
        murk_media_boundary(media, 1, murk_vec(10, 0, 0.5), up, INFINITY, &b));
    CHECK_NEAR(b.distance_m, 1.5, 1e-15);
    CHECK(b.normal.z == -1);
    /* centre (-10, 0, 0), radius 3 */
    CHECK(murk_media_inside(media, murk_vec(-10, 2.99, 0)) == 2);
    CHECK(murk_media_inside(media, murk_vec(-10, 3.01, 0)) == 0);
    CHECK(
        murk_media_boundary(media, 0, murk_vec(-10, 0, 8), down, INFINITY, &b));
    CHECK_NEAR(b.distance_m, 5, 1e-14);
    CHECK_NEAR(b.normal.z, 1, 1e-15);
    CHECK(
        murk_media_boundary(media, 2, murk_vec(-10, 0, 1), down, INFINITY, &b));
    CHECK_NEAR(b.distance_m, 4, 1e-14);
    CHECK_NEAR(b.normal.z, 1, 1e-15);
    CHECK(
        !murk_media_boundary(media, 0, murk_vec(-10, 3.001, 5), down, 100, &b));
    murk_media_destroy(media);
}

/* A sea with a tilted block in it, a bubble in the block, a moved ball of glass
 * in the sea and, in the air, a box that holds another. */
static murk_media *nest(void)
{
    murk_region regions[] = {
        below(0.1, 1.34),
        moved(box(murk_vec(-3, -2, -2.5), murk_vec(3, 2, 2.5), 1.5),
              murk_vec(20, 35, 50), 1.5, murk_vec(1, 2, -9)),
        ball(murk_vec(1.2, 2.1, -9.3), 2.2, 1),
        moved(ball(murk_vec(1, 1, 1), 2, 1.6), murk_vec(10, 0, 80), 1.1,
              murk_vec(-12, -9, -6)),
        box(murk_vec(-8, -8, 3), murk_vec(8, 8, 9), 1.2),
        moved(box(murk_vec(-1, -1, -1), murk_vec(1, 1, 1), 1.7),
              murk_vec(0, 10, 30), 1.3, murk_vec(0, 0, 6))};
    return build(regions, sizeof regions / sizeof *regions);
}

static murk_vec3 point_of(uint64_t i)
{
    const murk_random4 r = murk_random(7, MURK_TEST, i, 0, 0);
    return murk_vec(40 * r.u[0] - 20, 40 * r.u[1] - 20, 40 * r.u[2] - 20);
}

static murk_vec3 direction_of(uint64_t i)
{
    const murk_random4 r = murk_random(7, MURK_TEST, i, 1, 0);
    return murk_about(up, 2 * r.u[0] - 1, 2 * MURK_PI * r.u[1]);
}

/* Follows a ray to its last boundary; between two boundaries the set carried
 * must be that of the middle. Returns how many it met. */
static int check_along(const murk_media *media, murk_vec3 p, murk_vec3 d,
                       bool meets_edges)
{
    murk_inside inside = murk_media_inside(media, p);
    int n = 0;
    for (; n < EVERY; ++n) {
        murk_boundary b;
        const bool any = murk_media_boundary(media, inside, p, d, INFINITY, &b);
        const double length = any ? b.distance_m : 100;
        const murk_vec3 middle = murk_along(p, length / 2, d);
        CHECK(length < 1e-9 || murk_media_inside(media, middle) == inside);
        if (!any) {
            break;
        }
        CHECK(murk_dot(b.normal, d) <= 0);
        CHECK_NEAR(murk_length(b.normal), 1, 1e-14);
        /* reflected there, it meets nothing at once */
        const murk_vec3 at = murk_along(p, length, d);
        const murk_vec3 back =
            murk_along(d, -2 * murk_dot(d, b.normal), b.normal);
        murk_boundary again;
        CHECK(meets_edges ||
              !murk_media_boundary(media, inside, at, back, 1e-12, &again));
        p = at;
        inside ^= b.crossed;
    }
    CHECK((inside & ~(murk_inside)1) == 0);
    CHECK(n < EVERY);
    return n;
}

static void test_the_set_is_where_the_ray_is(void)
{
    murk_media *media = nest();
    int met = 0;
    for (uint64_t i = 0; i < 20000; ++i) {
        met += check_along(media, point_of(i), direction_of(i), false);
    }
    CHECK(met > 10000);
    /* box in the air, sea, block, bubble, block */
    CHECK(check_along(media, murk_vec(1.2, 2.1, 15), down, false) == 7);
    murk_media_destroy(media);
}

/* At edges and corners, along faces, tangent to balls: whatever is met, a ray
 * ends where it should and soon. */
static void test_edges_and_tangents(void)
{
    const murk_region regions[2] = {
        box(murk_vec(-1, -1, -1), murk_vec(1, 1, 1), 1.5),
        ball(murk_vec(5, 0, 0), 1, 1.4)};
    murk_media *media = build(regions, 2);
    const double at[] = {-1, 0, 1};
    for (int i = 0; i < 27 * 27; ++i) {
        const murk_vec3 target = {at[i % 3], at[i / 3 % 3], at[i / 9 % 3]};
        const murk_vec3 d = {at[i / 27 % 3], at[i / 81 % 3], at[i / 243]};
        if (murk_length(d) > 0) {
            const murk_vec3 unit = murk_unit(d);
            check_along(media, murk_along(target, -4, unit), unit, true);
            check_along(
                media,
                murk_add(murk_along(target, -4, unit), murk_vec(5, 0, 0)), unit,
                true);
        }
    }
    /* just inside the rim: in and out again */
    murk_boundary b;
    const double z = 1 - 1e-12;
    CHECK(murk_media_boundary(media, 0, murk_vec(5, -4, z), murk_vec(0, 1, 0),
                              100, &b));
    CHECK_NEAR(b.distance_m, 4, 2e-6);
    CHECK(murk_media_boundary(media, 2, murk_vec(5, -4 + b.distance_m, z),
                              murk_vec(0, 1, 0), 100, &b));
    CHECK(b.distance_m < 4e-6);
    /* inside by the set, though rounding leaves no chord */
    CHECK(murk_media_boundary(media, 2, murk_vec(5, 0, 1 + 1e-13),
                              murk_vec(0, 1, 0), 100, &b));
    CHECK_NEAR(b.distance_m, 0, 1e-12);
    murk_media_destroy(media);
}

/* Layers that share a face, turned and moved: each step leads from one index
 * straight to the next, also for rays that graze. */
static void test_stacked_slabs_share_their_faces(void)
{
    const murk_vec3 turn = {31, 17, 53}, shift = {0.3, -0.7, 0.1};
    const double z[] = {-0.7, -0.3, 0.1, 0.4};
    const double ior[] = {1.3, 1.5, 1.7};
    murk_region regions[3];
    for (int i = 0; i < 3; ++i) {
        regions[i] =
            moved(box(murk_vec(-5, -5, z[i]), murk_vec(5, 5, z[i + 1]), ior[i]),
                  turn, 1.1, shift);
    }
    murk_media *media = build(regions, 3);
    const double slopes[] = {1, 0.3, 1e-2, 1e-3};
    for (int k = 0; k < 4; ++k) {
        const murk_vec3 local = murk_unit(murk_vec(0.6, 0.8, slopes[k]));
        const murk_affine placed = murk_affine_place(turn, 1.1, shift);
        murk_vec3 d = murk_unit(murk_affine_direction(&placed, local));
        /* to the middle of the stack, from within the lowest */
        const double back = 0.3 / local.z;
        murk_vec3 p = murk_affine_point(
            &placed, murk_along(murk_vec(0, 0, -0.1), -fmin(back, 3), local));
        murk_inside inside = murk_media_inside(media, p);
        const murk_inside first = inside;
        murk_boundary b;
        int steps = 0;
        while (steps < 9 &&
               murk_media_boundary(media, inside, p, d, INFINITY, &b)) {
            const murk_inside next = inside ^ b.crossed;
            if (next != 0) { /* not out of the stack */
                CHECK((inside & next) == 0);
                CHECK(inside << 1 == next);
            }
            p = murk_along(p, b.distance_m, d);
            inside = next;
            ++steps;
        }
        CHECK(inside == 0 && first != 0);
        CHECK(steps >= 1);
    }
    /* straight through: three steps from the lowest */
    const murk_vec3 bottom[2] = {{0, 0, -0.5}, {0, 0, 2}};
    murk_vec3 p[2];
    for (int i = 0; i < 2; ++i) {
        p[i] = murk_affine_point(&regions[0].to_world, bottom[i]);
    }
    murk_boundary b;
    const murk_vec3 d = murk_unit(murk_sub(p[1], p[0]));
    CHECK(murk_media_boundary(media, 1, p[0], d, INFINITY, &b));
    CHECK(b.crossed == 3 && b.region == 1);
    CHECK_NEAR(murk_dot(b.normal, d), -1, 1e-14);
    CHECK(murk_media_boundary(media, 2, murk_along(p[0], b.distance_m, d), d,
                              INFINITY, &b));
    CHECK(b.crossed == 6);
    murk_media_destroy(media);
}

/* A slab of a micrometre in a domain of forty metres keeps its two faces. */
static void test_thin_slab(void)
{
    const murk_region film =
        box(murk_vec(-5, -5, 0), murk_vec(5, 5, 1e-6), 1.5);
    murk_media *media = build(&film, 1);
    murk_boundary b;
    CHECK(murk_media_boundary(media, 0, murk_vec(0, 0, 3), down, 100, &b));
    CHECK_NEAR(b.distance_m, 3 - 1e-6, 1e-15);
    CHECK(murk_media_boundary(media, 1, murk_vec(0, 0, 3 - b.distance_m), down,
                              100, &b));
    CHECK_NEAR(b.distance_m, 1e-6, 1e-15);
    murk_media_destroy(media);
}

static void test_last_listed_holds(void)
{
    const murk_region regions[] = {everywhere(1.1), below(5, 1.34),
                                   ball(murk_vec(0, 0, 0), 3, 1),
                                   ball(murk_vec(0, 0, 0), 1, 1.5)};
    murk_media *media = build(regions, 4);
    CHECK(murk_media_index(media,
                           murk_media_inside(media, murk_vec(0, 0, 9))) == 1.1);
    CHECK(murk_media_index(
              media, murk_media_inside(media, murk_vec(0, 0, 4))) == 1.34);
    CHECK(murk_media_index(media,
                           murk_media_inside(media, murk_vec(0, 2, 0))) == 1);
    CHECK(murk_media_index(media,
                           murk_media_inside(media, murk_vec(0, 0, 0))) == 1.5);
    CHECK(murk_media_inside(media, murk_vec(0, 0, 0)) == 15);
    murk_media_destroy(media);
}

/* What lies in a side of the domain or beyond is no boundary; a layer from side
 * to side goes on at the other. */
static void test_sides_of_the_domain(void)
{
    const murk_box domain = {{-0.3, -1, 0}, {0.3, 1, 2}};
    /* 0.1 + 0.2 is not 0.3 */
    const murk_region layer =
        moved(box(murk_vec(-0.3 - 0.2, -7, -1), murk_vec(0.1, 7, 1), 1.5),
              murk_vec(0, 0, 0), 1, murk_vec(0.2, 0, 0));
    murk_media *media = build_in(&domain, &layer, 1);
    murk_boundary b;
    const murk_vec3 p = {0, 0, 0.5};
    CHECK(murk_media_inside(media, murk_vec(0.3, 1, 0)) == 1);
    CHECK(!murk_media_boundary(media, 1, p, murk_vec(1, 0, 0), 9, &b));
    CHECK(!murk_media_boundary(media, 1, p, murk_vec(-1, 0, 0), 9, &b));
    CHECK(!murk_media_boundary(media, 1, p, murk_vec(0, 1, 0), 9, &b));
    CHECK(!murk_media_boundary(media, 1, p, down, 9, &b));
    CHECK(murk_media_boundary(media, 1, p, up, 9, &b));
    CHECK_NEAR(b.distance_m, 0.5, 1e-15);
    /* it stands in the face, above or below it by its set alone */
    for (murk_inside inside = 0; inside < 2; ++inside) {
        CHECK(murk_media_wrapped(media, inside, murk_vec(-0.3, 0, 1), 0) ==
              inside);
        CHECK(murk_media_wrapped(media, inside, murk_vec(0, 1, 1), 1) ==
              inside);
    }
    murk_media_destroy(media);
    /* turned by a quarter, too */
    const murk_region turned =
        moved(box(murk_vec(-1, -0.3, -1), murk_vec(1, 0.2, 1), 1.5),
              murk_vec(0, 0, 90), 1, murk_vec(0, 0, 0));
    media = build_in(&domain, &turned, 1);
    CHECK(!murk_media_boundary(media, 1, p, murk_vec(0, 1, 0), 9, &b));
    CHECK(!murk_media_boundary(media, 1, p, murk_vec(1, 0, 0), 9, &b));
    CHECK(murk_media_boundary(media, 1, p, murk_vec(-1, 0, 0), 9, &b));
    CHECK_NEAR(b.distance_m, 0.2, 1e-15);
    CHECK(murk_media_wrapped(media, 1, murk_vec(0, -1, 0.5), 1) == 1);
    CHECK(murk_media_wrapped(media, 1, murk_vec(-0.3, 0, 0.5), 0) == 0);
    CHECK(murk_media_wrapped(media, 0, murk_vec(0.3, 0, 0.5), 0) == 1);
    murk_media_destroy(media);
}

static void test_no_region_bends(void)
{
    murk_media *media = build(NULL, 0);
    CHECK(!murk_media_bends(media));
    CHECK(murk_media_index(media, 0) == 1);
    murk_media_destroy(media);
}

static void test_numbers_that_are_none(void)
{
    murk_media *media = nest();
    const double bad[] = {NAN, INFINITY, -INFINITY};
    murk_boundary b;
    for (int i = 0; i < 3; ++i) {
        const double x = bad[i];
        CHECK(!murk_media_boundary(media, 1, murk_vec(0, 0, -1),
                                   murk_vec(NAN, x, x), 9, &b));
        CHECK(!murk_media_boundary(media, 1, murk_vec(x, x, x), up, 9, &b) ||
              b.distance_m >= 0);
        CHECK(!murk_media_boundary(media, 0, murk_vec(x, NAN, x), up, 9, &b) ||
              b.distance_m >= 0);
    }
    CHECK(!murk_media_boundary(media, 1, murk_vec(0, 0, -1), up, NAN, &b));
    CHECK(!murk_media_boundary(media, 1, murk_vec(0, 0, -1), murk_vec(0, 0, 0),
                               9, &b));
    murk_media_destroy(media);
}

int main(void)
{
    murk_warn_to(NULL); /* of what lies in a region listed later */
    test_half_space();
    test_box_and_ball_in_their_places();
    test_the_set_is_where_the_ray_is();
    test_edges_and_tangents();
    test_stacked_slabs_share_their_faces();
    test_thin_slab();
    test_last_listed_holds();
    test_sides_of_the_domain();
    test_no_region_bends();
    test_numbers_that_are_none();
    return check_done();
}
