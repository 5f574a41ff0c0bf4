/* Walks of several rays at once (medium/grid_lanes.h) against the walk of one
 * ray (medium/march.h), to the bit, for every instruction set of this
 * processor: grids with leaves, constant nodes and gaps; rays along axes and
 * across, from inside and outside; with and without a constant extinction
 * beside the grid; walks that stop and walks that come to their end. */
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "base/rng.h"
#include "check.h"
#include "lane_sets.h"
#include "medium/grid.h"
#include "medium/grid_internal.h"
#include "medium/grid_lanes.h"
#include "medium/grid_ray.h"
#include "medium/march.h"

#define NX     37
#define NY     21
#define NZ     29
#define VOXELS (NX * NY * NZ)
#define ROUNDS 4000

static const size_t SIZE[3] = {NX, NY, NZ};
static float samples[VOXELS];

/* Noise, a constant block (a tile), a thin part and much nothing. */
static murk_grid *made(bool as_tiles, const murk_affine *to_world)
{
    float *value = samples;
    for (int k = 0; k < NZ; ++k) {
        for (int j = 0; j < NY; ++j) {
            for (int i = 0; i < NX; ++i, ++value) {
                const uint64_t n = (uint64_t)(value - samples);
                const double u = murk_random(1, MURK_TEST, n, 0, 0).u[0];
                const bool is_gap = j >= 16 && k < 8;
                *value = is_gap             ? 0
                         : i < 8 && j < 8   ? 0.75f
                         : i >= 8 && i < 24 ? (float)u
                                            : (float)(u < 0.3);
            }
        }
    }
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(!murk_grid_make(&grid, SIZE, samples, to_world, as_tiles, "test",
                          &err));
    return grid;
}

/* The rays of one round in the world, and the values of their walks. */
typedef struct rays {
    murk_lane_number x, y, z, dx, dy, dz, from, to;
} rays;

/* Rays from in and around the grid; every fourth of them along an axis, through
 * a corner of voxels or not; every fourth near the edges of voxels, where faces
 * across several axes are reached at the same time but for rounding. */
static void draw(rays *r, uint64_t round)
{
    for (size_t i = 0; i < MURK_LANE_COUNT; ++i) {
        const uint64_t n = round * MURK_LANE_COUNT + i;
        const murk_random4 a = murk_random(2, MURK_TEST, n, 0, 0);
        const murk_random4 b = murk_random(2, MURK_TEST, n, 1, 0);
        double p[3] = {60 * a.u[0] - 12, 45 * a.u[1] - 12, 53 * a.u[2] - 12};
        double d[3] = {2 * b.u[0] - 1, 2 * b.u[1] - 1, 2 * b.u[2] - 1};
        if (n % 4 == 0) {
            const size_t axis = n / 4 % 3;
            const double sign = b.u[3] < 0.5 ? -1 : 1;
            memset(d, 0, sizeof d);
            d[axis] = sign;
            for (size_t k = 0; k < 3 && n % 8 == 0; ++k) {
                p[k] = floor(p[k]) + 0.5; /* on faces of voxels */
            }
        }
        if (n % 4 == 1) {
            for (size_t k = 0; k < 3; ++k) {
                d[k] = d[k] < 0 ? -1 : 1;
                p[k] = floor(p[k]) + 0.1;
            }
        }
        const double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        r->x[i] = p[0];
        r->y[i] = p[1];
        r->z[i] = p[2];
        r->dx[i] = d[0] / length;
        r->dy[i] = d[1] / length;
        r->dz[i] = d[2] / length;
        r->from[i] = 0;
        r->to[i] = n % 5 == 0 ? 10 * a.u[3] : INFINITY;
    }
}

