/* The steps of an exploration (plan/explore.h) as JSON, CSV and lines, and the
 * path of an exploration for viewers. A plan that was not found with
 * `knowledge: explore` has none of these. */
#ifndef MURK_RESULTS_EXPLORE_H
#define MURK_RESULTS_EXPLORE_H

#include "results/fields.h"

/* Lists the field "explore". */
void murk_results_list_explore(murk_results_fields *f,
                               const murk_scene_desc *scene,
                               const murk_plan_result *plan);

/* Lists the fields of steps[i], or the columns of explore.csv. `of` points to a
 * struct internal to explore.c; NULL: the fields are only described
 * (results/fields.h). */
void murk_results_list_step(murk_results_fields *f, const void *of, size_t i);

/* Adds explore.csv, with a line for each step, and path.ply. The vertices of
 * path.ply are the stops of the path, in order, then six corners of a thin
 * three-sided tube about each segment (some viewers do not show edges). The
 * faces are the sides of the tubes. A vertex has
 *
 *     x y z           float, m
 *     red green blue  uchar: green at the start to violet at the end
 *     kind            uchar: 0 station, 1 passed on the way, 2 corner
 *     step            ushort: number of the station, from 1; of the other
 *                     vertices, of the station that the path leads to
 *
 * The edges join each stop to the next. Binary, little endian. A tube is 1/500
 * of the diagonal of the domain thick. Does nothing if there are no steps;
 * otherwise stage must not be NULL. */
murk_status murk_add_explore(murk_results *results, const murk_stage *stage,
                             const murk_plan_result *plan, murk_error *err);

void murk_print_explore(const murk_plan_result *plan, const char *folder);

#endif
