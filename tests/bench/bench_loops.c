/* The reference loops of the cube cases: a box of 60 m with a pencil beam into
 * the middle of one face, traced by the plain scalar loop
 * (tests/support/plain_tracer.c) or by the loop over SIMD lanes (lane_loop.c).
 * tools/bench runs the program beside murk and beside the ceilings.
 *
 *   bench_loops scalar|lanes even|ball|voxels|linear ABSORPTION SCATTERING G
 *               PHOTONS THREADS roulette|weights none|tally
 *
 * ball: radius 15 in the middle, of absorption .002, scattering 5, g .9.
 * voxels, linear: times a density that grows from 0 to 2 along the beam, in
 * voxels of side 1, or trilinear between whole coordinates. tally: absorption
 * in 60^3 cells with the standard errors over BATCHES batches. Prints one JSON
 * object with photons by weight and collisions. */
#include "lane_loop.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <threads.h>

#define SIDE    60
#define CELLS   ((size_t)SIDE * SIDE * SIDE)
#define BATCHES 16

/* One thread traces every batch that is a multiple of `threads` after
 * `first`. */
typedef struct share {
    plain_box box;
    bool is_lanes, has_tally;
    uint64_t photons, first, threads;
    plain_result sum;
    float *sums, *squares; /* [CELLS] over batches */
} share;

static void *allocate(size_t n, size_t size)
{
    void *memory = calloc(n, size);
    if (!memory) {
        fprintf(stderr, "bench_loops: out of memory\n");
        exit(1);
    }
    return memory;
}

static void add(plain_result *to, const plain_result *r)
{
    to->absorbed += r->absorbed;
    to->collisions += r->collisions;
    for (int k = 0; k < 3; ++k) {
        to->escaped[k][0] += r->escaped[k][0];
        to->escaped[k][1] += r->escaped[k][1];
    }
}

static int run(void *context)
{
    share *s = context;
    float *batch = NULL;
    if (s->has_tally) {
        batch = allocate(CELLS, sizeof *batch);
        s->sums = allocate(CELLS, sizeof *s->sums);
        s->squares = allocate(CELLS, sizeof *s->squares);
        s->box.absorption = batch;
    }
    for (uint64_t b = s->first; b < BATCHES; b += s->threads) {
        const uint64_t n =
            (b + 1) * s->photons / BATCHES - b * s->photons / BATCHES;
        const plain_result r = s->is_lanes ? lane_trace(&s->box, n, b + 1)
                                           : plain_trace(&s->box, n, b + 1);
        add(&s->sum, &r);
        /* Sums and squares of the batches give means and errors. */
        for (size_t i = 0; batch && i < CELLS; ++i) {
            s->sums[i] += batch[i];
            s->squares[i] += batch[i] * batch[i];
            batch[i] = 0;
        }
    }
    free(batch);
    return 0;
}

/* The sum of the tally over all cells and the mean relative error of the cells
 * that were reached. */
static void sum_tally(const share *s, uint64_t threads, double *sum,
                      double *error)
{
    double errors = 0, reached = 0;
    *sum = 0;
    for (size_t i = 0; i < CELLS; ++i) {
        double a = 0, b = 0;
        for (uint64_t t = 0; t < threads; ++t) {
            a += (double)s[t].sums[i];
            b += (double)s[t].squares[i];
        }
        if (a > 0) {
            errors += sqrt((b / (a * a) * BATCHES - 1) / (BATCHES - 1));
            reached += 1;
        }
        *sum += a;
    }
    *error = errors / reached;
}

/* z, the direction of the beam, grows fastest. */
static float *make_ramp(bool is_linear)
{
    const size_t n = is_linear ? SIDE + 1 : SIDE;
    float *density = allocate(n * n * n, sizeof *density);
    for (size_t i = 0; i < n * n * n; ++i) {
        density[i] =
            (float)(((double)(i % n) + (is_linear ? 0 : .5)) * 2 / SIDE);
    }
    return density;
}

