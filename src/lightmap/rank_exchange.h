/* What ranks (base/ranks.h) exchange while they trace the light of a scene: the
 * records of each wave, and the sums of ledger and tallies. Without ranks
 * nothing is exchanged. */
#ifndef MURK_LIGHTMAP_RANK_EXCHANGE_H
#define MURK_LIGHTMAP_RANK_EXCHANGE_H

#include "lightmap/record_buffers.h"
#include "transport/tallies.h"

/* Gives all ranks the records of the batches of a wave that are in buffer[n] of
 * the record buffers: this rank traced those of which it owns the place in
 * buffer[] (murk_ranks_owns()). *flag becomes that of rank 0. Collective. Fails
 * with MURK_NO_MEMORY. */
murk_status murk_ranks_exchange_records(murk_record_buffers *buffers,
                                        const size_t *buffer, size_t n,
                                        bool *flag, murk_status status,
                                        murk_error *err);

/* Sums as whole numbers: cell[murk_ledger_cells()] and
 * word[murk_tallies_words()]. */
typedef struct murk_light_sums {
    int64_t *cell;
    uint64_t *word;
    size_t cells, words;
} murk_light_sums;

/* The sums of ledger and tallies (NULL: none), of this rank; and, with of_all,
 * of all ranks together, for which the call is collective. Fails with
 * MURK_NO_MEMORY. Release also after a failure. */
murk_status murk_light_sums_read(murk_light_sums *out,
                                 const murk_ledger *ledger,
                                 const murk_tallies *tallies, bool of_all,
                                 murk_status status, murk_error *err);
void murk_light_sums_release(murk_light_sums *sums);

/* Adds to ledger and tallies what they lack of the sums of all ranks, so that
 * all ranks have these. Collective. Fails with MURK_NO_MEMORY. */
murk_status murk_ranks_add_sums(murk_ledger *ledger, murk_tallies *tallies,
                                murk_status status, murk_error *err);

#endif
