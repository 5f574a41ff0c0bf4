/* A plan as plan.json and as summary. */
#ifndef MURK_RESULTS_PLAN_H
#define MURK_RESULTS_PLAN_H

#include "cases/condition_plans.h"
#include "results/coverage.h"
#include "results/repeat.h"
#include "results/session.h"

/* Rows that a plan over a matrix has, too. "bound" and "curve", "nodes" and
 * "cut_by" of "placement"; of: a murk_place_result. */
void murk_results_list_bound(murk_results_fields *f, const void *of);
void murk_results_list_cut(murk_results_fields *f, const void *of);

/* Rows of "budget"; of: */
typedef struct murk_budget_results {
    double asked;
    const murk_place_result *place;
} murk_budget_results;
void murk_results_list_budget(murk_results_fields *f, const void *of);

/* The summary's line "bound". */
void murk_print_bound(const murk_place_result *place, bool has_budget,
                      const char *sample);

typedef struct murk_plan_results {
    const murk_session *session;
    const murk_plan_result *plan;
    const murk_condition_plans *conditions; /* NULL: the scene as it stands */
    const murk_repeat_results *repeat;      /* NULL: not repeated */
} murk_plan_results;

/* The plan's sensors with their coverage in sample. */
murk_sensor_results murk_plan_sensor_results(const murk_scene_desc *scene,
                                             const murk_plan_result *plan);

/* Rows of plan.json, yet without `run`, and the summary; of: a
 * murk_plan_results. */
void murk_results_list_plan(murk_results_fields *f, const void *of);
void murk_print_plan(const void *of);

#endif
