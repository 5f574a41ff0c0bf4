/* How an exploration went, as JSON, CSV, lines, and its path for viewers. With
 * other knowledge than `explore` all do nothing. */
#ifndef MURK_RESULTS_EXPLORE_H
#define MURK_RESULTS_EXPLORE_H

#include "results/fields.h"

/* Row "explore". */
void murk_results_list_explore(murk_results_fields *f,
                               const murk_scene_desc *scene,
                               const murk_plan_result *plan);

/* Rows of steps[], and columns of explore.csv; of: an exploration. */
void murk_results_list_step(murk_results_fields *f, const void *of, size_t i);

/* Adds explore.csv, a row a step, and path.ply. The latter's vertices are the
 * stops of the path, in order, then six corners of a thin three-sided line
 * about each segment, which the faces join (some viewers leave edges out), each
 * with
 *
 *     x y z           float, m
 *     red green blue  uchar: green at the start to violet at the end
 *     kind            uchar: 0 station, 1 passed on the way, 2 corner
 *     step            ushort: of the station, or the one that it leads to
 *
 * The edges join each stop to the next. Binary, little endian. The line is
 * one part in five hundred of the world's size thick. */
murk_status murk_add_explore(murk_results *results, const murk_stage *stage,
                             const murk_plan_result *plan, murk_error *err);

void murk_print_explore(const murk_plan_result *plan, const char *folder);

#endif
