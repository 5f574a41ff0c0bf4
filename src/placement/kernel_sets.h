/* Sets of inner loops for processors that have more than the plain one. */
#ifndef MURK_PLACEMENT_KERNEL_SETS_H
#define MURK_PLACEMENT_KERNEL_SETS_H

#include "placement/kernels.h"

/* NULL where this processor does not run it. */
const murk_kernels *murk_kernels_avx2(void);   /* AVX2, popcnt, bmi */
const murk_kernels *murk_kernels_avx512(void); /* and popcnt of 8 words */

#endif
