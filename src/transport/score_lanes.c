/* Scores segments of several photons in a grid (transport/score_lanes.h): the
 * kernel of transport/score_lanes_kernel.h for each vector instruction set. */
#include "transport/score_lanes.h"

#include <math.h>
#include <string.h>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

static int64_t offset_of(const murk_lane_lists *lists,
                         const murk_score_entry *entry)
{
    return (int64_t)((const char *)entry - (const char *)lists->entries);
}

void murk_lane_lists_create(murk_lane_lists *lists, murk_scorer *scorer)
{
    memset(lists, 0, sizeof *lists);
    lists->entries = scorer->lists;
    lists->entries_max = scorer->tallies->entries_max;
    lists->spare = offset_of(lists, scorer->spare);
    for (size_t i = 0; i < MURK_LANE_COUNT; ++i) {
        lists->last[i] = lists->limit[i] = lists->spare;
    }
}

void murk_lane_lists_open(murk_lane_lists *lists, size_t i,
                          murk_score_path *path)
{
    const int64_t entries =
        (int64_t)MURK_SCORE_ENTRIES - (int64_t)lists->entries_max;
    lists->path[i] = path;
    lists->last[i] = offset_of(lists, &path->list[path->last]);
    lists->limit[i] = offset_of(lists, path->list) +
                      entries * (int64_t)sizeof(murk_score_entry);
}

void murk_lane_lists_close(murk_lane_lists *lists, size_t i)
{
    murk_score_path *const path = lists->path[i];
    path->last = (size_t)(lists->last[i] - offset_of(lists, path->list)) /
                 sizeof(murk_score_entry);
    lists->path[i] = NULL;
    lists->last[i] = lists->limit[i] = lists->spare;
}

/* Scores the segment of a lane without vectors. */
static void score_one(const murk_lattice *lattice,
                      const murk_lane_segments *segments,
                      murk_lane_lists *lists, size_t i)
{
    const murk_lane_rays *const from = segments->from;
    murk_score_path *const path = lists->path[i];
    murk_lane_lists_close(lists, i);
    murk_score_lattice(path, lattice,
                       murk_vec(from->x[i], from->y[i], from->z[i]),
                       murk_vec(from->dx[i], from->dy[i], from->dz[i]),
                       segments->length_m[i], from->quanta[i]);
    murk_lane_lists_open(lists, i, path);
}

/* Vectors of 2, 4 and 8 numbers, masks, of which all bits of an element are
 * equal, and words, whose sums may overflow. */
typedef double vector_baseline __attribute__((vector_size(16)));
typedef int64_t mask_baseline __attribute__((vector_size(16)));
typedef uint64_t words_baseline __attribute__((vector_size(16)));
#if defined(__x86_64__)
typedef double vector_avx2 __attribute__((vector_size(32)));
typedef int64_t mask_avx2 __attribute__((vector_size(32)));
typedef uint64_t words_avx2 __attribute__((vector_size(32)));
typedef double vector_avx512 __attribute__((vector_size(64)));
typedef int64_t mask_avx512 __attribute__((vector_size(64)));
typedef uint64_t words_avx512 __attribute__((vector_size(64)));
#endif

/* The entries at base + at[0], base + at[2], ... in one register. */
static inline vector_baseline loaded_baseline(const char *base,
                                              const int64_t *at)
{
    vector_baseline entry;
    memcpy(&entry, base + at[0], sizeof entry);
    return entry;
}

#if defined(__x86_64__)
MURK_TARGET_AVX2 static inline vector_avx2 loaded_avx2(const char *base,
                                                       const int64_t *at)
{
    return (vector_avx2)_mm256_loadu2_m128d((const double *)(base + at[2]),
                                            (const double *)(base + at[0]));
}

MURK_TARGET_AVX512 static inline vector_avx512 loaded_avx512(const char *base,
                                                             const int64_t *at)
{
    const __m256d low = _mm256_loadu2_m128d((const double *)(base + at[2]),
                                            (const double *)(base + at[0]));
    const __m256d high = _mm256_loadu2_m128d((const double *)(base + at[6]),
                                             (const double *)(base + at[4]));
    return (vector_avx512)_mm512_insertf64x4(_mm512_castpd256_pd512(low), high,
                                             1);
}
#endif

