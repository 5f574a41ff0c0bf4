/* Adds up counters of work over ranks: the growth of each counter since the
 * ranks began to divide the work. */
#include "placement/work_count.h"

#include "base/ranks.h"

murk_work_count murk_work_count_begin(const murk_problem *problem)
{
    murk_work_count w = {.list = {.n = 0}};
    if (problem->list_counters) {
        problem->list_counters(problem->context, &w.list);
    }
    for (size_t i = 0; i < w.list.n; ++i) {
        w.before[i] = murk_tally_read(w.list.counter[i]);
    }
    return w;
}

murk_status murk_work_count_add(const murk_work_count *w, murk_status status,
                                murk_error *err)
{
    uint64_t work[MURK_COUNTERS_MAX];
    const size_t n = w->list.n;
    for (size_t i = 0; i < n; ++i) {
        work[i] =
            (uint64_t)(murk_tally_read(w->list.counter[i]) - w->before[i]);
    }
    status = murk_ranks_sum(work, n, false, status, err);
    for (size_t i = 0; i < n && !status; ++i) {
        const int64_t now = murk_tally_read(w->list.counter[i]);
        murk_tally_add(w->list.counter[i],
                       w->before[i] + (int64_t)work[i] - now);
    }
    return status;
}
