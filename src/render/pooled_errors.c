/* Pools the standard errors of pixels over their neighbourhood.
 *
 * Rare paths may carry much of the light of a pixel. With few samples, a pixel
 * that has missed such a path would report a small error although it is too
 * dark, and a pixel that has met it a large error. Adjacent pixels show similar
 * light, so the variance of the mean of a pixel is estimated as the weighted
 * mean of the variances of the pixels around it, with a Gaussian window. Each
 * variance is unbiased, so their mean over the picture does not change.
 *
 * All pixels of a window may have missed a rare path. Therefore the mean
 * variance of the picture, with the weight of one sample, is added to the
 * samples of the window, as Laplace's rule of succession adds one event to the
 * observed ones.
 *
 * The certainty of the pooled variance follows from the parts v_i with weights
 * k_i: it is that of n equal parts, n = (sum k_i v_i)^2 / sum (k_i v_i)^2. */
#include "render/pooled_errors.h"

#include <math.h>
#include <string.h>

#include "base/pool.h"
#include "base/tally.h"

/* The standard deviation of the window [pixels] at WINDOW_SAMPLES samples for
 * each pixel. It is in inverse proportion to the square root of the number of
 * samples, so that a window contains a constant number of samples, some 800.
 * With half as many, the errors of the smoke hall at 16 samples are exceeded
 * twofold by 1.5 % more of the pixels; with four times as many, the window is
 * wider than the details of the picture. */
#define WINDOW_PIXELS  2.0
#define WINDOW_SAMPLES 16.0

/* The largest standard deviation of the window, for few samples, because a
 * wider window would smooth out the picture. */
#define WINDOW_PIXELS_MAX 4.0

/* Below this standard deviation no neighbour has a weight above exp(-8), and
 * pixels are not pooled. */
#define WINDOW_PIXELS_MIN 0.25

/* The window is cut at this number of standard deviations. */
#define WINDOW_REACH 2

typedef struct pool {
    const murk_pooling *pooling;
    const float *own;
    float *error;
    double window;        /* standard deviation [pixels] */
    double mean_variance; /* over the pixels that are pooled */
    murk_tally unsure;
} pool;

/* Pools the error of one pixel. */
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
    /* The effective number of variances is sum^2 / squares, that of the pixels
     * in the window weights^2 / weights2. */
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
