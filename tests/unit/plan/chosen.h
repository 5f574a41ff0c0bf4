/* The sensors of a plan on traced light, without any measurement of them. */
#include "plan/plan.h"

static inline murk_status choose_sensors(murk_plan_result *plan,
                                         const murk_stage *stage,
                                         const murk_traced *traced,
                                         unsigned threads, murk_error *err)
{
    murk_sight *sight = NULL;
    murk_status status = murk_plan_sight(&sight, stage, traced, threads, err);
    if (!status) {
        status = murk_plan_choose(plan, stage, sight, err);
    }
    murk_sight_destroy(sight);
    return status;
}
