/* Kernels for AVX2. The loops over bits are the portable ones, compiled with
 * popcnt and bmi; the loop over dense clarities without weights processes 16
 * slots at a time. All sums are exact integers, equal to those of the portable
 * kernels. */
#include "placement/kernels.h"

#if defined(__x86_64__)

#include <immintrin.h>

#define MURK_TARGET __attribute__((target("avx2,popcnt,bmi")))
#include "placement/kernel_loops.h"

/* A 32-bit lane takes two 16-bit terms a step and is full after 2^15 steps. */
#define STEPS_PER_FLUSH 32768

/* 16 times murk_gain_term(). */
MURK_TARGET static inline __m256i term(__m256i row, __m256i best,
                                       bool is_independent)
{
    return is_independent
               ? _mm256_mulhi_epu16(
                     row, _mm256_xor_si256(best, _mm256_set1_epi32(-1)))
               : _mm256_subs_epu16(row, best);
}

/* The sum of the terms, with a flush of the 32-bit lanes to 64 bits. */
MURK_LOOP uint64_t sum_terms(const uint16_t *row, const uint16_t *best,
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
            const __m256i d = term(_mm256_load_si256((const void *)(row + i)),
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

MURK_TARGET static uint64_t dense(const uint16_t *row, const uint16_t *best,
                                  const uint32_t *weight, size_t n,
                                  bool is_independent)
{
    return weight ? murk_loop_dense(row, best, weight, n, is_independent)
           : is_independent ? sum_terms(row, best, n, true)
                            : sum_terms(row, best, n, false);
}

static const murk_kernels avx2 = {murk_loop_count_new, dense, murk_loop_packed};

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
