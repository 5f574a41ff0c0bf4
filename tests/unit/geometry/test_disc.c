/* Discs that lie on surfaces wholly, and discs that do not. */
#include "geometry/disc.h"

#include "base/rng.h"
#include "check.h"

#include <stdlib.h>

static double number(uint64_t i, uint32_t slot)
{
    return murk_random(1, MURK_TEST, i, 0, slot).u[0];
}

/* Areas against a count of the middles of 400 x 400 cells. The edges cut some
 * 2000 cells at most. A cut cell counts whole or not at all, so the error of
 * each is uniform between -1/2 and 1/2 cell, and the standard deviation of the
 * sum is 13 cells; five of these are allowed. */
#define CELLS_OFF_MAX 65

static void test_areas_are_those_of_counting(void)
{
    /* Random triangles around the unit disc. */
    const int cells = 400;
    for (uint64_t k = 0; k < 40; ++k) {
        double corner[3][2];
        for (uint32_t i = 0; i < 6; ++i) {
            corner[i / 2][i % 2] = 3 * number(k, i) - 1.5;
        }
        /* Count the middles in the disc and on the same side of all three
         * edges. */
        int in = 0;
        for (int i = 0; i < cells * cells; ++i) {
            const double x = 2 * (i % cells + 0.5) / cells - 1;
            const double y = 2 * (i / cells + 0.5) / cells - 1;
            int left = 0;
            for (int c = 0; c < 3; ++c) {
                const double *p = corner[c], *q = corner[(c + 1) % 3];
                left += (q[0] - p[0]) * (y - p[1]) > (q[1] - p[1]) * (x - p[0]);
            }
            in += x * x + y * y < 1 && (left == 0 || left == 3);
        }
        CHECK_NEAR(murk_disc_area_in_triangle(corner, 1),
                   4.0 * in / cells / cells,
                   4.0 * CELLS_OFF_MAX / cells / cells);
    }
    /* A triangle with an edge through the centre, one around the disc, and
     * one beside the disc. */
    double half[3][2] = {{0, -9}, {9, 0}, {0, 9}};
    CHECK_NEAR(murk_disc_area_in_triangle(half, 1), MURK_PI / 2, 1e-12);
    double around[3][2] = {{-9, -9}, {9, -9}, {0, 9}};
    CHECK_NEAR(murk_disc_area_in_triangle(around, 1), MURK_PI, 1e-12);
    double aside[3][2] = {{2, -9}, {9, 0}, {2, 9}};
    CHECK_NEAR(murk_disc_area_in_triangle(aside, 1), 0, 1e-12);
}

static murk_surfaces *made(const murk_surface_desc *shapes, size_t n)
{
    const murk_material paint = {.name = "default", .diffuse = {{0.5}}};
    murk_surfaces *surfaces = NULL;
    murk_error err = {0};
    if (murk_surfaces_create(&surfaces, shapes, n, &paint, 1, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    return surfaces;
}

static murk_surface_desc box(murk_vec3 min, murk_vec3 max)
{
    return (murk_surface_desc){.shape = MURK_SHAPE_BOX,
                               .box = {min, max},
                               .to_world = murk_affine_identity()};
}

static void test_only_whole_discs_are_filled(void)
{
    const murk_surface_desc shapes[] = {
        box(murk_vec(0, 0, 0), murk_vec(4, 4, 4)),
        box(murk_vec(2, 2, 0), murk_vec(3, 3, 1)),
        {.shape = MURK_SHAPE_SPHERE,
         .center = {1, 3, 1},
         .radius_m = 0.5,
         .to_world = murk_affine_identity()}};
    murk_surfaces *surfaces = made(shapes, 3);
    const murk_vec3 up = {0, 0, 1};
    const struct {
        murk_vec3 center;
        double radius_m;
        bool is_filled;
    } cases[] = {
        {{1, 1, 0}, 0.9, true},      {{1, 1, 0}, 1.1, false},    /* a wall */
        {{2.5, 1, 0}, 0.9, true},    {{2.5, 1, 0}, 1.05, false}, /* the crate */
        {{2.5, 2.5, 1}, 0.49, true}, {{2.5, 2.5, 1}, 0.51, false}, /* its top */
        {{1, 3, 0}, 0.49, true},     {{1, 3, 0}, 0.51, false}, /* the ball */
        {{1, 3, 1.5}, 0.1, false},   {{1, 1, 0.01}, 0.5, false},
        {{1, 1, 0}, 0, false},       {{1, 1, 0}, NAN, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        CHECK(murk_surfaces_fill_disc(surfaces, cases[i].center, up,
                                      cases[i].radius_m) == cases[i].is_filled);
    }
    CHECK(!murk_surfaces_fill_disc(surfaces, murk_vec(1, 1, 0),
                                   murk_unit(murk_vec(0.01, 0, 1)), 0.5));
    murk_surfaces_destroy(surfaces);
}

/* What lies twice in one place is not a disc's area once. */
static void test_a_floor_that_lies_twice_is_not_whole(void)
{
    const murk_surface_desc floor = {.shape = MURK_SHAPE_RECT,
                                     .edge1 = {4, 0, 0},
                                     .edge2 = {0, 4, 0},
                                     .to_world = murk_affine_identity()};
    const murk_surface_desc both[] = {floor, floor};
    for (size_t n = 1; n <= 2; ++n) {
        murk_surfaces *surfaces = made(both, n);
        CHECK(murk_surfaces_fill_disc(surfaces, murk_vec(2, 2, 0),
                                      murk_vec(0, 0, 1), 1) == (n == 1));
        murk_surfaces_destroy(surfaces);
    }
}

/* A disc whose center is 1 m from the floor's edge reaches over it by a segment
 * of the share (acos(1 / r) - sqrt(r^2 - 1) / r^2) / pi of its area: a
 * thousandth may be missing. */
static void test_a_thousandth_may_be_missing(void)
{
    const murk_surface_desc floor = {.shape = MURK_SHAPE_RECT,
                                     .edge1 = {9, 0, 0},
                                     .edge2 = {0, 9, 0},
                                     .to_world = murk_affine_identity()};
    murk_surfaces *surfaces = made(&floor, 1);
    const double radius_m[2] = {1.0141, 1.0144};
    double missing[2];
    for (int i = 0; i < 2; ++i) {
        const double r = radius_m[i];
        missing[i] = (acos(1 / r) - sqrt(r * r - 1) / (r * r)) / MURK_PI;
        CHECK(murk_surfaces_fill_disc(surfaces, murk_vec(1, 4, 0),
                                      murk_vec(0, 0, 1), r) == (i == 0));
    }
    CHECK(missing[0] > 0.98e-3 && missing[0] < 1e-3);
    CHECK(missing[1] > 1e-3 && missing[1] < 1.02e-3);
    murk_surfaces_destroy(surfaces);
}

int main(void)
{
    test_areas_are_those_of_counting();
    test_only_whole_discs_are_filled();
    test_a_floor_that_lies_twice_is_not_whole();
    test_a_thousandth_may_be_missing();
    return check_done();
}
