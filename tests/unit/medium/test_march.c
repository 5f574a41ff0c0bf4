/* The march through a tree against its simple twin (plain_grid.h), which adds
 * up every voxel's own chord; and the laws that need no twin. Deterministic:
 * tolerances are some hundred roundings of the largest length involved. */
#include "base/rng.h"
#include "check.h"
#include "grid_line.h"
#include "medium/grid.h"
#include "medium/grid_internal.h"
#include "medium/tree.h"
#include "plain_grid.h"

#include <stdlib.h>

#define NX     37
#define NY     21
#define NZ     29
#define VOXELS (NX * NY * NZ)

static const size_t SIZE[3] = {NX, NY, NZ};
static const murk_vec3 MIDDLE = {NX / 2.0, NY / 2.0, NZ / 2.0};

static float samples[VOXELS];

/* Noise, a constant block (tiles), a plain part (leaves) and much nothing. */
static void fill_samples(uint32_t seed)
{
    float *value = samples;
    for (int k = 0; k < NZ; ++k) {
        for (int j = 0; j < NY; ++j) {
            for (int i = 0; i < NX; ++i, ++value) {
                const double u = murk_random(seed, MURK_TEST,
                                             (uint64_t)(value - samples), 0, 0)
                                     .u[0];
                *value = i < 8                    ? 0
                         : i < 16 && j < 16       ? 0.75f
                         : i >= 16 && i < 24      ? (float)u
                         : i >= 32 && (j + k) % 7 ? 0
                                                  : (float)(u < 0.1);
            }
        }
    }
}

