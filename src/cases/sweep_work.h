/* The work of a study in the process that the host chooses (base/isolated.h):
 * on the rows of a group, and the choice of the plans for all rows. For use
 * inside src/cases only. */
#ifndef MURK_CASES_SWEEP_WORK_H
#define MURK_CASES_SWEEP_WORK_H

#include "base/isolated.h"
#include "cases/sweep_light.h"

/* A murk_isolated_work: context is the murk_sweep_job. Sends each row of the
 * group that the job wants (murk_sweep_send()), with the results of the row,
 * with the coverages of the plans for all rows (MURK_SWEEP_MEASURE) or as
 * failed. */
murk_status murk_sweep_work(murk_isolated *isolated, void *context,
                            murk_error *err);

/* A murk_isolated_work: context is the sweep, whose choosers are the rows that
 * take part. Sends each plan that is asked for and not stored yet, by its
 * number (murk_sweep_send()): sensors, in_sample and upper_bound, or the reason
 * why there is no plan. A plan without sensors and without a reason means that
 * no row has anything to see. */
murk_status murk_sweep_choose(murk_isolated *isolated, void *context,
                              murk_error *err);

#endif
