/* How the values of a channel spread: quantiles, of a large picture over some
 * of its pixels at even steps. */
#ifndef MURK_RENDER_SPREAD_H
#define MURK_RENDER_SPREAD_H

#include <stddef.h>

/* No more values than this are looked at. */
#define MURK_SPREAD_MAX ((size_t)1 << 20)

/* The step over n values that keeps within it. */
size_t murk_spread_step(size_t n);

/* The value below which this share, 0..1, of value[n] lies, n > 0; sorts
 * them. Values are finite. */
float murk_spread_share(float *value, size_t n, double share);

#endif
