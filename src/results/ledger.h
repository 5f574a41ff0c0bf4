/* The ledger of a trace as JSON: where the power of the light went. */
#ifndef MURK_RESULTS_LEDGER_H
#define MURK_RESULTS_LEDGER_H

#include "lightmap/lightmap.h"
#include "results/fields.h"

/* The values that the fields of ledger.json are made from; both are borrowed.
 */
typedef struct murk_ledger_results {
    const murk_traced *traced;
    const murk_stage *stage;
} murk_ledger_results;
void murk_results_list_ledger(murk_results_fields *f, const void *of);

/* The power [W] of one ledger column, summed over all channels (a channel is a
 * light source in a band). column[traced->channels]. */
double murk_ledger_watts(const murk_traced *traced, const murk_tally *column);

#endif
