/* Search in a table of rising numbers. */
#ifndef MURK_BASE_INTERVAL_H
#define MURK_BASE_INTERVAL_H

#include <stddef.h>

/* The last i < n - 1 with x[i] <= value, or 0 if there is none: the interval of
 * the table in which a value lies. n >= 2 numbers, which are `stride` numbers
 * apart in memory. */
static inline size_t murk_interval_of(const double *x, size_t stride, size_t n,
                                      double value)
{
    size_t low = 0, high = n - 1;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (x[stride * middle] <= value) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

#endif
