/* Time of placement once the matrix is there, on a made-up house: a box of
 * 30 x 20 x 10 m in six rooms with doors, candidates on a grid, photons on
 * floor, ceiling and walls (balanced weights: a fifth in the air).
 *
 * Cases: the paper's sizes in clear air, thick smoke, and a large map of which
 * a fifth is seen. Reference: the same number of weighings by a plain loop
 * over a clarity a pair, timed in the same run. JSON lines, one for each
 * number of threads; figures for people on standard error.
 *
 *   bench_placement [placement|placement-4|-smoke|-large|-huge] */
#include "base/rng.h"
#include "placement/place.h"
#include "times.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct bench_case {
    const char *name;
    size_t photons, count, restarts;
    double range_m, extinction_per_m;
    bool with_curve;
} bench_case;

typedef struct point {
    double x, y, z;
} point;

typedef struct house {
    const bench_case *what;
    murk_problem problem;
    point *photon, *candidate;
    uint32_t *weight;
    uint32_t *seen; /* [threads][photons] */
    uint16_t *clarity;
} house;

/* Inner walls in the plan: along x or y, with a door. */
typedef struct wall {
    bool is_along_x;
    double at, from, to, door_from, door_to;
} wall;

static const wall walls[] = {
    {true, 9, 0, 30, 4, 6},     {false, 10, 0, 9, 3, 4.5},
    {false, 20, 0, 9, 6, 7.5},  {false, 12, 9, 20, 14, 15},
    {false, 22, 9, 20, 10, 12},
};

static bool crosses(const wall *w, point a, point b)
{
    const double a0 = w->is_along_x ? a.y : a.x, b0 = w->is_along_x ? b.y : b.x;
    const double a1 = w->is_along_x ? a.x : a.y, b1 = w->is_along_x ? b.x : b.y;
    if ((a0 - w->at) * (b0 - w->at) >= 0) {
        return false;
    }
    const double share = (w->at - a0) / (b0 - a0);
    const double at = a1 + share * (b1 - a1);
    return at > w->from && at < w->to &&
           !(at > w->door_from && at < w->door_to);
}

static uint16_t clarity_between(const bench_case *what, point a, point b)
{
    const double d =
        sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) +
             (a.z - b.z) * (a.z - b.z));
    if (!(d < what->range_m)) {
        return 0;
    }
    for (size_t k = 0; k < sizeof walls / sizeof walls[0]; ++k) {
        if (crosses(&walls[k], a, b)) {
            return 0;
        }
    }
    return (uint16_t)(MURK_CLEAR * exp(-what->extinction_per_m * d) + 0.5);
}

static void get_row(void *context, unsigned worker, size_t candidate,
                    murk_sparse_row *out)
{
    const house *h = context;
    const size_t n = h->problem.photons;
    uint32_t *seen = h->seen + worker * n;
    uint16_t *clarity = h->clarity + worker * n;
    size_t k = 0;
    for (size_t i = 0; i < n; ++i) {
        const uint16_t c =
            clarity_between(h->what, h->candidate[candidate], h->photon[i]);
        if (c > 0) {
            seen[k] = (uint32_t)i;
            clarity[k++] = c;
        }
    }
    *out = (murk_sparse_row){k, seen,
                             h->what->extinction_per_m > 0 ? clarity : NULL};
}

static point photon_at(uint64_t i, bool is_in_air)
{
    const murk_random4 r = murk_random(1, MURK_TEST, i, 0, 0);
    point p = {30 * r.u[0], 20 * r.u[1], 10 * r.u[2]};
    if (!is_in_air) {
        const int side = (int)(6 * r.u[3]);
        p.z = side == 0 ? 0 : side == 1 ? 10 : p.z;
        p.x = side == 2 ? 1e-6 : side == 3 ? 30 - 1e-6 : p.x;
        p.y = side == 4 ? 1e-6 : side == 5 ? 20 - 1e-6 : p.y;
    }
    return p;
}

/* Rooms of a metre in rows, as a tree would roughly order them. */
static int by_place(const void *a, const void *b)
{
    const point *p = a, *q = b;
    const double x = floor(p->x) * 1000 + floor(p->y) * 20 + p->z;
    const double y = floor(q->x) * 1000 + floor(q->y) * 20 + q->z;
    return (x > y) - (x < y);
}

static house *house_create(const bench_case *what, unsigned threads)
{
    const size_t size[3] = {12, 11, 9};
    house *h = calloc(1, sizeof *h);
    const size_t n = what->photons, in_air = n / 5;
    const size_t candidates = size[0] * size[1] * size[2];
    h->what = what;
    h->photon = calloc(n, sizeof *h->photon);
    h->weight = calloc(n, sizeof *h->weight);
    h->candidate = calloc(candidates, sizeof *h->candidate);
    h->seen = calloc(n * threads, sizeof *h->seen);
    h->clarity = calloc(n * threads, sizeof *h->clarity);
    /* A fifth of the photons lie in the air and weigh more; order them in
     * space. */
    for (size_t i = 0; i < n; ++i) {
        h->photon[i] = photon_at(i, i >= n - in_air);
        h->weight[i] = i >= n - in_air ? 4000 : 1000;
    }
    qsort(h->photon, n - in_air, sizeof *h->photon, by_place);
    qsort(h->photon + n - in_air, in_air, sizeof *h->photon, by_place);
    /* Candidates on a regular grid. */
    for (size_t j = 0; j < candidates; ++j) {
        h->candidate[j] = (point){1.1 + 2.5 * (double)(j % size[0]),
                                  1.2 + 1.75 * (double)(j / size[0] % size[1]),
                                  1 + (double)(j / size[0] / size[1])};
    }
    h->problem = (murk_problem){.photons = n,
                                .candidates = candidates,
                                .weight = h->weight,
                                .get_row = get_row,
                                .context = h,
                                .threads = threads};
    return h;
}

