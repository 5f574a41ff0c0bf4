/* A study's rows as table.csv, and as JSON. */
#ifndef MURK_RESULTS_STUDY_H
#define MURK_RESULTS_STUDY_H

#include "cases/sweep.h"
#include "results/fields.h"

/* Adds table.csv: rows that are done, in the study's order; a column an axis,
 * then each value and its standard error, last `failed`. Empty cells: there is
 * no such value. */
murk_status murk_add_table(murk_results *results, const murk_sweep *sweep,
                           murk_error *err);

/* Rows of study.json; of: */
typedef struct murk_study_results {
    const murk_sweep *sweep;
    bool is_interrupted;
} murk_study_results;
void murk_results_list_study(murk_results_fields *f, const void *of);

#endif
