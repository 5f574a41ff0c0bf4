/* Plans over conditions that are made already: the regret of one plan in one
 * condition, and the release of all of them. */
#include "cases/condition_plans.h"

#include <stdlib.h>

const murk_pose *murk_condition_plan_sensors_in(const murk_condition_plan *plan,
                                                size_t c)
{
    return plan->sensor_in[c] ? plan->sensor_in[c] : plan->sensor;
}

double murk_condition_plans_regret(const murk_condition_plans *plans,
                                   const murk_condition_plan *plan, size_t c)
{
    const murk_condition_plan *own = &plans->plan[c];
    return plans->has_held_out
               ? own->held_out[c].value - plan->held_out[c].value
               : own->in_sample[c].value - plan->in_sample[c].value;
}

void murk_condition_plans_release(murk_condition_plans *plans)
{
    for (size_t p = 0; p < plans->plans; ++p) {
        free(plans->plan[p].sensor);
        for (size_t c = 0; c < MURK_SCENE_CONDITIONS_MAX; ++c) {
            free(plans->plan[p].sensor_in[c]);
        }
    }
    for (size_t c = 0; c < MURK_SCENE_CONDITIONS_MAX; ++c) {
        murk_coverage_result_release(&plans->coverage[c]);
    }
    free(plans->shaken);
    murk_conditions_destroy(plans->conditions);
    *plans = (murk_condition_plans){0};
}
