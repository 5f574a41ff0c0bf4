/* Chooses the plans over conditions: the plan that is asked for, and the plans
 * to compare it with. */
#ifndef MURK_CASES_CONDITION_PLANS_CHOOSE_H
#define MURK_CASES_CONDITION_PLANS_CHOOSE_H

#include "cases/condition_plans.h"

/* Fills plan->place with the plan that is asked for, and plans->plan with that
 * plan and the others. The others are chosen by the same method, with the same
 * number of sensors and without curves. The conditions must have their light
 * (murk_conditions_light()). */
murk_status murk_condition_plans_choose(murk_condition_plans *plans,
                                        murk_plan_result *plan,
                                        murk_error *err);

#endif
