/* Standard errors of pixels, pooled over their neighbourhood.
 *
 * A pixel's light may come by rare paths that carry much of it. By its few
 * samples alone a pixel that has missed such a path would claim a small error
 * just where it is too low, and one that has met it a large error where it is
 * too high. Neighbours see alike light, so the variance of a pixel's mean is
 * taken as the weighted mean of the variances of the pixels around it, by a
 * Gaussian window. Each variance is free of bias, so their mean over the
 * picture stays what it was.
 *
 * A rare path may have been missed in all of the window. Therefore one sample's
 * worth of the picture's mean variance is added to the window's samples, as
 * Laplace's rule of succession adds one event to those observed.
 *
 * How sure the pooled variance is follows from its parts v_i of weights k_i: it
 * is as sure as (sum k v)^2 / sum (k v)^2 equal ones. */
#include "render/pooled_errors.h"

#include <math.h>
#include <string.h>

#include "base/pool.h"
#include "base/tally.h"

/* The window has this standard deviation [pixels] at so many samples a pixel;
 * it shrinks with their square root, so that a window holds the same number of
 * samples, some 800. With half of them the smoke hall's errors at 16 samples
 * are exceeded twofold more often by 1.5 % of the pixels; with four times as
 * many the window is wider than what the picture shows. */
#define WINDOW_PIXELS  2.0
#define WINDOW_SAMPLES 16.0

/* Of few samples the window stays below this, or it would even the picture
 * out. */
#define WINDOW_PIXELS_MAX 4.0

/* Below this no neighbour has a weight above e-8: the pixel stands alone. */
#define WINDOW_PIXELS_MIN 0.25

/* The window ends at this many standard deviations. */
#define WINDOW_REACH 2

typedef struct pool {
    const murk_pooling *pooling;
    const float *own;
    float *error;
    double window;        /* standard deviation [pixels] */
    double mean_variance; /* of the pixels that pool */
    murk_tally unsure;
} pool;

/* Of one pixel. */
static void pool_at(pool *p, ptrdiff_t x, ptrdiff_t y)
{
    const murk_pooling *g = p->pooling;
    const ptrdiff_t width = (ptrdiff_t)g->width, height = (ptrdiff_t)g->height;
    const ptrdiff_t reach = (ptrdiff_t)ceil(WINDOW_REACH * p->window);
    const double narrow = -0.5 / (p->window * p->window);
    double weights = 0, weights2 = 0, sum = 0, squares = 0;
    for (ptrdiff_t v = -reach; v <= reach; ++v) {
        for (ptrdiff_t u = -reach; u <= reach; ++u) {
            ptrdiff_t column = x + u;
            if (g->is_round && width > 2 * reach) {
                column = (column + width) % width;
            }
            if (y + v < 0 || y + v >= height || column < 0 || column >= width) {
                continue;
            }
            const size_t at = (size_t)((y + v) * width + column);
            if (g->is_own[at]) {
                continue;
            }
            const double k = exp(narrow * (double)(u * u + v * v));
            const double part = k * (double)p->own[at] * (double)p->own[at];
            weights += k;
            weights2 += k * k;
            sum += part;
            squares += part * part;
        }
    }
    const double samples = weights * (double)g->samples;
    p->error[y * width + x] = (float)sqrt(
        (samples * sum / weights + p->mean_variance) / (samples + 1));
    /* effective counts: of what brings the variance, and of the window */
    if (sum * sum * weights2 < MURK_POOLED_FEW * weights * weights * squares) {
        murk_tally_add(&p->unsure, 1);
    }
}

static void pool_row(void *context, uint64_t row)
{
    pool *p = context;
    const size_t width = p->pooling->width;
    for (size_t x = 0; x < width; ++x) {
        if (!p->pooling->is_own[row * width + x]) {
            pool_at(p, (ptrdiff_t)x, (ptrdiff_t)row);
        }
    }
}

size_t murk_pool_errors(const murk_pooling *pooling, float *error,
                        float *scratch)
{
    const size_t n = pooling->width * pooling->height;
    pool p = {.pooling = pooling,
              .own = scratch,
              .error = error,
              .window = fmin(WINDOW_PIXELS_MAX,
                             WINDOW_PIXELS * sqrt(WINDOW_SAMPLES /
                                                  (double)pooling->samples))};
    memcpy(scratch, error, n * sizeof *error);
    size_t pooled = 0;
    for (size_t i = 0; i < n; ++i) {
        if (!pooling->is_own[i]) {
            p.mean_variance += (double)error[i] * (double)error[i];
            ++pooled;
        }
    }
    if (p.window < WINDOW_PIXELS_MIN || pooled == 0) {
        return 0;
    }
    p.mean_variance /= (double)pooled;
    murk_pool_run(pooling->threads, pooling->height, pool_row, &p);
    return (size_t)murk_tally_read(&p.unsure);
}
