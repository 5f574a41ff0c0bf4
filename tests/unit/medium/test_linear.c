/* The linear walk against its simple twin (plain_linear.h), and the laws that
 * need no twin. Deterministic: tolerances are some hundred roundings of the
 * largest depth involved. */
#include "base/rng.h"
#include "check.h"
#include "lane_sets.h"
#include "medium/grid.h"
#include "medium/grid_internal.h"
#include "medium/linear.h"
#include "medium/tree.h"
#include "plain_linear.h"

#include <float.h>
#include <stdlib.h>

#define FOLDER "tests/unit/medium/grids/"

#define NX     37
#define NY     21
#define NZ     29
#define VOXELS (NX * NY * NZ)

static const size_t SIZE[3] = {NX, NY, NZ};
static const murk_vec3 MIDDLE = {NX / 2.0, NY / 2.0, NZ / 2.0};

static float samples[VOXELS];
static const plain_grid PLAIN = {{NX, NY, NZ}, samples};

/* Noise, a constant block (tiles), a sparse part (leaves) and much nothing. */
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
                         : i < 16 && j < 16       ? 0.75F
                         : i >= 16 && i < 24      ? (float)u
                         : i >= 32 && (j + k) % 7 ? 0
                                                  : (float)(u < 0.1);
            }
        }
    }
}

/* A grid with its blocks of cells. */
typedef struct field {
    murk_grid *grid;
    murk_linear_blocks blocks;
} field;

