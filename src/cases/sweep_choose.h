/* The process in which plans for all rows of a study are chosen. Private to the
 * sweep. */
#ifndef MURK_CASES_SWEEP_CHOOSE_H
#define MURK_CASES_SWEEP_CHOOSE_H

#include "base/isolated.h"
#include "cases/sweep.h"

/* A murk_isolated_work: context is the sweep, whose choosers say which rows
 * have a say. Sends each plan that is wanted and lacks (cases/sweep_store.h),
 * by its number: sensors, in_sample and upper_bound, or why there is none.
 * Without sensors and reason, no row has anything to see. */
murk_status murk_sweep_choose(murk_isolated *isolated, void *context,
                              murk_error *err);

#endif
