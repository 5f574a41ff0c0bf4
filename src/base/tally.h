/* Energy accounting in whole quanta.
 *
 * Every photon packet leaves its light source with MURK_PACKET quanta. Sums of
 * integers do not depend on the order of the terms, so a tally does not depend
 * on the number of threads, and energy balance can be tested with ==. An
 * int64_t holds the quanta of fewer than 2^33 packets in one cell; runs have at
 * most 2^32 photons. */
#ifndef MURK_BASE_TALLY_H
#define MURK_BASE_TALLY_H

#include <stdatomic.h>
#include <stdint.h>

/* 2^30 quanta resolve a packet to 1e-9. 2^33 packets would have 2^63 quanta,
 * one more than an int64_t holds.
 */
#define MURK_PACKET (INT64_C(1) << 30)

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
