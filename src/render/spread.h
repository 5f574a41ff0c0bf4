/* Quantiles of the values of a channel; of a large picture, of pixels at equal
 * steps. */
#ifndef MURK_RENDER_SPREAD_H
#define MURK_RENDER_SPREAD_H

#include <stddef.h>

/* The largest number of values that are sorted. */
#define MURK_SPREAD_MAX ((size_t)1 << 20)

/* The step over n values that keeps the number within MURK_SPREAD_MAX. */
size_t murk_spread_step(size_t n);

/* The quantile of value[n] for a share 0..1, n > 0; sorts the values, which
 * must be finite. */
float murk_spread_share(float *value, size_t n, double share);

#endif
