/* Kernels for AVX2. The loops over bits are the portable ones, compiled with
 * popcnt and bmi; the loop over dense clarities without weights processes 16
 * slots at a time. Packed clarities are spread over their slots eight at a
 * time, by a byte shuffle whose control is looked up by the eight bits of the
 * row. All sums are exact integers, equal to those of the portable kernels. */
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

/* ---- packed clarities ---- */

/* Controls of a byte shuffle for each value m of eight bits: the clarity of
 * rank r, which is the r-th one in memory, moves to the slot of the r-th bit
 * that is set in m. Slots without a bit become 0 (0x80). */
#define RANK(m, k) __builtin_popcount((m) & ((1 << (k)) - 1))
#define PAIR(m, k)                                   \
    (uint8_t)((m) >> (k)&1 ? 2 * RANK(m, k) : 0x80), \
        (uint8_t)((m) >> (k)&1 ? 2 * RANK(m, k) + 1 : 0x80)
#define SPREAD(m)                                                   \
    {                                                               \
        PAIR(m, 0), PAIR(m, 1), PAIR(m, 2), PAIR(m, 3), PAIR(m, 4), \
            PAIR(m, 5), PAIR(m, 6), PAIR(m, 7)                      \
    }
#define SPREAD_4(m) SPREAD(m), SPREAD((m) + 1), SPREAD((m) + 2), SPREAD((m) + 3)
#define SPREAD_16(m) \
    SPREAD_4(m), SPREAD_4((m) + 4), SPREAD_4((m) + 8), SPREAD_4((m) + 12)
#define SPREAD_64(m) \
    SPREAD_16(m), SPREAD_16((m) + 16), SPREAD_16((m) + 32), SPREAD_16((m) + 48)
static const uint8_t spread[256][16] __attribute__((aligned(16))) = {
    SPREAD_64(0), SPREAD_64(64), SPREAD_64(128), SPREAD_64(192)};

/* The numbers of set bits below each byte of the word, one byte each; the
 * highest byte of the product would be the number of all. */
static inline uint64_t bits_below_bytes(uint64_t word)
{
    const uint64_t ones = UINT64_C(0x0101010101010101);
    uint64_t count = word - ((word >> 1) & 0x55 * ones);
    count = (count & 0x33 * ones) + ((count >> 2) & 0x33 * ones);
    count = (count + (count >> 4)) & 0x0f * ones;
    return (count * ones) << 8;
}

/* The clarities of eight slots: those from p go to the slots whose bits are set
 * in mask, all other slots are 0. p NULL: MURK_CLEAR in place of those from p.
 */
MURK_LOOP __m128i expand(const uint16_t *p, uint8_t mask)
{
    if (p) {
        return _mm_shuffle_epi8(_mm_loadu_si128((const void *)p),
                                _mm_load_si128((const void *)spread[mask]));
    }
    const __m128i bit = _mm_setr_epi16(1, 2, 4, 8, 16, 32, 64, 128);
    return _mm_cmpeq_epi16(_mm_and_si128(_mm_set1_epi16(mask), bit), bit);
}

/* Adds 8 terms to the lanes of sum: 8 lanes of 32 bits, or with weights 4 lanes
 * of 64 bits. */
MURK_LOOP __m256i add_terms(__m256i sum, __m128i d, const uint32_t *weight)
{
    const __m256i wide = _mm256_cvtepu16_epi32(d);
    if (!weight) {
        return _mm256_add_epi32(sum, wide);
    }
    const __m256i w = _mm256_loadu_si256((const void *)weight);
    sum = _mm256_add_epi64(sum, _mm256_mul_epu32(wide, w));
    return _mm256_add_epi64(sum, _mm256_mul_epu32(_mm256_srli_epi64(wide, 32),
                                                  _mm256_srli_epi64(w, 32)));
}

/* The sum of the lanes that add_terms() filled. */
MURK_LOOP uint64_t reduce_terms(__m256i sum, bool has_weights)
{
    uint64_t lane[4];
    if (!has_weights) {
        const __m256i zero = _mm256_setzero_si256();
        sum = _mm256_add_epi64(_mm256_unpacklo_epi32(sum, zero),
                               _mm256_unpackhi_epi32(sum, zero));
    }
    _mm256_storeu_si256((void *)lane, sum);
    return lane[0] + lane[1] + lane[2] + lane[3];
}

/* A word makes eight steps, in each of which a 32-bit lane takes one term: so
 * many words fill the lane. */
#define WORDS_PER_FLUSH 8192

/* The terms of the eight slots of one byte of a word, best of the first of
 * them. */
MURK_LOOP __m128i terms_of_byte(uint64_t word, uint64_t below, int byte,
                                const uint16_t *p, const uint16_t *best,
                                bool is_independent)
{
    const __m128i given = expand(p ? p + (uint8_t)(below >> (8 * byte)) : NULL,
                                 (uint8_t)(word >> (8 * byte)));
    const __m128i old = _mm_loadu_si128((const void *)(best + 8 * byte));
    return is_independent
               ? _mm_mulhi_epu16(given, _mm_xor_si128(old, _mm_set1_epi32(-1)))
               : _mm_subs_epu16(given, old);
}

