/* The plans over conditions: the one asked for, and those to compare it with.
 */
#ifndef MURK_CASES_CONDITION_PLANS_CHOOSE_H
#define MURK_CASES_CONDITION_PLANS_CHOOSE_H

#include "cases/condition_plans.h"

/* Fills plan->place with what was asked for, and plans->plan with it and the
 * others: by the same method, with as many sensors, without curves. Conditions
 * are lit. */
murk_status murk_condition_plans_choose(murk_condition_plans *plans,
                                        murk_plan_result *plan,
                                        murk_error *err);

#endif
