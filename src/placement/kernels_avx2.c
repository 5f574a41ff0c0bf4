/* Kernels for AVX2. The loops over bits are the portable ones, compiled with
 * popcnt and bmi; the loop over dense clarities without weights processes 16
 * slots at a time. Packed clarities are spread over their slots sixteen at a
 * time, by byte shuffles whose controls are looked up by eight bits of the row
 * each. All sums are exact integers, equal to those of the portable kernels. */
#include "placement/kernels.h"

#if defined(__x86_64__)

#include <immintrin.h>

#define MURK_TARGET __attribute__((target("avx2,popcnt,bmi")))
#include "placement/kernel_loops.h"

/* A 32-bit lane takes two 16-bit terms a step and is full after 2^15 steps. */
#define STEPS_PER_FLUSH 32768

/* murk_gain_term() of 16 slots. */
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

/* The clarities of 16 slots, those of the two bytes of the word from bit
 * `shift` on: those from p, the clarities of the whole word, go to the slots
 * whose bits are set, all other slots are 0. p NULL: MURK_CLEAR in place of
 * those from p. */
MURK_LOOP __m256i expand(const uint16_t *p, uint64_t word, int shift)
{
    if (!p) {
        const __m256i bit =
            _mm256_setr_epi16(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048,
                              4096, 8192, 16384, (short)32768);
        return _mm256_cmpeq_epi16(
            _mm256_and_si256(_mm256_set1_epi16((short)(word >> shift)), bit),
            bit);
    }
    /* Each byte begins behind the clarities of the bits below it. */
    const uint16_t *low =
        p + (shift > 0 ? __builtin_popcountll(word << (64 - shift)) : 0);
    const uint16_t *high = p + __builtin_popcountll(word << (56 - shift));
    const __m256i given = _mm256_inserti128_si256(
        _mm256_castsi128_si256(_mm_loadu_si128((const void *)low)),
        _mm_loadu_si128((const void *)high), 1);
    const __m256i control = _mm256_inserti128_si256(
        _mm256_castsi128_si256(
            _mm_load_si128((const void *)spread[(uint8_t)(word >> shift)])),
        _mm_load_si128((const void *)spread[(uint8_t)(word >> (shift + 8))]),
        1);
    return _mm256_shuffle_epi8(given, control);
}

/* Sums of 16-bit terms. Without weights `pairs` has 8 lanes of 32 bits, each
 * the sum of the pairs of terms, low + 65536 high, modulo 2^32, and `high` the
 * sum of the high terms. With weights `pairs` has 4 lanes of 64 bits. */
typedef struct term_sums {
    __m256i pairs, high;
} term_sums;

/* Adds the products of 8 terms and their weights. */
MURK_LOOP __m256i add_products(__m256i sum, __m128i d, const uint32_t *weight)
{
    const __m256i wide = _mm256_cvtepu16_epi32(d);
    const __m256i w = _mm256_loadu_si256((const void *)weight);
    sum = _mm256_add_epi64(sum, _mm256_mul_epu32(wide, w));
    return _mm256_add_epi64(sum, _mm256_mul_epu32(_mm256_srli_epi64(wide, 32),
                                                  _mm256_srli_epi64(w, 32)));
}

/* Adds 16 terms. */
MURK_LOOP void add_terms(term_sums *sums, __m256i d, const uint32_t *weight)
{
    if (weight) {
        sums->pairs =
            add_products(sums->pairs, _mm256_castsi256_si128(d), weight);
        sums->pairs = add_products(sums->pairs, _mm256_extracti128_si256(d, 1),
                                   weight + 8);
    } else {
        sums->pairs = _mm256_add_epi32(sums->pairs, d);
        sums->high = _mm256_add_epi32(sums->high, _mm256_srli_epi32(d, 16));
    }
}

/* The sum of all terms that add_terms() has added. */
MURK_LOOP uint64_t reduce_terms(const term_sums *sums, bool has_weights)
{
    uint64_t lane[4];
    __m256i sum = sums->pairs;
    if (!has_weights) {
        const __m256i zero = _mm256_setzero_si256(), high = sums->high;
        const __m256i low = _mm256_sub_epi32(sum, _mm256_slli_epi32(high, 16));
        sum = _mm256_add_epi64(
            _mm256_add_epi64(_mm256_unpacklo_epi32(low, zero),
                             _mm256_unpackhi_epi32(low, zero)),
            _mm256_add_epi64(_mm256_unpacklo_epi32(high, zero),
                             _mm256_unpackhi_epi32(high, zero)));
    }
    _mm256_storeu_si256((void *)lane, sum);
    return lane[0] + lane[1] + lane[2] + lane[3];
}

/* A word makes four steps, in each of which a 32-bit lane takes one low and one
 * high term: so many words fill the sum of either. */
#define WORDS_PER_FLUSH 16384

/* Each word makes four steps, written out so that all shifts are constants. */
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
        const __m256i zero = _mm256_setzero_si256();
        term_sums sums = {zero, zero};
        for (; k < end; ++k) {
            const uint64_t word = row[k];
            const size_t first = 64 * murk_word_at(at, k);
            /* The step takes slots `shift` to shift + 15 of the word. */
#define STEP(shift)                                                            \
    add_terms(&sums,                                                           \
              term(expand(p, word, shift),                                     \
                   _mm256_loadu_si256((const void *)(best + first + (shift))), \
                   is_independent),                                            \
              weight ? weight + first + (shift) : NULL)
            STEP(0);
            STEP(16);
            STEP(32);
            STEP(48);
#undef STEP
            if (p) {
                p += __builtin_popcountll(word);
            }
        }
        total += reduce_terms(&sums, weight);
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