static bool is_equal(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* One walk by march.h against that of the lane. Returns 1 if it stops. */
static int compare(const murk_grid_lanes *g, const murk_lane_grid *grid,
                   const rays *r, const rays *clipped, size_t i, double scale,
                   double offset, double limit, double before)
{
    const murk_vec3 o =
        murk_affine_point(&grid->to_index, murk_vec(r->x[i], r->y[i], r->z[i]));
    const murk_vec3 d = murk_affine_direction(
        &grid->to_index, murk_vec(r->dx[i], r->dy[i], r->dz[i]));
    double from = r->from[i], to = r->to[i];
    const bool is_met = murk_grid_clip(grid->tree, 0, o, d, &from, &to);
    CHECK(is_met == (clipped->from[i] < clipped->to[i]));
    if (!is_met) {
        CHECK(g->walks[i] == 0);
        return 0;
    }
    /* The walk. */
    CHECK(is_equal(from, clipped->from[i]) && is_equal(to, clipped->to[i]));
    murk_march march;
    murk_march_begin(&march, grid->tree, o, d, from, to);
    double sum = before;
    const bool stops = murk_march_integrate(&march, scale, offset, limit, &sum);
    CHECK(stops == (g->stops[i] != 0));
    CHECK(is_equal(sum, g->sum[i]));
    if (stops) {
        CHECK(is_equal(march.ray.to, g->to[i]));
        CHECK(is_equal(march.value, g->value[i]));
    }
    return stops;
}

/* Compares, and destroys the grid, of which some rays must stop and some come
 * to their end. */
static void test_grid(murk_lane_set set, murk_grid *given,
                      const murk_affine *to_world)
{
    murk_leaf_table leaves =
        murk_leaf_table_made(murk_grid_tree(given), murk_grid_nanovdb(given));
    murk_lane_grid grid = {.tree = murk_grid_tree(given), .leaves = &leaves};
    CHECK(leaves.leaf != NULL);
    CHECK(murk_affine_invert(to_world, &grid.to_index));
    grid.to_index.shift =
        murk_add(grid.to_index.shift, murk_vec(0.5, 0.5, 0.5));
    const murk_grid_lane_steps *steps = murk_grid_lane_steps_for(set);
    murk_grid_lanes *g = calloc(1, sizeof *g);
    int stops = 0, ends = 0;
    for (uint64_t round = 0; round < ROUNDS; ++round) {
        rays r, clipped;
        draw(&r, round);
        clipped = r;
        const double *const of_ray[6] = {r.x, r.y, r.z, r.dx, r.dy, r.dz};
        /* Fewer lanes than there are, in some rounds. */
        const size_t n = round % 3 == 0 ? MURK_LANE_GROUP : MURK_LANE_COUNT;
        steps->clip(g, &grid, of_ray, clipped.from, clipped.to, n);
        double limit[MURK_LANE_COUNT];
        const double offset = round % 2 == 0 ? 0 : 0.01;
        const double before = round % 4 == 0 ? 0 : 0.125;
        for (size_t i = 0; i < n; ++i) {
            const uint64_t lane = round * MURK_LANE_COUNT + i;
            const double u = murk_random(3, MURK_TEST, lane, 0, 0).u[0];
            limit[i] = -4 * log(u) + before;
            g->walks[i] = clipped.from[i] < clipped.to[i] ? 1 : 0;
            g->from[i] = clipped.from[i];
            g->end[i] = clipped.to[i];
            g->scale[i] = 0.5;
            g->offset[i] = offset;
            g->limit[i] = limit[i];
            g->sum[i] = before;
        }
        steps->walk(g, &grid, n);
        for (size_t i = 0; i < n; ++i) {
            const int stop = compare(g, &grid, &r, &clipped, i, 0.5, offset,
                                     limit[i], before);
            stops += stop;
            ends += g->walks[i] != 0 && !stop;
        }
    }
    CHECK(stops > ROUNDS / 8 && ends > ROUNDS / 8);
    free(g);
    murk_leaf_table_release(&leaves);
    murk_grid_destroy(given);
}

static murk_grid *read(const char *path)
{
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(!murk_grid_read(&grid, path, NULL, "test", &err));
    return grid;
}

/* A single value: one voxel, or all of a box that is stored as tiles. */
static murk_grid *uniform(size_t size, const murk_affine *to_world)
{
    const size_t box[3] = {size, size, size};
    murk_grid *grid = NULL;
    for (size_t i = 0; i < size * size * size; ++i) {
        samples[i] = 1;
    }
    CHECK(!murk_grid_make(&grid, box, samples, to_world, true, "test", NULL));
    return grid;
}

/* Two voxels in an enormous box have no table of leaves. */
static void test_sparse_grid(void)
{
    murk_grid *grid = read("tests/unit/medium/grids/wide.vdb");
    CHECK(!murk_leaf_table_made(murk_grid_tree(grid), murk_grid_nanovdb(grid))
               .leaf);
    murk_grid_destroy(grid);
}

int main(void)
{
    const murk_affine identity = murk_affine_identity();
    const murk_affine moved =
        murk_affine_place(murk_vec(20, 30, 40), 0.7, murk_vec(1, 2, 3));
    /* below.vdb moved to the rays, and voxels of 20 m. */
    const murk_affine shifted =
        murk_affine_place(murk_vec(0, 0, 0), 1, murk_vec(18, 12, 25));
    const murk_affine large =
        murk_affine_place(murk_vec(0, 0, 0), 20, murk_vec(15, 10, 15));
    for (size_t i = 0; i < MURK_LANE_SETS; ++i) {
        const murk_lane_set set = (murk_lane_set)i;
        if (!test_lane_set_forced(set)) {
            continue;
        }
        test_grid(set, made(false, &identity), &identity);
        test_grid(set, made(true, &identity), &identity);
        test_grid(set, made(false, &moved), &moved);
        test_grid(set, read("tests/unit/medium/grids/below.vdb"), &shifted);
        test_grid(set, uniform(1, &large), &large);
        test_grid(set, uniform(16, &identity), &identity);
    }
    test_sparse_grid();
    return check_done();
}
