/* Free flights through a real plume, by march and by delta tracking, nearest
 * and linear: both follow the exact optical depth. Twelve distances of
 * Kolmogorov and Smirnov share a 1e-6 chance of a false alarm per seed. */
#include "check.h"
#include "flights.h"
#include "medium/delta.h"
#include "medium/grid.h"

#include <stdlib.h>
#include <unistd.h>

#define FLIGHTS 20000
#define CHECKS  12

static const murk_box DOMAIN = {{-1e4, -1e4, -1e4}, {1e4, 1e4, 1e4}};

static murk_media *media_of(const murk_grid *grid, bool is_linear,
                            double extinction_per_m, double factor)
{
    murk_media *media = NULL;
    murk_error err = {0};
    const murk_medium smoke = {
        .extinction_per_m = murk_spectrum_flat(extinction_per_m, 1),
        .albedo = murk_spectrum_flat(0.5, 1),
        .grid = grid,
        .interpolation = is_linear ? MURK_LINEAR : MURK_NEAREST};
    const murk_region region = {.shape = MURK_REGION_GRID,
                                .to_world = murk_affine_identity()};
    CHECK(murk_media_create(&media, &smoke, 1, &region, 1, &DOMAIN, &err) ==
          MURK_OK);
    CHECK(murk_delta_prepare(media, MURK_BRICK_EDGE_MIN, factor, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return media;
}

static double worst_of(const murk_grid *grid, bool is_linear,
                       double extinction_per_m, double factor, uint32_t seed)
{
    murk_media *media = media_of(grid, is_linear, extinction_per_m, factor);
    const murk_box box = murk_media_bounds(media);
    test_flights march = test_fly(media, &box, FLIGHTS, seed, false);
    test_flights delta = test_fly(media, &box, FLIGHTS, seed, true);
    double worst =
        fmax(test_flights_off_law(&march), test_flights_off_law(&delta));
    worst = fmax(worst, test_flights_distance(&march, &delta));
    CHECK(march.wrong == 0 && delta.wrong == 0);
    CHECK(march.collided > 0.1 * FLIGHTS && march.collided < 0.98 * FLIGHTS);
    test_flights_free(&march);
    test_flights_free(&delta);
    murk_media_destroy(media);
    return worst;
}

static void test_plume(const char *path, double extinction_per_m, uint32_t seed)
{
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_read(&grid, path, "density", path, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    if (!grid) {
        return;
    }
    const double limit = test_flights_limit(1e-6, CHECKS);
    for (int is_linear = 0; is_linear < 2; ++is_linear) {
        CHECK(worst_of(grid, is_linear, extinction_per_m, 1, seed) < limit);
        /* Teeth: bounds at a quarter. */
        CHECK(worst_of(grid, is_linear, extinction_per_m, 0.25, seed) > limit);
    }
    murk_grid_destroy(grid);
}

int main(int argc, char **argv)
{
    static const char *const plume = "../shared/data/vdb/smoke_r64_f50.vdb";
    static const char *const large = "../shared/data/vdb/arnold_smoke.vdb";
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    if (access(plume, R_OK) != 0 || access(large, R_OK) != 0) {
        check_skip("no grids at ../shared/data/vdb");
    }
    test_plume(plume, 3, seed);
    test_plume(large, 0.3, seed);
    return check_done();
}
