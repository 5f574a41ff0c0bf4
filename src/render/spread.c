/* Quantiles of the values of a channel, over at most MURK_SPREAD_MAX pixels at
 * equal steps. */
#include "render/spread.h"

#include "base/sort.h"

#include <stdlib.h>

size_t murk_spread_step(size_t n)
{
    /* odd, so that the step does not follow a column of a picture */
    return (n > 0 ? (n - 1) / MURK_SPREAD_MAX + 1 : 1) | 1;
}

float murk_spread_share(float *value, size_t n, double share)
{
    qsort(value, n, sizeof *value, murk_by_float);
    return value[(size_t)(share * (double)(n - 1) + 0.5)];
}
