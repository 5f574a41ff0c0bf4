/* The counters of the work for rows (murk_problem.list_counters) when ranks
 * (base/ranks.h) divide the rows. For use inside src/placement only. */
#ifndef MURK_PLACEMENT_WORK_COUNT_H
#define MURK_PLACEMENT_WORK_COUNT_H

#include "placement/problem.h"

/* The counters, and their values when ranks begin to divide the work. */
typedef struct murk_work_count {
    murk_counters list;
    int64_t before[MURK_COUNTERS_MAX];
} murk_work_count;

murk_work_count murk_work_count_begin(const murk_problem *problem);

/* Adds the work of the other ranks since then to the counters. Collective. */
murk_status murk_work_count_add(const murk_work_count *work, murk_status status,
                                murk_error *err);

#endif
