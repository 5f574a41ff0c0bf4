/* Integrates a density over the sphere of directions by Gauss-Legendre
 * quadrature, and bins sampled cosines for Pearson's chi-squared statistic. */
#include "turns.h"

#include <math.h>

#include "base/rng.h"

#define PI      3.14159265358979324
#define BINS    40
#define NEAREST 1e-5 /* rad */
#define EDGES   4000
#define MIN_IN  20. /* samples expected in a bin */

/* Nodes and weights of the five-point rule on [-1, 1], Abramowitz & Stegun,
 * Handbook of Mathematical Functions, 1964, table 25.4. */
static const double NODE[] = {0, .5384693101056831, -.5384693101056831,
                              .9061798459386640, -.9061798459386640};
static const double WEIGHT[] = {.5688888888888889, .4786286704993665,
                                .4786286704993665, .2369268850561891,
                                .2369268850561891};

static double panel(turn_density density, const void *context, double from,
                    double to)
{
    double sum = 0;
    for (int k = 0; k < 5; ++k) {
        const double angle = .5 * (from + to) + .5 * (to - from) * NODE[k];
        sum += WEIGHT[k] * sin(angle) * density(context, cos(angle));
    }
    return PI * (to - from) * sum;
}

double turn_share(turn_density density, const void *context, double from_rad,
                  double to_rad)
{
    double sum = 0;
    for (double from = from_rad; from < to_rad;) {
        const double step = fmin(PI / 3600, from > 0 ? from / 100 : 1e-7);
        const double to = to_rad - from < 1.01 * step ? to_rad : from + step;
        sum += panel(density, context, from, to);
        from = to;
    }
    return sum;
}

typedef struct bins {
    size_t n;
    double until[BINS]; /* cosine that a bin ends at, falling */
    double share[BINS];
} bins;

static bins bins_of(turn_density density, const void *context, uint64_t n)
{
    bins b = {.n = 0};
    const double min = fmax(1. / (BINS - 1), MIN_IN / (double)n);
    const double all = turn_share(density, context, NEAREST, PI);
    double share = fmax(0, 1 - all), from = NEAREST;
    for (int i = 0; i < EDGES; ++i) {
        const double to =
            i + 1 == EDGES ? PI : NEAREST * pow(PI / NEAREST, (i + 1.) / EDGES);
        share += turn_share(density, context, from, to);
        from = to;
        if (i + 1 == EDGES && share < MIN_IN / (double)n) {
            b.share[b.n - 1] += share; /* the last one takes what is left */
            b.until[b.n - 1] = -1;
        } else if (i + 1 == EDGES || share >= min) {
            b.until[b.n] = i + 1 == EDGES ? -1 : cos(to);
            b.share[b.n++] = share;
            share = 0;
        }
    }
    return b;
}

static size_t bin_of(const bins *b, double mu)
{
    size_t from = 0, to = b->n - 1; /* the first with until <= mu */
    while (from < to) {
        const size_t middle = (from + to) / 2;
        if (b->until[middle] <= mu) {
            to = middle;
        } else {
            from = middle + 1;
        }
    }
    return from;
}

double turn_misfit(turn_sample sample, const void *sampled,
                   turn_density density, const void *expected, uint64_t n,
                   uint32_t seed)
{
    const bins b = bins_of(density, expected, n);
    uint64_t count[BINS] = {0};
    for (uint64_t i = 0; i < n; ++i) {
        const double u = murk_random(seed, MURK_TEST, i, 0, 0).u[0];
        ++count[bin_of(&b, sample(sampled, u))];
    }
    double chi2 = 0;
    for (size_t i = 0; i < b.n; ++i) {
        const double want = (double)n * b.share[i];
        chi2 += ((double)count[i] - want) * ((double)count[i] - want) / want;
    }
    const double free = (double)b.n - 1, spread = 2 / (9 * free);
    return (cbrt(chi2 / free) - (1 - spread)) / sqrt(spread);
}
