/* Sums of 128 bits to which several threads may add, and the exact variance of
 * the terms. Sums are modulo 2^128 and independent of the order, so a term is
 * taken back by adding the complement. Private to this room. */
#ifndef MURK_TRANSPORT_WIDE_H
#define MURK_TRANSPORT_WIDE_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

typedef struct murk_wide {
    uint64_t low, high;
} murk_wide;

typedef struct murk_wide_sum {
    _Atomic uint64_t low, high;
} murk_wide_sum;

static inline murk_wide murk_wide_negated(murk_wide x)
{
    return (murk_wide){~x.low + 1, ~x.high + (x.low == 0)};
}

static inline murk_wide murk_wide_square(uint64_t x)
{
    const uint64_t a = x >> 32, b = x & UINT32_MAX;
    const uint64_t cross = a * b; /* counts twice, shifted by 32 bits */
    const uint64_t middle = cross << 33, low = b * b + middle;
    return (murk_wide){low, a * a + (cross >> 31) + (low < middle)};
}

static inline void murk_wide_add(murk_wide_sum *sum, murk_wide x)
{
    const uint64_t before =
        atomic_fetch_add_explicit(&sum->low, x.low, memory_order_relaxed);
    const uint64_t high = x.high + (before + x.low < x.low);
    if (high) {
        atomic_fetch_add_explicit(&sum->high, high, memory_order_relaxed);
    }
}

/* Like murk_wide_add() if no other thread adds to the sum: ten times as
 * fast. */
static inline void murk_wide_add_alone(murk_wide_sum *sum, murk_wide x)
{
    const uint64_t before =
        atomic_load_explicit(&sum->low, memory_order_relaxed);
    const uint64_t high = x.high + (before + x.low < x.low);
    atomic_store_explicit(&sum->low, before + x.low, memory_order_relaxed);
    if (high) {
        atomic_store_explicit(
            &sum->high,
            atomic_load_explicit(&sum->high, memory_order_relaxed) + high,
            memory_order_relaxed);
    }
}

/* The sum of two values. */
static inline murk_wide murk_wide_plus(murk_wide a, murk_wide b)
{
    const uint64_t low = a.low + b.low;
    return (murk_wide){low, a.high + b.high + (low < b.low)};
}

static inline double murk_wide_value(murk_wide x)
{
    return (double)x.high * 0x1p64 + (double)x.low;
}

/* Returns sum x^2 - (sum x)^2 / n for n numbers, n < 2^32, with a sum below
 * 2^95. The result is rounded once, so it is exactly 0 if all numbers are
 * equal. */
double murk_wide_spread(murk_wide sum, murk_wide squares, uint64_t n);

#endif
