/* Runs a study that was read. */
#ifndef MURK_CASES_SWEEP_RUN_H
#define MURK_CASES_SWEEP_RUN_H

#include "cases/sweep.h"

/* Runs the rows that are not done, then makes the plans for all rows. Fails
 * with MURK_INTERRUPTED, or if a finished row cannot be stored; a row that
 * fails is no failure of the study. Call it while this process has no threads
 * (fork). */
murk_status murk_sweep_run(murk_sweep *sweep, murk_error *err);

#endif
