/* march: line integrals through density grids against the bare loop that
 * anybody would write with PNanoVDB.h (its hierarchical DDA, in single
 * precision), on the same buffer and the same rays.
 *
 *   bench_march [FILE.vdb]...
 *
 * Rays run from a sphere about the grid through a random point of its box and
 * out on the other side. Timings alternate; the bench fails when the two
 * disagree. The library's other way in, optical depth through a medium placed
 * in the world, is timed as `march-world`; the same with trilinear
 * interpolation as `march-linear`, against a plain loop over dense samples
 * (peer_march.h), and as `march-linear-nearest` against march-world, so murk
 * against murk on the same grid. */
#include "base/pool.h"
#include "base/rng.h"
#include "grid_line.h"
#include "medium/grid.h"
#include "medium/media.h"
#include "peer_march.h"
#include "times.h"

#define PNANOVDB_C
#define PNANOVDB_HDDA
#include <nanovdb/PNanoVDB.h>

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define RAYS    65536
#define BATCH   1024
#define WORKERS 2

/* A ray in index space, where voxel i covers [i - 1/2, i + 1/2]. */
typedef struct ray {
    float origin[3], direction[3], length;
} ray;

typedef struct contest {
    const char *file;
    murk_grid *grid;
    murk_media *media;  /* the grid as a medium, where its transform puts it */
    murk_media *smooth; /* the same, trilinear */
    pnanovdb_buf_t buffer;
    dense_field dense; /* the samples once more, from `corner` on */
    int corner[3];
    ray rays[RAYS];
    murk_vec3 world_origin[RAYS], world_direction[RAYS];
    double world_length_m[RAYS];
    double ours[RAYS], bare[RAYS], world[RAYS], linear[RAYS], plain[RAYS];
} contest;

static _Noreturn void stop(const char *file, const char *why)
{
    fprintf(stderr, "bench_march: %s: %s\n", file, why);
    exit(1);
}

/* ---- the bare loop ---- */

static pnanovdb_vec3_t vec3(const float v[3], float add)
{
    return (pnanovdb_vec3_t){v[0] + add, v[1] + add, v[2] + add};
}

/* One step a cell, whatever its size: its value times the length in it. */
static double bare_integral(pnanovdb_buf_t buffer, const ray *r)
{
    pnanovdb_grid_handle_t grid = {{0}};
    const pnanovdb_root_handle_t root =
        pnanovdb_tree_get_root(buffer, pnanovdb_grid_get_tree(buffer, grid));
    pnanovdb_readaccessor_t accessor;
    pnanovdb_readaccessor_init(&accessor, root);

    /* Clip the ray to the bounding box of the active voxels. */
    pnanovdb_vec3_t origin = vec3(r->origin, 0.5f);
    pnanovdb_vec3_t direction = vec3(r->direction, 0);
    const pnanovdb_coord_t first = pnanovdb_root_get_bbox_min(buffer, root);
    const pnanovdb_coord_t last = pnanovdb_root_get_bbox_max(buffer, root);
    pnanovdb_vec3_t low = {(float)first.x, (float)first.y, (float)first.z};
    pnanovdb_vec3_t high = {(float)last.x + 1, (float)last.y + 1,
                            (float)last.z + 1};
    float start = 0, end = r->length;
    if (!pnanovdb_hdda_ray_clip(&low, &high, &origin, &start, &direction,
                                &end) ||
        !(start < end)) {
        return 0;
    }

    /* Step from leaf to leaf and voxel to voxel, and add value times
     * length. */
    pnanovdb_vec3_t at = pnanovdb_hdda_ray_start(&origin, start, &direction);
    pnanovdb_coord_t voxel = pnanovdb_hdda_pos_to_ijk(&at);
    pnanovdb_hdda_t walk;
    pnanovdb_hdda_init(
        &walk, &origin, start, &direction, end,
        (int)pnanovdb_readaccessor_get_dim(PNANOVDB_GRID_TYPE_FLOAT, buffer,
                                           &accessor, &voxel));
    double sum = 0;
    for (bool more = true; more;) {
        pnanovdb_hdda_update(
            &walk, &origin, &direction,
            (int)pnanovdb_readaccessor_get_dim(PNANOVDB_GRID_TYPE_FLOAT, buffer,
                                               &accessor, &walk.voxel));
        const float density =
            pnanovdb_read_float(buffer, pnanovdb_readaccessor_get_value_address(
                                            PNANOVDB_GRID_TYPE_FLOAT, buffer,
                                            &accessor, &walk.voxel));
        const float from = walk.tmin;
        more = pnanovdb_hdda_step(&walk);
        sum += (double)density * (fminf(walk.tmin, end) - from);
    }
    return sum;
}