static murk_grid *make(bool as_tiles)
{
    const murk_affine identity = murk_affine_identity();
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_make(&grid, SIZE, samples, &identity, as_tiles, "test",
                         &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return grid;
}

static murk_vec3 random_direction(uint32_t seed, uint64_t i)
{
    const murk_random4 r = murk_random(seed, MURK_TEST, i, 1, 0);
    const double mu = 2 * r.u[0] - 1;
    return murk_about(murk_vec(0, 0, 1), mu, 2 * MURK_PI * r.u[1]);
}

static murk_vec3 random_point(uint32_t seed, uint64_t i, double reach)
{
    const murk_random4 r = murk_random(seed, MURK_TEST, i, 2, 0);
    return murk_vec(MIDDLE.x + reach * (2 * r.u[0] - 1),
                    MIDDLE.y + reach * (2 * r.u[1] - 1),
                    MIDDLE.z + reach * (2 * r.u[2] - 1));
}

/* Inside and outside starts, any direction and axis-parallel ones, and the
 * same answer from tiles and from leaves. */
static void test_random_rays_agree_with_the_twin(uint32_t seed)
{
    const plain_grid plain = {{NX, NY, NZ}, samples};
    murk_grid *tiles = make(true), *leaves = make(false);
    CHECK(murk_grid_describe(tiles)->active ==
          murk_grid_describe(leaves)->active);
    CHECK(murk_grid_describe(tiles)->memory_bytes <
          murk_grid_describe(leaves)->memory_bytes);
    double total = 0;
    for (uint64_t i = 0; i < 300; ++i) {
        const murk_vec3 from = random_point(seed, i, i & 1 ? 12 : 40);
        murk_vec3 along = random_direction(seed, i);
        if (i % 10 == 0) {
            along = murk_unit(murk_vec(along.x, 0, along.z));
        } else if (i % 10 == 5) {
            along = murk_vec(0, along.y < 0 ? -1 : 1, 0);
        }
        const double length = i & 2 ? 100 : 10;
        const double got = grid_line_integral(tiles, from, along, length);
        CHECK_NEAR(got, plain_line_integral(&plain, from, along, length),
                   1e-12);
        CHECK_NEAR(grid_line_integral(leaves, from, along, length), got, 1e-12);
        /* A direction of another length is another parameter. */
        CHECK_NEAR(
            grid_line_integral(tiles, from, murk_scale(4, along), length / 4),
            got / 4, 1e-12);
        total += got;
    }
    CHECK(total > 100);
    murk_grid_destroy(tiles);
    murk_grid_destroy(leaves);
}

static void test_values_are_the_samples(void)
{
    murk_grid *grid = make(true);
    const float *value = samples;
    int wrong = 0;
    for (int k = 0; k < NZ; ++k) {
        for (int j = 0; j < NY; ++j) {
            for (int i = 0; i < NX; ++i, ++value) {
                wrong += murk_grid_value(grid, i, j, k) != (double)*value;
            }
        }
    }
    CHECK(wrong == 0);
    CHECK(murk_grid_value(grid, -1, 0, 0) == 0);
    CHECK(murk_grid_value(grid, INT64_MAX, 0, INT64_MIN) == 0);
    murk_grid_destroy(grid);
}

static void test_additive_along_a_ray(uint32_t seed)
{
    murk_grid *grid = make(true);
    for (uint64_t i = 0; i < 300; ++i) {
        const murk_vec3 from = random_point(seed, i, 30);
        const murk_vec3 along = random_direction(seed, i);
        const double cut = 60 * murk_random(seed, MURK_TEST, i, 3, 0).u[0];
        const double whole = grid_line_integral(grid, from, along, 60);
        const double first = grid_line_integral(grid, from, along, cut);
        const double second = grid_line_integral(
            grid, murk_along(from, cut, along), along, 60 - cut);
        CHECK_NEAR(first + second, whole, 1e-12);
    }
    murk_grid_destroy(grid);
}

/* Through voxel faces, edges and corners: no voxel is skipped, none counts
 * twice; on a face the upper neighbour counts. */
static void test_faces_edges_and_corners(void)
{
    for (int i = 0; i < VOXELS; ++i) {
        samples[i] = (float)(i % 1009) / 1024;
    }
    murk_grid *grid = make(true);
    const murk_vec3 x = {1, 0, 0}, minus_z = {0, 0, -1};
    const murk_vec3 diagonal = murk_unit(murk_vec(1, 1, 1));
    double row = 0, column = 0, corner = 0;
    for (int i = 0; i < NX; ++i) {
        row += murk_grid_value(grid, i, 7, 8);
    }
    for (int k = 0; k < NZ; ++k) {
        column += murk_grid_value(grid, 16, 8, k);
    }
    for (int i = 0; i < NY; ++i) {
        corner += murk_grid_value(grid, i, i, i) * sqrt(3);
    }
    CHECK_NEAR(grid_line_integral(grid, murk_vec(-9, 6.5, 7.5), x, 100), row,
               1e-12);
    CHECK_NEAR(grid_line_integral(grid, murk_vec(15.5, 7.5, 90), minus_z, 100),
               column, 1e-12);
    CHECK_NEAR(
        grid_line_integral(grid, murk_vec(-0.5, -0.5, -0.5), diagonal, 100),
        corner, 1e-12);
    CHECK_NEAR(
        grid_line_integral(grid, murk_vec(-9.5, -9.5, -9.5), diagonal, 100),
        corner, 1e-12);
    CHECK_NEAR(grid_line_integral(grid, murk_vec(39.5, 39.5, 39.5),
                                  murk_scale(-1, diagonal), 100),
               corner, 1e-12);
    /* Upper outer faces are outside. */
    CHECK(grid_line_integral(grid, murk_vec(-9, NY - 0.5, 3), x, 100) == 0);
    CHECK(grid_line_integral(grid, murk_vec(-9, -0.5, 3), x, 100) > 0);
    murk_grid_destroy(grid);
}

/* A box of ones is as deep as its chord is long, however it is crossed. */
static void test_uniform_grid_is_its_chord(uint32_t seed)
{
    for (int i = 0; i < VOXELS; ++i) {
        samples[i] = 1;
    }
    murk_grid *grid = make(true);
    const murk_box box = {{-0.5, -0.5, -0.5}, {NX - 0.5, NY - 0.5, NZ - 0.5}};
    for (uint64_t i = 0; i < 500; ++i) {
        const murk_vec3 from = random_point(seed, i, 30);
        murk_vec3 along = random_direction(seed, i);
        if (i % 3 == 0) { /* nearly parallel to two faces */
            along = murk_unit(murk_vec(1, along.y * 1e-9, along.z * 1e-300));
        }
        double t0 = 0, t1 = 200;
        const bool meets = murk_box_clip(&box, from, along, &t0, &t1);
        const double chord = meets ? t1 - t0 : 0;
        CHECK_NEAR(grid_line_integral(grid, from, along, 200), chord, 1e-12);
    }
    murk_grid_destroy(grid);
}

/* Cells of 4096 voxels side by side, so many that a walk from cell to cell
 * is cheaper than a test of all, with a gap in the walk. */
static void test_many_root_cells_and_a_gap(void)
{
    /* A row with one voxel of value 1 in each cell but one. */
    enum { CELLS = 72, GAP = 35, EDGE = 4096 };
    const size_t size[3] = {(size_t)CELLS * EDGE, 1, 1};
    float *row = calloc(size[0], sizeof *row);
    CHECK(row != NULL);
    if (!row) {
        return;
    }
    for (size_t i = 0; i < CELLS; ++i) {
        row[i * EDGE + 17 * i] = i == GAP ? 0 : 1;
    }
    const murk_affine identity = murk_affine_identity();
    murk_grid *grid = NULL;
    CHECK(murk_grid_from_samples(&grid, size, row, &identity, "test", NULL) ==
          MURK_OK);
    free(row);
    if (!grid) {
        return;
    }
    /* The empty cell is not stored. */
    CHECK(murk_grid_tree(grid)->n_cells == CELLS - 1);
    /* In both directions along the row all voxels count; within the gap none
     * does. */
    const double length = (double)size[0] + 100;
    CHECK_NEAR(grid_line_integral(grid, murk_vec(-50, 0, 0), murk_vec(1, 0, 0),
                                  length),
               CELLS - 1, 1e-8);
    CHECK_NEAR(grid_line_integral(grid, murk_vec(length - 50, 0, 0),
                                  murk_vec(-1, 0, 0), length),
               CELLS - 1, 1e-8);
    const double from = GAP * EDGE + 5.0;
    CHECK(grid_line_integral(grid, murk_vec(from, 0, 0), murk_vec(1, 0, 0),
                             EDGE) == 0);
    murk_grid_destroy(grid);
}

/* What makes no sense ends, and is a number. */
static void test_odd_rays_end(void)
{
    murk_grid *grid = make(true);
    const double odd[] = {NAN, INFINITY, -INFINITY, 1e308, 0, 5e-324, -1e-308};
    const int n = sizeof odd / sizeof *odd;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            for (int k = 0; k < n; ++k) {
                const double got =
                    grid_line_integral(grid, murk_vec(odd[i], 1, 1),
                                       murk_vec(odd[j], odd[k], 1), 100);
                CHECK(got >= 0 && got <= 101);
            }
        }
    }
    CHECK(grid_line_integral(grid, murk_vec(1, 1, 1), murk_vec(0, 0, 0), 7) ==
          7);
    CHECK(grid_line_integral(grid, murk_vec(1, 1, 1), murk_vec(1, 0, 0),
                             INFINITY) == NX - 1.5);
    CHECK(grid_line_integral(grid, murk_vec(1, 1, 1), murk_vec(1, 0, 0), -1) ==
          0);
    murk_grid_destroy(grid);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    fill_samples(seed);
    test_random_rays_agree_with_the_twin(seed);
    test_values_are_the_samples();
    test_additive_along_a_ray(seed);
    test_faces_edges_and_corners();
    test_uniform_grid_is_its_chord(seed);
    test_many_root_cells_and_a_gap();
    test_odd_rays_end();
    return check_done();
}
