/* The same transport as tests/support/plain_tracer.h, as fast as one loop over
 * lanes makes it: the reference for photons in SIMD lanes. */
#ifndef MURK_BENCH_LANE_LOOP_H
#define MURK_BENCH_LANE_LOOP_H

#include "plain_tracer.h"

/* Box sizes are whole numbers of metres; mean cosines are not 0. */
plain_result lane_trace(const plain_box *box, uint64_t photons, uint64_t seed);

#endif
