/* kd-query, kd-sums and kd-build: the photon map against nanoflann.
 *
 *   bench_kd [light.murk]
 *   bench_kd --even RADIUS THREADS
 *
 * On the surface and volume maps of the file, else on 1e6 photon-like points:
 * walls of rooms and clusters in the air. Queries are at the maps' own photons
 * in random order, with the radius of each map that finds about 50: kd-query
 * lists the photons within, kd-sums only counts them. nanoflann gets its points
 * packed, its best leaf size of those tried (for queries and for building
 * apart), and unsorted results. Timings of both alternate.
 *
 * --even: counts alone, once after a warm-up, around the 1e6 points and with
 * the queries of the ceiling kdtree.c, evenly in a cube of side 1 m, in the
 * same order. The ceiling adds up a weight a point, too. Prints queries, hits
 * and times. */
#include "base/pool.h"
#include "base/rng.h"
#include "peer_kd.h"
#include "photonmap/map.h"
#include "photonmap/map_file.h"
#include "times.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define POINTS       1000000
#define HITS         50.0
#define QUERIES      65536
#define EVEN_QUERIES 102400
#define BATCH        1024
#define WORKERS      2

static const size_t leaf_sizes[] = {10, 16, 24, 32, 64};
#define LEAF_SIZES (sizeof leaf_sizes / sizeof leaf_sizes[0])

/* One map, ours and the peer's, and its queries. */
typedef struct contest {
    murk_photon *photons; /* as given */
    size_t n;
    float *points; /* [3 n] */
    murk_photon_map *map;
    peer_kd *peer;
    size_t queries; /* a multiple of BATCH */
    float *centers; /* [3 queries] */
    double radius_m;
    uint32_t *found[WORKERS]; /* [n] each */
    size_t hits[EVEN_QUERIES / BATCH];
} contest;

static _Noreturn void stop(const char *why)
{
    fprintf(stderr, "bench_kd: %s\n", why);
    exit(1);
}

static void *allocate(size_t size)
{
    void *memory = malloc(size + 1);
    if (!memory) {
        stop("out of memory");
    }
    return memory;
}

/* ---- the points ---- */

/* Six in ten on floors, ceilings and walls of 4 x 4 rooms of 6 x 5 x 3 m, the
 * others in 24 clouds of different sizes. */
static void place(float p[3], uint64_t i)
{
    const double size[3] = {6, 5, 3};
    const murk_random4 r = murk_random(1, MURK_TEST, i, 0, 0);
    const murk_random4 s = murk_random(1, MURK_TEST, i, 1, 0);
    if (i % 10 < 6) {
        const int side = (int)(6 * s.u[0]);
        for (int a = 0; a < 3; ++a) {
            const double u = side / 2 == a ? side % 2 : r.u[a];
            const double column = a < 2 ? (double)(int)(4 * s.u[a + 1]) : 0;
            p[a] = (float)(size[a] * (column + u));
        }
        return;
    }
    const uint64_t cloud = (uint64_t)(24 * s.u[3]);
    const murk_random4 c = murk_random(1, MURK_TEST, cloud, 2, 0);
    for (int a = 0; a < 3; ++a) {
        const double spread = r.u[a] + s.u[a] - 1; /* a triangle's density */
        p[a] = (float)(size[a] * ((a < 2 ? 4 : 1) * c.u[a] + c.u[3] * spread));
    }
}

static void make_points(contest *c)
{
    c->n = POINTS;
    c->photons = allocate(c->n * sizeof *c->photons);
    memset(c->photons, 0, c->n * sizeof *c->photons);
    for (size_t i = 0; i < c->n; ++i) {
        place(c->photons[i].position_m, i);
        c->photons[i].emitted = (uint32_t)i;
    }
}

static int compare_emitted(const void *a, const void *b)
{
    const murk_photon *p = a, *q = b;
    return p->emitted != q->emitted ? (p->emitted > q->emitted) * 2 - 1
                                    : memcmp(p, q, sizeof *p);
}

/* In the order of emission, as the tracer hands them over: the file has them in
 * tree order, which would spare both sides half of the work. */
