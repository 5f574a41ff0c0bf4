/* The AVX-512 intrinsics of the ceiling kdtree.c on a processor with AVX2: a
 * vector is two registers of 256 bits. The program then runs as fast as one
 * written for AVX2, which SIMDe (emulated/immintrin.h) does not reach: a vector
 * of SIMDe is an array in memory, and the program takes four times as long.
 * tools/bench puts the folder of this file before the compiler's own headers on
 * a machine without AVX-512. */
#include_next <immintrin.h>

#ifndef MURK_BENCH_HALVES_IMMINTRIN_H
#define MURK_BENCH_HALVES_IMMINTRIN_H

typedef struct halves {
    __m256 low, high; /* lanes 0 to 7 and 8 to 15 */
} halves;

static inline halves halves_set1(float x)
{
    return (halves){_mm256_set1_ps(x), _mm256_set1_ps(x)};
}

static inline halves halves_sub(halves a, halves b)
{
    return (halves){_mm256_sub_ps(a.low, b.low), _mm256_sub_ps(a.high, b.high)};
}

static inline halves halves_mul(halves a, halves b)
{
    return (halves){_mm256_mul_ps(a.low, b.low), _mm256_mul_ps(a.high, b.high)};
}

static inline halves halves_fmadd(halves a, halves b, halves c)
{
    return (halves){_mm256_fmadd_ps(a.low, b.low, c.low),
                    _mm256_fmadd_ps(a.high, b.high, c.high)};
}

/* All bits of the lanes whose bit in the mask is set, for one half. */
static inline __m256i halves_lanes(unsigned mask)
{
    const __m256i bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    return _mm256_cmpeq_epi32(
        _mm256_and_si256(_mm256_set1_epi32((int)mask), bit), bit);
}

/* Reads all 16 numbers: the arrays of kdtree.c are 64 bytes longer than their
 * points, and a masked load takes longer. */
static inline halves halves_load(unsigned mask, const float *from)
{
    const __m256 low = _mm256_castsi256_ps(halves_lanes(mask));
    const __m256 high = _mm256_castsi256_ps(halves_lanes(mask >> 8));
    return (halves){_mm256_and_ps(low, _mm256_loadu_ps(from)),
                    _mm256_and_ps(high, _mm256_loadu_ps(from + 8))};
}

static inline halves halves_add(halves other, unsigned mask, halves a, halves b)
{
    return (halves){
        _mm256_blendv_ps(other.low, _mm256_add_ps(a.low, b.low),
                         _mm256_castsi256_ps(halves_lanes(mask))),
        _mm256_blendv_ps(other.high, _mm256_add_ps(a.high, b.high),
                         _mm256_castsi256_ps(halves_lanes(mask >> 8)))};
}

/* Bit i: a <= b in lane i. */
static inline unsigned halves_not_above(halves a, halves b)
{
    const __m256 low = _mm256_cmp_ps(a.low, b.low, _CMP_LE_OQ);
    const __m256 high = _mm256_cmp_ps(a.high, b.high, _CMP_LE_OQ);
    return (unsigned)_mm256_movemask_ps(low) |
           (unsigned)_mm256_movemask_ps(high) << 8;
}

static inline float halves_sum(halves v)
{
    float lane[8], sum = 0;
    _mm256_storeu_ps(lane, _mm256_add_ps(v.low, v.high));
    for (int i = 0; i < 8; ++i) {
        sum += lane[i];
    }
    return sum;
}

/* The program's names, in place of those of the compiler. */
#define __m512                         halves
#define __mmask16                      unsigned short
#define _mm512_set1_ps(x)              halves_set1(x)
#define _mm512_setzero_ps()            halves_set1(0)
#define _mm512_sub_ps(a, b)            halves_sub(a, b)
#define _mm512_mul_ps(a, b)            halves_mul(a, b)
#define _mm512_fmadd_ps(a, b, c)       halves_fmadd(a, b, c)
#define _mm512_maskz_loadu_ps(k, from) halves_load(k, from)
#define _mm512_mask_add_ps(v, k, a, b) halves_add(v, k, a, b)
#define _mm512_mask_cmp_ps_mask(k, a, b, relation) \
    ((__mmask16)((k)&halves_not_above(a, b)))
#define _mm512_reduce_add_ps(v) halves_sum(v)

#endif
