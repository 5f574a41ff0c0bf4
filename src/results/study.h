/* The rows of a study as table.csv, and as the list `rows` of study.json. */
#ifndef MURK_RESULTS_STUDY_H
#define MURK_RESULTS_STUDY_H

#include "cases/sweep.h"
#include "results/fields.h"

/* Adds table.csv: a line for each row that is done, in the order of the study.
 * Its columns are the axes, then each value with its standard error, and last
 * `failed`. A cell is empty if the row has no such value. Fails as
 * murk_results_add() does. */
murk_status murk_add_table(murk_results *results, const murk_sweep *sweep,
                           murk_error *err);

/* The values that the fields of study.json are made from. */
typedef struct murk_study_results {
    const murk_sweep *sweep;
    bool is_interrupted;
    const char *folder; /* of the results; NULL: nothing is written */
} murk_study_results;
void murk_results_list_study(murk_results_fields *f, const void *of);

#endif
