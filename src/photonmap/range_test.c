/* Range tests of bounding boxes and photons, in plain C, AVX2 and AVX-512.
 * Records are loaded as they are stored and transposed in registers; the last
 * photons of a leaf that do not fill a register use the plain version. */
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

#define AVX2 __attribute__((target("avx2")))

AVX2 static inline __m256 avx2_length2(__m256 x, __m256 y, __m256 z)
{
    return _mm256_add_ps(
        _mm256_add_ps(_mm256_mul_ps(x, x), _mm256_mul_ps(y, y)),
        _mm256_mul_ps(z, z));
}

/* Offsets to the nearest and (in magnitude) the farthest points of boxes
 * i..i+7. */
AVX2 static inline void avx2_box(const murk_bounds *bounds, const float *center,
                                 int i, __m256 near[3], __m256 far[3])
{
    for (int a = 0; a < 3; ++a) {
        const __m256 c = _mm256_set1_ps(center[a]);
        const __m256 below =
            _mm256_sub_ps(_mm256_load_ps(bounds->min[a] + i), c);
        const __m256 above =
            _mm256_sub_ps(c, _mm256_load_ps(bounds->max[a] + i));
        near[a] =
            _mm256_max_ps(_mm256_max_ps(below, above), _mm256_setzero_ps());
        far[a] = _mm256_min_ps(below, above);
    }
}

AVX2 static void avx2_bounds_distance2(const murk_bounds *bounds,
                                       const float center[3],
                                       float out[MURK_WIDE])
{
    for (int i = 0; i < MURK_WIDE; i += 8) {
        __m256 near[3], far[3];
        avx2_box(bounds, center, i, near, far);
        _mm256_storeu_ps(out + i, avx2_length2(near[0], near[1], near[2]));
    }
}

AVX2 static uint32_t avx2_bounds(const murk_bounds *bounds,
                                 const murk_query_sphere *ball, uint32_t *whole)
{
    const __m256 radius2 = _mm256_set1_ps(ball->radius2);
    uint32_t met = 0, inside = 0;
    for (int i = 0; i < MURK_WIDE; i += 8) {
        __m256 near[3], far[3];
        avx2_box(bounds, ball->center, i, near, far);
        met |=
            (uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(
                avx2_length2(near[0], near[1], near[2]), radius2, _CMP_LE_OQ))
            << i;
        inside |=
            (uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(
                avx2_length2(far[0], far[1], far[2]), radius2, _CMP_LE_OQ))
            << i;
    }
    *whole = inside;
    return met;
}

/* x, y, z and the next word of photons i and i + 4. */
AVX2 static inline __m256 avx2_pair(const murk_photon *p)
{
    return _mm256_insertf128_ps(
        _mm256_castps128_ps256(_mm_loadu_ps(p[0].position_m)),
        _mm_loadu_ps(p[4].position_m), 1);
}

/* Loads eight records, transposes them to three vectors of coordinates, and
 * returns squared distances. */
AVX2 static inline __m256 avx2_photons(const murk_photon *p,
                                       const __m256 center[3])
{
    const __m256 a = avx2_pair(p), b = avx2_pair(p + 1);
    const __m256 c = avx2_pair(p + 2), d = avx2_pair(p + 3);
    const __m256 xy01 = _mm256_unpacklo_ps(a, b);
    const __m256 xy23 = _mm256_unpacklo_ps(c, d);
    const __m256 z01 = _mm256_unpackhi_ps(a, b);
    const __m256 z23 = _mm256_unpackhi_ps(c, d);
    const __m256 x = _mm256_shuffle_ps(xy01, xy23, 0x44);
    const __m256 y = _mm256_shuffle_ps(xy01, xy23, 0xee);
    const __m256 z = _mm256_shuffle_ps(z01, z23, 0x44);
    return avx2_length2(_mm256_sub_ps(x, center[0]),
                        _mm256_sub_ps(y, center[1]),
                        _mm256_sub_ps(z, center[2]));
}

AVX2 static void avx2_leaf_distance2(const murk_photon *photons, uint32_t n,
                                     const float center[3],
                                     float out[MURK_LEAF])
{
    const __m256 c[3] = {_mm256_set1_ps(center[0]), _mm256_set1_ps(center[1]),
                         _mm256_set1_ps(center[2])};
    uint32_t i = 0;
    for (; i + 8 <= n; i += 8) {
        _mm256_storeu_ps(out + i, avx2_photons(photons + i, c));
    }
    plain_leaf_distance2(photons + i, n - i, center, out + i);
}

AVX2 static uint32_t avx2_leaf(const murk_photon *photons, uint32_t n,
                               const murk_query_sphere *ball)
{
    if (n < MURK_LEAF) {
        return plain_leaf(photons, n, ball);
    }
    const __m256 c[3] = {_mm256_set1_ps(ball->center[0]),
                         _mm256_set1_ps(ball->center[1]),
                         _mm256_set1_ps(ball->center[2])};
    const __m256 radius2 = _mm256_set1_ps(ball->radius2);
    uint32_t in = 0;
    for (int i = 0; i < MURK_LEAF; i += 8) {
        in |= (uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(
                  avx2_photons(photons + i, c), radius2, _CMP_LE_OQ))
              << i;
    }
    return in;
}

static const murk_range_test avx2 = {
    "AVX2", avx2_bounds, avx2_leaf, avx2_bounds_distance2, avx2_leaf_distance2};

/* ---- AVX-512: 16 at a time ---- */

#define AVX512 __attribute__((target("avx512f")))

