/* Kernels for AVX-512 (bw, vbmi2, vpopcntdq): 32 slots at a time, with bit
 * counts of eight words in one instruction and packed clarities expanded by
 * masks. All sums are exact integers, equal to those of the portable kernels.
 */
#include "placement/kernel_loops.h"
#include "placement/kernels.h"

#if defined(__x86_64__)

#include <immintrin.h>
#include <stdbool.h>

#define WIDE        \
    __attribute__(( \
        target("avx512f,avx512bw,avx512vbmi2,avx512vpopcntdq,popcnt")))

/* A 32-bit lane takes two 16-bit terms a step and is full after 2^15 steps. */
#define STEPS_PER_FLUSH 32768

WIDE static uint64_t count_new_side_by_side(const uint64_t *row,
                                            const uint64_t *full, size_t words)
{
    __m512i sum = _mm512_setzero_si512();
    size_t k = 0;
    for (; k + 8 <= words; k += 8) {
        const __m512i new = _mm512_andnot_si512(_mm512_loadu_si512(full + k),
                                                _mm512_loadu_si512(row + k));
        sum = _mm512_add_epi64(sum, _mm512_popcnt_epi64(new));
    }
    if (k < words) {
        const __mmask8 mask = (__mmask8)((1u << (words - k)) - 1);
        const __m512i new =
            _mm512_andnot_si512(_mm512_maskz_loadu_epi64(mask, full + k),
                                _mm512_maskz_loadu_epi64(mask, row + k));
        sum = _mm512_add_epi64(sum, _mm512_popcnt_epi64(new));
    }
    return (uint64_t)_mm512_reduce_add_epi64(sum);
}

/* A sparse row uses the portable loop: eight single loads are as fast as a
 * gather. */
WIDE static uint64_t count_new_avx512(const uint64_t *row, const uint32_t *at,
                                      const uint64_t *full, size_t words)
{
    return at ? murk_loop_count_new(row, at, full, words)
              : count_new_side_by_side(row, full, words);
}

/* The sum of the 16 unsigned 32-bit lanes. */
WIDE static uint64_t reduce_u32(__m512i sum)
{
    const __m512i even = _mm512_and_si512(sum, _mm512_set1_epi64(0xffffffff));
    const __m512i odd = _mm512_srli_epi64(sum, 32);
    return (uint64_t)_mm512_reduce_add_epi64(_mm512_add_epi64(even, odd));
}

/* Adds the 32 unsigned 16-bit lanes of d to 16 lanes of 32 bits. */
WIDE static inline __m512i fold_u16(__m512i sum, __m512i d)
{
    const __m512i low = _mm512_set1_epi32(0xffff);
    return _mm512_add_epi32(_mm512_add_epi32(sum, _mm512_and_si512(d, low)),
                            _mm512_srli_epi32(d, 16));
}

WIDE static uint64_t sum_missing_avx512(const uint64_t *row, const uint32_t *at,
                                        const uint16_t *best, size_t words)
{
    const __m512i ones = _mm512_set1_epi32(-1);
    uint64_t total = 0;
    for (size_t k = 0; k < words;) {
        /* each word makes two steps */
        const size_t end =
            words - k < STEPS_PER_FLUSH / 2 ? words : k + STEPS_PER_FLUSH / 2;
        __m512i sum = _mm512_setzero_si512();
        for (; k < end; ++k) {
            const uint16_t *p = best + 64 * murk_word_at(at, k);
            const __m512i a = _mm512_xor_si512(_mm512_loadu_si512(p), ones);
            const __m512i b =
                _mm512_xor_si512(_mm512_loadu_si512(p + 32), ones);
            sum = fold_u16(sum, _mm512_maskz_mov_epi16((__mmask32)row[k], a));
            sum = fold_u16(
                sum, _mm512_maskz_mov_epi16((__mmask32)(row[k] >> 32), b));
        }
        total += reduce_u32(sum);
    }
    return total;
}

/* 32 terms: max(0, row - best), or with is_independent row * (MURK_CLEAR -
 * best) / 65536. */
WIDE static inline __m512i part(__m512i row, const uint16_t *best,
                                bool is_independent)
{
    const __m512i at = _mm512_loadu_si512(best);
    return is_independent
               ? _mm512_mulhi_epu16(row,
                                    _mm512_xor_si512(at, _mm512_set1_epi32(-1)))
               : _mm512_subs_epu16(row, at);
}

WIDE static inline uint64_t sum_parts(const uint16_t *row, const uint16_t *best,
                                      size_t n, bool is_independent)
{
    uint64_t total = 0;
    for (size_t i = 0; i < n;) {
        const size_t end = (n - i) / 32 < STEPS_PER_FLUSH
                               ? n
                               : i + (size_t)32 * STEPS_PER_FLUSH;
        __m512i sum = _mm512_setzero_si512();
        for (; i < end; i += 32) {
            sum = fold_u16(sum, part(_mm512_loadu_si512(row + i), best + i,
                                     is_independent));
        }
        total += reduce_u32(sum);
    }
    return total;
}

WIDE static uint64_t sum_above_avx512(const uint16_t *row, const uint16_t *best,
                                      size_t n)
{
    return sum_parts(row, best, n, false);
}

WIDE static uint64_t sum_independent_avx512(const uint16_t *row,
                                            const uint16_t *best, size_t n)
{
    return sum_parts(row, best, n, true);
}

/* sum + the 16 products of 16-bit d (widened to 32-bit lanes) and 32-bit
 * weights. */
WIDE static inline __m512i add_products(__m512i sum, __m256i d,
                                        const uint32_t *weight)
{
    const __m512i wide = _mm512_cvtepu16_epi32(d);
    const __m512i w = _mm512_loadu_si512(weight);
    sum = _mm512_add_epi64(sum, _mm512_mul_epu32(wide, w));
    return _mm512_add_epi64(sum, _mm512_mul_epu32(_mm512_srli_epi64(wide, 32),
                                                  _mm512_srli_epi64(w, 32)));
}

