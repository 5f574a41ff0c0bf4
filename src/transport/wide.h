/* Sums of 128 bits to which several threads may add, and the exact variance of
 * the terms. Sums are modulo 2^128 and independent of the order, so a term is
 * subtracted by adding its two's complement. For use inside src/transport only.
 */
#ifndef MURK_TRANSPORT_WIDE_H
#define MURK_TRANSPORT_WIDE_H

#include <stdatomic.h>
#include <stdint.h>

/* An extension of gcc and clang on 64-bit machines. */
__extension__ typedef unsigned __int128 murk_wide;

typedef struct murk_wide_sum {
    _Atomic uint64_t low, high;
} murk_wide_sum;

static inline void murk_wide_add(murk_wide_sum *sum, murk_wide x)
{
    const uint64_t low = (uint64_t)x;
    const uint64_t before =
        atomic_fetch_add_explicit(&sum->low, low, memory_order_relaxed);
    const uint64_t high = (uint64_t)(x >> 64) + (before + low < low);
    if (high) {
        atomic_fetch_add_explicit(&sum->high, high, memory_order_relaxed);
    }
}

static inline murk_wide murk_wide_read(const murk_wide_sum *sum)
{
    return (murk_wide)atomic_load_explicit(&sum->high, memory_order_relaxed)
               << 64 |
           atomic_load_explicit(&sum->low, memory_order_relaxed);
}

/* Like murk_wide_add() if no other thread adds to the sum: ten times as
 * fast. */
static inline void murk_wide_add_alone(murk_wide_sum *sum, murk_wide x)
{
    const uint64_t before =
        atomic_load_explicit(&sum->low, memory_order_relaxed);
    const uint64_t low = before + (uint64_t)x;
    const uint64_t high =
        atomic_load_explicit(&sum->high, memory_order_relaxed) +
        (uint64_t)(x >> 64) + (low < before);
    atomic_store_explicit(&sum->low, low, memory_order_relaxed);
    atomic_store_explicit(&sum->high, high, memory_order_relaxed);
}

static inline double murk_wide_value(murk_wide x)
{
    return (double)(uint64_t)(x >> 64) * 0x1p64 + (double)(uint64_t)x;
}

/* Returns sum x^2 - (sum x)^2 / n for n numbers, 1 <= n < 2^32, with a sum
 * below 2^95. n sum x^2 - (sum x)^2 is computed in integers, so the result is
 * exactly 0 if all numbers are equal. */
double murk_wide_spread(murk_wide sum, murk_wide squares, uint64_t n);

#endif
