/* Refractive regions that may not lie as they do. Nothing here is random. */
#include "interface_media.h"

/* ---- what may lie how ---- */

static bool is_allowed(murk_region a, murk_region b, murk_error *err)
{
    const murk_medium clear = {.where = "clear"};
    const murk_region regions[2] = {a, b};
    murk_media *media = NULL;
    *err = (murk_error){0};
    const murk_status status =
        murk_media_create(&media, &clear, 1, regions, 2, &DOMAIN, err);
    CHECK(status == MURK_OK || status == MURK_BAD_VALUE);
    murk_media_destroy(media);
    return status == MURK_OK;
}

/* The same, whichever is listed first. */
static void check_pair(bool is_fine, murk_region a, murk_region b)
{
    murk_error err;
    CHECK(is_allowed(a, b, &err) == is_fine);
    CHECK(is_allowed(b, a, &err) == is_fine);
    a.ior = 0; /* no index, no boundary */
    CHECK(is_allowed(a, b, &err));
}

static void test_crossing_is_refused(void)
{
    const murk_region unit = box(murk_vec(0, 0, 0), murk_vec(1, 1, 1), 1.5);
    const murk_vec3 none = {0, 0, 0};
    /* half spaces */
    check_pair(true, below(1, 1.3), below(2, 1.4));
    check_pair(false, below(0.5, 1.3), unit);
    check_pair(true, below(1, 1.3), unit);
    check_pair(true, below(0, 1.3), unit);
    check_pair(false, below(0, 1.3), ball(murk_vec(0, 0, 0.5), 1, 1.5));
    check_pair(true, below(0, 1.3), ball(murk_vec(0, 0, -1), 1, 1.5));
    check_pair(true, below(0, 1.3), ball(murk_vec(19.5, 0, -19.5), 3, 1.5));
    check_pair(true, everywhere(1.3), ball(murk_vec(0, 0, 0.5), 1, 1.5));
    /* boxes */
    check_pair(true, unit, box(murk_vec(1, 0, 0), murk_vec(2, 1, 1), 1.5));
    check_pair(true, unit, box(murk_vec(0, 0, 0), murk_vec(2, 1, 1), 1.3));
    check_pair(true, unit, unit);
    check_pair(false, unit, box(murk_vec(0.5, 0, 0), murk_vec(2, 1, 1), 1.3));
    check_pair(false, unit,
               moved(unit, murk_vec(0, 0, 1), 1, murk_vec(0, 0, 0)));
    check_pair(true, unit,
               moved(unit, murk_vec(0, 0, 45), 1, murk_vec(1.8, 0.5, 0)));
    check_pair(false, unit,
               moved(unit, murk_vec(0, 0, 45), 1, murk_vec(1.6, 0.1, 0)));
    check_pair(true, moved(unit, murk_vec(30, 20, 10), 0.5, none),
               box(murk_vec(-1, -1, -1), murk_vec(1, 1, 1), 1.3));
    /* apart, though only an edge-edge axis tells: two bars laid crosswise,
     * turned about both of their long axes */
    const murk_region bar =
        box(murk_vec(-4, -0.5, -0.5), murk_vec(4, 0.5, 0.5), 1.5);
    check_pair(true, moved(bar, murk_vec(45, 0, 0), 1, none),
               moved(moved(bar, none, 1, none), murk_vec(45, 0, 90), 1,
                     murk_vec(0, 0, 1.415)));
    check_pair(false, moved(bar, murk_vec(45, 0, 0), 1, none),
               moved(bar, murk_vec(45, 0, 90), 1, murk_vec(0, 0, 1.413)));
    /* beyond the domain nothing counts */
    check_pair(true, box(murk_vec(-50, -50, 0), murk_vec(30, 50, 2), 1.5),
               box(murk_vec(-30, -50, 0.5), murk_vec(90, 50, 1), 1.3));
    check_pair(false, box(murk_vec(-50, -50, 0), murk_vec(10, 50, 2), 1.5),
               box(murk_vec(-30, -50, 0.5), murk_vec(90, 50, 1), 1.3));
    /* balls */
    check_pair(true, ball(none, 1, 1.5), ball(murk_vec(2, 0, 0), 1, 1.3));
    check_pair(false, ball(none, 1, 1.5), ball(murk_vec(1.9, 0, 0), 1, 1.3));
    check_pair(true, ball(none, 1, 1.5), ball(murk_vec(1, 0, 0), 2, 1.3));
    check_pair(false, ball(none, 1, 1.5), ball(murk_vec(1.1, 0, 0), 2, 1.3));
    check_pair(true, unit, ball(murk_vec(0.5, 0.5, 0.5), 0.5, 1.3));
    check_pair(false, unit, ball(murk_vec(0.5, 0.5, 0.5), 0.6, 1.3));
    check_pair(true, unit, ball(murk_vec(0.5, 0.5, 0.5), 0.9, 1.3));
    check_pair(false, unit, ball(murk_vec(1.5, 1.5, 1.5), 0.9, 1.3));
    check_pair(true, unit, ball(murk_vec(1.5, 1.5, 1.5), 0.86, 1.3));

    murk_error err;
    murk_region sea = below(0.5, 1.3), block = unit;
    block.where = "fog.yaml:9:5: regions.1";
    CHECK(!is_allowed(sea, block, &err));
    CHECK_TEXT(err.where, "fog.yaml:9:5: regions.1");
    CHECK_TEXT(err.text, "crosses sea, must lie in it, hold it or lie apart: "
                         "both have an index of refraction");
}

