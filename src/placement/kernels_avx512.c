/* Kernels for AVX-512 (bw, vbmi2, vpopcntdq): 32 slots at a time, with bit
 * counts of eight words in one instruction and packed clarities expanded by
 * masks. All sums are exact integers, equal to those of the portable kernels.
 */
#include "placement/kernels.h"

#if defined(__x86_64__)

#include <immintrin.h>

#define MURK_TARGET \
    __attribute__(( \
        target("avx512f,avx512bw,avx512vbmi2,avx512vpopcntdq,popcnt")))
#include "placement/kernel_loops.h"

/* A 32-bit lane takes two 16-bit terms a step and is full after 2^15 steps. */
#define STEPS_PER_FLUSH 32768

MURK_TARGET static uint64_t
count_new_side_by_side(const uint64_t *row, const uint64_t *full, size_t words)
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

/* A sparse row (`at` not NULL) uses the portable loop, because eight single
 * loads are as fast as a gather; so does a sum with weights. */
MURK_TARGET static uint64_t count_new(const uint64_t *row, const uint32_t *at,
                                      const uint64_t *full,
                                      const uint32_t *weight, size_t words)
{
    return at || weight ? murk_loop_count_new(row, at, full, weight, words)
                        : count_new_side_by_side(row, full, words);
}

/* The sum of the 16 unsigned 32-bit lanes. */
MURK_TARGET static uint64_t reduce_u32(__m512i sum)
{
    const __m512i even = _mm512_and_si512(sum, _mm512_set1_epi64(0xffffffff));
    const __m512i odd = _mm512_srli_epi64(sum, 32);
    return (uint64_t)_mm512_reduce_add_epi64(_mm512_add_epi64(even, odd));
}

/* Adds the 32 unsigned 16-bit lanes of d to 16 lanes of 32 bits. */
MURK_TARGET static inline __m512i fold_u16(__m512i sum, __m512i d)
{
    const __m512i low = _mm512_set1_epi32(0xffff);
    return _mm512_add_epi32(_mm512_add_epi32(sum, _mm512_and_si512(d, low)),
                            _mm512_srli_epi32(d, 16));
}

/* sum + the 16 products of 16-bit d (widened to 32-bit lanes) and 32-bit
 * weights. */
MURK_TARGET static inline __m512i add_products(__m512i sum, __m256i d,
                                               const uint32_t *weight)
{
    const __m512i wide = _mm512_cvtepu16_epi32(d);
    const __m512i w = _mm512_loadu_si512(weight);
    sum = _mm512_add_epi64(sum, _mm512_mul_epu32(wide, w));
    return _mm512_add_epi64(sum, _mm512_mul_epu32(_mm512_srli_epi64(wide, 32),
                                                  _mm512_srli_epi64(w, 32)));
}

/* Adds 32 terms d to the lanes of sum: 16 lanes of 32 bits, or with weights 8
 * lanes of 64 bits. */
MURK_LOOP __m512i add_terms(__m512i sum, __m512i d, const uint32_t *weight)
{
    if (!weight) {
        return fold_u16(sum, d);
    }
    sum = add_products(sum, _mm512_castsi512_si256(d), weight);
    return add_products(sum, _mm512_extracti64x4_epi64(d, 1), weight + 16);
}

/* The sum of the lanes that add_terms() filled. */
MURK_LOOP uint64_t reduce_terms(__m512i sum, bool has_weights)
{
    return has_weights ? (uint64_t)_mm512_reduce_add_epi64(sum)
                       : reduce_u32(sum);
}

/* murk_gain_term() of 32 slots side by side. */
MURK_TARGET static inline __m512i term(__m512i row, const uint16_t *best,
                                       bool is_independent)
{
    const __m512i at = _mm512_loadu_si512(best);
    return is_independent
               ? _mm512_mulhi_epu16(row,
                                    _mm512_xor_si512(at, _mm512_set1_epi32(-1)))
               : _mm512_subs_epu16(row, at);
}

MURK_LOOP uint64_t sum_dense(const uint16_t *row, const uint16_t *best,
                             const uint32_t *weight, size_t n,
                             bool is_independent)
{
    uint64_t total = 0;
    for (size_t i = 0; i < n;) {
        const size_t end = (n - i) / 32 < STEPS_PER_FLUSH
                               ? n
                               : i + (size_t)32 * STEPS_PER_FLUSH;
        __m512i sum = _mm512_setzero_si512();
        for (; i < end; i += 32) {
            sum = add_terms(
                sum,
                term(_mm512_loadu_si512(row + i), best + i, is_independent),
                weight ? weight + i : NULL);
        }
        total += reduce_terms(sum, weight);
    }
    return total;
}

MURK_TARGET static uint64_t dense(const uint16_t *row, const uint16_t *best,
                                  const uint32_t *weight, size_t n,
                                  bool is_independent)
{
    if (weight) {
        return sum_dense(row, best, weight, n, is_independent);
    }
    return is_independent ? sum_dense(row, best, NULL, n, true)
                          : sum_dense(row, best, NULL, n, false);
}

/* The clarities of 32 slots: those from p go to the slots whose bits are set in
 * mask, all other slots are 0. p NULL: MURK_CLEAR in place of those from p. */
MURK_LOOP __m512i expand(const uint16_t *p, uint32_t mask)
{
    if (!p) {
        return _mm512_maskz_mov_epi16(mask, _mm512_set1_epi32(-1));
    }
    /* The compiler must not read the clarities by the expansion itself: on a
     * processor of AMD that takes half as long again. */
    __m512i packed = _mm512_loadu_si512(p);
    __asm__("" : "+v"(packed));
    return _mm512_maskz_expand_epi16(mask, packed);
}

MURK_LOOP uint64_t sum_packed(const uint64_t *row, const uint32_t *at,
                              const uint16_t *clarity, const uint16_t *best,
                              const uint32_t *weight, size_t words,
                              bool is_independent, size_t *used)
{
    uint64_t total = 0;
    const uint16_t *p = clarity;
    for (size_t k = 0; k < words;) {
        /* Each word makes two steps of 32 slots, with a sum for each. */
        const size_t end =
            words - k < STEPS_PER_FLUSH / 2 ? words : k + STEPS_PER_FLUSH / 2;
        __m512i low = _mm512_setzero_si512(), high = low;
        for (; k < end; ++k) {
            const uint32_t first = (uint32_t)row[k],
                           second = (uint32_t)(row[k] >> 32);
            const uint16_t *q = p ? p + __builtin_popcount(first) : NULL;
            const size_t i = 64 * murk_word_at(at, k);
            low =
                add_terms(low, term(expand(p, first), best + i, is_independent),
                          weight ? weight + i : NULL);
            high = add_terms(
                high, term(expand(q, second), best + i + 32, is_independent),
                weight ? weight + i + 32 : NULL);
            p = q ? q + __builtin_popcount(second) : NULL;
        }
        total += reduce_terms(low, weight) + reduce_terms(high, weight);
    }
    *used = (size_t)(p - clarity);
    return total;
}

MURK_PACKED_KERNEL(packed, sum_packed)

static const murk_kernels avx512 = {count_new, dense, packed,
                                    murk_kernels_avx2_lanes};

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
