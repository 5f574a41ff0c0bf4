/* The choice of the set of vector instructions (base/lanes.h). */
#include "base/lanes.h"

#include <stdlib.h>
#include <string.h>

static const char *const names[MURK_LANE_SETS] = {
    [MURK_LANES_BASELINE] = "baseline",
#if defined(__x86_64__)
    [MURK_LANES_AVX2] = "avx2",
    [MURK_LANES_AVX512] = "avx512",
#endif
};

const char *murk_lane_set_name(murk_lane_set set)
{
    return names[set];
}

static bool is_present(murk_lane_set set)
{
#if defined(__x86_64__)
    if (set == MURK_LANES_AVX2) {
        return __builtin_cpu_supports("avx2");
    }
    if (set == MURK_LANES_AVX512) {
        return __builtin_cpu_supports("avx512f") &&
               __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl") &&
               __builtin_cpu_supports("avx512bw");
    }
#endif
    return set == MURK_LANES_BASELINE;
}

bool murk_lane_set_chosen(murk_lane_set *set)
{
    const char *name = getenv("MURK_LANES");
    bool is_named = false;
    *set = MURK_LANES_BASELINE;
    for (size_t i = 0; i < MURK_LANE_SETS; ++i) {
        const murk_lane_set next = (murk_lane_set)i;
        if (!is_named && is_present(next)) {
            *set = next;
            is_named = name && strcmp(name, names[i]) == 0;
        }
    }
    return !(name && strcmp(name, "off") == 0);
}
