/* Photons that every candidate sees alike, in a matrix: a few stand for all.
 *
 * Of m such photons of weight w, one stands for each power of two in m, with
 * w times as much, so few weights appear and photons of one weight still lie
 * side by side. All sums are those of the photons themselves: values, bounds
 * and decisions stay the same in every bit. */
#ifndef MURK_PLACEMENT_MERGE_H
#define MURK_PLACEMENT_MERGE_H

#include "placement/row.h"

#include <stdatomic.h>

/* print[photons] is a sum of random words, one a candidate that sees the
 * photon: equal views have equal prints. From any thread. */
void murk_merge_hash(_Atomic uint64_t *hash, size_t candidate,
                     const murk_sparse_row *entries);

/* Merges where that makes rows so much shorter that it pays (or always). Equal
 * prints are checked, row by row: where two views that differ have the same,
 * nothing is merged. Fails when out of memory. */
murk_status murk_merge(murk_layout *layout, murk_row *row,
                       const murk_problem *problem,
                       const _Atomic uint64_t *hash, bool is_forced,
                       uint64_t *row_bytes, murk_error *err);

#endif
