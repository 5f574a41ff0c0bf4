/* The bounds by which delta tracking flies: each is the largest value that is
 * seen from its brick, no more and no less, and a walk along a ray meets them
 * in order, without gaps. Deterministic. */
#include "base/rng.h"
#include "check.h"
#include "medium/brick_cells.h"
#include "medium/bricks.h"
#include "medium/grid.h"
#include "medium/grid_internal.h"
#include "medium/march.h"

#include <stdlib.h>

/* The bound at a voxel. */
static float bound_at(const murk_bricks *bricks, const int32_t voxel[3])
{
    const murk_brick_bound s = murk_bricks_lookup(bricks, voxel);
    return s.table
               ? fmaxf(s.bound,
                       s.table[murk_brick_in_block(bricks->edge_shift, voxel)])
               : s.bound;
}

typedef struct bricks_facts {
    double volume; /* volume with a bound above 0 [voxels] */
    double sum;    /* sum of bound times volume [density * voxels] */
    size_t memory_bytes;
} bricks_facts;

static bricks_facts describe_bricks(const murk_bricks *bricks)
{
    const murk_bricks *b = bricks;
    bricks_facts facts = {.memory_bytes =
                              sizeof *b + b->n_slots * sizeof *b->slot +
                              b->tables_capacity * murk_table_size(b) *
                                  sizeof *b->bound};
    const size_t n = b->n_tables * murk_table_size(b);
    const double brick = ldexp(1, 3 * b->edge_shift);
    for (size_t i = 0; i < n; ++i) {
        facts.volume += b->bound[i] > 0 ? brick : 0;
        facts.sum += (double)b->bound[i] * brick;
    }
    for (size_t i = 0; i < b->n_slots; ++i) {
        const murk_brick_cell *c = &b->slot[i];
        if (c->bound > 0) {
            const double volume = ldexp(1, 3 * murk_level_shift[c->level]);
            facts.volume += volume;
            facts.sum += (double)c->bound * volume;
        }
    }
    return facts;
}

#define NX     40
#define NY     27
#define NZ     150 /* over two blocks */
#define VOXELS (NX * NY * NZ)

static float samples[VOXELS];

/* Noise, nothing, a constant part (tiles), a few single voxels. */
static void fill_samples(uint32_t seed)
{
    float *value = samples;
    for (int k = 0; k < NZ; ++k) {
        for (int j = 0; j < NY; ++j) {
            for (int i = 0; i < NX; ++i, ++value) {
                const double u = murk_random(seed, MURK_TEST,
                                             (uint64_t)(value - samples), 0, 0)
                                     .u[0];
                *value = k < 20              ? (float)u
                         : k < 64            ? 0
                         : k < 88 && i < 16  ? 0.75f
                         : k < 100 && j >= 8 ? (float)(u * u)
                                             : (float)(u < 0.001);
            }
        }
    }
}

static murk_grid *make(bool as_tiles)
{
    const size_t size[3] = {NX, NY, NZ};
    const murk_affine identity = murk_affine_identity();
    murk_grid *grid = NULL;
    CHECK(murk_grid_make(&grid, size, samples, &identity, as_tiles, "test",
                         NULL) == MURK_OK);
    return grid;
}

static float sample(int i, int j, int k)
{
    const bool is_in = i >= 0 && i < NX && j >= 0 && j < NY && k >= 0 && k < NZ;
    return is_in ? samples[(k * NY + j) * NX + i] : 0;
}

/* The simple twin: every value that is seen from any voxel of the brick. */
static float plain_bound(const int32_t first[3], int edge, int below, int above)
{
    float max = 0;
    for (int i = first[0] - below; i < first[0] + edge + above; ++i) {
        for (int j = first[1] - below; j < first[1] + edge + above; ++j) {
            for (int k = first[2] - below; k < first[2] + edge + above; ++k) {
                max = fmaxf(max, sample(i, j, k));
            }
        }
    }
    return max;
}

