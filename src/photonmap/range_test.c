/* Range tests of bounding boxes and photons, in plain C, AVX2 and AVX-512. The
 * vector versions load records as they are stored and transpose them in
 * registers. Squared distances of the last photons of a leaf that do not fill a
 * register come from the plain version; a leaf with fewer than MURK_LEAF
 * photons is tested against a ball by the plain version alone. */
#include "photonmap/range_test.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

static float max2(float a, float b)
{
    return a > b ? a : b;
}

static float min2(float a, float b)
{
    return a < b ? a : b;
}

static float length2(const float d[3])
{
    return (d[0] * d[0] + d[1] * d[1]) + d[2] * d[2];
}

/* ---- plain C ---- */

static void plain_bounds_distance2(const murk_bounds *bounds,
                                   const float center[3], float out[MURK_WIDE])
{
    for (int i = 0; i < MURK_WIDE; ++i) {
        float d[3];
        for (int a = 0; a < 3; ++a) {
            const float below = bounds->min[a][i] - center[a];
            const float above = center[a] - bounds->max[a][i];
            d[a] = max2(max2(below, above), 0);
        }
        out[i] = length2(d);
    }
}

static uint32_t plain_bounds(const murk_bounds *bounds,
                             const murk_query_sphere *ball, uint32_t *whole)
{
    uint32_t met = 0, inside = 0;
    for (int i = 0; i < MURK_WIDE; ++i) {
        float near[3], far[3];
        for (int a = 0; a < 3; ++a) {
            const float below = bounds->min[a][i] - ball->center[a];
            const float above = ball->center[a] - bounds->max[a][i];
            near[a] = max2(max2(below, above), 0);
            far[a] = min2(below, above); /* the square of it counts */
        }
        met |= (uint32_t)(length2(near) <= ball->radius2) << i;
        inside |= (uint32_t)(length2(far) <= ball->radius2) << i;
    }
    *whole = inside;
    return met;
}

static void plain_leaf_distance2(const murk_photon *photons, uint32_t n,
                                 const float center[3], float out[MURK_LEAF])
{
    for (uint32_t i = 0; i < n; ++i) {
        float d[3];
        for (int a = 0; a < 3; ++a) {
            d[a] = photons[i].position_m[a] - center[a];
        }
        out[i] = length2(d);
    }
}

static uint32_t plain_leaf(const murk_photon *photons, uint32_t n,
                           const murk_query_sphere *ball)
{
    float distance2[MURK_LEAF];
    uint32_t in = 0;
    plain_leaf_distance2(photons, n, ball->center, distance2);
    for (uint32_t i = 0; i < n; ++i) {
        in |= (uint32_t)(distance2[i] <= ball->radius2) << i;
    }
    return in;
}

static const murk_range_test plain = {"plain", plain_bounds, plain_leaf,
                                      plain_bounds_distance2,
                                      plain_leaf_distance2};

#if defined(__x86_64__)

/* ---- AVX2: 8 at a time ---- */

__attribute__((target("avx2"))) static inline __m256
quarters_avx2(const murk_photon *p)
{
    return _mm256_insertf128_ps(
        _mm256_castps128_ps256(_mm_loadu_ps(p[0].position_m)),
        _mm_loadu_ps(p[4].position_m), 1);
}

#define NAME(x)         x##_avx2
#define TITLE           "AVX2"
#define TARGET          __attribute__((target("avx2")))
#define VECTOR          __m256
#define LANES           8 /* single-precision numbers in 256 bits */
#define SPLAT           _mm256_set1_ps
#define LOAD            _mm256_load_ps
#define STORE           _mm256_storeu_ps
#define LARGER          _mm256_max_ps
#define SMALLER         _mm256_min_ps
#define NOT_ABOVE(a, b) _mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LE_OQ))
#define QUARTERS        quarters_avx2
#define LOW             _mm256_unpacklo_ps
#define HIGH            _mm256_unpackhi_ps
#define PAIRS           _mm256_shuffle_ps
#include "photonmap/range_loops.h"

/* ---- AVX-512: 16 at a time ---- */

__attribute__((target("avx512f"))) static inline __m512
quarters_avx512(const murk_photon *p)
{
    __m512 v = _mm512_castps128_ps512(_mm_loadu_ps(p[0].position_m));
    v = _mm512_mask_broadcast_f32x4(v, 0x00f0, _mm_loadu_ps(p[4].position_m));
    v = _mm512_mask_broadcast_f32x4(v, 0x0f00, _mm_loadu_ps(p[8].position_m));
    v = _mm512_mask_broadcast_f32x4(v, 0xf000, _mm_loadu_ps(p[12].position_m));
    return v;
}

#define NAME(x)         x##_avx512
#define TITLE           "AVX-512"
#define TARGET          __attribute__((target("avx512f")))
#define VECTOR          __m512
#define LANES           16 /* in 512 bits */
#define SPLAT           _mm512_set1_ps
#define LOAD            _mm512_load_ps
#define STORE           _mm512_storeu_ps
#define LARGER          _mm512_max_ps
#define SMALLER         _mm512_min_ps
#define NOT_ABOVE(a, b) _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ)
#define QUARTERS        quarters_avx512
#define LOW             _mm512_unpacklo_ps
#define HIGH            _mm512_unpackhi_ps
#define PAIRS           _mm512_shuffle_ps
#include "photonmap/range_loops.h"

#endif

const murk_range_test *const *murk_range_tests(unsigned *n)
{
#if defined(__x86_64__)
    static const murk_range_test *const all[] = {&plain, &test_avx2,
                                                 &test_avx512};
    *n = __builtin_cpu_supports("avx512f") ? 3
         : __builtin_cpu_supports("avx2")  ? 2
                                           : 1;
#else
    static const murk_range_test *const all[] = {&plain};
    *n = 1;
#endif
    return all;
}
