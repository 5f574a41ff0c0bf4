/* Loops over lanes: the same operations for several photons side by side, in
 * plain C that the compiler turns into vector instructions, compiled once for
 * each set of vector instructions. Each photon has a lane: the same index of
 * all arrays.
 *
 * All sets give the same bits: the operations are those of IEEE 754 in the same
 * order, products and sums are never fused (-ffp-contract=off), and a photon
 * knows nothing of the other lanes. Files with such loops are compiled with -O3
 * and without errno and exception flags of mathematics (CMakeLists.txt).
 * Truth values are numbers, 1 or 0, which keeps loops to one size of element;
 * conditions are joined by & and |, because && and || are branches. */
#ifndef MURK_BASE_LANES_H
#define MURK_BASE_LANES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* The number of lanes, and that to which the lanes of a loop are rounded up, so
 * that loops fill the registers. With 32 lanes the arrays of a trace fit into a
 * cache of 32 kB. Neither number enters a result. */
#define MURK_LANE_COUNT 32
#define MURK_LANE_GROUP 8

typedef double murk_lane_number[MURK_LANE_COUNT];

/* Words of 32 bits, each in the space of a number. */
typedef uint64_t murk_lane_word[MURK_LANE_COUNT];

/* Before a function that is inlined into one function for each set. */
#define MURK_LANE_KERNEL static inline __attribute__((always_inline)) void

/* A loop over n lanes from `first`. The rounding down changes nothing: it tells
 * the compiler that n is a multiple of the group. */
#define MURK_FOR_LANES_FROM(first, n) \
    for (size_t i = (first);          \
         i < (first) + ((n) & ~(size_t)(MURK_LANE_GROUP - 1)); ++i)
#define MURK_FOR_LANES(n) MURK_FOR_LANES_FROM((size_t)0, n)

static inline double murk_truth(bool is_true)
{
    return is_true ? 1 : 0;
}

/* a if is_first, else b. In place of `?:` where b is a value in memory: the
 * compiler makes a masked store of that, which is slow on some processors. */
static inline double murk_choose(bool is_first, double a, double b)
{
    const uint64_t mask = is_first ? UINT64_MAX : 0;
    uint64_t bits_a, bits_b;
    double chosen;
    memcpy(&bits_a, &a, sizeof a);
    memcpy(&bits_b, &b, sizeof b);
    bits_a = (bits_a & mask) | (bits_b & ~mask);
    memcpy(&chosen, &bits_a, sizeof chosen);
    return chosen;
}

/* The sets of vector instructions: SSE2 or NEON (the baseline of the compiler),
 * AVX2, AVX-512. */
typedef enum murk_lane_set {
    MURK_LANES_BASELINE,
#if defined(__x86_64__)
    MURK_LANES_AVX2,
    MURK_LANES_AVX512,
#endif
    MURK_LANE_SETS
} murk_lane_set;

/* Before a function that is compiled for a set. */
#define MURK_TARGET_BASELINE
#define MURK_TARGET_AVX2 __attribute__((target("avx2")))
#define MURK_TARGET_AVX512 \
    __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw")))

/* The name of a set, as the environment variable MURK_LANES has it. */
const char *murk_lane_set_name(murk_lane_set set);

/* The fastest set of this processor. The environment variable MURK_LANES
 * selects another: `baseline`, `avx2` or `avx512`; with `off` the result is
 * false, and photons are treated one by one. A set that the processor lacks or
 * an unknown name counts as not given. */
bool murk_lane_set_chosen(murk_lane_set *set);

#endif
