/* Energy bookkeeping in whole quanta.
 *
 * Every photon packet leaves its lamp with MURK_PACKET quanta. Integers add up
 * the same in any order, so a tally does not depend on threads, and energy
 * balance can be tested with ==. int64_t holds 2^33 packets' worth in one
 * cell; longer runs are refused at set-up. */
#ifndef MURK_BASE_TALLY_H
#define MURK_BASE_TALLY_H

#include <stdatomic.h>
#include <stdint.h>

#define MURK_PACKET      (INT64_C(1) << 30)
#define MURK_PACKETS_MAX (INT64_C(1) << 33)

typedef _Atomic int64_t murk_tally;

static inline void murk_tally_add(murk_tally *cell, int64_t quanta)
{
    atomic_fetch_add_explicit(cell, quanta, memory_order_relaxed);
}

static inline int64_t murk_tally_read(const murk_tally *cell)
{
    return atomic_load_explicit((murk_tally *)(uintptr_t)cell,
                                memory_order_relaxed);
}

#endif