/* Whether an argument is `yes`; it must be that or `no`. */
static bool is_word(const char *argument, const char *yes, const char *no)
{
    const bool is_yes = strcmp(argument, yes) == 0;
    if (!is_yes && strcmp(argument, no) != 0) {
        fprintf(stderr, "bench_loops: %s: must be %s or %s\n", argument, yes,
                no);
        exit(2);
    }
    return is_yes;
}

int main(int argc, char **argv)
{
    if (argc != 10) {
        fprintf(stderr, "usage: bench_loops scalar|lanes "
                        "even|ball|voxels|linear ABSORPTION SCATTERING G "
                        "PHOTONS THREADS roulette|weights none|tally\n");
        return 2;
    }
    const bool is_lanes = is_word(argv[1], "lanes", "scalar");
    const bool has_weights = is_word(argv[8], "weights", "roulette");
    const bool has_tally = is_word(argv[9], "tally", "none");
    /* The box; the density of a ramp grows to 2. */
    const bool is_ball = strcmp(argv[2], "ball") == 0;
    const bool is_linear = strcmp(argv[2], "linear") == 0;
    const bool is_ramp =
        is_linear || (!is_ball && is_word(argv[2], "voxels", "even"));
    const plain_matter matter = {atof(argv[3]), atof(argv[4]), atof(argv[5])};
    const plain_matter ball = {.002, 5, .9};
    const double highest =
        is_ball ? fmax(matter.scattering_per_m + matter.absorption_per_m,
                       ball.scattering_per_m + ball.absorption_per_m)
                : matter.scattering_per_m + matter.absorption_per_m;
    const uint64_t photons = (uint64_t)atof(argv[6]);
    const uint64_t threads = is_word(argv[7], "2", "1") ? 2 : 1;
    float *density = is_ramp ? make_ramp(is_linear) : NULL;

    /* Each thread traces some of the batches. */
    share shares[2];
    thrd_t thread[2];
    for (uint64_t t = 0; t < threads; ++t) {
        shares[t] =
            (share){.box = {.size_m = {SIDE, SIDE, SIDE},
                            .start_m = {30.1, 30.2, 0},
                            .direction = {0, 0, 1},
                            .matter = matter,
                            .majorant_per_m = is_ramp ? 2 * highest : highest,
                            .center_m = {SIDE / 2, SIDE / 2, SIDE / 2},
                            .radius_m = is_ball ? 15 : 0,
                            .ball = ball,
                            .density = density,
                            .is_linear = is_linear,
                            .has_weights = has_weights},
                    .is_lanes = is_lanes,
                    .has_tally = has_tally,
                    .photons = photons,
                    .first = t,
                    .threads = threads};
        if (thrd_create(&thread[t], run, &shares[t]) != thrd_success) {
            fprintf(stderr, "bench_loops: no thread\n");
            return 1;
        }
    }
    plain_result sum = {0};
    for (uint64_t t = 0; t < threads; ++t) {
        thrd_join(thread[t], NULL);
        add(&sum, &shares[t].sum);
    }

    /* Sums over all photons. */
    printf("{\"photons\": %llu, \"collisions\": %llu, \"absorbed\": %.9g, "
           "\"reflected\": %.9g, \"transmitted\": %.9g",
           (unsigned long long)photons, (unsigned long long)sum.collisions,
           sum.absorbed, sum.escaped[2][0], sum.escaped[2][1]);
    if (shares[0].has_tally) {
        double tally, error;
        sum_tally(shares, threads, &tally, &error);
        printf(", \"tally\": %.9g, \"tally_error\": %.3g", tally, error);
    }
    printf("}\n");
    for (uint64_t t = 0; t < threads; ++t) {
        free(shares[t].sums);
        free(shares[t].squares);
    }
    free(density);
    return 0;
}
