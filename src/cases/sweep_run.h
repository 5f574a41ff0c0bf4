/* Reads and runs a study. */
#ifndef MURK_CASES_SWEEP_RUN_H
#define MURK_CASES_SWEEP_RUN_H

#include "cases/sweep.h"

/* Reads the scenes of all rows and what is kept of earlier runs; traces
 * nothing. Rows that cannot be read have failed; the study fails where all
 * have. *out is the caller's; the desc is copied, what it points to must
 * outlive it. */
murk_status murk_sweep_create(murk_sweep **out, const murk_sweep_desc *desc,
                              murk_error *err);
void murk_sweep_destroy(murk_sweep *sweep); /* NULL is fine */

/* Runs what is not done, then makes the plans for all rows. Fails where it was
 * interrupted, or a row cannot be kept; rows that fail do not make it fail.
 * Call it while this process has no threads. */
murk_status murk_sweep_run(murk_sweep *sweep, murk_error *err);

#endif
