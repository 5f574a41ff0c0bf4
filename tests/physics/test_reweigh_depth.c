/* Slopes of light inside a medium against adding-doubling.
 *
 * Deep fog lit straight on has, at a depth of a metre, the table's fluence rate
 * and irradiances at an optical depth that is its extinction. So their slopes
 * by extinction, integrated by Gauss and Legendre from 1 to 2 over light traced
 * at each place, are differences of two rows. Errors are of 100 batches of
 * photons; all checks share a chance of 1e-6 of a false alarm. */
#include "base/stats.h"
#include "calibrate/reweigh.h"
#include "check.h"
#include "optics_text.h"
#include "stage_text.h"

#include <stdlib.h>

#define BATCHES 100
#define CHECKS  6
#define BUDGET  1e-6

/* Spheres in a level lattice, three receivers each: fluence rate and both
 * sides. What lies a radius above and below is averaged: that adds k^2 r^2 / 10
 * of itself, with light falling as exp(-k depth), which is allowed for. */
#define SIDE      5
#define RADIUS_M  0.1
#define RECEIVERS (SIDE * SIDE)
#define KINDS     3

#define PLACES 5

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, -30], max_m: [1, 1, 0], sides: periodic}\n"
    "media: {fog: {extinction_per_m: 1, albedo: 0.9, phase: {hg: 0}}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: directional, direction: [0, 0, -1],"
    " irradiance_w_per_m2: 1}\n"
    "photons: {emit: 100000, maps: none}\n";

static const char *const kind_name[KINDS] = {"fluence", "down", "up"};

static void make_receivers(murk_receiver receiver[KINDS * RECEIVERS])
{
    for (size_t i = 0; i < RECEIVERS; ++i) {
        const double x = ((double)(i % SIDE) + .5) / SIDE;
        const double y = ((double)(i / SIDE) + .5) / SIDE;
        for (int kind = 0; kind < KINDS; ++kind) {
            receiver[KINDS * i + (size_t)kind] =
                (murk_receiver){.center = murk_vec(x, y, -1),
                                .radius_m = RADIUS_M,
                                .normal = murk_vec(0, 0,
                                                   kind == 1   ? 1
                                                   : kind == 2 ? -1
                                                               : 0),
                                .band = -1};
        }
    }
}

static murk_optics *optics_at(double extinction, const char *phase)
{
    char text[64];
    snprintf(text, sizeof text, "media.fog.extinction_per_m=%.17g", extinction);
    const char *const overrides[] = {text, phase, NULL};
    return optics_text_create(scene_text, overrides);
}

