/* Case flight: free flights by delta tracking against free flights by march,
 * through density grids, nearest and linear, one thread.
 *
 *   bench_flight [--edge N] [FILE.vdb]...     N: voxels along a brick
 *
 * Rays start anywhere in the grid's box and go any way until they leave it, as
 * scattered light does; the extinction is such that they meet a mean optical
 * depth of .3, 3 and 30. Timings alternate; the figure is the median. The two
 * must agree on how many flights collide. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "medium/delta.h"
#include "times.h"

#define RAYS 40000

static const double DEPTHS[] = {.3, 3, 30};

typedef struct contest {
    const char *file;
    const murk_grid *grid;
    murk_interpolation interpolation;
    int32_t edge; /* 0: the usual one */
    murk_media *media;
    murk_box box;
    double collided[2], nulls;
} contest;

static _Noreturn void stop(const char *file, const char *why)
{
    fprintf(stderr, "bench_flight: %s: %s\n", file, why);
    exit(1);
}

static murk_media *media_of(const contest *c, double extinction_per_m)
{
    const char *file = c->file;
    murk_media *media = NULL;
    murk_error err = {0};
    murk_medium medium = {
        .grid = c->grid, .interpolation = c->interpolation, .where = file};
    medium.extinction_per_m.band[0] = extinction_per_m;
    const murk_region region = {.shape = MURK_REGION_GRID,
                                .to_world = murk_affine_identity(),
                                .where = file};
    const murk_box domain = {murk_vec(-1e6, -1e6, -1e6),
                             murk_vec(1e6, 1e6, 1e6)};
    if (murk_media_create(&media, &medium, 1, &region, 1, &domain, &err) ||
        (c->edge > 0 ? murk_delta_prepare(media, c->edge, 1, &err)
                     : murk_media_prepare_delta(media, &err))) {
        stop(file, err.text);
    }
    return media;
}

static void ray_of(const murk_box *box, uint64_t i, murk_vec3 *from,
                   murk_vec3 *along)
{
    const murk_random4 a = murk_random(1, MURK_TEST, i, 0, 0);
    const murk_random4 b = murk_random(1, MURK_TEST, i, 0, 1);
    const murk_vec3 size = murk_sub(box->max, box->min);
    *from = murk_vec(box->min.x + a.u[0] * size.x, box->min.y + a.u[1] * size.y,
                     box->min.z + a.u[2] * size.z);
    *along =
        murk_about(murk_vec(0, 0, 1), 2 * b.u[0] - 1, 2 * MURK_PI * b.u[1]);
}

static double mean_depth(const contest *c)
{
    double sum = 0;
    for (uint64_t i = 0; i < RAYS; ++i) {
        murk_vec3 from, along;
        ray_of(&c->box, i, &from, &along);
        sum += murk_media_optical_depth(c->media, 0, 0, from, along, INFINITY);
    }
    return sum / RAYS;
}

static void fly(contest *c, bool by_delta, bench_times *times, int repeat)
{
    const bench_moment begun = bench_now();
    for (uint64_t i = 0; i < RAYS; ++i) {
        murk_vec3 from, along;
        ray_of(&c->box, i, &from, &along);
        const murk_address address = {1, MURK_TEST, i, 1};
        const murk_random4 r = murk_random_at(&address, 0);
        murk_collision met;
        murk_flight_randoms dice = {.address = &address};
        c->collided[by_delta] +=
            by_delta ? murk_delta_fly(c->media, 0, 0, from, along, INFINITY,
                                      -log(r.u[0]), r.u[1], &dice, &met)
                     : murk_media_fly(c->media, 0, 0, from, along, INFINITY,
                                      -log(r.u[0]), r.u[1], &met);
        c->nulls += dice.nulls;
    }
    bench_add(times, repeat, begun);
}

static void run(contest c, double depth)
{
    c.media = media_of(&c, 1);
    c.box = murk_media_bounds(c.media);
    const double extinction = depth / mean_depth(&c);
    murk_media_destroy(c.media);
    c.media = media_of(&c, extinction);
    bench_times march = {0}, delta = {0};
    for (int i = 0; i < BENCH_REPEATS; ++i) {
        fly(&c, false, &march, i);
        fly(&c, true, &delta, i);
    }
    murk_media_destroy(c.media);
    const char *slash = strrchr(c.file, '/');
    char reference[256];
    snprintf(reference, sizeof reference, "march, %s, %s, depth %g",
             slash ? slash + 1 : c.file,
             c.interpolation == MURK_LINEAR ? "linear" : "nearest", depth);
    fprintf(stderr, "flight, %s: %.1f null collisions a flight\n", reference,
            c.nulls / RAYS / BENCH_REPEATS);
    bench_print(&(bench_row){.name = "flight",
                             .unit = "flights/s",
                             .reference = reference,
                             .threads = 1,
                             .work = RAYS,
                             .reference_work = RAYS,
                             .ours = &delta,
                             .theirs = &march});
    /* The same rays, other numbers but for the first of each. */
    const double share = c.collided[0] / RAYS / BENCH_REPEATS;
    const double sigma = sqrt(2. * RAYS * share * (1 - share)) * BENCH_REPEATS;
    if (!(fabs(c.collided[0] - c.collided[1]) <= 5 * sigma)) {
        stop(c.file, "march and delta do not agree");
    }
}

int main(int argc, char **argv)
{
    static const char *const usual[] = {"media/smoke_r64_f50.vdb",
                                        "../shared/data/vdb/arnold_smoke.vdb"};
    /* Options: the edge length of the majorant blocks, then the grids. */
    int32_t edge = 0;
    if (argc > 2 && strcmp(argv[1], "--edge") == 0) {
        edge = (int32_t)strtol(argv[2], NULL, 10);
        argv += 2;
        argc -= 2;
    }
    const char *const *files = argc > 1 ? (const char *const *)&argv[1] : usual;
    const int n = argc > 1 ? argc - 1 : 2;
    /* Each grid at each optical depth, with nearest and with linear
     * interpolation. */
    for (int i = 0; i < n; ++i) {
        murk_grid *grid = NULL;
        murk_error err = {0};
        if (files == usual && i > 0 && access(files[i], R_OK) != 0) {
            fprintf(stderr, "bench_flight: %s is not there: left out\n",
                    files[i]);
            continue;
        }
        if (murk_grid_read(&grid, files[i], NULL, files[i], &err)) {
            stop(files[i], err.text);
        }
        for (size_t k = 0; k < sizeof DEPTHS / sizeof *DEPTHS; ++k) {
            const contest c = {.file = files[i], .grid = grid, .edge = edge};
            contest linear = c;
            linear.interpolation = MURK_LINEAR;
            run(c, DEPTHS[k]);
            run(linear, DEPTHS[k]);
        }
        murk_grid_destroy(grid);
    }
    return 0;
}
