/* The plans over conditions: the one asked for, and those to compare it with.
 */
#ifndef MURK_CASES_OVER_CHOOSE_H
#define MURK_CASES_OVER_CHOOSE_H

#include "cases/over.h"

/* Fills plan->place with what was asked for, and over->plan with it and the
 * others: by the same method, with as many sensors, without curves. Conditions
 * are lit. */
murk_status murk_over_choose(murk_over *over, murk_plan_result *plan,
                             murk_error *err);

#endif
