/* A plan as plan.json and as summary. */
#ifndef MURK_RESULTS_PLAN_H
#define MURK_RESULTS_PLAN_H

#include "cases/condition_plans.h"
#include "results/coverage.h"
#include "results/repeat.h"
#include "results/session.h"

/* List fields that a plan over a matrix has, too: the first "bound" and
 * "curve", the second "nodes" and "cut_by" of the object "placement". `of`
 * points to a murk_place_result. */
void murk_results_list_bound(murk_results_fields *f, const void *of);
void murk_results_list_cut(murk_results_fields *f, const void *of);

/* The values that the fields of the object "budget" are made from. */
typedef struct murk_budget_results {
    double asked;
    const murk_place_result *place;
} murk_budget_results;
void murk_results_list_budget(murk_results_fields *f, const void *of);

/* Prints the line "bound" of the summary. `sample` is what the bound holds for,
 * such as "sample of photons". */
void murk_print_bound(const murk_place_result *place, bool has_budget,
                      const char *sample);

typedef struct murk_plan_results {
    const murk_session *session;
    const murk_plan_result *plan;
    const murk_condition_plans *conditions; /* NULL: a plan for the scene
                                               without conditions */
    const murk_repeat_results *repeat;      /* NULL: not repeated */
} murk_plan_results;

/* The sensors of the plan with their coverage in sample, and with the coverage
 * of the regions of interest on the held-out map, a second map that did not
 * choose the plan (NULL if it was not measured). Borrows from scene and plan.
 */
murk_sensor_results murk_plan_sensor_results(const murk_scene_desc *scene,
                                             const murk_plan_result *plan);

/* The first lists the fields of plan.json except `identity`, `files` and `run`,
 * the second prints the summary. `of` points to a murk_plan_results. */
void murk_results_list_plan(murk_results_fields *f, const void *of);
void murk_print_plan(const void *of);

#endif
