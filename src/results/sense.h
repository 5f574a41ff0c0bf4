/* Coverage of given sensors as coverage.json and as summary. */
#ifndef MURK_RESULTS_SENSE_H
#define MURK_RESULTS_SENSE_H

#include "results/goals.h"
#include "results/session.h"

typedef struct murk_sense_results {
    const murk_session *session;
    murk_sensor_results sensors;
    const murk_target_facts *targets;
    const murk_robust *robust;
} murk_sense_results;

/* The first lists the fields of coverage.json except `identity`, `files` and
 * `run`, the second prints the summary. `of` points to a murk_sense_results. */
void murk_results_list_sense(murk_results_fields *f, const void *of);
void murk_print_sense(const void *of);

#endif
