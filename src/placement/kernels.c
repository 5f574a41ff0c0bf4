/* The portable kernels, and the choice of the fastest version that this
 * processor can run. */
#include "placement/kernels.h"

#include "placement/kernel_loops.h"

static const murk_kernels plain = {murk_loop_count_new, murk_loop_dense,
                                   murk_loop_packed, murk_loop_lanes};

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