/* Conditions that are masks: all bits of an element are equal. */
#define MASK_LESS(a, b)         ((a) < (b))
#define MASK_NOT_LESS(a, b)     ((a) >= (b))
#define MASK_DIFFER(a, b)       ((a) != (b))
#define MASK_EQUAL_WHOLE(a, b)  ((MASK)(a) == (MASK)(b))
#define MASK_BOTH(c, d)         ((c) & (d))
#define MASK_BUT(c, d)          ((c) & ~(d))
#define MASK_NEITHER(c, d)      (~(c) & ~(d))
#define MASK_AND(c, a)          ((VECTOR)((c) & (MASK)(a)))
#define MASK_INCREASED(c, a, b) ((a) + MASK_AND(c, b))

#define WHOLE_CHOSEN(c, a, b) ((MASK)CHOSEN(c, (VECTOR)(a), (VECTOR)(b)))

/* The integer of a whole number from 0 to 2^52 - 1: the last bits of the sum
 * with 2^52. */
#define WHOLE(a) ((MASK)((a) + 0x1p52) ^ 0x4330000000000000)

#define WIDTH           2 /* numbers in a register of 16 bytes */
#define TARGET          MURK_TARGET_BASELINE
#define NAMED(name)     name##_baseline
#define TRUTHS          MASK
#define LESS            MASK_LESS
#define NOT_LESS        MASK_NOT_LESS
#define DIFFER          MASK_DIFFER
#define LESS_WHOLE      MASK_LESS
#define PRODUCT(a, b)   ((MASK)((WORDS)(a) * (WORDS)(b)))
#define EQUAL_WHOLE     MASK_EQUAL_WHOLE
#define BOTH            MASK_BOTH
#define BUT             MASK_BUT
#define NEITHER         MASK_NEITHER
#define AND             MASK_AND
#define INCREASED       MASK_INCREASED
#define MASK_OF(c)      (c)
#define CHOSEN(c, a, b) ((VECTOR)(((c) & (MASK)(a)) | (~(c) & (MASK)(b))))
#define LOWER(a, b)     CHOSEN((a) < (b), a, b)
#define HIGHER(a, b)    CHOSEN((a) > (b), a, b)
#define ROUNDED_DOWN(a) \
    ((a) + 0x1p52 - 0x1p52 - AND((a) + 0x1p52 - 0x1p52 > (a), (VECTOR){0} + 1))
#define EVEN_PAIRS(a, b) ((VECTOR){(a)[0], (b)[0]})
#define ODD_PAIRS(a, b)  ((VECTOR){(a)[1], (b)[1]})
#define LOADED           loaded_baseline
#define ANY(c)           (((c)[0] | (c)[1]) != 0)
#define LARGEST(a)       ((a)[0] > (a)[1] ? (a)[0] : (a)[1])
#include "transport/score_lanes_kernel.h"

#if defined(__x86_64__)
#define WIDTH       4 /* 32 bytes */
#define TARGET      MURK_TARGET_AVX2
#define NAMED(name) name##_avx2
#define TRUTHS      MASK
#define LESS        MASK_LESS
#define NOT_LESS    MASK_NOT_LESS
#define DIFFER      MASK_DIFFER
#define LESS_WHOLE  MASK_LESS
#define EQUAL_WHOLE MASK_EQUAL_WHOLE
#define BOTH        MASK_BOTH
#define BUT         MASK_BUT
#define NEITHER     MASK_NEITHER
#define AND         MASK_AND
#define INCREASED   MASK_INCREASED
#define MASK_OF(c)  (c)
#define CHOSEN(c, a, b) \
    ((VECTOR)_mm256_blendv_pd((__m256d)(b), (__m256d)(a), (__m256d)(c)))
