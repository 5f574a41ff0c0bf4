/* The subprocess that chooses the plans for all rows of a study. Inside this
 * room only. */
#ifndef MURK_CASES_SWEEP_CHOOSE_H
#define MURK_CASES_SWEEP_CHOOSE_H

#include "base/isolated.h"
#include "cases/sweep.h"

/* A murk_isolated_work: context is the sweep, whose choosers are the rows that
 * take part. Sends each plan that is asked for and not stored yet, by its
 * number (murk_sweep_send()): sensors, in_sample and upper_bound, or the reason
 * why there is no plan. A plan without sensors and without a reason means that
 * no row has anything to see. */
murk_status murk_sweep_choose(murk_isolated *isolated, void *context,
                              murk_error *err);

#endif
