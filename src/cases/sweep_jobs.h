/* The work of the subprocesses of a study as jobs that murk-rows does
 * (base/isolated.h). */
#ifndef MURK_CASES_SWEEP_JOBS_H
#define MURK_CASES_SWEEP_JOBS_H

#include "base/isolated.h"

/* The context is a murk_sweep_job (cases/sweep_light.h). */
extern const murk_isolated_job murk_sweep_group_job;
/* The context is the murk_sweep, whose choosers are the rows that take part. */
extern const murk_isolated_job murk_sweep_choose_job;

#endif
