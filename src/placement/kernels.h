/* The inner loops of placement: integer sums over one row and one cover.
 *
 * A wide version runs where the processor has it; all sums are exact, so it
 * agrees with its plain twin in every bit. Arrays are 64-byte aligned and
 * padded to whole words of 64 photons; rows are 0 in the padding. A row's
 * words may lie apart: word k is the cover's word at[k] (at NULL: k). */
#ifndef MURK_PLACEMENT_KERNELS_H
#define MURK_PLACEMENT_KERNELS_H

#include <stddef.h>
#include <stdint.h>

typedef struct murk_kernels {
    /* Photons in row and not in full. */
    uint64_t (*count_new)(const uint64_t *row, const uint32_t *at,
                          const uint64_t *full, size_t words);
    /* sum over the row's photons of MURK_CLEAR - best. */
    uint64_t (*sum_missing)(const uint64_t *row, const uint32_t *at,
                            const uint16_t *best, size_t words);
    /* The same, each photon times its weight. */
    uint64_t (*weighted_missing)(const uint64_t *row, const uint32_t *at,
                                 const uint16_t *best, const uint32_t *weight,
                                 size_t words);
    /* sum of max(0, row - best); n is a multiple of 64. */
    uint64_t (*sum_above)(const uint16_t *row, const uint16_t *best, size_t n);
    /* The same, each photon times its weight. */
    uint64_t (*weighted_above)(const uint16_t *row, const uint16_t *best,
                               const uint32_t *weight, size_t n);
    /* sum of max(0, clarity - best) over the row's photons, whose clarities
     * are packed one behind the other (64 bytes behind them may be read);
     * *used: how many. */
    uint64_t (*sum_packed)(const uint64_t *row, const uint32_t *at,
                           const uint16_t *clarity, const uint16_t *best,
                           size_t words, size_t *used);
    /* The same, each photon times its weight. */
    uint64_t (*weighted_packed)(const uint64_t *row, const uint32_t *at,
                                const uint16_t *clarity, const uint16_t *best,
                                const uint32_t *weight, size_t words,
                                size_t *used);
    /* Of sum_above and sum_packed, with row * (MURK_CLEAR - best) / 65536
     * rounded down in place of max(0, row - best). */
    uint64_t (*sum_independent)(const uint16_t *row, const uint16_t *best,
                                size_t n);
    uint64_t (*sum_independent_packed)(const uint64_t *row, const uint32_t *at,
                                       const uint16_t *clarity,
                                       const uint16_t *best, size_t words,
                                       size_t *used);
} murk_kernels;

const murk_kernels *murk_kernels_plain(void);

/* Those that this processor runs, from the plain one on; NULL beyond. */
const murk_kernels *murk_kernels_number(size_t k);

/* NULL where this processor does not run it. */
const murk_kernels *murk_kernels_avx2(void);   /* AVX2, popcnt, bmi */
const murk_kernels *murk_kernels_avx512(void); /* and popcnt of 8 words */

/* The last of them. */
const murk_kernels *murk_kernels_fastest(void);

#endif
