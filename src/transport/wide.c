/* The variance of whole numbers from their sum and the sum of their squares,
 * in integers of 192 bits, so that it is exact before one last rounding. */
#include "transport/wide.h"

/* Words of 32 bits: n sum x^2 and (sum x)^2 are below 2^192. */
#define LIMBS 6

/* out = a b; both factors have 128 bits, and the product is below 2^192. */
static void multiply(murk_wide a, murk_wide b, uint32_t out[LIMBS])
{
    const uint32_t p[4] = {(uint32_t)a.low, (uint32_t)(a.low >> 32),
                           (uint32_t)a.high, (uint32_t)(a.high >> 32)};
    const uint32_t q[4] = {(uint32_t)b.low, (uint32_t)(b.low >> 32),
                           (uint32_t)b.high, (uint32_t)(b.high >> 32)};
    for (int i = 0; i < LIMBS; ++i) {
        out[i] = 0;
    }
    for (int i = 0; i < 4; ++i) {
        uint64_t carry = 0;
        for (int j = 0; i + j < LIMBS; ++j) {
            const uint64_t factor = j < 4 ? q[j] : 0;
            carry += out[i + j] + p[i] * factor;
            out[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
    }
}

double murk_wide_spread(murk_wide sum, murk_wide squares, uint64_t n)
{
    uint32_t all[LIMBS], mean[LIMBS];
    multiply(squares, (murk_wide){n, 0}, all);
    multiply(sum, sum, mean);
    /* The difference is not negative, by the inequality of Cauchy and
     * Schwarz. */
    double spread = 0;
    uint32_t difference[LIMBS];
    uint64_t borrow = 0;
    for (int i = 0; i < LIMBS; ++i) {
        const uint64_t d = (uint64_t)all[i] - mean[i] - borrow;
        difference[i] = (uint32_t)d;
        borrow = d >> 63;
    }
    for (int i = LIMBS; i > 0; --i) {
        spread = spread * 0x1p32 + difference[i - 1];
    }
    return spread / (double)n;
}
