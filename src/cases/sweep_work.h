/* The subprocess that measures the rows of one group. Inside this room only. */
#ifndef MURK_CASES_SWEEP_WORK_H
#define MURK_CASES_SWEEP_WORK_H

#include "base/isolated.h"
#include "cases/sweep.h"

typedef struct murk_sweep_job {
    const murk_sweep *sweep;
    const murk_sweep_group *group;
    bool measures_plans; /* true: measures the plans for all rows, in the rows
                            that are done; false: runs the rows that are not */
} murk_sweep_job;

/* True if row k of the group is left for the job to do. */
bool murk_sweep_job_wants(const murk_sweep_job *job, size_t k);

/* A murk_isolated_work: context is the job. Sends each row
 * (murk_sweep_send()). */
murk_status murk_sweep_work(murk_isolated *isolated, void *context,
                            murk_error *err);

#endif
