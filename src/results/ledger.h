/* The ledger of a trace as JSON: where the light's power went. */
#ifndef MURK_RESULTS_LEDGER_H
#define MURK_RESULTS_LEDGER_H

#include "lightmap/lightmap.h"

#include <cjson/cJSON.h>

/* ledger.json's own fields. */
void murk_json_ledger(cJSON *object, const murk_traced *traced,
                      const murk_stage *stage);

/* Watts of one ledger column, over all channels. */
double murk_ledger_watts(const murk_traced *traced, const murk_tally *column);

#endif