static field of_grid(murk_grid *grid)
{
    field made = {.grid = grid};
    murk_error err = {0};
    CHECK(murk_linear_blocks_make(&made.blocks, murk_grid_tree(grid), "test",
                                  &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return made;
}

static void release(field *made)
{
    murk_linear_blocks_release(&made->blocks);
    murk_grid_destroy(made->grid);
}

static field make(bool as_tiles)
{
    const murk_affine identity = murk_affine_identity();
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_make(&grid, SIZE, samples, &identity, as_tiles, "test",
                         &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return of_grid(grid);
}

typedef struct line {
    murk_vec3 from, along;
    double length;
} line;

/* The depth, or, with a limit, *t where it is reached and the field there. */
static double depth(const field *in, const line *l, double limit, double *t,
                    double *value)
{
    double from = 0, to = l->length, sum = 0;
    *t = INFINITY;
    if (murk_grid_clip(in->blocks.tree, 1, l->from, l->along, &from, &to)) {
        murk_linear walk;
        murk_linear_begin(&walk, &in->blocks, l->from, l->along, from, to);
        if (murk_linear_integrate(&walk, 1, 0, limit, &sum)) {
            *t = walk.ray.to;
            *value = walk.value;
        }
    }
    return sum;
}

static double whole_depth(const field *in, const line *l)
{
    double t, value;
    return depth(in, l, INFINITY, &t, &value);
}

/* The same, segment by segment. */
static double depth_by_segments(const field *in, const line *l)
{
    double from = 0, to = l->length, sum = 0;
    if (murk_grid_clip(in->blocks.tree, 1, l->from, l->along, &from, &to)) {
        murk_linear walk;
        murk_linear_begin(&walk, &in->blocks, l->from, l->along, from, to);
        double last = from;
        while (murk_linear_next(&walk)) {
            CHECK(walk.ray.from == last && walk.ray.to >= walk.ray.from);
            const murk_cubic c =
                murk_linear_cubic(&walk, walk.ray.from, walk.ray.to);
            sum += murk_cubic_integral(&c, 1) * (walk.ray.to - walk.ray.from);
            last = walk.ray.to;
        }
        CHECK(last == to);
    }
    return sum;
}

static line random_line(uint32_t seed, uint64_t i)
{
    const murk_random4 a = murk_random(seed, MURK_TEST, i, 1, 0);
    const murk_random4 b = murk_random(seed, MURK_TEST, i, 2, 0);
    const double reach = i & 1 ? 12 : 40;
    line l = {
        murk_vec(MIDDLE.x + reach * (2 * a.u[0] - 1),
                 MIDDLE.y + reach * (2 * a.u[1] - 1),
                 MIDDLE.z + reach * (2 * a.u[2] - 1)),
        murk_about(murk_vec(0, 0, 1), 2 * b.u[0] - 1, 2 * MURK_PI * b.u[1]),
        i & 2 ? 100 : 10};
    if (i % 10 == 0) {
        l.along = murk_unit(murk_vec(l.along.x, 0, l.along.z));
    } else if (i % 10 == 5) {
        l.along = murk_vec(0, l.along.y < 0 ? -1 : 1, 0);
    } else if (i % 10 == 7) { /* in faces, along edges, through corners */
        l.from = murk_vec(floor(l.from.x), floor(l.from.y), floor(l.from.z));
        l.along = i % 30 == 7    ? murk_vec(1, 0, 0)
                  : i % 30 == 17 ? murk_unit(murk_vec(0, -1, 1))
                                 : murk_unit(murk_vec(-1, 1, -1));
    }
    return l;
}

static void test_random_rays_agree_with_the_twin(uint32_t seed)
{
    field tiles = make(true), leaves = make(false);
    double total = 0;
    for (uint64_t i = 0; i < 600; ++i) {
        line l = random_line(seed, i);
        const double want =
            plain_linear_integral(&PLAIN, l.from, l.along, l.length);
        const double got = whole_depth(&tiles, &l);
        CHECK_NEAR(got, want, 1e-12);
        CHECK_NEAR(whole_depth(&leaves, &l), want, 1e-12);
        CHECK_NEAR(depth_by_segments(&tiles, &l), want, 1e-12);
        /* A direction of another length is another parameter. */
        l.along = murk_scale(4, l.along);
        l.length /= 4;
        CHECK_NEAR(whole_depth(&tiles, &l), got / 4, 1e-12);
        total += got;
    }
    CHECK(total > 100);
    release(&tiles);
    release(&leaves);
}

/* The midpoint rule on n points errs by at most length^3 |f''| / 24 n^2 in
 * each cubic piece and by kinks, which together stay far below 1e-3 here: a
 * check of the twin itself, and of the field at points. */
static void test_the_field_at_points(uint32_t seed)
{
    field grid = make(true);
    for (uint64_t i = 0; i < 20; ++i) {
        const line l = random_line(seed, i);
        const int n = 20000;
        double sum = 0;
        for (int k = 0; k < n; ++k) {
            const murk_vec3 p =
                murk_along(l.from, (k + 0.5) * l.length / n, l.along);
            double value = 0;
            murk_linear_density(&grid.blocks, p, &value);
            CHECK_NEAR(value, plain_linear_field(&PLAIN, p), 1e-14);
            sum += value * l.length / n;
        }
        CHECK_NEAR(whole_depth(&grid, &l), sum, 1e-4);
    }
    double value = 7;
    CHECK(!murk_linear_density(&grid.blocks, murk_vec(NAN, 5, 5), &value));
    CHECK(!murk_linear_density(&grid.blocks, murk_vec(1e300, 5, 5), &value));
    release(&grid);
}

/* Where the flight stops, that much depth is behind it; parts add up. */
static void test_flight_and_depth_are_one_crossing(uint32_t seed)
{
    field grid = make(true);
    for (uint64_t i = 0; i < 600; ++i) {
        line l = random_line(seed, i);
        const double whole = whole_depth(&grid, &l);
        const double limit = whole * murk_random(seed, MURK_TEST, i, 3, 0).u[0];
        if (!(whole > 0)) {
            continue;
        }
        double t, value, unused;
        CHECK(depth(&grid, &l, limit, &t, &value) == limit);
        CHECK(t > 0 && t < l.length && value > 0);
        const murk_vec3 stop = murk_along(l.from, t, l.along);
        CHECK_NEAR(value, plain_linear_field(&PLAIN, stop), 1e-12);
        const line before = {l.from, l.along, t};
        const line after = {stop, l.along, l.length - t};
        CHECK_NEAR(whole_depth(&grid, &before), limit, 1e-12);
        CHECK_NEAR(whole_depth(&grid, &after), whole - limit, 1e-12);
        /* The very end, where the field may be 0. */
        CHECK(depth(&grid, &l, whole, &t, &value) == whole);
        CHECK(t <= l.length && value > 0);
        CHECK(depth(&grid, &l, whole * (1 + 1e-9), &t, &unused) < whole * 2 &&
              t == INFINITY);
    }
    release(&grid);
}

static field reads(const char *file)
{
    char path[128];
    snprintf(path, sizeof path, FOLDER "%s", file);
    murk_grid *grid = NULL;
    murk_error err = {0};
    CHECK(murk_grid_read(&grid, path, NULL, "test", &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return of_grid(grid);
}

/* Along an axis through voxel centres the ramps at both ends make up for one
 * another: the integral is the sum of the values. Between four rows it is
 * their mean. */
static void test_tiles_of_every_size(void)
{
    field grid = reads("tiles.vdb");
    line l = {murk_vec(-100, -4, -4), murk_vec(1, 0, 0), 1e4};
    CHECK_NEAR(whole_depth(&grid, &l), 3 * 8, 1e-9);
    l.from = murk_vec(-100, -4, -0.5); /* half way down from the top layer */
    CHECK_NEAR(whole_depth(&grid, &l), 3 * 8 / 2.0, 1e-9);
    l.from = murk_vec(-100, 0, 0);
    CHECK_NEAR(whole_depth(&grid, &l), 28 + 2 * 128 + 4096, 1e-9);
    l.from = murk_vec(-100, 0.25, 0.5); /* the row of 28 ends here */
    CHECK_NEAR(whole_depth(&grid, &l), 28 * 0.75 * 0.5 + 2 * 128 + 4096, 1e-9);
    l.from = murk_vec(8190, 4095.5, 2000); /* in the last cells of a tile */
    l.along = murk_vec(-1, 0, 0);
    CHECK_NEAR(whole_depth(&grid, &l), 0.5 * (8190 - 4096 + 0.5), 1e-9);
    l.from = murk_vec(5000, 9, 9);
    l.length = 10;
    CHECK_NEAR(whole_depth(&grid, &l), 10, 1e-9);
    /* Corner to corner of the largest tile, backwards: one cell of x y z and
     * one of (1 - x)(1 - y)(1 - z) at the ends. */
    l = (line){murk_vec(8192, 4096, 4096), murk_unit(murk_vec(-1, -1, -1)),
               4097 * sqrt(3)};
    CHECK_NEAR(whole_depth(&grid, &l), (4095 + 2 / 4.0) * sqrt(3), 1e-8);
    double t, value;
    CHECK(depth(&grid, &l, 100, &t, &value) == 100 && value == 1);
    CHECK_NEAR(t, 100 + 0.75 * sqrt(3), 1e-9);
    release(&grid);
}

/* 2e9 voxels wide, two of them filled: nothing may cost by the width, along
 * whichever row, in the last cells below a node of the tree or elsewhere. */
static void test_a_sparse_box_is_never_walked_through(void)
{
    field grid = reads("wide.vdb");
    for (int i = 0; i < 1000; ++i) {
        const double y = i & 1 ? -7 : -7.75, z = i & 2 ? 5 : 4.5;
        const line l = {murk_vec(-1000000009.0, y, z), murk_vec(1, 0, 0), 3e9};
        const double share = (1 - fabs(y + 7)) * (1 - fabs(z - 5));
        CHECK_NEAR(whole_depth(&grid, &l), 5 * share, 1e-6);
    }
    line l = {murk_vec(1000000000, -7, 5), murk_vec(1, 0, 0), 9};
    CHECK(whole_depth(&grid, &l) == 1.5);
    l.from = murk_vec(-999999998.0, -7, 5);
    l.length = 1.9e9;
    CHECK(whole_depth(&grid, &l) == 0);
    l = (line){murk_vec(-1e9, -6.5, 4.5), murk_unit(murk_vec(2e9, 1e-9, 0)),
               3e9};
    CHECK_NEAR(whole_depth(&grid, &l), 0.25 * (1 + 3), 1e-5);
    release(&grid);
}

/* Sums of depths along a ray with every set of vector instructions, and where
 * it stops, against those of the baseline, to the bit. */
static void test_all_sets_give_the_same_bits(uint32_t seed)
{
    field base = make(true);
    base.blocks.set = MURK_LANES_BASELINE;
    for (size_t s = 0; s < MURK_LANE_SETS; ++s) {
        const murk_lane_set set = (murk_lane_set)s;
        if (!test_lane_set_forced(set)) {
            continue;
        }
        /* The set is chosen when the blocks are made. */
        field other = make(true);
        CHECK(other.blocks.set == set);
        int stops = 0;
        for (uint64_t i = 0; i < 3000; ++i) {
            line l = random_line(seed, i);
            /* Far away, so that rounding takes places out of their cells. */
            if (i % 2 == 0) {
                l.from = murk_along(l.from, -1e14, l.along);
                l.length += 1e14;
            }
            const murk_random4 u = murk_random(seed, MURK_TEST, i, 4, 0);
            const double limit = i % 3 == 0 ? INFINITY : -3 * log(u.u[0]);
            double t[2], value[2] = {0, 0};
            CHECK(depth(&base, &l, limit, &t[0], &value[0]) ==
                  depth(&other, &l, limit, &t[1], &value[1]));
            CHECK(t[0] == t[1] && value[0] == value[1]);
            stops += t[0] < INFINITY;
        }
        CHECK(stops > 100);
        release(&other);
    }
    release(&base);
    /* Without lanes the baseline counts. */
    setenv("MURK_LANES", "off", 1);
    base = make(true);
    CHECK(base.blocks.set == MURK_LANES_BASELINE);
    release(&base);
    unsetenv("MURK_LANES");
}

/* A constant beside the field counts in all cells, also where the field is
 * 0. */
static void test_a_constant_is_added(uint32_t seed)
{
    const double constant = 0.25;
    field grid = make(true);
    for (uint64_t i = 0; i < 200; ++i) {
        const line l = random_line(seed, i);
        double from = 0, to = l.length, sum = 0;
        if (!murk_grid_clip(grid.blocks.tree, 1, l.from, l.along, &from, &to)) {
            continue;
        }
        murk_linear walk;
        murk_linear_begin(&walk, &grid.blocks, l.from, l.along, from, to);
        CHECK(!murk_linear_integrate(&walk, 2, constant, INFINITY, &sum));
        CHECK_NEAR(sum, 2 * whole_depth(&grid, &l) + constant * (to - from),
                   1e-12);
    }
    release(&grid);
}

static double reached(const murk_cubic *c, double share)
{
    const double s = murk_cubic_reach(c, share);
    CHECK(s >= 0 && s <= 1);
    return murk_cubic_integral(c, s) / murk_cubic_integral(c, 1);
}

/* Also where Newton's method alone would creep or leave: double and triple
 * zeros at the ends and in the middle, and next to nothing. */
static void test_the_root_of_a_cubic(void)
{
    const murk_cubic cubics[] = {{{1, 0, 0, 0}},
                                 {{0, 1, 0, 0}},
                                 {{1, -1, 0, 0}},
                                 {{0, 0, 1, 0}},
                                 {{0, 0, 0, 1}},
                                 {{1, -3, 3, -1}},
                                 {{0.25, -1, 1, 0}},
                                 {{1e-300, 0, 0, 1e300}},
                                 {{1e-30, 1e-30, 2e-30, 1e-31}},
                                 {{1e30, -2e30, 1e30, 0}},
                                 {{1, -1, 1e-20, 0}}};
    const double shares[] = {1e-300, 1e-16, 1e-9, 0.1, 0.5, 0.9, 1 - 1e-9, 1};
    for (size_t i = 0; i < sizeof cubics / sizeof *cubics; ++i) {
        for (size_t k = 0; k < sizeof shares / sizeof *shares; ++k) {
            /* some ten roundings of the whole */
            CHECK_NEAR(reached(&cubics[i], shares[k]), shares[k],
                       16 * DBL_EPSILON);
        }
    }
    const murk_cubic nothing = {{0}}, bad = {{NAN, 0, 0, 0}};
    CHECK(murk_cubic_reach(&nothing, 0.5) == 0.5);
    CHECK(murk_cubic_reach(&bad, 0.5) == 0.5);
    CHECK(murk_cubic_reach(&cubics[0], NAN) == 0);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    fill_samples(seed);
    test_random_rays_agree_with_the_twin(seed);
    test_the_field_at_points(seed);
    test_flight_and_depth_are_one_crossing(seed);
    test_all_sets_give_the_same_bits(seed);
    test_a_constant_is_added(seed);
    test_tiles_of_every_size();
    test_a_sparse_box_is_never_walked_through();
    test_the_root_of_a_cubic();
    return check_done();
}
