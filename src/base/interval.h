/* Searches in a table of rising numbers. */
#ifndef MURK_BASE_INTERVAL_H
#define MURK_BASE_INTERVAL_H

#include <stdbool.h>
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

/* Two places in a table, and the weight of the second; equal ones, and 0, if
 * the value is that of one place. */
typedef struct murk_bracket {
    size_t first, second;
    double weight;
} murk_bracket;

/* The places between which a value lies, in a table of n >= 1 rising numbers. A
 * value that is as close as `same` to a number is that number. False if the
 * value lies outside of the table. */
static inline bool murk_bracket_find(murk_bracket *out, const double *x,
                                     size_t n, double value, double same)
{
    if (!(value >= x[0] - same && value <= x[n - 1] + same)) {
        return false;
    }
    const size_t low = n > 1 ? murk_interval_of(x, 1, n, value) : 0;
    const size_t high = n > 1 ? low + 1 : 0;
    if (value - x[low] <= same) {
        *out = (murk_bracket){low, low, 0};
    } else if (x[high] - value <= same) {
        *out = (murk_bracket){high, high, 0};
    } else {
        *out = (murk_bracket){low, high, (value - x[low]) / (x[high] - x[low])};
    }
    return true;
}

#endif
