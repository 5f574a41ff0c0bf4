/* Inner loops of placement: integer sums over one row and one cover, with a
 * version for each instruction set.
 *
 * All sums are exact, so every version gives the same bits. Arrays are aligned
 * to 64 bytes and padded to whole words of 64 slots; rows are 0 in the padding.
 * A row may store only some words: its word k belongs to word at[k] of the
 * cover (at NULL: k). */
#ifndef MURK_PLACEMENT_KERNELS_H
#define MURK_PLACEMENT_KERNELS_H

#include <stddef.h>
#include <stdint.h>

typedef struct murk_kernels {
    /* Number of bits that are set in row and not in full. */
    uint64_t (*count_new)(const uint64_t *row, const uint32_t *at,
                          const uint64_t *full, size_t words);
    /* Sum of MURK_CLEAR - best over the set bits of the row. */
    uint64_t (*sum_missing)(const uint64_t *row, const uint32_t *at,
                            const uint16_t *best, size_t words);
    /* The same, each term times the weight of the slot. */
    uint64_t (*weighted_missing)(const uint64_t *row, const uint32_t *at,
                                 const uint16_t *best, const uint32_t *weight,
                                 size_t words);
    /* Sum of max(0, row - best); n is a multiple of 64. */
    uint64_t (*sum_above)(const uint16_t *row, const uint16_t *best, size_t n);
    /* The same, each term times the weight of the slot. */
    uint64_t (*weighted_above)(const uint16_t *row, const uint16_t *best,
                               const uint32_t *weight, size_t n);
    /* Sum of max(0, clarity - best) over the set bits of the row. The clarities
     * of the set bits lie one after the other; *used is their number. Up to 64
     * bytes behind them may be read. */
    uint64_t (*sum_packed)(const uint64_t *row, const uint32_t *at,
                           const uint16_t *clarity, const uint16_t *best,
                           size_t words, size_t *used);
    /* The same, each term times the weight of the slot. */
    uint64_t (*weighted_packed)(const uint64_t *row, const uint32_t *at,
                                const uint16_t *clarity, const uint16_t *best,
                                const uint32_t *weight, size_t words,
                                size_t *used);
    /* As sum_above and sum_packed, with row * (MURK_CLEAR - best) / 65536,
     * rounded down, in place of max(0, row - best): the gain of independent
     * detection. */
    uint64_t (*sum_independent)(const uint16_t *row, const uint16_t *best,
                                size_t n);
    uint64_t (*sum_independent_packed)(const uint64_t *row, const uint32_t *at,
                                       const uint16_t *clarity,
                                       const uint16_t *best, size_t words,
                                       size_t *used);
} murk_kernels;

const murk_kernels *murk_kernels_plain(void);

/* Version k of those that this processor can run, the portable one first; NULL
 * beyond the last. */
const murk_kernels *murk_kernels_number(size_t k);

/* The versions for AVX2 (with popcnt and bmi) and AVX-512 (with vpopcntdq and
 * vbmi2). NULL if this processor cannot run them. */
const murk_kernels *murk_kernels_avx2(void);
const murk_kernels *murk_kernels_avx512(void);

/* The last of these versions. */
const murk_kernels *murk_kernels_fastest(void);

#endif
