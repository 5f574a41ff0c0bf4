/* Repeated placements: "repeat" of plan.json, repeat.csv, and lines of the
 * summary. */
#ifndef MURK_RESULTS_REPEAT_H
#define MURK_RESULTS_REPEAT_H

#include "cases/repeat.h"
#include "results/fields.h"

/* The values that the fields of the object "repeat" are made from. */
typedef struct murk_repeat_results {
    const murk_repeat *repeat; /* at least one run is finished */
    murk_repeat_summary summary;
} murk_repeat_results;
void murk_results_list_repeat(murk_results_fields *f, const void *of);

/* Lists the columns of repeat.csv. `of` points to a murk_repeat; i: run. */
void murk_results_list_run(murk_results_fields *f, const void *of, size_t i);

void murk_print_repeat(const murk_repeat_results *results);

#endif