/* ---- what is timed ---- */

static void ours_batch(void *context, uint64_t batch)
{
    contest *c = context;
    for (size_t i = batch * BATCH; i < (batch + 1) * BATCH; ++i) {
        const ray *r = &c->rays[i];
        c->ours[i] = grid_line_integral(
            c->grid, murk_vec(r->origin[0], r->origin[1], r->origin[2]),
            murk_vec(r->direction[0], r->direction[1], r->direction[2]),
            r->length);
    }
}

static void bare_batch(void *context, uint64_t batch)
{
    contest *c = context;
    for (size_t i = batch * BATCH; i < (batch + 1) * BATCH; ++i) {
        c->bare[i] = bare_integral(c->buffer, &c->rays[i]);
    }
}

static void world_batch(void *context, uint64_t batch)
{
    contest *c = context;
    for (size_t i = batch * BATCH; i < (batch + 1) * BATCH; ++i) {
        c->world[i] = murk_media_optical_depth(
            c->media, 0, 0, c->world_origin[i], c->world_direction[i],
            c->world_length_m[i]);
    }
}

static void linear_batch(void *context, uint64_t batch)
{
    contest *c = context;
    for (size_t i = batch * BATCH; i < (batch + 1) * BATCH; ++i) {
        c->linear[i] = murk_media_optical_depth(
            c->smooth, 0, 0, c->world_origin[i], c->world_direction[i],
            c->world_length_m[i]);
    }
}

static void plain_batch(void *context, uint64_t batch)
{
    contest *c = context;
    for (size_t i = batch * BATCH; i < (batch + 1) * BATCH; ++i) {
        const ray *r = &c->rays[i];
        const float origin[3] = {r->origin[0] - (float)c->corner[0],
                                 r->origin[1] - (float)c->corner[1],
                                 r->origin[2] - (float)c->corner[2]};
        c->plain[i] =
            dense_field_integral(&c->dense, origin, r->direction, r->length);
    }
}

static void time_of(murk_job job, contest *c, unsigned threads,
                    bench_times *times, int repeat)
{
    const bench_moment begun = bench_now();
    murk_pool_run(threads, RAYS / BATCH, job, c);
    bench_add(times, repeat, begun);
}

/* ---- setting up ---- */

/* Coordinates on a raster of 2^-10 voxels, so that the shift by a half is
 * exact in single precision as well. */
static float on_raster(double x)
{
    return (float)(nearbyint(x * 1024) / 1024);
}

static void make_rays(contest *c)
{
    const murk_grid_facts *facts = murk_grid_describe(c->grid);
    double low[3], size[3], radius = 0;
    /* A sphere around the bounding box of the grid, in index space. */
    for (int a = 0; a < 3; ++a) {
        low[a] = (double)facts->index_min[a] - 0.5;
        size[a] = (double)(facts->index_max[a] - facts->index_min[a] + 1);
        radius += size[a] * size[a] / 4;
    }
    radius = 1.01 * sqrt(radius) + 1;
    /* Each ray goes from a random point of the sphere to a random point in
     * the box. */
    for (size_t i = 0; i < RAYS; ++i) {
        const murk_random4 at = murk_random(1, MURK_TEST, i, 0, 0);
        const murk_random4 aim = murk_random(1, MURK_TEST, i, 0, 1);
        const murk_vec3 out = murk_about(murk_vec(0, 0, 1), 2 * at.u[0] - 1,
                                         2 * MURK_PI * at.u[1]);
        const double outward[3] = {out.x, out.y, out.z};
        ray *r = &c->rays[i];
        double direction[3], length = 0;
        for (int a = 0; a < 3; ++a) {
            r->origin[a] =
                on_raster(low[a] + size[a] / 2 + radius * outward[a]);
            direction[a] = low[a] + size[a] * aim.u[a] - (double)r->origin[a];
            length += direction[a] * direction[a];
        }
        length = sqrt(length);
        for (int a = 0; a < 3; ++a) {
            r->direction[a] = (float)(direction[a] / length);
        }
        r->length = (float)(2 * radius);

        /* The same ray in world space, for murk. */
        const murk_affine *m = &facts->index_to_world;
        c->world_origin[i] = murk_affine_point(
            m, murk_vec(r->origin[0], r->origin[1], r->origin[2]));
        const murk_vec3 d = murk_affine_direction(
            m, murk_vec(r->direction[0], r->direction[1], r->direction[2]));
        c->world_length_m[i] = r->length * murk_length(d);
        c->world_direction[i] = murk_unit(d);
    }
}

