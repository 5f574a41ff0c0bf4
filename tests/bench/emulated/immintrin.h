/* The AVX-512 intrinsics of the ceiling simd.c (tools/bench --ceilings) on a
 * processor without AVX-512: SIMDe (libsimde-dev) translates most of them, and
 * the seven that SIMDe 0.7.4 lacks follow as loops over the lanes. tools/bench
 * puts the folder of this file before the compiler's own headers on such a
 * machine, and says in the output that the ceiling is emulated. */
#include_next <immintrin.h>

#ifndef MURK_BENCH_EMULATED_IMMINTRIN_H
#define MURK_BENCH_EMULATED_IMMINTRIN_H

#define SIMDE_ENABLE_NATIVE_ALIASES
#include <simde/x86/avx512.h>

#include <math.h>
#include <string.h>

#define EMULATED_LANES 16

typedef struct emulated_floats {
    float lane[EMULATED_LANES];
} emulated_floats;

typedef struct emulated_ints {
    int lane[EMULATED_LANES];
} emulated_ints;

static inline emulated_floats emulated_floats_of(simde__m512 v)
{
    emulated_floats out;
    memcpy(&out, &v, sizeof out);
    return out;
}

static inline simde__m512 emulated_vector(emulated_floats f)
{
    simde__m512 out;
    memcpy(&out, &f, sizeof out);
    return out;
}

static inline emulated_ints emulated_ints_of(simde__m512i v)
{
    emulated_ints out;
    memcpy(&out, &v, sizeof out);
    return out;
}

static inline simde__m512 emulated_cvtepi32_ps(simde__m512i v)
{
    const emulated_ints in = emulated_ints_of(v);
    emulated_floats out;
    for (int i = 0; i < EMULATED_LANES; ++i) {
        out.lane[i] = (float)in.lane[i];
    }
    return emulated_vector(out);
}

static inline simde__m512i emulated_cvttps_epi32(simde__m512 v)
{
    const emulated_floats in = emulated_floats_of(v);
    emulated_ints whole;
    for (int i = 0; i < EMULATED_LANES; ++i) {
        whole.lane[i] = (int)in.lane[i];
    }
    simde__m512i out;
    memcpy(&out, &whole, sizeof out);
    return out;
}

/* Exponent and mantissa in [1, 2) of normal numbers, by their bits. */
static inline simde__m512 emulated_getexp_ps(simde__m512 v)
{
    emulated_ints bits;
    emulated_floats out;
    memcpy(&bits, &v, sizeof bits);
    for (int i = 0; i < EMULATED_LANES; ++i) {
        out.lane[i] = (float)((bits.lane[i] >> 23 & 0xff) - 127);
    }
    return emulated_vector(out);
}

static inline simde__m512 emulated_getmant_ps(simde__m512 v)
{
    emulated_ints bits;
    memcpy(&bits, &v, sizeof bits);
    for (int i = 0; i < EMULATED_LANES; ++i) {
        bits.lane[i] = (bits.lane[i] & 0x7fffff) | 0x3f800000;
    }
    simde__m512 out;
    memcpy(&out, &bits, sizeof out);
    return out;
}

static inline simde__m512 emulated_gather(simde__m512 other, int mask,
                                          simde__m512i index, const float *from)
{
    const emulated_ints at = emulated_ints_of(index);
    emulated_floats out = emulated_floats_of(other);
    for (int i = 0; i < EMULATED_LANES; ++i) {
        if (mask >> i & 1) {
            out.lane[i] = from[at.lane[i]];
        }
    }
    return emulated_vector(out);
}

static inline simde__m512 emulated_rsqrt(simde__m512 v)
{
    emulated_floats f = emulated_floats_of(v);
    for (int i = 0; i < EMULATED_LANES; ++i) {
        f.lane[i] = 1 / sqrtf(f.lane[i]);
    }
    return emulated_vector(f);
}

#define _mm512_cvtepi32_ps(v)                emulated_cvtepi32_ps(v)
#define _mm512_cvttps_epi32(v)               emulated_cvttps_epi32(v)
#define _mm512_getexp_ps(v)                  emulated_getexp_ps(v)
#define _mm512_getmant_ps(v, interval, sign) emulated_getmant_ps(v)
#define _mm512_mask_cmp_ps_mask(mask, a, b, relation) \
    ((simde__mmask16)((mask)&simde_mm512_cmp_ps_mask(a, b, relation)))
#define _mm512_mask_i32gather_ps(other, mask, index, from, scale) \
    emulated_gather(other, mask, index, from)
#define _mm512_rsqrt14_ps(v) emulated_rsqrt(v)

#endif
