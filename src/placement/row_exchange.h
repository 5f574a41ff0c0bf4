/* Rows that other ranks (base/ranks.h) have computed: all of them are exchanged
 * at once, or each stays with the rank that computed it, and the other ranks
 * fetch a row when they need it. For use inside src/placement only. */
#ifndef MURK_PLACEMENT_ROW_EXCHANGE_H
#define MURK_PLACEMENT_ROW_EXCHANGE_H

#include "placement/row_space.h"

/* True if this rank computes the row: rank r computes every count-th row, from
 * row r on. */
bool murk_row_is_own(size_t candidate);

/* Exchanges row[candidates] of one layout. Rows that this rank does not have
 * yet are stored in the space. row_bytes: the size of a row, at most.
 * Collective. Fails with MURK_NO_MEMORY, with the failure of a space that
 * cannot take a row, or with MURK_INTERRUPTED. */
murk_status murk_row_exchange(murk_row *row, size_t candidates,
                              murk_row_space *space, size_t row_bytes,
                              murk_status status, murk_error *err);

/* The rows that were fetched last, the same ones in all ranks. */
typedef struct murk_fetched_rows murk_fetched_rows;

/* For row[candidates], of which each rank has those of its own candidates.
 * Collective. Fails with MURK_NO_MEMORY or the failure of a rank. */
murk_status murk_fetched_rows_create(murk_fetched_rows **out,
                                     const murk_row *row, size_t candidates,
                                     murk_status status, murk_error *err);
void murk_fetched_rows_destroy(murk_fetched_rows *fetched); /* accepts NULL */

/* The row of a candidate, which lies in `space`; row[candidate] has the entries
 * in the rank that owns the row. Collective: all ranks fetch the same rows in
 * the same order. The arrays stay valid until the next call. After a failure of
 * any rank (murk_interrupted()) the row has no entries. */
murk_row murk_fetched_rows_get(murk_fetched_rows *fetched, const murk_row *row,
                               murk_row_space *space, size_t candidate);

#endif