AVX512 static inline __m512 avx512_length2(__m512 x, __m512 y, __m512 z)
{
    return _mm512_add_ps(
        _mm512_add_ps(_mm512_mul_ps(x, x), _mm512_mul_ps(y, y)),
        _mm512_mul_ps(z, z));
}

AVX512 static inline void avx512_box(const murk_bounds *bounds,
                                     const float *center, __m512 near[3],
                                     __m512 far[3])
{
    for (int a = 0; a < 3; ++a) {
        const __m512 c = _mm512_set1_ps(center[a]);
        const __m512 below = _mm512_sub_ps(_mm512_load_ps(bounds->min[a]), c);
        const __m512 above = _mm512_sub_ps(c, _mm512_load_ps(bounds->max[a]));
        near[a] =
            _mm512_max_ps(_mm512_max_ps(below, above), _mm512_setzero_ps());
        far[a] = _mm512_min_ps(below, above);
    }
}

AVX512 static void avx512_bounds_distance2(const murk_bounds *bounds,
                                           const float center[3],
                                           float out[MURK_WIDE])
{
    __m512 near[3], far[3];
    avx512_box(bounds, center, near, far);
    _mm512_storeu_ps(out, avx512_length2(near[0], near[1], near[2]));
}

AVX512 static uint32_t avx512_bounds(const murk_bounds *bounds,
                                     const murk_query_sphere *ball,
                                     uint32_t *whole)
{
    const __m512 radius2 = _mm512_set1_ps(ball->radius2);
    __m512 near[3], far[3];
    avx512_box(bounds, ball->center, near, far);
    *whole = _mm512_cmp_ps_mask(avx512_length2(far[0], far[1], far[2]), radius2,
                                _CMP_LE_OQ);
    return _mm512_cmp_ps_mask(avx512_length2(near[0], near[1], near[2]),
                              radius2, _CMP_LE_OQ);
}

/* x, y, z and the next word of photons i, i + 4, i + 8 and i + 12. */
AVX512 static inline __m512 avx512_four(const murk_photon *p)
{
    __m512 v = _mm512_castps128_ps512(_mm_loadu_ps(p[0].position_m));
    v = _mm512_mask_broadcast_f32x4(v, 0x00f0, _mm_loadu_ps(p[4].position_m));
    v = _mm512_mask_broadcast_f32x4(v, 0x0f00, _mm_loadu_ps(p[8].position_m));
    v = _mm512_mask_broadcast_f32x4(v, 0xf000, _mm_loadu_ps(p[12].position_m));
    return v;
}

AVX512 static inline __m512 avx512_photons(const murk_photon *p,
                                           const __m512 center[3])
{
    const __m512 a = avx512_four(p), b = avx512_four(p + 1);
    const __m512 c = avx512_four(p + 2), d = avx512_four(p + 3);
    const __m512 xy01 = _mm512_unpacklo_ps(a, b);
    const __m512 xy23 = _mm512_unpacklo_ps(c, d);
    const __m512 z01 = _mm512_unpackhi_ps(a, b);
    const __m512 z23 = _mm512_unpackhi_ps(c, d);
    const __m512 x = _mm512_shuffle_ps(xy01, xy23, 0x44);
    const __m512 y = _mm512_shuffle_ps(xy01, xy23, 0xee);
    const __m512 z = _mm512_shuffle_ps(z01, z23, 0x44);
    return avx512_length2(_mm512_sub_ps(x, center[0]),
                          _mm512_sub_ps(y, center[1]),
                          _mm512_sub_ps(z, center[2]));
}

AVX512 static void avx512_leaf_distance2(const murk_photon *photons, uint32_t n,
                                         const float center[3],
                                         float out[MURK_LEAF])
{
    const __m512 c[3] = {_mm512_set1_ps(center[0]), _mm512_set1_ps(center[1]),
                         _mm512_set1_ps(center[2])};
    uint32_t i = 0;
    for (; i + 16 <= n; i += 16) {
        _mm512_storeu_ps(out + i, avx512_photons(photons + i, c));
    }
    plain_leaf_distance2(photons + i, n - i, center, out + i);
}

AVX512 static uint32_t avx512_leaf(const murk_photon *photons, uint32_t n,
                                   const murk_query_sphere *ball)
{
    if (n < MURK_LEAF) {
        return plain_leaf(photons, n, ball);
    }
    const __m512 c[3] = {_mm512_set1_ps(ball->center[0]),
                         _mm512_set1_ps(ball->center[1]),
                         _mm512_set1_ps(ball->center[2])};
    const __m512 radius2 = _mm512_set1_ps(ball->radius2);
    uint32_t in = 0;
    for (int i = 0; i < MURK_LEAF; i += 16) {
        in |= (uint32_t)_mm512_cmp_ps_mask(avx512_photons(photons + i, c),
                                           radius2, _CMP_LE_OQ)
              << i;
    }
    return in;
}

static const murk_range_test avx512 = {"AVX-512", avx512_bounds, avx512_leaf,
                                       avx512_bounds_distance2,
                                       avx512_leaf_distance2};

const murk_range_test *const *murk_range_tests(unsigned *n)
{
    static const murk_range_test *const all[] = {&plain, &avx2, &avx512};
    *n = __builtin_cpu_supports("avx512f") ? 3
         : __builtin_cpu_supports("avx2")  ? 2
                                           : 1;
    return all;
}

#else

const murk_range_test *const *murk_range_tests(unsigned *n)
{
    static const murk_range_test *const all[] = {&plain};
    *n = 1;
    return all;
}

#endif
