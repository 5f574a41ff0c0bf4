/* The order of a photon map's records: an implicit balanced kd-tree.
 *
 * Leaves are runs of MURK_LEAF records (the last may be shorter). A node of 2^j
 * leaves starts at a multiple of 2^j leaves and is split, along the widest side
 * of its records' box, after its first 2^(j-1) leaves; nodes at the end may
 * lack leaves, and nothing is stored. Records are compared by coordinate, then
 * by all their bytes, and each leaf is sorted: the order is a function of the
 * set of records, whatever order they come in and whoever sorts them. */
#ifndef MURK_PHOTONMAP_ORDER_H
#define MURK_PHOTONMAP_ORDER_H

#include "photonmap/photon.h"

#include <stddef.h>

/* Positions must be finite. False when it was interrupted; then the records
 * are all there, in some order. */
int murk_order(murk_photon *photons, size_t n, unsigned threads);

/* Puts the record in place k < n that sorting along that axis would put there,
 * none after it before it and none before it after it. Expected time O(n),
 * never beyond O(n log n). */
void murk_order_select(murk_photon *photons, size_t n, size_t k, int axis);

/* Sorts along that axis in place, in O(n log n) always. */
void murk_order_sort(murk_photon *photons, size_t n, int axis);

#endif