static size_t read_maps(contest contests[2], const char *path)
{
    murk_section *sections = NULL;
    size_t n_sections = 0, n = 0;
    murk_error err = {0};
    if (murk_map_file_read(&sections, &n_sections, path, &err)) {
        fprintf(stderr, "bench_kd: %s: %s\n", err.where, err.text);
        exit(2);
    }
    const char *names[] = {"surface", "volume"};
    for (int i = 0; i < 2; ++i) {
        const murk_section *section =
            murk_map_file_find(sections, n_sections, names[i]);
        if (section && section->size >= 1000 * sizeof(murk_photon)) {
            contest *c = &contests[n++];
            c->n = section->size / sizeof(murk_photon);
            c->photons = allocate(section->size);
            memcpy(c->photons, section->bytes, section->size);
            qsort(c->photons, c->n, sizeof *c->photons, compare_emitted);
        }
    }
    murk_map_file_release(sections, n_sections);
    return n;
}

/* ---- one map ---- */

static murk_photon_map *build(const contest *c, unsigned threads,
                              bench_times *times, int repeat)
{
    murk_photon *photons = allocate(c->n * sizeof *photons);
    murk_photon_map *map = NULL;
    memcpy(photons, c->photons, c->n * sizeof *photons);
    const bench_moment begun = bench_now();
    if (murk_photon_map_create(&map, photons, c->n, threads, NULL)) {
        stop("no map");
    }
    bench_add(times, repeat, begun);
    return map;
}

static murk_vec3 center_of(const contest *c, size_t query)
{
    const float *p = c->centers + 3 * query;
    return murk_vec((double)p[0], (double)p[1], (double)p[2]);
}

static void find_radius(contest *c)
{
    double low = 1e-6, high = 1e3;
    for (int step = 0; step < 40; ++step) {
        double hits = 0;
        c->radius_m = sqrt(low * high);
        for (size_t i = 0; i < 4096; ++i) {
            hits += (double)murk_photon_map_count_within(
                c->map, center_of(c, i), c->radius_m);
        }
        *(hits > HITS * 4096 ? &high : &low) = c->radius_m;
    }
}

static void batch_of_map(void *context, unsigned worker, uint64_t batch)
{
    contest *c = context;
    size_t hits = 0;
    for (size_t i = batch * BATCH; i < (batch + 1) * BATCH; ++i) {
        hits += murk_photon_map_within(c->map, center_of(c, i), c->radius_m,
                                       c->found[worker]);
    }
    c->hits[batch] = hits;
}

static void batch_of_sums(void *context, unsigned worker, uint64_t batch)
{
    contest *c = context;
    size_t hits = 0;
    (void)worker;
    for (size_t i = batch * BATCH; i < (batch + 1) * BATCH; ++i) {
        hits +=
            murk_photon_map_count_within(c->map, center_of(c, i), c->radius_m);
    }
    c->hits[batch] = hits;
}

static void batch_of_peer(void *context, unsigned worker, uint64_t batch)
{
    contest *c = context;
    (void)worker;
    c->hits[batch] = peer_kd_within(c->peer, c->centers + 3 * batch * BATCH,
                                    BATCH, (float)c->radius_m);
}

static void batch_of_peer_sums(void *context, unsigned worker, uint64_t batch)
{
    contest *c = context;
    (void)worker;
    c->hits[batch] = peer_kd_sums(c->peer, c->centers + 3 * batch * BATCH,
                                  BATCH, (float)c->radius_m);
}

/* Times all queries; returns the photons found in all. */
static size_t time_queries(contest *c, murk_worker_job job, unsigned threads,
                           bench_times *times, int repeat)
{
    const bench_moment begun = bench_now();
    murk_pool_run_workers(threads, c->queries / BATCH, job, c);
    bench_add(times, repeat, begun);
    size_t hits = 0;
    for (size_t i = 0; i < c->queries / BATCH; ++i) {
        hits += c->hits[i];
    }
    return hits;
}

/* Copies the positions, and takes query centres at some of them. */
static void set_centers(contest *c)
{
    /* Positions of the photons, and query centres at some of them. */
    c->points = allocate(3 * c->n * sizeof *c->points);
    c->queries = QUERIES;
    c->centers = allocate(3 * c->queries * sizeof *c->centers);
    for (size_t i = 0; i < c->n; ++i) {
        memcpy(c->points + 3 * i, c->photons[i].position_m,
               3 * sizeof *c->points);
    }
    for (size_t i = 0; i < c->queries; ++i) {
        const murk_random4 r = murk_random(2, MURK_TEST, i, 0, 0);
        memcpy(c->centers + 3 * i,
               c->points + 3 * (size_t)(r.u[0] * (double)c->n),
               3 * sizeof *c->centers);
    }
}

