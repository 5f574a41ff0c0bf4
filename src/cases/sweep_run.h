/* Reads and runs a study. */
#ifndef MURK_CASES_SWEEP_RUN_H
#define MURK_CASES_SWEEP_RUN_H

#include "cases/sweep.h"

/* Reads the scenes of all rows, and the stored rows of earlier runs; traces
 * nothing. A row whose scene cannot be read has failed; the study fails if all
 * rows have. *out is the caller's: murk_sweep_destroy(). The desc is copied;
 * the objects that it points to must outlive *out. */
murk_status murk_sweep_create(murk_sweep **out, const murk_sweep_desc *desc,
                              murk_error *err);
void murk_sweep_destroy(murk_sweep *sweep); /* NULL is fine */

/* Runs the rows that are not done, then makes the plans for all rows. Fails
 * with MURK_INTERRUPTED, or if a finished row cannot be stored; a row that
 * fails is no failure of the study. Call it while this process has no threads
 * (fork). */
murk_status murk_sweep_run(murk_sweep *sweep, murk_error *err);

#endif