static void test_bad_indices_are_named(void)
{
    const double bad[] = {0.99, -1, 10.5, NAN, INFINITY};
    murk_error err;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        CHECK(!is_allowed(everywhere(0), below(0, bad[i]), &err));
        CHECK_TEXT(err.where, "sea");
        CHECK_MENTIONS(err.text, "must be 1..10");
    }
    CHECK(!is_allowed(everywhere(0), below(NAN, 1.3), &err));
    CHECK_MENTIONS(err.text, "below_z_m is nan m, must be finite");
    murk_region flat = ball(murk_vec(0, 0, 0), 1, 1.3);
    flat.to_world.matrix[2][2] = 0.5;
    CHECK(!is_allowed(everywhere(0), flat, &err));
    CHECK_MENTIONS(err.text, "must keep its shape");
}

static size_t warnings;

static void count_warning(const char *where, const char *text)
{
    (void)where;
    warnings += strstr(text, "lies wholly in") != NULL;
}

typedef enum relation { DISJOINT, CROSSING, IN, HOLDS, SAME } relation;

/* How a lies to b: two that cross are refused, and of what is hidden by one
 * that is listed later there is a warning. */
static void check_relation(relation expected, murk_region a, murk_region b)
{
    murk_error err;
    warnings = 0;
    CHECK(is_allowed(a, b, &err) == (expected != CROSSING));
    CHECK(warnings == (expected == IN || expected == SAME));
    warnings = 0;
    CHECK(is_allowed(b, a, &err) == (expected != CROSSING));
    CHECK(warnings == (expected == HOLDS || expected == SAME));
}

/* So they do when both are turned, enlarged and moved. */
static void check_relations(relation expected, murk_region a, murk_region b)
{
    const murk_vec3 turn = {20, -35, 50}, to = {1, -2, 3};
    check_relation(expected, a, b);
    check_relation(expected, moved(a, turn, 2, to), moved(b, turn, 2, to));
    check_relation(expected, moved(a, turn, 0.5, to), moved(b, turn, 0.5, to));
}

static murk_vec3 on_axis(int axis, double value)
{
    return murk_vec(axis == 0 ? value : 0, axis == 1 ? value : 0,
                    axis == 2 ? value : 0);
}

static murk_region cube(murk_vec3 center, double half)
{
    return box(murk_along(center, -half, murk_vec(1, 1, 1)),
               murk_along(center, half, murk_vec(1, 1, 1)), 1.5);
}

/* Along each axis in both directions. Overlaps of less than 2e-11 m, 1e-12 of
 * the farthest coordinate of the domain, do not count. */
static void test_relations_along_the_axes(void)
{
    static const struct {
        double off; /* more than where they touch */
        bool is_disjoint;
    } table[] = {{0.03, true}, {0, true}, {-5e-12, true}, {-1e-10, false}};
    for (int side = 0; side < 6; ++side) {
        const double sign = side % 2 ? -1 : 1;
        for (size_t i = 0; i < sizeof table / sizeof *table; ++i) {
            const relation disjoint =
                table[i].is_disjoint ? DISJOINT : CROSSING;
            const relation in = table[i].is_disjoint ? IN : CROSSING;
            const murk_vec3 far =
                on_axis(side / 2, sign * (1.5 + table[i].off));
            const murk_vec3 near =
                on_axis(side / 2, sign * (0.5 - table[i].off));
            const murk_vec3 none = {0, 0, 0};
            check_relations(disjoint, cube(far, 0.5), cube(none, 1));
            check_relations(disjoint, ball(far, 0.5, 1.3), cube(none, 1));
            check_relations(disjoint, cube(far, 0.5), ball(none, 1, 1.3));
            check_relations(disjoint, ball(far, 0.5, 1.3), ball(none, 1, 1.3));
            check_relations(in, cube(near, 0.5), cube(none, 1));
            check_relations(in, ball(near, 0.5, 1.3), cube(none, 1));
            check_relations(in, ball(near, 0.5, 1.3), ball(none, 1, 1.3));
            const double corner = hypot(1, sqrt(0.5));
            check_relations(in, cube(near, 0.5), ball(none, corner, 1.3));
        }
    }
}