/* Each word makes eight steps, written out so that all shifts are constants. */
MURK_LOOP uint64_t sum_packed(const uint64_t *row, const uint32_t *at,
                              const uint16_t *clarity, const uint16_t *best,
                              const uint32_t *weight, size_t words,
                              bool is_independent, size_t *used)
{
    const uint16_t *p = clarity;
    uint64_t total = 0;
    for (size_t k = 0; k < words;) {
        const size_t end =
            words - k < WORDS_PER_FLUSH ? words : k + WORDS_PER_FLUSH;
        __m256i sum = _mm256_setzero_si256();
        for (; k < end; ++k) {
            const uint64_t word = row[k];
            const uint64_t below = p ? bits_below_bytes(word) : 0;
            const size_t first = 64 * murk_word_at(at, k);
            /* Byte b of the word has slots 8 b to 8 b + 7 of the word. */
#define STEP(byte)                                                         \
    sum = add_terms(                                                       \
        sum,                                                               \
        terms_of_byte(word, below, byte, p, best + first, is_independent), \
        weight ? weight + first + 8 * (byte) : NULL)
            STEP(0);
            STEP(1);
            STEP(2);
            STEP(3);
            STEP(4);
            STEP(5);
            STEP(6);
            STEP(7);
#undef STEP
            if (p) {
                p += __builtin_popcountll(word);
            }
        }
        total += reduce_terms(sum, weight);
    }
    *used = (size_t)(p - clarity);
    return total;
}

MURK_PACKED_KERNEL(packed, sum_packed)

/* ---- many covers at once ---- */

/* A lane of 32 bits takes one term an entry: so many words of 64 entries fill
 * the lane. */
#define WORDS_PER_LANE_FLUSH 1024

/* Accumulators of the terms of all lanes. Without weights element 0 has the
 * even lanes and element 1 the odd ones, in 32 bits. With weights the even
 * lanes are in elements 0 and 1, the odd ones in 2 and 3, in 64 bits. */
typedef struct lane_sums {
    __m256i of[4];
} lane_sums;

/* Adds the products of the 32-bit lanes x and the weight. */
MURK_TARGET static inline void add_weighted(__m256i of[2], __m256i x, __m256i w)
{
    of[0] = _mm256_add_epi64(of[0], _mm256_mul_epu32(x, w));
    of[1] =
        _mm256_add_epi64(of[1], _mm256_mul_epu32(_mm256_srli_epi64(x, 32), w));
}

MURK_LOOP void add_lanes(lane_sums *sums, __m256i d, const uint32_t *weight)
{
    const __m256i even = _mm256_and_si256(d, _mm256_set1_epi32(0xffff));
    const __m256i odd = _mm256_srli_epi32(d, 16);
    if (weight) {
        const __m256i w = _mm256_set1_epi32((int)*weight);
        add_weighted(sums->of, even, w);
        add_weighted(sums->of + 2, odd, w);
    } else {
        sums->of[0] = _mm256_add_epi32(sums->of[0], even);
        sums->of[1] = _mm256_add_epi32(sums->of[1], odd);
    }
}

/* Adds the accumulators to sum[] in the order of the lanes, and empties them.
 */
MURK_LOOP void flush_lanes(lane_sums *sums, bool has_weights,
                           uint64_t sum[MURK_COVER_LANES])
{
    for (size_t part = 0; part < (has_weights ? 4 : 2); ++part) {
        uint64_t of_64[4];
        uint32_t of_32[8];
        _mm256_storeu_si256((void *)of_64, sums->of[part]);
        _mm256_storeu_si256((void *)of_32, sums->of[part]);
        for (size_t k = 0; k < 4 && has_weights; ++k) {
            sum[4 * k + 2 * (part % 2) + part / 2] += of_64[k];
        }
        for (size_t k = 0; k < 8 && !has_weights; ++k) {
            sum[2 * k + part] += of_32[k];
        }
        sums->of[part] = _mm256_setzero_si256();
    }
}

MURK_LOOP void sum_lanes(const uint64_t *row, const uint32_t *at,
                         const uint16_t *clarity, const uint16_t *best,
                         const uint32_t *weight, size_t words, size_t *used,
                         uint64_t sum[MURK_COVER_LANES])
{
    const uint16_t *p = clarity;
    const __m256i zero = _mm256_setzero_si256();
    lane_sums sums = {{zero, zero, zero, zero}};
    for (size_t lane = 0; lane < MURK_COVER_LANES; ++lane) {
        sum[lane] = 0;
    }
    for (size_t k = 0; k < words;) {
        const size_t end =
            words - k < WORDS_PER_LANE_FLUSH ? words : k + WORDS_PER_LANE_FLUSH;
        /* Each entry is compared with the clarities of all lanes. */
        for (; k < end; ++k) {
            const size_t first = 64 * murk_word_at(at, k);
            for (uint64_t left = row[k]; left; left &= left - 1) {
                const size_t i = first + (size_t)__builtin_ctzll(left);
                const __m256i given =
                    _mm256_set1_epi16((short)(clarity ? *p++ : MURK_CLEAR));
                const __m256i old = _mm256_load_si256(
                    (const void *)(best + MURK_COVER_LANES * i));
                add_lanes(&sums, _mm256_subs_epu16(given, old),
                          weight ? weight + i : NULL);
            }
        }
        flush_lanes(&sums, weight, sum);
    }
    *used = (size_t)(p - clarity);
}

MURK_TARGET void
murk_kernels_avx2_lanes(const uint64_t *row, const uint32_t *at,
                        const uint16_t *clarity, const uint16_t *best,
                        const uint32_t *weight, size_t words, size_t *used,
                        uint64_t sum[MURK_COVER_LANES])
{
    if (!clarity) {
        sum_lanes(row, at, NULL, best, weight, words, used, sum);
    } else if (weight) {
        sum_lanes(row, at, clarity, best, weight, words, used, sum);
    } else {
        sum_lanes(row, at, clarity, best, NULL, words, used, sum);
    }
}

static const murk_kernels avx2 = {murk_loop_count_new, dense, packed,
                                  murk_kernels_avx2_lanes};

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
