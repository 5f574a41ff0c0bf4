/* Grids in the world: placed, overlapping, mixed with homogeneous media. The
 * reference is the simple twin of the march (plain_grid.h), one grid at a
 * time; extinctions add.
 *
 * The flight test makes 10 z-tests with a 1e-6 chance of a false alarm per
 * seed together (Sidak); all else is deterministic. */
#include "base/rng.h"
#include "base/stats.h"
#include "check.h"
#include "medium/media.h"
#include "plain_grid.h"

#include <stdlib.h>

#define N      12
#define VOXELS (N * N * N)

static const murk_box DOMAIN = {{-50, -50, -50}, {50, 50, 50}};

/* Three grids of one size with transforms of their own. */
typedef struct grids {
    float density[3][VOXELS];
    murk_grid *grid[3];
} grids;

static grids all;

static void make_grids(uint32_t seed)
{
    const size_t size[3] = {N, N, N};
    for (uint32_t g = 0; g < 3; ++g) {
        for (uint32_t i = 0; i < VOXELS; ++i) {
            const murk_random4 r = murk_random(seed, MURK_TEST, i, g, 0);
            all.density[g][i] = r.u[1] < 0.3 ? (float)r.u[0] : 0;
        }
        murk_affine own = murk_affine_place(murk_vec(10.0 * g, 20, 30), 1,
                                            murk_vec(-4, 1.0 * g, -3));
        own.matrix[0][0] *= 0.5; /* voxels that are not cubes */
        own.matrix[1][0] *= 0.5;
        own.matrix[2][0] *= 0.5;
        murk_error err = {0};
        CHECK(murk_grid_from_samples(&all.grid[g], size, all.density[g], &own,
                                     "test", &err) == MURK_OK);
        CHECK_TEXT(err.text, "");
    }
}

static murk_medium medium(const murk_grid *grid, double extinction_per_m,
                          double albedo)
{
    return (murk_medium){.extinction_per_m =
                             murk_spectrum_flat(extinction_per_m, 1),
                         .albedo = murk_spectrum_flat(albedo, 1),
                         .grid = grid};
}

static murk_region lies(size_t number, const murk_grid *grid)
{
    return (murk_region){.medium = number,
                         .shape =
                             grid ? MURK_REGION_GRID : MURK_REGION_EVERYWHERE,
                         .to_world = murk_affine_identity()};
}

static murk_media *build(const murk_medium *media, const murk_region *regions,
                         size_t n)
{
    murk_media *out = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&out, media, n, regions, n, &DOMAIN, &err) ==
          MURK_OK);
    CHECK_TEXT(err.text, "");
    return out;
}

/* The twin in the world: the ray goes to index space, its parameter stays. */
static double plain_depth(const murk_medium *of, const murk_region *region,
                          const float *density, murk_vec3 from, murk_vec3 along,
                          double length)
{
    const plain_grid plain = {{N, N, N}, density};
    const murk_affine to_world = murk_affine_compose(
        &region->to_world, &murk_grid_describe(of->grid)->index_to_world);
    murk_affine to_index;
    CHECK(murk_affine_invert(&to_world, &to_index));
    return of->extinction_per_m.band[0] *
           plain_line_integral(&plain, murk_affine_point(&to_index, from),
                               murk_affine_direction(&to_index, along), length);
}

typedef struct line {
    murk_vec3 from, along;
    double length;
} line;

static line random_line(uint32_t seed, uint64_t i)
{
    const murk_random4 a = murk_random(seed, MURK_TEST, i, 10, 0);
    const murk_random4 b = murk_random(seed, MURK_TEST, i, 11, 0);
    const murk_vec3 from = {24 * a.u[0] - 12, 24 * a.u[1] - 12,
                            24 * a.u[2] - 12};
    const murk_vec3 to = {10 * b.u[0] - 5, 10 * b.u[1] - 2, 10 * b.u[2] - 3};
    const murk_vec3 offset = murk_sub(to, from);
    return (line){from, murk_unit(offset), 2 * murk_length(offset)};
}

/* One, two and three grids at once, with haze between: the sum of the
 * twins. */
