/* The rows of a study with ranks (base/ranks.h): each rank runs the next group
 * of rows until none is left, and stores the rows in the folder of the study,
 * which all ranks see; then the ranks exchange what they have found. For use
 * inside src/cases only. */
#ifndef MURK_CASES_SWEEP_RANKS_H
#define MURK_CASES_SWEEP_RANKS_H

#include "cases/sweep_store.h"

/* Begins to collect rows. Fails with MURK_RUN_FAILED if ranks see different
 * stored rows. Collective: no rank stores a row before all have read theirs. */
murk_status murk_sweep_ranks_begin(murk_sweep *sweep, murk_status status,
                                   murk_error *err);

/* Adds a row, or a plan for all rows, to what the other ranks receive; nothing
 * without ranks. murk_sweep_ranks_exchange() reports a lack of memory. */
void murk_sweep_ranks_add(murk_sweep *sweep, size_t number,
                          const murk_study_row *row);

/* Calls put() for all that the other ranks have added, without storing it, and
 * exchanges which groups were traced. Collective. */
murk_status murk_sweep_ranks_exchange(murk_sweep *sweep, size_t numbers,
                                      murk_sweep_put put, murk_status status,
                                      murk_error *err);

#endif