/* From corner to corner and from edge to edge. */
static void test_relations_of_corners(void)
{
    const murk_vec3 none = {0, 0, 0};
    for (int i = 0; i < 8; ++i) {
        const murk_vec3 corner = {i & 4 ? -1 : 1, i & 2 ? -1 : 1,
                                  i & 1 ? -1 : 1};
        const murk_vec3 at = murk_scale(2, corner);
        check_relations(DISJOINT, ball(at, sqrt(3) * 0.999, 1.3),
                        cube(none, 1));
        check_relations(CROSSING, ball(at, sqrt(3) * 1.001, 1.3),
                        cube(none, 1));
        check_relations(HOLDS, ball(corner, 2 * sqrt(3) * 1.001, 1.3),
                        cube(none, 1));
        check_relations(CROSSING, ball(corner, 2 * sqrt(3) * 0.999, 1.3),
                        cube(none, 1));
    }
    check_relations(SAME, cube(none, 1), cube(none, 1));
    check_relations(SAME, ball(none, 1, 1.3), ball(none, 1, 1.5));
    check_relation(SAME, everywhere(1.3), everywhere(1.3));
    check_relation(HOLDS, everywhere(1.3), ball(none, 1, 1.5));
    check_relation(IN, below(1, 1.3), below(1.1, 1.3));
    check_relation(IN, below(1, 1.3), below(1.2, 1.4));
}

/* A turned cube meets a face of a larger cube with one corner alone. */
static void test_relations_of_turned_cubes(void)
{
    /* Extent of the turned small cube along the axis of each face. */
    const murk_vec3 turn[] = {{20, -35, 50}, {-25, 30, 140}, {70, 15, -20}};
    for (size_t k = 0; k < sizeof turn / sizeof *turn; ++k) {
        const murk_affine turned =
            murk_affine_place(turn[k], 1, murk_vec(0, 0, 0));
        for (int side = 0; side < 6; ++side) {
            const double *row = turned.matrix[side / 2];
            const double sign = side % 2 ? -1 : 1;
            const double half =
                0.4 * (fabs(row[0]) + fabs(row[1]) + fabs(row[2]));
            /* Move the small cube until a corner is slightly on one or the
             * other side of the face, from inside and from outside. */
            for (int is_off = 0; is_off < 2; ++is_off) {
                const double off = is_off ? 0.001 : -0.001;
                const murk_region big = cube(murk_vec(0, 0, 0), 1),
                                  small = cube(murk_vec(0, 0, 0), 0.4);
                const murk_vec3 in = on_axis(side / 2, sign * (1 - half + off)),
                                out =
                                    on_axis(side / 2, sign * (1 + half + off));
                check_relation(is_off ? CROSSING : IN,
                               moved(small, turn[k], 1, in), big);
                check_relation(is_off ? DISJOINT : CROSSING,
                               moved(small, turn[k], 1, out), big);
            }
        }
    }
}

/* A long box that is turned a little keeps its faces, as they lie in no side
 * of the domain, and lies in a half space as far as it reaches. */
static void test_what_reaches_far(void)
{
    const murk_region sea = below(0, 1.3);
    for (int axis = 0; axis < 3; ++axis) {
        const murk_vec3 turn = on_axis((axis + 2) % 3, 0.5);
        const double height = axis == 2 ? -1005 : -15;
        const murk_vec3 end =
            murk_along(murk_vec(1, 1, 1), 999, on_axis(axis, 1));
        const murk_region bar = box(murk_scale(-1, end), end, 1.5);
        check_relation(IN, moved(bar, turn, 1, murk_vec(0, 0, height)), sea);
        check_relation(IN, ball(on_axis(axis, -3000), 2990, 1.5),
                       ball(on_axis(axis, -3000), 2995, 1.5));
    }
}

int main(void)
{
    murk_warn_to(count_warning); /* of what lies in a region listed later */
    test_crossing_is_refused();
    test_relations_along_the_axes();
    test_relations_of_corners();
    test_relations_of_turned_cubes();
    test_what_reaches_far();
    test_bad_indices_are_named();
    return check_done();
}