static void test_overlapping_grids_add(uint32_t seed)
{
    /* Three grids, one of them turned, and haze. */
    const murk_medium media[] = {
        medium(all.grid[0], 0.5, 1), medium(all.grid[1], 1.5, 0.5),
        medium(NULL, 0.01, 0.25), medium(all.grid[2], 0.25, 0)};
    murk_region regions[] = {lies(0, all.grid[0]), lies(1, all.grid[1]),
                             lies(2, NULL), lies(3, all.grid[2])};
    regions[1].to_world =
        murk_affine_place(murk_vec(0, 0, 45), 1.5, murk_vec(1, 1, 0));
    murk_media *together = build(media, regions, 4);
    double maximum = 0;
    for (uint64_t i = 0; i < 200; ++i) {
        /* Depth of a random line against the sum of the plain twins. */
        const line ray = random_line(seed, i);
        const double even = 0.01 * ray.length;
        double want = even;
        want += plain_depth(&media[0], &regions[0], all.density[0], ray.from,
                            ray.along, ray.length);
        want += plain_depth(&media[1], &regions[1], all.density[1], ray.from,
                            ray.along, ray.length);
        want += plain_depth(&media[3], &regions[3], all.density[2], ray.from,
                            ray.along, ray.length);
        const double got = murk_media_optical_depth(together, 0, 0, ray.from,
                                                    ray.along, ray.length);
        CHECK_NEAR(got, want, 1e-12);
        maximum = fmax(maximum, got - even);

        /* A free flight of part of this depth ends where the depth is
         * reached, with the coefficients of that place. */
        const murk_random4 r = murk_random(seed, MURK_TEST, i, 12, 0);
        const double tau = r.u[0] * got;
        murk_collision c;
        CHECK(murk_media_fly(together, 0, 0, ray.from, ray.along, ray.length,
                             tau, r.u[1], &c));
        CHECK_NEAR(murk_media_optical_depth(together, 0, 0, ray.from, ray.along,
                                            c.distance_m),
                   tau, 1e-12);
        const murk_vec3 at = murk_along(ray.from, c.distance_m, ray.along);
        CHECK_NEAR(c.scattering_per_m,
                   murk_media_scattering(together, 0, 0, at), 1e-12);
        CHECK(murk_media_extinction(together, 0, 0, at) > 0);
        /* A flight of slightly more than the depth does not collide;
         * transmittance is exp(-depth). */
        CHECK(!murk_media_fly(together, 0, 0, ray.from, ray.along, ray.length,
                              got * (1 + 1e-9), r.u[1], &c));
        CHECK_NEAR(murk_media_transmittance(
                       together, 0, 0, ray.from,
                       murk_along(ray.from, ray.length, ray.along)),
                   exp(-got), 1e-12);
    }
    CHECK(maximum > 1);
    murk_media_destroy(together);
}

/* A region that replaces hides the grid within the region; a later grid is
 * not hidden. */
static void test_a_box_replaces_a_grid(uint32_t seed)
{
    /* A grid, a box that replaces, and a later grid. */
    const murk_medium media[] = {medium(all.grid[0], 1, 1),
                                 medium(NULL, 0.125, 1),
                                 medium(all.grid[2], 1, 1)};
    murk_region regions[] = {lies(0, all.grid[0]), lies(1, NULL),
                             lies(2, all.grid[2])};
    regions[1].shape = MURK_REGION_BOX;
    regions[1].replaces = true;
    regions[1].box = (murk_box){{-3, -1, -2}, {4, 5, 6}};
    murk_media *hidden = build(media, regions, 3);
    double cut_off = 0;
    for (uint64_t i = 0; i < 100; ++i) {
        const line ray = random_line(seed, i);
        /* The part of the line in the box; a line beside the box has none. */
        double t0 = 0, t1 = ray.length;
        if (!murk_box_clip(&regions[1].box, ray.from, ray.along, &t0, &t1)) {
            t0 = t1 = ray.length;
        }
        /* The first grid counts before and behind the box, the last one
         * everywhere. */
        const murk_vec3 leaves = murk_along(ray.from, t1, ray.along);
        const double inside = plain_depth(
            &media[0], &regions[0], all.density[0],
            murk_along(ray.from, t0, ray.along), ray.along, t1 - t0);
        const double want = plain_depth(&media[0], &regions[0], all.density[0],
                                        ray.from, ray.along, t0) +
                            0.125 * (t1 - t0) +
                            plain_depth(&media[0], &regions[0], all.density[0],
                                        leaves, ray.along, ray.length - t1) +
                            plain_depth(&media[2], &regions[2], all.density[2],
                                        ray.from, ray.along, ray.length);
        CHECK_NEAR(murk_media_optical_depth(hidden, 0, 0, ray.from, ray.along,
                                            ray.length),
                   want, 1e-12);
        cut_off += inside;
    }
    /* The box hid a part of the grid. */
    CHECK(cut_off > 10);
    murk_media_destroy(hidden);
}

