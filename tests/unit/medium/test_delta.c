/* Delta tracking flight by flight. In a grid of one value the bound is the
 * extinction itself, so a flight ends at its first try, exactly at the depth
 * that it was thrown; in a grid of two values the tries lie where the larger
 * value puts them. So a bound that is a little too low or too high is seen in
 * one flight, which no sample of flights would show. Deterministic. */
#include "medium/delta.h"
#include "medium/grid_internal.h"

#include "check.h"

#include <stdlib.h>

#define EDGE_VOXELS 16
#define FLIGHTS     200
#define PER_M       .7

static float one_value(size_t i)
{
    (void)i;
    return 1;
}

/* One voxel in 512 has the largest value, so each brick of 8^3 has one. */
static float two_values(size_t i)
{
    const size_t x = i % EDGE_VOXELS, y = i / EDGE_VOXELS % EDGE_VOXELS;
    const size_t z = i / (EDGE_VOXELS * EDGE_VOXELS);
    return x % 8 == 7 && y % 8 == 7 && z % 8 == 7 ? 1 : .5f;
}

static murk_media *media_of(float (*value)(size_t), murk_grid **grid)
{
    /* A grid of these values, kept as tiles where values are equal. */
    static float density[EDGE_VOXELS * EDGE_VOXELS * EDGE_VOXELS];
    const size_t size[3] = {EDGE_VOXELS, EDGE_VOXELS, EDGE_VOXELS};
    const murk_affine identity = murk_affine_identity();
    for (size_t i = 0; i < sizeof density / sizeof *density; ++i) {
        density[i] = value(i);
    }
    CHECK(murk_grid_make(grid, size, density, &identity, true, "test", NULL) ==
          MURK_OK);
    /* One medium with the grid, ready for delta tracking. */
    const murk_medium medium = {.extinction_per_m = {{PER_M}},
                                .albedo = {{.5}},
                                .grid = *grid,
                                .where = "test"};
    const murk_region region = {.shape = MURK_REGION_GRID,
                                .to_world = murk_affine_identity(),
                                .where = "test"};
    const murk_box domain = {{-50, -50, -50}, {50, 50, 50}};
    murk_media *media = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&media, &medium, 1, &region, 1, &domain, &err) ==
          MURK_OK);
    CHECK(murk_media_prepare_delta(media, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return media;
}

/* Flights through the middle of the grid, from x = 2 to 14, as the program
 * flies them. */
static bool fly(const murk_media *media, uint64_t i, double tau,
                double *distance_m, uint32_t *nulls)
{
    const murk_address address = {5, MURK_TEST, i, 0};
    murk_flight_randoms stream = {.address = &address};
    murk_collision c;
    const bool has_met =
        murk_delta_fly(media, 0, 0, murk_vec(2, 3.5, 3.5), murk_vec(1, 0, 0),
                       12, tau, .25, &stream, &c);
    *distance_m = has_met ? c.distance_m : 12;
    *nulls = stream.nulls;
    return has_met;
}

static void test_one_value_has_no_null_collisions(void)
{
    murk_grid *grid = NULL;
    murk_media *media = media_of(one_value, &grid);
    for (uint64_t i = 0; i < FLIGHTS; ++i) {
        const double tau = 12 * PER_M * ((double)i + .5) / FLIGHTS;
        double distance_m;
        uint32_t nulls;
        CHECK(fly(media, i, tau, &distance_m, &nulls) && nulls == 0);
        CHECK_NEAR(distance_m, tau / PER_M, 1e-12);
    }
    murk_media_destroy(media);
    murk_grid_destroy(grid);
}

/* u = .25 makes every try real where the density is half the bound. */
static void test_tries_go_by_the_largest_value(void)
{
    murk_grid *grid = NULL;
    murk_media *media = media_of(two_values, &grid);
    for (uint64_t i = 0; i < FLIGHTS; ++i) {
        const double tau = 12 * PER_M * ((double)i + .5) / FLIGHTS;
        double distance_m;
        uint32_t nulls;
        CHECK(fly(media, i, tau, &distance_m, &nulls) && nulls == 0);
        CHECK_NEAR(distance_m, tau / PER_M, 1e-12);
    }
    murk_media_destroy(media);
    murk_grid_destroy(grid);
}

int main(void)
{
    test_one_value_has_no_null_collisions();
    test_tries_go_by_the_largest_value();
    return check_done();
}
