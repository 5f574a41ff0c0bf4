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

/* Half of a sum. The two halves of a sum lie apart: the upper half changes
 * seldom, so that the lower halves of many sums fit into a cache. */
typedef _Atomic uint64_t murk_wide_half;

static inline void murk_wide_add(murk_wide_half *low, murk_wide_half *high,
                                 murk_wide x)
{
    const uint64_t x_low = (uint64_t)x;
    const uint64_t before =
        atomic_fetch_add_explicit(low, x_low, memory_order_relaxed);
    const uint64_t carried = (uint64_t)(x >> 64) + (before + x_low < x_low);
    if (carried) {
        atomic_fetch_add_explicit(high, carried, memory_order_relaxed);
    }
}

static inline murk_wide murk_wide_read(const murk_wide_half *low,
                                       const murk_wide_half *high)
{
    return (murk_wide)atomic_load_explicit(high, memory_order_relaxed) << 64 |
           atomic_load_explicit(low, memory_order_relaxed);
}

/* Adds to an upper half, if no other thread does. */
static inline void murk_wide_carry_alone(murk_wide_half *high, uint64_t carried)
{
    atomic_store_explicit(
        high, atomic_load_explicit(high, memory_order_relaxed) + carried,
        memory_order_relaxed);
}

/* Like murk_wide_add() if no other thread adds to the sum: ten times as
 * fast. */
static inline void murk_wide_add_alone(murk_wide_half *low,
                                       murk_wide_half *high, murk_wide x)
{
    const uint64_t x_low = (uint64_t)x;
    const uint64_t after =
        atomic_load_explicit(low, memory_order_relaxed) + x_low;
    const uint64_t carried = (uint64_t)(x >> 64) + (after < x_low);
    atomic_store_explicit(low, after, memory_order_relaxed);
    if (carried) {
        murk_wide_carry_alone(high, carried);
    }
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
