/* The portable inner loops, slot by slot. Each file of kernels compiles them
 * anew: before this header it may define MURK_TARGET, an attribute that allows
 * instructions which count and find bits. */
#ifndef MURK_PLACEMENT_KERNEL_LOOPS_H
#define MURK_PLACEMENT_KERNEL_LOOPS_H

#include "placement/cover_lanes.h"
#include "placement/problem.h"

#ifndef MURK_TARGET
#define MURK_TARGET
#endif

/* A loop is compiled once for each combination of options that a caller passes
 * as constants, without tests inside. */
#define MURK_LOOP MURK_TARGET static inline __attribute__((always_inline))

/* max(0, clarity - best); or, with is_independent, clarity * (MURK_CLEAR -
 * best) / 65536, rounded down: an approximation of the gain of independent
 * detection (murk_row_gain_bound()). */
static inline uint64_t murk_gain_term(uint16_t clarity, uint16_t best,
                                      bool is_independent)
{
    return is_independent
               ? (uint64_t)clarity * (uint64_t)(MURK_CLEAR - best) >> 16
               : (uint64_t)clarity -
                     (uint64_t)(clarity < best ? clarity : best);
}

static inline size_t murk_word_at(const uint32_t *at, size_t k)
{
    return at ? at[k] : k;
}

MURK_LOOP uint64_t murk_weighted_bits(const uint64_t *row, const uint32_t *at,
                                      const uint64_t *full,
                                      const uint32_t *weight, size_t words)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < words; ++k) {
        const size_t word = murk_word_at(at, k);
        for (uint64_t left = row[k] & ~full[word]; left; left &= left - 1) {
            sum += weight[64 * word + (size_t)__builtin_ctzll(left)];
        }
    }
    return sum;
}

MURK_TARGET static inline uint64_t
murk_loop_count_new(const uint64_t *row, const uint32_t *at,
                    const uint64_t *full, const uint32_t *weight, size_t words)
{
    if (weight) {
        return murk_weighted_bits(row, at, full, weight, words);
    }
    /* The most frequent loop: without a test of `at` inside. */
    uint64_t sum = 0;
    if (!at) {
        for (size_t k = 0; k < words; ++k) {
            sum += (uint64_t)__builtin_popcountll(row[k] & ~full[k]);
        }
        return sum;
    }
    for (size_t k = 0; k < words; ++k) {
        sum += (uint64_t)__builtin_popcountll(row[k] & ~full[at[k]]);
    }
    return sum;
}

MURK_LOOP uint64_t murk_dense_sum(const uint16_t *row, const uint16_t *best,
                                  const uint32_t *weight, size_t n,
                                  bool is_independent)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < n; ++i) {
        sum += murk_gain_term(row[i], best[i], is_independent) *
               (weight ? weight[i] : 1);
    }
    return sum;
}

MURK_TARGET static inline uint64_t
murk_loop_dense(const uint16_t *row, const uint16_t *best,
                const uint32_t *weight, size_t n, bool is_independent)
{
    if (is_independent) {
        return weight ? murk_dense_sum(row, best, weight, n, true)
                      : murk_dense_sum(row, best, NULL, n, true);
    }
    return weight ? murk_dense_sum(row, best, weight, n, false)
                  : murk_dense_sum(row, best, NULL, n, false);
}

MURK_LOOP uint64_t murk_packed_sum(const uint64_t *row, const uint32_t *at,
                                   const uint16_t *clarity,
                                   const uint16_t *best, const uint32_t *weight,
                                   size_t words, bool is_independent,
                                   size_t *used)
{
    uint64_t sum = 0;
    const uint16_t *p = clarity;
    for (size_t k = 0; k < words; ++k) {
        const size_t first = 64 * murk_word_at(at, k);
        const uint16_t *best_of_word = best + first;
        for (uint64_t left = row[k]; left; left &= left - 1) {
            const size_t i = (size_t)__builtin_ctzll(left);
            sum += murk_gain_term(clarity ? *p++ : MURK_CLEAR, best_of_word[i],
                                  is_independent) *
                   (weight ? weight[first + i] : 1);
        }
    }
    *used = (size_t)(p - clarity);
    return sum;
}

/* Defines the kernel packed() (placement/kernels.h) as `name`. `sum` is its
 * loop, which is compiled for each combination of options that a row can have.
 */
#define MURK_PACKED_KERNEL(name, sum)                                         \
    MURK_TARGET static inline uint64_t name(                                  \
        const uint64_t *row, const uint32_t *at, const uint16_t *clarity,     \
        const uint16_t *best, const uint32_t *weight, size_t words,           \
        bool is_independent, size_t *used)                                    \
    {                                                                         \
        if (!clarity) {                                                       \
            return weight                                                     \
                       ? sum(row, at, NULL, best, weight, words, false, used) \
                       : sum(row, at, NULL, best, NULL, words, false, used);  \
        }                                                                     \
        if (weight) {                                                         \
            return sum(row, at, clarity, best, weight, words, is_independent, \
                       used);                                                 \
        }                                                                     \
        return is_independent                                                 \
                   ? sum(row, at, clarity, best, NULL, words, true, used)     \
                   : sum(row, at, clarity, best, NULL, words, false, used);   \
    }

MURK_PACKED_KERNEL(murk_loop_packed, murk_packed_sum)

MURK_TARGET static inline void
murk_loop_lanes(const uint64_t *row, const uint32_t *at,
                const uint16_t *clarity, const uint16_t *best,
                const uint32_t *weight, size_t words, size_t *used,
                uint64_t sum[MURK_COVER_LANES])
{
    const uint16_t *p = clarity;
    for (size_t lane = 0; lane < MURK_COVER_LANES; ++lane) {
        sum[lane] = 0;
    }
    for (size_t k = 0; k < words; ++k) {
        const size_t first = 64 * murk_word_at(at, k);
        for (uint64_t left = row[k]; left; left &= left - 1) {
            const size_t i = first + (size_t)__builtin_ctzll(left);
            const uint16_t given = clarity ? *p++ : MURK_CLEAR;
            for (size_t lane = 0; lane < MURK_COVER_LANES; ++lane) {
                sum[lane] +=
                    murk_gain_term(given, best[MURK_COVER_LANES * i + lane],
                                   false) *
                    (weight ? weight[i] : 1);
            }
        }
    }
    *used = (size_t)(p - clarity);
}

#endif