/* Builds ours, then the peer's with each leaf size, and keeps the one that
 * answers fastest. Returns that leaf size. */
static size_t prepare(contest *c)
{
    double best_s = INFINITY;
    size_t best = 0;
    bench_times built = {0};
    set_centers(c);
    for (int i = 0; i < WORKERS; ++i) {
        c->found[i] = allocate(c->n * sizeof *c->found[i]);
    }
    /* The tree of murk, and the radius that finds the wanted number of
     * photons. */
    c->map = build(c, 1, &built, 0);
    find_radius(c);
    /* The first timing of each leaf size only warms the caches. */
    for (size_t i = 0; i < LEAF_SIZES; ++i) {
        peer_kd *best_peer = c->peer;
        c->peer = peer_kd_create(c->points, c->n, leaf_sizes[i]);
        bench_times times = {0};
        time_queries(c, batch_of_peer, 1, &times, 0);
        time_queries(c, batch_of_peer, 1, &times, 1);
        if (times.clock_s[1] < best_s) {
            best_s = times.clock_s[1];
            best = leaf_sizes[i];
            peer_kd_destroy(best_peer);
        } else {
            peer_kd_destroy(c->peer);
            c->peer = best_peer;
        }
    }
    return best;
}

static void release(contest *c)
{
    free(c->photons);
    free(c->points);
    free(c->centers);
    for (int i = 0; i < WORKERS; ++i) {
        free(c->found[i]);
    }
    murk_photon_map_destroy(c->map);
    if (c->peer) {
        peer_kd_destroy(c->peer);
    }
}

/* ---- the cases ---- */

static void print_case(const char *name, const char *unit, double work,
                       size_t leaf, unsigned threads, const bench_times *ours,
                       const bench_times *peers)
{
    fprintf(stderr, "%s: best leaf size of nanoflann: %zu\n", name, leaf);
    bench_print(&(bench_row){.name = name,
                             .unit = unit,
                             .reference = "nanoflann, best leaf size",
                             .threads = threads,
                             .work = work,
                             .reference_work = work,
                             .ours = ours,
                             .theirs = peers});
}

static void query_case(const char *name, murk_worker_job our_job,
                       murk_worker_job peer_job, contest *contests, size_t n,
                       size_t leaf, unsigned threads)
{
    bench_times ours = {0}, peers = {0};
    for (int repeat = 0; repeat < BENCH_REPEATS; ++repeat) {
        for (size_t i = 0; i < n; ++i) {
            contest *c = &contests[i];
            const double our_hits =
                (double)time_queries(c, our_job, threads, &ours, repeat);
            const double peer_hits =
                (double)time_queries(c, peer_job, threads, &peers, repeat);
            /* nanoflann's ball is open, and where it puts the rounding of a
             * square is its own: a photon in a million may differ. */
            if (fabs(our_hits - peer_hits) > 1e-5 * our_hits) {
                stop("nanoflann found other photons");
            }
        }
    }
    print_case(name, "queries/s", (double)n * QUERIES, leaf, threads, &ours,
               &peers);
}

/* nanoflann 1.4 builds on one thread. */
static void build_case(contest *contests, size_t n, unsigned threads)
{
    bench_times ours = {0}, peers[LEAF_SIZES] = {0};
    double photons = 0;
    for (size_t i = 0; i < n; ++i) {
        photons += (double)contests[i].n;
    }
    /* Time all trees in turn, so that a drift of the clock rate meets all. */
    for (int repeat = 0; repeat < BENCH_REPEATS; ++repeat) {
        for (size_t i = 0; i < n; ++i) {
            murk_photon_map_destroy(
                build(&contests[i], threads, &ours, repeat));
            for (size_t j = 0; j < LEAF_SIZES; ++j) {
                const bench_moment begun = bench_now();
                peer_kd *peer = peer_kd_create(contests[i].points,
                                               contests[i].n, leaf_sizes[j]);
                bench_add(&peers[j], repeat, begun);
                peer_kd_destroy(peer);
            }
        }
    }
    /* The peer competes with its fastest leaf size. */
    size_t best = 0;
    for (size_t j = 1; j < LEAF_SIZES; ++j) {
        best =
            bench_median_s(&peers[j]) < bench_median_s(&peers[best]) ? j : best;
    }
    print_case("kd-build", "photons/s", photons, leaf_sizes[best], threads,
               &ours, &peers[best]);
}