/* Copies the active box and one layer of zeros around it. */
static void make_dense(contest *c)
{
    const murk_grid_facts *facts = murk_grid_describe(c->grid);
    int size[3];
    for (int a = 0; a < 3; ++a) {
        c->corner[a] = (int)facts->index_min[a] - 1;
        size[a] = (int)(facts->index_max[a] - facts->index_min[a]) + 3;
    }
    if (!dense_field_create(&c->dense, size)) {
        stop(c->file, "out of memory");
    }
    /* Read voxel by voxel, and find the bricks that are not empty. */
    pnanovdb_grid_handle_t grid = {{0}};
    pnanovdb_readaccessor_t accessor;
    pnanovdb_readaccessor_init(
        &accessor, pnanovdb_tree_get_root(
                       c->buffer, pnanovdb_grid_get_tree(c->buffer, grid)));
    float *sample = c->dense.sample;
    for (int z = 0; z < size[2]; ++z) {
        for (int y = 0; y < size[1]; ++y) {
            for (int x = 0; x < size[0]; ++x) {
                const pnanovdb_coord_t at = {c->corner[0] + x, c->corner[1] + y,
                                             c->corner[2] + z};
                *sample++ = pnanovdb_read_float(
                    c->buffer,
                    pnanovdb_readaccessor_get_value_address(
                        PNANOVDB_GRID_TYPE_FLOAT, c->buffer, &accessor, &at));
            }
        }
    }
    dense_field_prepare(&c->dense);
}

static void set_up(contest *c, const char *file)
{
    murk_error err = {0};
    c->file = file;
    if (murk_grid_read(&c->grid, file, NULL, file, &err)) {
        stop(file, err.text);
    }
    const void *grid = murk_grid_nanovdb(c->grid);
    if (!grid) {
        stop(file, "the grid is empty");
    }
    c->buffer = pnanovdb_make_buf((uint32_t *)grid, 0); /* only read */
    make_rays(c);
    make_dense(c);

    murk_medium medium = {.grid = c->grid, .where = file};
    medium.extinction_per_m.band[0] = 1;
    const murk_region region = {.shape = MURK_REGION_GRID,
                                .to_world = murk_affine_identity(),
                                .where = file};
    const murk_box domain = {murk_vec(-1e6, -1e6, -1e6),
                             murk_vec(1e6, 1e6, 1e6)};
    if (murk_media_create(&c->media, &medium, 1, &region, 1, &domain, &err)) {
        stop(file, err.text);
    }
    medium.interpolation = MURK_LINEAR;
    if (murk_media_create(&c->smooth, &medium, 1, &region, 1, &domain, &err)) {
        stop(file, err.text);
    }
}

/* The bare loop counts in single precision: each of its boundaries is off by a
 * few units in the last place of the distance, at either side of which the
 * density differs by no more than its maximum. That bounds one ray; all rays
 * together must agree to 1e-5. */
