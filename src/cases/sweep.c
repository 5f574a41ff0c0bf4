/* Questions about the rows and the plans of a study. */
#include "cases/sweep.h"

bool murk_sweep_owns(const murk_sweep *sweep, size_t row)
{
    const murk_shard shard = sweep->desc.shard;
    const size_t group = sweep->row[row].group;
    return shard.count == 0 ||
           (group != SIZE_MAX && group % shard.count == shard.number - 1);
}

size_t murk_sweep_owned(const murk_sweep *sweep)
{
    size_t owned = 0;
    for (size_t i = 0; i < sweep->desc.study->rows; ++i) {
        owned += murk_sweep_owns(sweep, i);
    }
    return owned;
}

size_t murk_sweep_done(const murk_sweep *sweep)
{
    size_t done = 0;
    for (size_t i = 0; i < sweep->desc.study->rows; ++i) {
        done += sweep->row[i].is_done;
    }
    return done;
}

size_t murk_sweep_failed(const murk_sweep *sweep)
{
    size_t failed = 0;
    for (size_t i = 0; i < sweep->desc.study->rows; ++i) {
        failed += sweep->row[i].is_done && sweep->row[i].found.failed[0];
    }
    return failed;
}

const char *murk_sweep_why_no_plan(const murk_sweep *sweep)
{
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        const murk_sweep_plan *plan = &sweep->plan[p];
        if (plan->is_wanted && plan->found.failed[0]) {
            return plan->found.failed;
        }
    }
    return NULL;
}

const char *murk_sweep_plan_name(int plan)
{
    return plan == MURK_SWEEP_MEAN ? "coverage_one_mean" : "coverage_one_worst";
}

bool murk_sweep_plan_stands(const murk_sweep_plan *plan)
{
    return plan->is_wanted && plan->found.sensors > 0;
}

bool murk_sweep_lacks_values(const murk_sweep_row *row)
{
    return row->is_done && !row->found.failed[0] && !row->has_plans;
}
