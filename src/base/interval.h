/* Search in a table of rising numbers. */
#ifndef MURK_BASE_INTERVAL_H
#define MURK_BASE_INTERVAL_H

#include <stddef.h>

/* The interval i, from x[i] to x[i + 1], in which a value lies: the largest i
 * <= n - 2 with x[i] <= value, or 0 if there is none. The table has n >= 2
 * numbers; x[i] is stored at x[stride * i]. */
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