/* Mean over the lattice of the slopes by extinction, with standard errors. */
static void slopes_at(double extinction, const char *phase, int place,
                      murk_estimate slope[KINDS])
{
    /* The receivers, and the scene with this extinction. */
    static const size_t reweighed[1] = {0};
    static murk_receiver receiver[KINDS * RECEIVERS];
    static double batch[BATCHES][KINDS];
    char text[64], seed[24];
    make_receivers(receiver);
    snprintf(text, sizeof text, "media.fog.extinction_per_m=%.17g", extinction);
    snprintf(seed, sizeof seed, "seed=%d", place + 1);
    const char *const overrides[] = {text, phase, seed, NULL};
    murk_stage *stage = stage_text_create(scene_text, overrides);
    /* Follow the light; re-weighing to the traced optics itself gives
     * slopes. */
    const double step = 1e-5 * extinction;
    murk_optics *traced = optics_at(extinction, phase);
    murk_optics *low = optics_at(extinction - step, phase);
    murk_optics *high = optics_at(extinction + step, phase);
    const murk_optics_sides sides = {low, high, 2 * step};
    const murk_histories_desc desc = {.stage = stage,
                                      .threads = 2,
                                      .medium = reweighed,
                                      .media = 1,
                                      .receiver = receiver,
                                      .receivers = KINDS * RECEIVERS};
    murk_histories *f = NULL;
    murk_reweighed r = {0};
    murk_error err = {0};
    if (murk_histories_trace(&f, &desc, &err) ||
        murk_reweigh(&r, f, traced, traced, &sides, 1, 2, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    /* Each contribution counts for the batch of the photon, as a mean over
     * the volume of the sphere and over all spheres. */
    memset(batch, 0, sizeof batch);
    const double volume = 4. / 3 * MURK_PI * RADIUS_M * RADIUS_M * RADIUS_M;
    for (size_t i = 0; i < f->n; ++i) {
        const murk_contribution *c = &f->contribution[i];
        batch[c->photon * (uint64_t)BATCHES / f->emitted]
             [c->receiver % KINDS] +=
            r.slope[i] * (double)c->value * f->packet_w[0] / volume / RECEIVERS;
    }
    /* The standard error is that of the sum over batches. */
    for (int kind = 0; kind < KINDS; ++kind) {
        double total = 0, squares = 0;
        for (int b = 0; b < BATCHES; ++b) {
            total += batch[b][kind];
        }
        for (int b = 0; b < BATCHES; ++b) {
            const double off = batch[b][kind] - total / BATCHES;
            squares += off * off;
        }
        slope[kind] =
            (murk_estimate){total, sqrt(squares * BATCHES / (BATCHES - 1))};
    }
    murk_reweighed_release(&r);
    murk_histories_destroy(f);
    murk_optics_destroy(traced);
    murk_optics_destroy(low);
    murk_optics_destroy(high);
    stage_text_destroy(stage);
}

/* `rows` are the values at optical depths 1 and 2; `decay` is the rate at
 * which light falls deep inside, per mean free path (the eigenvalue of
 * Case); `teeth` is the relative deviation of a slope that must be seen. */
static void check_rows(const char *phase, double decay, double teeth,
                       const double rows[2][KINDS])
{
    /* Nodes and weights of Gauss and Legendre. */
    static const double place[PLACES] = {-.9061798459386640, -.5384693101056831,
                                         0, .5384693101056831,
                                         .9061798459386640};
    static const double weight[PLACES] = {.2369268850561891, .4786286704993665,
                                          .5688888888888889, .4786286704993665,
                                          .2369268850561891};
    /* Integrate the slopes over extinctions from 1 to 2. */
    double sum[KINDS] = {0}, variance[KINDS] = {0};
    for (int p = 0; p < PLACES; ++p) {
        murk_estimate slope[KINDS];
        slopes_at(1.5 + .5 * place[p], phase, p, slope);
        for (int kind = 0; kind < KINDS; ++kind) {
            const double w = .5 * weight[p];
            const double error = w * slope[kind].standard_error;
            sum[kind] += w * slope[kind].value;
            variance[kind] += error * error;
        }
    }
    for (int kind = 0; kind < KINDS; ++kind) {
        /* Each row is averaged over a sphere, which adds a term of second
         * order in the radius; the term grows with the square of the
         * extinction. */
        const double spread = decay * decay * RADIUS_M * RADIUS_M / 10;
        const double want =
            rows[1][kind] * (1 + 4 * spread) - rows[0][kind] * (1 + spread);
        const double error = sqrt(variance[kind]);
        const double limit = murk_sidak_limit(BUDGET, CHECKS);
        printf("%-18s %-8s %9.6f +- %.6f  %9.6f  %5.2f\n", phase,
               kind_name[kind], sum[kind], error, want,
               sigmas_off(sum[kind], want, error));
        /* The integral is the difference of the rows, and is known well
         * enough. */
        CHECK_WITHIN(limit, sum[kind], want, error);
        CHECK(error * limit < teeth * fabs(want));
    }
}

int main(void)
{
    /* tests/physics/reference/depth.csv, cases A and B of index 1: fluence
     * rate, down and up; point_source_hg's kappa0 */
    check_rows("media.fog.phase.hg=0", .52543, .1,
               (const double[2][KINDS]){{1.763647, .705001, .316003},
                                        {1.184642, .447294, .205093}});
    check_rows("media.fog.phase.hg=0.75", .28808, .4,
               (const double[2][KINDS]){{1.473209, .852818, .164019},
                                        {1.320812, .690654, .142587}});
    return check_done();
}
