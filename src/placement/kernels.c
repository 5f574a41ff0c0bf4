/* The portable kernels, and the choice of the fastest version that this
 * processor can run. */
#include "placement/kernels.h"
#include "placement/kernel_loops.h"

MURK_COMPILE_LOOPS(plain, )

static uint64_t sum_above_plain(const uint16_t *row, const uint16_t *best,
                                size_t n)
{
    return murk_loop_sum_above(row, best, n);
}

static uint64_t sum_independent_plain(const uint16_t *row, const uint16_t *best,
                                      size_t n)
{
    return murk_loop_sum_independent(row, best, n);
}

static const murk_kernels plain = {
    count_new_plain,       sum_missing_plain,     weighted_missing_plain,
    sum_above_plain,       weighted_above_plain,  sum_packed_plain,
    weighted_packed_plain, sum_independent_plain, sum_independent_packed_plain};

const murk_kernels *murk_kernels_plain(void)
{
    return &plain;
}

const murk_kernels *murk_kernels_number(size_t k)
{
    const murk_kernels *const known[] = {&plain, murk_kernels_avx2(),
                                         murk_kernels_avx512()};
    size_t runs = 0;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i) {
        if (known[i] && runs++ == k) {
            return known[i];
        }
    }
    return NULL;
}

const murk_kernels *murk_kernels_fastest(void)
{
    size_t k = 0;
    while (murk_kernels_number(k + 1)) {
        ++k;
    }
    return murk_kernels_number(k);
}