#define PRODUCT(a, b)   ((MASK)_mm256_mul_epu32((__m256i)(a), (__m256i)(b)))
#define LOWER(a, b)     ((VECTOR)_mm256_min_pd((__m256d)(a), (__m256d)(b)))
#define HIGHER(a, b)    ((VECTOR)_mm256_max_pd((__m256d)(a), (__m256d)(b)))
#define ROUNDED_DOWN(a) ((VECTOR)_mm256_floor_pd((__m256d)(a)))
#define EVEN_PAIRS(a, b) \
    ((VECTOR)_mm256_unpacklo_pd((__m256d)(a), (__m256d)(b)))
#define ODD_PAIRS(a, b) ((VECTOR)_mm256_unpackhi_pd((__m256d)(a), (__m256d)(b)))
#define LOADED          loaded_avx2
#define ANY(c)          (_mm256_movemask_pd((__m256d)(c)) != 0)
#define LARGEST(a)      fmax(fmax((a)[0], (a)[1]), fmax((a)[2], (a)[3]))
#include "transport/score_lanes_kernel.h"

/* AVX-512 has registers of conditions, with a bit for each lane. */
#define WIDTH       8 /* 64 bytes */
#define TARGET      MURK_TARGET_AVX512
#define NAMED(name) name##_avx512
#define TRUTHS      __mmask8
#define LESS(a, b)  _mm512_cmp_pd_mask((__m512d)(a), (__m512d)(b), _CMP_LT_OQ)
#define NOT_LESS(a, b) \
    _mm512_cmp_pd_mask((__m512d)(a), (__m512d)(b), _CMP_GE_OQ)
#define DIFFER(a, b)      _mm512_cmp_pd_mask((__m512d)(a), (__m512d)(b), _CMP_NEQ_UQ)
#define LESS_WHOLE(a, b)  _mm512_cmplt_epi64_mask((__m512i)(a), (__m512i)(b))
#define EQUAL_WHOLE(a, b) _mm512_cmpeq_epi64_mask((__m512i)(a), (__m512i)(b))
#define BOTH(c, d)        _kand_mask8(c, d)
#define BUT(c, d)         _kandn_mask8(d, c)
#define NEITHER(c, d)     _knot_mask8(_kor_mask8(c, d))
#define AND(c, a)         ((VECTOR)_mm512_maskz_mov_pd(c, (__m512d)(a)))
#define INCREASED(c, a, b) \
    ((VECTOR)_mm512_mask_add_pd((__m512d)(a), c, (__m512d)(a), (__m512d)(b)))
#define MASK_OF(c) ((MASK)_mm512_movm_epi64(c))
#define CHOSEN(c, a, b) \
    ((VECTOR)_mm512_mask_blend_pd(c, (__m512d)(b), (__m512d)(a)))
#define PRODUCT(a, b)   ((MASK)_mm512_mul_epu32((__m512i)(a), (__m512i)(b)))
#define LOWER(a, b)     ((VECTOR)_mm512_min_pd((__m512d)(a), (__m512d)(b)))
#define HIGHER(a, b)    ((VECTOR)_mm512_max_pd((__m512d)(a), (__m512d)(b)))
#define ROUNDED_DOWN(a) ((VECTOR)_mm512_floor_pd((__m512d)(a)))
#define EVEN_PAIRS(a, b) \
    ((VECTOR)_mm512_unpacklo_pd((__m512d)(a), (__m512d)(b)))
#define ODD_PAIRS(a, b) ((VECTOR)_mm512_unpackhi_pd((__m512d)(a), (__m512d)(b)))
#define LOADED          loaded_avx512
#define ANY(c)          ((c) != 0)
#define LARGEST(a)      _mm512_reduce_max_pd((__m512d)(a))
#include "transport/score_lanes_kernel.h"
#endif

const murk_lane_scoring *murk_lane_scoring_for(murk_lane_set set)
{
    static const murk_lane_scoring scoring[MURK_LANE_SETS] = {
        [MURK_LANES_BASELINE] = {select_baseline, score_baseline, add_baseline},
#if defined(__x86_64__)
        [MURK_LANES_AVX2] = {select_avx2, score_avx2, add_avx2},
        [MURK_LANES_AVX512] = {select_avx512, score_avx512, add_avx512},
#endif
    };
    return &scoring[set];
}
