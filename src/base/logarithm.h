/* The natural logarithm of the photon tracer, inline and without branches, so
 * that a compiler can compute it for several photons at once. Only additions,
 * multiplications, one division and operations on the bits of the number are
 * used, in a fixed order. The result therefore has the same bits on every
 * machine and with every vector instruction set, which the C library does not
 * promise.
 *
 * x = 2^k (1 + f) with 1 + f between sqrt(1/2) and sqrt(2). With s = f/(2 + f),
 * log(1 + f) is 2 s + s R(s^2), where R is a polynomial with the coefficients
 * of fdlibm (Sun Microsystems, 1993, e_log.c). The error is below 1 unit in the
 * last place. */
#ifndef MURK_BASE_LOGARITHM_H
#define MURK_BASE_LOGARITHM_H

#include <stdint.h>
#include <string.h>

/* log(x) for a normal number x > 0. The result has no meaning for 0, negative
 * and subnormal numbers, infinity and NaN. */
static inline double murk_log(double x)
{
    /* log(2) in two parts; products of the first with exponents are exact. */
    static const double log2_high = 6.93147180369123816490e-01;
    static const double log2_low = 1.90821492927058770002e-10;
    static const uint64_t sqrt_half = UINT64_C(0x3fe6a09e667f3bcd);
    static const uint64_t exponent_mask = UINT64_C(0xfff0000000000000);
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    /* The exponent k. It is converted to a double by its place in the mantissa
     * of 2^52, which takes no instruction that only few processors have for
     * several numbers at once. */
    const uint64_t above = bits - sqrt_half;
    const uint64_t shifted = ((above >> 52) + 2048) & 0xfff;
    const uint64_t k_bits = shifted | UINT64_C(0x4330000000000000);
    double k;
    memcpy(&k, &k_bits, sizeof k);
    k -= 0x1p52 + 2048;
    /* The mantissa 1 + f. */
    const uint64_t mantissa_bits = bits - (above & exponent_mask);
    double mantissa;
    memcpy(&mantissa, &mantissa_bits, sizeof mantissa);
    const double f = mantissa - 1, s = f / (2 + f), z = s * s;
    const double r =
        z * (6.666666666666735130e-01 +
             z * (3.999999999940941908e-01 +
                  z * (2.857142874366239149e-01 +
                       z * (2.222219843214978396e-01 +
                            z * (1.818357216161805012e-01 +
                                 z * (1.531383769920937332e-01 +
                                      z * 1.479819860511658591e-01))))));
    const double half_square = .5 * f * f;
    return k * log2_high -
           ((half_square - (s * (half_square + r) + k * log2_low)) - f);
}

#endif
