/* The rows of one group, in their own process. Private to the sweep. */
#ifndef MURK_CASES_SWEEP_WORK_H
#define MURK_CASES_SWEEP_WORK_H

#include "base/isolated.h"
#include "cases/sweep.h"

typedef struct murk_sweep_job {
    const murk_sweep *sweep;
    const murk_sweep_group *group;
    bool measures_plans; /* of rows that are done, what the plans for all rows
                            are worth in them; else rows that are not done */
} murk_sweep_job;

/* A murk_isolated_work: context is the job. Sends each row of it
 * (cases/sweep_store.h). */
murk_status murk_sweep_work(murk_isolated *isolated, void *context,
                            murk_error *err);

#endif
