/* Presolve of photons: photons with equal columns in the coverage matrix and
 * equal weight are merged.
 *
 * Of m equal photons of weight w, one stays for each binary digit 1 of m, with
 * weight w times the power of two of that digit (a weight beyond 32 bits is
 * split). So few distinct weights appear, and photons of one weight still share
 * words (placement/layout.h). All sums are those of the original photons:
 * values, bounds and decisions stay the same in every bit. */
#ifndef MURK_PLACEMENT_MERGE_H
#define MURK_PLACEMENT_MERGE_H

#include "placement/row_space.h"

#include <stdatomic.h>

/* Adds a row to the hashes of the columns, or takes it away. hash[photons] is a
 * sum of pseudo-random words, one for each entry of the photon's column, so
 * equal columns have equal hashes. May be called from any thread. */
void murk_merge_hash(_Atomic uint64_t *hash, size_t candidate,
                     const murk_sparse_row *entries);
void murk_merge_unhash(_Atomic uint64_t *hash, size_t candidate,
                       const murk_sparse_row *entries);

/* Merges photons in layout and row[candidates], which lie in `space`, if the
 * rows become so much shorter that merging pays, or always with is_forced.
 * Equal hashes are verified, row by row; if columns with one hash differ,
 * nothing is merged. is_distributed: each rank has the rows of its own
 * candidates alone, and merges if all ranks can; collective then. Takes
 * ownership of hash (from malloc()) and frees it as soon as photons are
 * grouped, unless keeps_hash. If photons were merged and `representative` is
 * not NULL, *representative receives an array [photons of the problem], for
 * free(): the number of each photon, or of one with an equal column, in the new
 * layout. Fails with MURK_NO_MEMORY or MURK_INTERRUPTED, or with
 * MURK_RUN_FAILED if the scratch file of the rows cannot take them. */
murk_status murk_merge(murk_layout *layout, murk_row *row,
                       murk_row_space *space, bool is_distributed,
                       const murk_problem *problem, _Atomic uint64_t *hash,
                       bool keeps_hash, bool is_forced,
                       uint32_t **representative, murk_error *err);

#endif