/* Turning grid and ray together changes nothing; growing both by s makes
 * the path s times longer, and so the optical depth. */
static void test_moves_with_its_placement(uint32_t seed)
{
    /* The same grid where it lies, and moved. */
    const murk_medium smoke = medium(all.grid[0], 2, 1);
    const murk_region still = lies(0, all.grid[0]);
    murk_region moved = still;
    const double grown = 2.5;
    moved.to_world =
        murk_affine_place(murk_vec(25, -130, 77), grown, murk_vec(-8, 3, 11));
    murk_media *a = build(&smoke, &still, 1), *b = build(&smoke, &moved, 1);
    for (uint64_t i = 0; i < 200; ++i) {
        /* Depth of a line, and of the moved line in the moved grid. */
        const line ray = random_line(seed, i);
        const double want =
            murk_media_optical_depth(a, 0, 0, ray.from, ray.along, ray.length);
        const double got = murk_media_optical_depth(
            b, 0, 0, murk_affine_point(&moved.to_world, ray.from),
            murk_unit(murk_affine_direction(&moved.to_world, ray.along)),
            grown * ray.length);
        /* Depth grows with the length; the extinction at the middle is the
         * same. */
        CHECK_NEAR(got, grown * want, 1e-11);
        CHECK_NEAR(
            murk_media_extinction(
                b, 0, 0,
                murk_affine_point(
                    &moved.to_world,
                    murk_along(ray.from, ray.length / 2, ray.along))),
            murk_media_extinction(
                a, 0, 0, murk_along(ray.from, ray.length / 2, ray.along)),
            0);
    }
    /* Bounds are finite. */
    const murk_box box = murk_media_bounds(b);
    CHECK(box.min.x < box.max.x && isfinite(box.max.z));
    murk_media_destroy(a);
    murk_media_destroy(b);
}

/* Counts flights through one column of twelve voxels with the densities
 * 0..3 four times over: the numbers of flights that collide in each voxel
 * and that pass follow the exponential law. */
static void count_flights(uint32_t seed, double extinction_per_m,
                          double *counts, int n)
{
    /* The column as a medium. */
    const size_t size[3] = {N, 1, 1};
    const float column[N] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    const murk_affine identity = murk_affine_identity();
    murk_grid *grid = NULL;
    CHECK(murk_grid_from_samples(&grid, size, column, &identity, "test",
                                 NULL) == MURK_OK);
    const murk_medium smoke = medium(grid, extinction_per_m, 1);
    const murk_region region = lies(0, grid);
    murk_media *media = build(&smoke, &region, 1);
    /* counts[N] is of flights that pass. */
    for (int i = 0; i <= N; ++i) {
        counts[i] = 0;
    }
    for (int i = 0; i < n; ++i) {
        /* Fly along the column from 1 m before the first voxel. */
        const murk_random4 r = murk_random(seed, MURK_TEST, (uint64_t)i, 20, 0);
        murk_collision c;
        const bool hits =
            murk_media_fly(media, 0, 0, murk_vec(-1.5, 0, 0), murk_vec(1, 0, 0),
                           99, -log(r.u[0]), r.u[1], &c);
        counts[hits ? (int)(c.distance_m - 1) : N] += 1;
    }
    murk_media_destroy(media);
    murk_grid_destroy(grid);
}

static double worst_of_flights(uint32_t seed, double extinction_per_m)
{
    const int n = 100000;
    double counts[N + 1], left = 1, worst = 0;
    count_flights(seed, extinction_per_m, counts, n);
    for (int i = 0; i <= N; ++i) {
        const double share = i == N ? left : left * (1 - exp(-0.1 * (i % 4)));
        left -= i == N ? 0 : share;
        if (share == 0) {
            CHECK(counts[i] == 0);
            continue;
        }
        worst = fmax(worst, sigmas_off(counts[i], n * share,
                                       sqrt(n * share * (1 - share))));
    }
    return worst;
}

static void test_flights_follow_the_exponential_law(uint32_t seed)
{
    const double limit = murk_sidak_limit(1e-6, 10);
    CHECK(worst_of_flights(seed, 0.1) < limit);
    /* Teeth: 4 % more extinction must not get through. */
    CHECK(worst_of_flights(seed, 0.104) > limit);
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    make_grids(seed);
    test_overlapping_grids_add(seed);
    test_a_box_replaces_a_grid(seed);
    test_moves_with_its_placement(seed);
    test_flights_follow_the_exponential_law(seed);
    for (int i = 0; i < 3; ++i) {
        murk_grid_destroy(all.grid[i]);
    }
    return check_done();
}
