/* The ledger of a trace as JSON: where the light's power went. */
#ifndef MURK_RESULTS_LEDGER_H
#define MURK_RESULTS_LEDGER_H

#include "lightmap/lightmap.h"
#include "results/fields.h"

/* Rows of ledger.json, yet without `run`; of: */
typedef struct murk_ledger_results {
    const murk_traced *traced;
    const murk_stage *stage;
} murk_ledger_results;
void murk_results_list_ledger(murk_results_fields *f, const void *of);

/* Watts of one ledger column, over all channels. */
double murk_ledger_watts(const murk_traced *traced, const murk_tally *column);

#endif
