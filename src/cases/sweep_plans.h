/* One plan for all rows of a study: for the mean of their coverages, or for the
 * least of them. Private to the sweep.
 *
 * The rows' light is traced once more, and held together in one process, which
 * chooses; then each group measures the plans in its rows. All rows weigh the
 * same; those with nothing to see have no say. More than
 * MURK_SWEEP_CHOOSERS_MAX rows are chosen for by so many of them, evenly spread
 * in their order, and measured in all. */
#ifndef MURK_CASES_SWEEP_PLANS_H
#define MURK_CASES_SWEEP_PLANS_H

#include "cases/sweep.h"

/* Makes the plans that are asked for and measures them: rows that have not
 * failed get their values. What is kept of earlier runs is not made anew. A
 * plan that cannot be made says why, and leaves the rows alone. Fails where it
 * was interrupted, or what is done cannot be kept. */
murk_status murk_sweep_plan_all(murk_sweep *sweep, murk_error *err);

#endif
