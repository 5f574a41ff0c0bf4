/* Gives every rank (base/ranks.h) the rows that the other ranks have computed.
 * For use inside src/placement only. */
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

#endif
