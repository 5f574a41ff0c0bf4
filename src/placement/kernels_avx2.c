/* Kernels for AVX2. The loops over bits are the portable ones, compiled with
 * popcnt and bmi; the loops over clarities process 16 slots at a time. All sums
 * are exact integers, equal to those of the portable kernels. */
#include "placement/kernel_loops.h"
#include "placement/kernels.h"

#if defined(__x86_64__)

#include <immintrin.h>
#include <stdbool.h>

#define AVX2 __attribute__((target("avx2,popcnt,bmi")))

MURK_COMPILE_LOOPS(avx2, AVX2)

/* A 32-bit lane takes two 16-bit terms a step and is full after 2^15 steps. */
#define STEPS_PER_FLUSH 32768

/* 16 terms: max(0, row - best), or with is_independent row * (MURK_CLEAR -
 * best) / 65536. */
AVX2 static inline __m256i part(__m256i row, __m256i best, bool is_independent)
{
    return is_independent
               ? _mm256_mulhi_epu16(
                     row, _mm256_xor_si256(best, _mm256_set1_epi32(-1)))
               : _mm256_subs_epu16(row, best);
}

/* The sum of the terms, with a flush of the 32-bit lanes to 64 bits. */
AVX2 static inline uint64_t sum_parts(const uint16_t *row, const uint16_t *best,
                                      size_t n, bool is_independent)
{
    const __m256i low = _mm256_set1_epi32(0xffff);
    const __m256i zero = _mm256_setzero_si256();
    __m256i total = zero;
    for (size_t i = 0; i < n;) {
        const size_t steps = (n - i) / 16;
        size_t left = steps < STEPS_PER_FLUSH ? steps : STEPS_PER_FLUSH;
        __m256i sum = zero;
        for (; left > 0; --left, i += 16) {
            const __m256i d = part(_mm256_load_si256((const void *)(row + i)),
                                   _mm256_load_si256((const void *)(best + i)),
                                   is_independent);
            sum = _mm256_add_epi32(sum, _mm256_and_si256(d, low));
            sum = _mm256_add_epi32(sum, _mm256_srli_epi32(d, 16));
        }
        total = _mm256_add_epi64(total, _mm256_unpacklo_epi32(sum, zero));
        total = _mm256_add_epi64(total, _mm256_unpackhi_epi32(sum, zero));
    }
    uint64_t lane[4];
    _mm256_storeu_si256((void *)lane, total);
    return lane[0] + lane[1] + lane[2] + lane[3];
}

AVX2 static uint64_t sum_above_avx2(const uint16_t *row, const uint16_t *best,
                                    size_t n)
{
    return sum_parts(row, best, n, false);
}

AVX2 static uint64_t sum_independent_avx2(const uint16_t *row,
                                          const uint16_t *best, size_t n)
{
    return sum_parts(row, best, n, true);
}

static const murk_kernels avx2 = {
    count_new_avx2,       sum_missing_avx2,     weighted_missing_avx2,
    sum_above_avx2,       weighted_above_avx2,  sum_packed_avx2,
    weighted_packed_avx2, sum_independent_avx2, sum_independent_packed_avx2};

const murk_kernels *murk_kernels_avx2(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("popcnt") &&
                   __builtin_cpu_supports("bmi")
               ? &avx2
               : NULL;
}

#else

const murk_kernels *murk_kernels_avx2(void)
{
    return NULL;
}

#endif