static void compare_answers(const contest *c)
{
    const murk_grid_facts *facts = murk_grid_describe(c->grid);
    double ours = 0, bare = 0, world = 0, linear = 0, plain = 0;
    for (size_t i = 0; i < RAYS; ++i) {
        const double reach = 2 * (double)c->rays[i].length;
        const double bound = 8 * FLT_EPSILON * reach * reach * facts->maximum;
        if (!(fabs(c->ours[i] - c->bare[i]) <= bound)) {
            fprintf(stderr, "bench_march: ray %zu: %.9g, bare loop %.9g\n", i,
                    c->ours[i], c->bare[i]);
            stop(c->file, "one ray's integrals differ");
        }
        ours += c->ours[i];
        bare += c->bare[i];
        world += c->world[i] / c->world_length_m[i] * c->rays[i].length;
        linear += c->linear[i] / c->world_length_m[i] * c->rays[i].length;
        plain += c->plain[i];
    }
    /* The sums of nearest samples, and those of the trilinear field. */
    if (!(fabs(bare / ours - 1) <= 1e-5 && fabs(world / ours - 1) <= 1e-5)) {
        fprintf(stderr, "bench_march: sums: %.9g, bare %.9g, world %.9g\n",
                ours, bare, world);
        stop(c->file, "the integrals differ");
    }
    if (!(fabs(linear / plain - 1) <= 1e-5)) {
        fprintf(stderr, "bench_march: linear sums: %.9g, plain loop %.9g\n",
                linear, plain);
        stop(c->file, "the linear integrals differ");
    }
}

static void tear_down(contest *c)
{
    murk_media_destroy(c->media);
    murk_media_destroy(c->smooth);
    murk_grid_destroy(c->grid);
    dense_field_release(&c->dense);
}

/* ---- the cases ---- */

static void print_case(const char *name, const char *reference,
                       const contest *c, unsigned threads,
                       const bench_times *ours, const bench_times *theirs)
{
    const char *slash = strrchr(c->file, '/');
    char text[256];
    snprintf(text, sizeof text, "%s, %s", reference,
             slash ? slash + 1 : c->file);
    bench_print(&(bench_row){.name = name,
                             .unit = "rays/s",
                             .reference = text,
                             .threads = threads,
                             .work = RAYS,
                             .reference_work = RAYS,
                             .ours = ours,
                             .theirs = theirs});
}

static void run(contest *c, unsigned threads)
{
    bench_times ours = {0}, bare = {0}, world = {0}, linear = {0}, plain = {0};
    for (int repeat = 0; repeat < BENCH_REPEATS; ++repeat) {
        time_of(ours_batch, c, threads, &ours, repeat);
        time_of(bare_batch, c, threads, &bare, repeat);
        time_of(world_batch, c, threads, &world, repeat);
        time_of(linear_batch, c, threads, &linear, repeat);
        time_of(plain_batch, c, threads, &plain, repeat);
        compare_answers(c);
    }
    print_case("march", "bare PNanoVDB DDA", c, threads, &ours, &bare);
    print_case("march-world", "bare PNanoVDB DDA", c, threads, &world, &bare);
    print_case("march-linear", "plain dense loop", c, threads, &linear, &plain);
    print_case("march-linear-nearest", "march-world", c, threads, &linear,
               &world);
}

int main(int argc, char **argv)
{
    static const char *const usual[] = {"media/smoke_r64_f50.vdb",
                                        "../shared/data/vdb/arnold_smoke.vdb"};
    const char *const *files = argc > 1 ? (const char *const *)&argv[1] : usual;
    const int n = argc > 1 ? argc - 1 : 2;
    /* Grids are read in child processes: all of them before any thread. */
    contest *contests = calloc((size_t)n, sizeof *contests);
    if (!contests) {
        stop("rays", "out of memory");
    }
    int found = 0;
    for (int i = 0; i < n; ++i) {
        if (files == usual && i > 0 && access(files[i], R_OK) != 0) {
            fprintf(stderr, "bench_march: %s is not there: left out\n",
                    files[i]);
            continue;
        }
        set_up(&contests[found++], files[i]);
    }
    for (int i = 0; i < found; ++i) {
        for (unsigned threads = 1; threads <= WORKERS; ++threads) {
            run(&contests[i], threads);
        }
        tear_down(&contests[i]);
    }
    free(contests);
    return 0;
}