static murk_bricks *bricks_of(const murk_grid *grid, int edge, int below,
                              int above)
{
    murk_bricks *bricks = NULL;
    murk_error err = {0};
    CHECK(murk_bricks_create(&bricks, murk_grid_tree(grid), edge, below, above,
                             "test", &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return bricks;
}

static void test_bound_is_the_largest_value_seen(const murk_grid *grid)
{
    /* Reaches around a brick within which values count: none, one voxel on
     * both sides, and one voxel above. */
    static const int reach[3][2] = {{0, 0}, {1, 1}, {0, 1}};
    for (int edge = MURK_BRICK_EDGE_MIN; edge <= MURK_BRICK_EDGE_MAX;
         edge *= 2) {
        for (int r = 0; r < 3; ++r) {
            const int below = reach[r][0], above = reach[r][1];
            /* Compare each brick of the grid and around the grid with the
             * twin. */
            murk_bricks *bricks = bricks_of(grid, edge, below, above);
            int wrong = 0, empty = 0;
            for (int32_t i = -edge; i < NX + edge; i += edge) {
                for (int32_t j = -edge; j < NY + edge; j += edge) {
                    for (int32_t k = -edge; k < NZ + edge; k += edge) {
                        const int32_t at[3] = {i & -edge, j & -edge, k & -edge};
                        /* Ask at a voxel within the brick. */
                        const int32_t in[3] = {at[0] + edge / 3,
                                               at[1] + edge - 1, at[2]};
                        const float bound = bound_at(bricks, in);
                        wrong += bound != plain_bound(at, edge, below, above);
                        empty += bound == 0;
                    }
                }
            }
            /* All bounds are right, and some bricks are empty. */
            CHECK(wrong == 0);
            CHECK(empty > 0);
            murk_bricks_destroy(bricks);
        }
    }
}

/* The segments of a ray from anywhere join, and the middle of each has the
 * bound of the brick there. */
static void test_walk_meets_the_bounds_in_order(const murk_grid *grid,
                                                uint32_t seed)
{
    /* Bricks of each size, and random rays to the grid. */
    const murk_tree *tree = murk_grid_tree(grid);
    for (int edge = MURK_BRICK_EDGE_MIN; edge <= 32; edge *= 2) {
        murk_bricks *bricks = bricks_of(grid, edge, 0, 0);
        int segments = 0;
        for (uint64_t i = 0; i < 300; ++i) {
            const murk_random4 a = murk_random(seed, MURK_TEST, i, 1, 0);
            const murk_random4 b = murk_random(seed, MURK_TEST, i, 2, 0);
            const murk_vec3 from = {120 * a.u[0] - 40, 120 * a.u[1] - 40,
                                    240 * a.u[2] - 40};
            murk_vec3 along =
                murk_sub(murk_vec(NX * b.u[0], NY * b.u[1], NZ * b.u[2]), from);
            /* Some rays lie in a plane or along an axis. */
            if (i % 5 == 0) {
                along.x = 0;
            } else if (i % 5 == 1) {
                along = murk_vec(0, 0, i % 2 ? 2 : -2);
            }
            double t0 = 0, t1 = 10;
            if (!murk_grid_clip(tree, 0, from, along, &t0, &t1)) {
                continue;
            }
            /* Walk from where the ray enters the grid to where it leaves. */
            murk_brick_walk walk;
            murk_brick_walk_begin(&walk, bricks, from, along, t0, t1);
            double reached = t0;
            while (murk_brick_walk_next(&walk)) {
                CHECK(walk.ray.from == reached && walk.ray.to >= walk.ray.from);
                reached = walk.ray.to;
                ++segments;
                if (walk.ray.to - walk.ray.from < 1e-9) {
                    continue;
                }
                /* The bound is that of the brick, and no less than the
                 * voxel. */
                const double middle = (walk.ray.from + walk.ray.to) / 2;
                const int32_t in[3] = {
                    (int32_t)floor(from.x + middle * along.x),
                    (int32_t)floor(from.y + middle * along.y),
                    (int32_t)floor(from.z + middle * along.z)};
                CHECK(walk.bound == (double)bound_at(bricks, in));
                CHECK(walk.bound >= (double)murk_tree_value(tree, in));
            }
            CHECK(reached == t1);
        }
        CHECK(segments > 300);
        murk_bricks_destroy(bricks);
    }
}

/* Single voxels 4096 and more apart take few bricks and few steps. */
static void test_emptiness_costs_little(void)
{
    /* A row with one voxel in each cell of 4096 but one. */
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
    /* One brick of 512 voxels for each value, in less memory than the grid. */
    murk_bricks *bricks = bricks_of(grid, 8, 0, 0);
    const bricks_facts facts = describe_bricks(bricks);
    CHECK(facts.volume == (CELLS - 1) * 512. && facts.sum == facts.volume);
    CHECK(facts.memory_bytes < murk_grid_describe(grid)->memory_bytes);
    /* A walk through all of the row meets each brick, in few steps. */
    murk_brick_walk walk;
    const murk_vec3 from = {(double)size[0], 0.5, 0.5}, along = {-1, 0, 0};
    murk_brick_walk_begin(&walk, bricks, from, along, 0, (double)size[0]);
    double bound = 0;
    int steps = 0;
    while (murk_brick_walk_next(&walk)) {
        bound += walk.bound * (walk.ray.to - walk.ray.from);
        ++steps;
    }
    CHECK_NEAR(bound, (CELLS - 1) * 8, 1e-6);
    CHECK(steps < 80 * CELLS);
    murk_bricks_destroy(bricks);
    murk_grid_destroy(grid);
}

/* A tile of 128 voxels is bounded as a whole, and so are the cells beside
 * it if interpolation reaches across. */
static void test_large_tiles(void)
{
    /* A constant cube and some slices of another value beside it. */
    enum { EDGE = 128 };
    const size_t size[3] = {EDGE + 9, EDGE, EDGE};
    const size_t n = size[0] * size[1] * size[2];
    float *dense = calloc(n, sizeof *dense);
    CHECK(dense != NULL);
    if (!dense) {
        return;
    }
    for (size_t i = 0; i < n; ++i) {
        dense[i] = i % size[0] < EDGE ? 0.5f : 0.25f;
    }
    const murk_affine identity = murk_affine_identity();
    murk_grid *grid = NULL;
    CHECK(murk_grid_from_samples(&grid, size, dense, &identity, "test", NULL) ==
          MURK_OK);
    free(dense);
    if (!grid) {
        return;
    }
    /* Bricks for nearest and for linear interpolation. */
    murk_bricks *nearest = bricks_of(grid, 16, 0, 0);
    murk_bricks *linear = bricks_of(grid, 16, 1, 1);
    const int32_t in[3] = {5, 100, 64}, beside[3] = {EDGE + 3, 100, 64};
    const int32_t before[3] = {-1, 3, 3}, far[3] = {-EDGE - 1, 3, 3};
    /* Nearest: each place has a bound of its own. */
    CHECK(bound_at(nearest, in) == 0.5f);
    CHECK(bound_at(nearest, beside) == 0.25f);
    CHECK(bound_at(nearest, before) == 0);
    /* Linear: bricks next to the tile have the bound of the tile, far ones
     * have 0. */
    CHECK(bound_at(linear, in) == 0.5f);
    CHECK(bound_at(linear, beside) == 0.5f);
    CHECK(bound_at(linear, before) == 0.5f);
    CHECK(bound_at(linear, far) == 0);
    CHECK(describe_bricks(nearest).memory_bytes < 100000);
    murk_bricks_destroy(nearest);
    murk_bricks_destroy(linear);
    murk_grid_destroy(grid);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    fill_samples(seed);
    for (int as_tiles = 0; as_tiles < 2; ++as_tiles) {
        murk_grid *grid = make(as_tiles);
        test_bound_is_the_largest_value_seen(grid);
        test_walk_meets_the_bounds_in_order(grid, seed);
        murk_grid_destroy(grid);
    }
    test_emptiness_costs_little();
    test_large_tiles();
    return check_done();
}
