/* "repeat" of plan.json, repeat.csv, and the summary's lines. */
#ifndef MURK_RESULTS_REPEAT_H
#define MURK_RESULTS_REPEAT_H

#include "cases/repeat.h"
#include "results/fields.h"

/* Rows of "repeat"; of: */
typedef struct murk_repeat_results {
    const murk_repeat *repeat; /* at least one run is finished */
    murk_repeat_summary summary;
} murk_repeat_results;
void murk_results_list_repeat(murk_results_fields *f, const void *of);

/* Columns of repeat.csv; of: a murk_repeat. */
void murk_results_list_run(murk_results_fields *f, const void *of, size_t i);

void murk_print_repeat(const murk_repeat_results *results);

#endif
