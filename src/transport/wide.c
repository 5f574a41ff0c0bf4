/* The variance of whole numbers from their sum and the sum of their squares, in
 * integers of 192 bits, so that only the conversion to a double and the
 * division by the number of terms round. */
#include "transport/wide.h"

/* A number of 192 bits: high 2^64 + low, where `low` may exceed 2^64. */
typedef struct number {
    murk_wide high, low;
} number;

static number carried(number x)
{
    return (number){x.high + (x.low >> 64), (uint64_t)x.low};
}

double murk_wide_spread(murk_wide sum, murk_wide squares, uint64_t n)
{
    /* n sum x^2 and (sum x)^2, from factors of 64 bits. */
    const murk_wide a = sum >> 64, b = (uint64_t)sum;
    const number all = carried(
        (number){(squares >> 64) * n, (murk_wide)(uint64_t)squares * n});
    const number mean = carried((number){(a * a << 64) + 2 * (a * b), b * b});
    /* The difference is not negative, by the inequality of Cauchy and
     * Schwarz. */
    const murk_wide high = all.high - mean.high - (all.low < mean.low);
    const uint64_t low = (uint64_t)all.low - (uint64_t)mean.low;
    double spread = 0;
    for (int shift = 96; shift >= 0; shift -= 32) {
        spread = spread * 0x1p32 + (double)(uint32_t)(high >> shift);
    }
    spread = spread * 0x1p32 + (double)(low >> 32);
    spread = spread * 0x1p32 + (double)(uint32_t)low;
    return spread / (double)n;
}
