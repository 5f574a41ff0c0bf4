/* murk_sort_uint64() against qsort(), for keys that differ in all bytes, in the
 * low or the high ones alone, and for equal keys. */
#include "base/rng.h"
#include "base/sort.h"
#include "check.h"

#include <stdlib.h>
#include <string.h>

#define LENGTH_MAX 20000

static void compare(size_t n, uint64_t mask)
{
    static uint64_t key[LENGTH_MAX], plain[LENGTH_MAX];
    for (size_t i = 0; i < n; ++i) {
        const murk_random4 r = murk_random(1, MURK_EMIT, i, (uint32_t)n, 0);
        key[i] =
            ((uint64_t)(r.u[0] * 0x1p32) << 32 | (uint64_t)(r.u[1] * 0x1p32)) &
            mask;
    }
    memcpy(plain, key, n * sizeof *key);
    murk_sort_uint64(key, n);
    qsort(plain, n, sizeof *plain, murk_by_uint64);
    CHECK(memcmp(key, plain, n * sizeof *key) == 0);
}

int main(void)
{
    const uint64_t mask[] = {UINT64_MAX,   0,         0xff, 0xff00ff,
                             0xfful << 56, UINT32_MAX};
    const size_t n[] = {0, 1, 2, 48, 49, 1000, LENGTH_MAX};
    for (size_t m = 0; m < sizeof mask / sizeof *mask; ++m) {
        for (size_t k = 0; k < sizeof n / sizeof *n; ++k) {
            compare(n[k], mask[m]);
        }
    }
    return check_done();
}