/* The generator of the ceilings (pts.h there): xorshift128+ (Vigna, J. Comput.
 * Appl. Math. 315 (2017) 175, doi:10.1016/j.cam.2016.11.006) with the shifts
 * 23, 17 and 26. */
static uint64_t ceiling_word(void)
{
    static uint64_t state[2] = {0x9E3779B97F4A7C15, 0xD1B54A32D192ED03};
    uint64_t a = state[0];
    const uint64_t b = state[1];
    state[0] = b;
    a ^= a << 23;
    state[1] = a ^ b ^ (a >> 17) ^ (b >> 26);
    return state[1] + b;
}

/* A number in [0, 1). */
static double ceiling_number(void)
{
    return (double)(ceiling_word() >> 11) * 0x1p-53;
}

/* The points of kdtree.c, evenly in a cube of side 1 m, and its queries, each
 * near one of the points. */
static void make_even(contest *c, float radius_m)
{
    for (int i = 0; i < 20; ++i) { /* kdtree.c drops the first 20 words */
        ceiling_word();
    }
    c->n = POINTS;
    c->photons = allocate(c->n * sizeof *c->photons);
    memset(c->photons, 0, c->n * sizeof *c->photons);
    for (size_t i = 0; i < c->n; ++i) {
        for (int a = 0; a < 3; ++a) {
            c->photons[i].position_m[a] = (float)ceiling_number();
        }
    }
    c->radius_m = (double)radius_m;
    c->queries = EVEN_QUERIES;
    c->centers = allocate(3 * c->queries * sizeof *c->centers);
    for (size_t i = 0; i < c->queries; ++i) {
        const float *p = c->photons[ceiling_word() % c->n].position_m;
        for (int a = 0; a < 3; ++a) {
            c->centers[3 * i + (size_t)a] =
                (float)((double)p[a] +
                        (double)(radius_m * .1f) * (ceiling_number() - .5));
        }
    }
}

static int even_sums(float radius_m, unsigned threads)
{
    static contest c;
    bench_times built = {0}, times = {0};
    make_even(&c, radius_m);
    c.map = build(&c, threads, &built, 0);
    time_queries(&c, batch_of_sums, threads, &times, 1);
    const size_t hits = time_queries(&c, batch_of_sums, threads, &times, 0);
    printf("{\"queries\": %zu, \"hits\": %.4f, \"clock_s\": %.6g, \"cpu_s\": "
           "%.6g}\n",
           c.queries, (double)hits / (double)c.queries, times.clock_s[0],
           times.cpu_s[0]);
    release(&c);
    return 0;
}

int main(int argc, char **argv)
{
    static contest contests[2];
    size_t n = 1, leaf = 0;
    if (argc == 4 && strcmp(argv[1], "--even") == 0) {
        return even_sums((float)atof(argv[2]), (unsigned)atoi(argv[3]));
    }
    /* Points: the photon maps of a file, or uniform points. */
    if (argc > 1) {
        n = read_maps(contests, argv[1]);
    } else {
        make_points(&contests[0]);
    }
    if (n == 0) {
        stop("both maps have fewer than 1000 photons");
    }
    /* Both trees for each map, then queries and builds for each number of
     * threads. */
    for (size_t i = 0; i < n; ++i) {
        leaf = prepare(&contests[i]);
    }
    for (unsigned threads = 1; threads <= WORKERS; ++threads) {
        query_case("kd-query", batch_of_map, batch_of_peer, contests, n, leaf,
                   threads);
        query_case("kd-sums", batch_of_sums, batch_of_peer_sums, contests, n,
                   leaf, threads);
    }
    for (unsigned threads = 1; threads <= WORKERS; ++threads) {
        build_case(contests, n, threads);
    }
    for (size_t i = 0; i < n; ++i) {
        release(&contests[i]);
    }
    return 0;
}