static void house_destroy(house *h)
{
    free(h->photon);
    free(h->weight);
    free(h->candidate);
    free(h->seen);
    free(h->clarity);
    free(h);
}

#define PLAIN_ROWS 64

/* Times plain weighings of PLAIN_ROWS candidates, all photons. */
static void time_plain(const house *h, bench_times *times, int repeat)
{
    const size_t n = h->problem.photons, rows = PLAIN_ROWS;
    uint16_t *row = calloc(rows * n, sizeof *row);
    uint16_t *best = calloc(n, sizeof *best);
    /* Dense rows of some candidates, and a partial plan that holds the
     * first. */
    for (size_t j = 0; j < rows; ++j) {
        murk_sparse_row l;
        get_row((void *)(uintptr_t)h, 0, j * h->problem.candidates / rows, &l);
        for (size_t k = 0; k < l.seen; ++k) {
            row[j * n + l.photon[k]] = l.clarity ? l.clarity[k] : MURK_CLEAR;
        }
    }
    memcpy(best, row, n * sizeof *best);
    /* The plain loop: the gain of each row over the partial plan. */
    volatile uint64_t keep = 0;
    const bench_moment begun = bench_now();
    for (size_t j = 0; j < rows; ++j) {
        uint64_t sum = 0;
        for (size_t i = 0; i < n; ++i) {
            const uint16_t p = row[j * n + i];
            sum += p > best[i] ? (uint64_t)(p - best[i]) * h->weight[i] : 0;
        }
        keep = keep + sum;
    }
    bench_add(times, repeat, begun);
    free(row);
    free(best);
}

static int run(const bench_case *what, unsigned threads)
{
    house *h = house_create(what, threads);
    murk_error err = {0};
    murk_matrix *matrix = NULL;
    murk_place_result r = {0};
    murk_place_desc desc = murk_place_defaults();
    desc.count = what->count;
    desc.restarts = what->restarts;
    desc.with_curve = what->with_curve;
    /* Time the coverage matrix and the search apart. */
    bench_times built = {0}, ours = {0}, plain = {0};
    bench_moment begun = bench_now();
    murk_status status =
        murk_matrix_create(&matrix, &h->problem, (uint64_t)1 << 34, &err);
    bench_add(&built, 0, begun);
    for (int i = 0; i < BENCH_REPEATS && !status; ++i) {
        murk_place_release(&r);
        r = (murk_place_result){0};
        begun = bench_now();
        status = murk_place_sensors(&r, &h->problem, matrix, &desc, &err);
        bench_add(&ours, i, begun);
        time_plain(h, &plain, i);
    }
    if (status) {
        fprintf(stderr, "%s: %s\n", what->name, err.text);
    } else {
        bench_print(&(bench_row){.name = what->name,
                                 .unit = "weighings/s",
                                 .reference = "plain weighings",
                                 .threads = threads,
                                 .work = (double)r.evaluations,
                                 .reference_work = PLAIN_ROWS,
                                 .ours = &ours,
                                 .theirs = &plain});
        fprintf(stderr,
                "  matrix %.2f s, %.3g MB, %.3g pairs; %zu of %zu candidates "
                "after presolve; %zu starts, %.3g weighings\n"
                "  coverage %.4f, upper %.4f, gap %.2f %%\n",
                built.clock_s[0], (double)murk_matrix_bytes(matrix) * 1e-6,
                (double)murk_matrix_pairs(matrix), r.after_presolve,
                h->problem.candidates, r.restarts, (double)r.evaluations,
                (double)r.value / (double)r.whole,
                (double)r.upper / (double)r.whole,
                100 * (double)(r.upper - r.value) / (double)r.upper);
        for (size_t k = 0; k < r.curve_points; ++k) {
            fprintf(stderr, "  %zu: %.4f <= %.4f\n", r.curve[k].count,
                    (double)r.curve[k].value / (double)r.whole,
                    (double)r.curve[k].upper / (double)r.whole);
        }
    }
    murk_place_release(&r);
    murk_matrix_destroy(matrix);
    house_destroy(h);
    return status != MURK_OK;
}

int main(int argc, char **argv)
{
    static const bench_case cases[] = {
        {"placement", 10000, 5, 200, 100, 0, true},
        {"placement-4", 10000, 4, 200, 100, 0, false},
        {"placement-smoke", 10000, 5, 200, 100, 0.1, true},
        {"placement-large", 200000, 5, 200, 14, 0.1, true},
        {"placement-huge", 1000000, 5, 200, 14, 0.1, true},
    };
    const char *wanted = argc > 1 ? argv[1] : cases[0].name;
    int failed = 1;
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        if (strcmp(wanted, cases[k].name) == 0) {
            failed = run(&cases[k], 1) | run(&cases[k], 2);
        }
    }
    return failed;
}
