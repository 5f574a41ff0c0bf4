/* Orders the records of a photon map as an implicit balanced kd-tree.
 *
 * Leaves are ranges of MURK_LEAF records (photonmap/range_test.h; the last leaf
 * may be shorter). A node of 2^j leaves starts at a multiple of 2^j leaves. The
 * node is split along the widest side of the bounding box of its records, after
 * the first 2^(j-1) leaves, if it has more leaves than these. Nodes at the end
 * may lack leaves, for which nothing is stored. Records are compared by one
 * coordinate, then by all their bytes, and the records of each leaf are sorted
 * by x. The order is therefore a function of the set of records, whatever their
 * original order and the number of threads. */
#ifndef MURK_PHOTONMAP_ORDER_H
#define MURK_PHOTONMAP_ORDER_H

#include "base/status.h"
#include "photonmap/photon.h"

#include <stddef.h>

/* Orders the records. Positions must be finite. Returns false if the run was
 * interrupted; the records are then complete, in some order. */
int murk_order(murk_photon *photons, size_t n, unsigned threads);

/* The same for records that the ranks of a machine share (base/block.h), which
 * divide the work. Collective. Fails with MURK_INTERRUPTED. */
murk_status murk_order_shared(murk_photon *photons, size_t n, unsigned threads,
                              murk_status status, murk_error *err);

/* Selection: moves the record that sorting along the axis would put at place k
 * < n to that place, with no later record before it and no earlier record after
 * it, in O(n). */
void murk_order_select(murk_photon *photons, size_t n, size_t k, int axis);

#endif
