/* Parts of the report's section of a placement. Each writes nothing where the
 * results have nothing of it, and returns false when out of memory. */
#ifndef MURK_REPORT_PLAN_H
#define MURK_REPORT_PLAN_H

#include "report/results_in.h"

#include <stdio.h>

/* What each sensor sees, as bars and as a table; how many see the same. */
bool murk_report_sensors(FILE *to, const murk_results_in *results,
                         const murk_yaml *plan);

/* Conditions, and plans made for one of them used in the others. */
bool murk_report_over(FILE *to, const murk_yaml *plan);

/* A sensor lost, sensors not quite in place, links between them. */
bool murk_report_robust(FILE *to, const murk_yaml *plan);

/* What is seen along the way of who has to explore. */
bool murk_report_explore(FILE *to, const murk_yaml *plan);

/* The same with other seeds: repeat.csv. */
murk_status murk_report_repeat(FILE *to, const murk_results_in *results,
                               const murk_yaml *plan, murk_error *err);

#endif