WIDE static uint64_t weighted_above_avx512(const uint16_t *row,
                                           const uint16_t *best,
                                           const uint32_t *weight, size_t n)
{
    __m512i sum = _mm512_setzero_si512();
    for (size_t i = 0; i < n; i += 32) {
        const __m512i d = _mm512_subs_epu16(_mm512_loadu_si512(row + i),
                                            _mm512_loadu_si512(best + i));
        sum = add_products(sum, _mm512_castsi512_si256(d), weight + i);
        sum =
            add_products(sum, _mm512_extracti64x4_epi64(d, 1), weight + i + 16);
    }
    return (uint64_t)_mm512_reduce_add_epi64(sum);
}

WIDE static uint64_t weighted_missing_avx512(const uint64_t *row,
                                             const uint32_t *at,
                                             const uint16_t *best,
                                             const uint32_t *weight,
                                             size_t words)
{
    const __m512i ones = _mm512_set1_epi32(-1);
    __m512i sum = _mm512_setzero_si512();
    for (size_t k = 0; k < words; ++k) {
        for (size_t half = 0; half < 2; ++half) {
            const size_t i = 64 * murk_word_at(at, k) + 32 * half;
            const __m512i d = _mm512_maskz_mov_epi16(
                (__mmask32)(row[k] >> (32 * half)),
                _mm512_xor_si512(_mm512_loadu_si512(best + i), ones));
            sum = add_products(sum, _mm512_castsi512_si256(d), weight + i);
            sum = add_products(sum, _mm512_extracti64x4_epi64(d, 1),
                               weight + i + 16);
        }
    }
    return (uint64_t)_mm512_reduce_add_epi64(sum);
}

/* The terms of 32 slots: clarities from p go to the slots whose bits are set in
 * mask. */
WIDE static inline __m512i expand(const uint16_t *p, uint32_t mask,
                                  const uint16_t *best, bool is_independent)
{
    return part(_mm512_maskz_expand_epi16(mask, _mm512_loadu_si512(p)), best,
                is_independent);
}

WIDE static inline uint64_t sum_packed_parts(const uint64_t *row,
                                             const uint32_t *at,
                                             const uint16_t *clarity,
                                             const uint16_t *best, size_t words,
                                             size_t *used, bool is_independent)
{
    /* Each word makes two steps of 32 slots. */
    uint64_t total = 0;
    const uint16_t *p = clarity;
    for (size_t k = 0; k < words;) {
        const size_t end =
            words - k < STEPS_PER_FLUSH / 2 ? words : k + STEPS_PER_FLUSH / 2;
        __m512i sum = _mm512_setzero_si512();
        for (; k < end; ++k) {
            for (size_t half = 0; half < 2 && row[k]; ++half) {
                const uint32_t mask = (uint32_t)(row[k] >> (32 * half));
                const uint16_t *lowest =
                    best + 64 * murk_word_at(at, k) + 32 * half;
                sum = fold_u16(sum, expand(p, mask, lowest, is_independent));
                p += __builtin_popcount(mask);
            }
        }
        total += reduce_u32(sum);
    }
    *used = (size_t)(p - clarity);
    return total;
}

WIDE static uint64_t sum_packed_avx512(const uint64_t *row, const uint32_t *at,
                                       const uint16_t *clarity,
                                       const uint16_t *best, size_t words,
                                       size_t *used)
{
    return sum_packed_parts(row, at, clarity, best, words, used, false);
}

WIDE static uint64_t sum_independent_packed_avx512(const uint64_t *row,
                                                   const uint32_t *at,
                                                   const uint16_t *clarity,
                                                   const uint16_t *best,
                                                   size_t words, size_t *used)
{
    return sum_packed_parts(row, at, clarity, best, words, used, true);
}

WIDE static uint64_t
weighted_packed_avx512(const uint64_t *row, const uint32_t *at,
                       const uint16_t *clarity, const uint16_t *best,
                       const uint32_t *weight, size_t words, size_t *used)
{
    const uint16_t *p = clarity;
    __m512i sum = _mm512_setzero_si512();
    for (size_t k = 0; k < words; ++k) {
        for (size_t half = 0; half < 2 && row[k]; ++half) {
            const size_t i = 64 * murk_word_at(at, k) + 32 * half;
            const uint32_t mask = (uint32_t)(row[k] >> (32 * half));
            const __m512i d = expand(p, mask, best + i, false);
            sum = add_products(sum, _mm512_castsi512_si256(d), weight + i);
            sum = add_products(sum, _mm512_extracti64x4_epi64(d, 1),
                               weight + i + 16);
            p += __builtin_popcount(mask);
        }
    }
    *used = (size_t)(p - clarity);
    return (uint64_t)_mm512_reduce_add_epi64(sum);
}

static const murk_kernels avx512 = {count_new_avx512,
                                    sum_missing_avx512,
                                    weighted_missing_avx512,
                                    sum_above_avx512,
                                    weighted_above_avx512,
                                    sum_packed_avx512,
                                    weighted_packed_avx512,
                                    sum_independent_avx512,
                                    sum_independent_packed_avx512};

const murk_kernels *murk_kernels_avx512(void)
{
    return __builtin_cpu_supports("avx512f") &&
                   __builtin_cpu_supports("avx512bw") &&
                   __builtin_cpu_supports("avx512vbmi2") &&
                   __builtin_cpu_supports("avx512vpopcntdq")
               ? &avx512
               : NULL;
}

#else

const murk_kernels *murk_kernels_avx512(void)
{
    return NULL;
}

#endif
