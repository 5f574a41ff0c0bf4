/* The portable inner loops, slot by slot. They are compiled twice: for any
 * processor, and for processors with instructions that count and find bits. */
#ifndef MURK_PLACEMENT_KERNEL_LOOPS_H
#define MURK_PLACEMENT_KERNEL_LOOPS_H

#include "placement/problem.h"

static inline size_t murk_word_at(const uint32_t *at, size_t k)
{
    return at ? at[k] : k;
}

static inline uint64_t murk_loop_count_new(const uint64_t *row,
                                           const uint32_t *at,
                                           const uint64_t *full, size_t words)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < words; ++k) {
        sum +=
            (uint64_t)__builtin_popcountll(row[k] & ~full[murk_word_at(at, k)]);
    }
    return sum;
}

static inline uint64_t murk_loop_sum_missing(const uint64_t *row,
                                             const uint32_t *at,
                                             const uint16_t *best, size_t words)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < words; ++k) {
        const uint16_t *b = best + 64 * murk_word_at(at, k);
        for (uint64_t left = row[k]; left; left &= left - 1) {
            sum += MURK_CLEAR - (uint64_t)b[__builtin_ctzll(left)];
        }
    }
    return sum;
}

static inline uint64_t murk_loop_weighted_missing(const uint64_t *row,
                                                  const uint32_t *at,
                                                  const uint16_t *best,
                                                  const uint32_t *weight,
                                                  size_t words)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < words; ++k) {
        const size_t first = 64 * murk_word_at(at, k);
        for (uint64_t left = row[k]; left; left &= left - 1) {
            const size_t i = first + (size_t)__builtin_ctzll(left);
            sum += (MURK_CLEAR - (uint64_t)best[i]) * weight[i];
        }
    }
    return sum;
}

static inline uint64_t murk_loop_sum_above(const uint16_t *row,
                                           const uint16_t *best, size_t n)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < n; ++i) {
        sum += row[i] > best[i] ? (uint64_t)(row[i] - best[i]) : 0;
    }
    return sum;
}

static inline uint64_t murk_loop_weighted_above(const uint16_t *row,
                                                const uint16_t *best,
                                                const uint32_t *weight,
                                                size_t n)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < n; ++i) {
        sum += row[i] > best[i] ? (uint64_t)(row[i] - best[i]) * weight[i] : 0;
    }
    return sum;
}

static inline uint64_t murk_loop_sum_packed(const uint64_t *row,
                                            const uint32_t *at,
                                            const uint16_t *clarity,
                                            const uint16_t *best, size_t words,
                                            size_t *used)
{
    uint64_t sum = 0;
    const uint16_t *p = clarity;
    for (size_t k = 0; k < words; ++k) {
        const uint16_t *lowest = best + 64 * murk_word_at(at, k);
        for (uint64_t left = row[k]; left; left &= left - 1, ++p) {
            const uint16_t b = lowest[__builtin_ctzll(left)];
            sum += *p > b ? (uint64_t)(*p - b) : 0;
        }
    }
    *used = (size_t)(p - clarity);
    return sum;
}

static inline uint64_t
murk_loop_weighted_packed(const uint64_t *row, const uint32_t *at,
                          const uint16_t *clarity, const uint16_t *best,
                          const uint32_t *weight, size_t words, size_t *used)
{
    uint64_t sum = 0;
    const uint16_t *p = clarity;
    for (size_t k = 0; k < words; ++k) {
        const size_t first = 64 * murk_word_at(at, k);
        for (uint64_t left = row[k]; left; left &= left - 1, ++p) {
            const size_t i = first + (size_t)__builtin_ctzll(left);
            sum += *p > best[i] ? (uint64_t)(*p - best[i]) * weight[i] : 0;
        }
    }
    *used = (size_t)(p - clarity);
    return sum;
}

static inline uint64_t murk_loop_independent_gain(uint16_t row, uint16_t best)
{
    return (uint64_t)row * (uint64_t)(MURK_CLEAR - best) >> 16;
}

static inline uint64_t murk_loop_sum_independent(const uint16_t *row,
                                                 const uint16_t *best, size_t n)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < n; ++i) {
        sum += murk_loop_independent_gain(row[i], best[i]);
    }
    return sum;
}

static inline uint64_t
murk_loop_sum_independent_packed(const uint64_t *row, const uint32_t *at,
                                 const uint16_t *clarity, const uint16_t *best,
                                 size_t words, size_t *used)
{
    uint64_t sum = 0;
    const uint16_t *p = clarity;
    for (size_t k = 0; k < words; ++k) {
        const uint16_t *lowest = best + 64 * murk_word_at(at, k);
        for (uint64_t left = row[k]; left; left &= left - 1, ++p) {
            sum +=
                murk_loop_independent_gain(*p, lowest[__builtin_ctzll(left)]);
        }
    }
    *used = (size_t)(p - clarity);
    return sum;
}

/* Defines the loops as functions NAME_SUFFIX, compiled for `TARGET`, an
 * attribute that may be empty. */
#define MURK_COMPILE_LOOPS(SUFFIX, TARGET)                                     \
    TARGET static uint64_t count_new_##SUFFIX(                                 \
        const uint64_t *row, const uint32_t *at, const uint64_t *full,         \
        size_t words)                                                          \
    {                                                                          \
        return murk_loop_count_new(row, at, full, words);                      \
    }                                                                          \
    TARGET static uint64_t sum_missing_##SUFFIX(                               \
        const uint64_t *row, const uint32_t *at, const uint16_t *best,         \
        size_t words)                                                          \
    {                                                                          \
        return murk_loop_sum_missing(row, at, best, words);                    \
    }                                                                          \
    TARGET static uint64_t weighted_missing_##SUFFIX(                          \
        const uint64_t *row, const uint32_t *at, const uint16_t *best,         \
        const uint32_t *weight, size_t words)                                  \
    {                                                                          \
        return murk_loop_weighted_missing(row, at, best, weight, words);       \
    }                                                                          \
    TARGET static uint64_t weighted_above_##SUFFIX(                            \
        const uint16_t *row, const uint16_t *best, const uint32_t *weight,     \
        size_t n)                                                              \
    {                                                                          \
        return murk_loop_weighted_above(row, best, weight, n);                 \
    }                                                                          \
    TARGET static uint64_t sum_packed_##SUFFIX(                                \
        const uint64_t *row, const uint32_t *at, const uint16_t *clarity,      \
        const uint16_t *best, size_t words, size_t *used)                      \
    {                                                                          \
        return murk_loop_sum_packed(row, at, clarity, best, words, used);      \
    }                                                                          \
    TARGET static uint64_t weighted_packed_##SUFFIX(                           \
        const uint64_t *row, const uint32_t *at, const uint16_t *clarity,      \
        const uint16_t *best, const uint32_t *weight, size_t words,            \
        size_t *used)                                                          \
    {                                                                          \
        return murk_loop_weighted_packed(row, at, clarity, best, weight,       \
                                         words, used);                         \
    }                                                                          \
    TARGET static uint64_t sum_independent_packed_##SUFFIX(                    \
        const uint64_t *row, const uint32_t *at, const uint16_t *clarity,      \
        const uint16_t *best, size_t words, size_t *used)                      \
    {                                                                          \
        return murk_loop_sum_independent_packed(row, at, clarity, best, words, \
                                                used);                         \
    }

#endif
