/* One plan for all rows of a study: for the mean of their coverages, or for the
 * least of them. Inside this room only.
 *
 * One subprocess traces the light of the rows once more, holds it in memory at
 * one time and chooses; then the subprocess of each group measures the plans in
 * the rows of the group. All rows have equal weight; rows in which nothing can
 * be seen do not take part. Of more than MURK_SWEEP_CHOOSERS_MAX rows that many
 * take part in the choice, evenly spread in their order; the plans are measured
 * in all rows. */
#ifndef MURK_CASES_SWEEP_PLANS_H
#define MURK_CASES_SWEEP_PLANS_H

#include "cases/sweep.h"

/* Makes the plans that are asked for and measures them in the rows that have
 * not failed. Plans and values that an earlier run stored are taken over. A
 * plan that cannot be made holds the reason and leaves the rows alone. Fails
 * with MURK_INTERRUPTED, or if a result cannot be stored. */
murk_status murk_sweep_plan_all(murk_sweep *sweep, murk_error *err);

#endif
