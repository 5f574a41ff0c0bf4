/* The rows of one group, in their own process. Private to the sweep. */
#ifndef MURK_STUDY_SWEEP_WORK_H
#define MURK_STUDY_SWEEP_WORK_H

#include "base/apart.h"
#include "study/sweep.h"

typedef struct murk_sweep_job {
    const murk_sweep *sweep;
    const murk_sweep_group *group;
} murk_sweep_job;

/* A murk_apart_work: context is the job. Sends a message for each row that was
 * not done: its number, a line end, and its text (study/row.h). */
murk_status murk_sweep_work(murk_apart *apart, void *context, murk_error *err);

/* The file of a row's fluence within a folder. */
#define MURK_SWEEP_NAME_SIZE 32
void murk_sweep_fluence_name(char out[MURK_SWEEP_NAME_SIZE], size_t row);

#endif
