/* Inner loops of placement: integer sums over one row and one cover, with a
 * version for each instruction set.
 *
 * All sums are exact, so every version gives the same bits. Arrays of slots are
 * padded to whole words of 64 slots, and rows are 0 in the padding; the arrays
 * of dense() are aligned to 64 bytes. A row may store only some words: its word
 * k belongs to word at[k] of the cover (at NULL: k). Each term is multiplied by
 * the weight of its slot; weight NULL stands for weights of 1. */
#ifndef MURK_PLACEMENT_KERNELS_H
#define MURK_PLACEMENT_KERNELS_H

#include "placement/cover_lanes.h"
#include "placement/problem.h"

typedef struct murk_kernels {
    /* Sum of the weights of the bits that are set in row and not in full; their
     * number with weight NULL. */
    uint64_t (*count_new)(const uint64_t *row, const uint32_t *at,
                          const uint64_t *full, const uint32_t *weight,
                          size_t words);
    /* Sum of murk_gain_term() (placement/kernel_loops.h) over all slots; n is a
     * multiple of 64. */
    uint64_t (*dense)(const uint16_t *row, const uint16_t *best,
                      const uint32_t *weight, size_t n, bool is_independent);
    /* Sum of murk_gain_term() over the set bits of the row. The clarities of
     * the set bits lie one after the other; *used is the number of clarities
     * read. Up to 64 bytes behind them may be read. clarity NULL: all are
     * MURK_CLEAR, *used is 0, and is_independent must be false. */
    uint64_t (*packed)(const uint64_t *row, const uint32_t *at,
                       const uint16_t *clarity, const uint16_t *best,
                       const uint32_t *weight, size_t words,
                       bool is_independent, size_t *used);
    /* The terms max(0, clarity - best) of packed() over MURK_COVER_LANES covers
     * at once: best[slot * MURK_COVER_LANES + lane] is aligned to 64 bytes, and
     * sum[lane] receives the sum over the cover of the lane. */
    void (*lanes)(const uint64_t *row, const uint32_t *at,
                  const uint16_t *clarity, const uint16_t *best,
                  const uint32_t *weight, size_t words, size_t *used,
                  uint64_t sum[MURK_COVER_LANES]);
} murk_kernels;

/* Version k of those that this processor can run, the portable one first; NULL
 * beyond the last. */
const murk_kernels *murk_kernels_number(size_t k);

/* The versions for AVX2 (with popcnt and bmi) and AVX-512 (with bw, vpopcntdq
 * and vbmi2). NULL if this processor cannot run them. */
const murk_kernels *murk_kernels_avx2(void);
const murk_kernels *murk_kernels_avx512(void);

/* lanes() of AVX2, which is also that of AVX-512. */
void murk_kernels_avx2_lanes(const uint64_t *row, const uint32_t *at,
                             const uint16_t *clarity, const uint16_t *best,
                             const uint32_t *weight, size_t words, size_t *used,
                             uint64_t sum[MURK_COVER_LANES]);

/* The last of the versions that murk_kernels_number() lists. */
const murk_kernels *murk_kernels_fastest(void);

#endif
