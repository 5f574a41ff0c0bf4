/* "repeat" of plan.json, repeat.csv, and the summary's lines. */
#ifndef MURK_RESULTS_REPEAT_H
#define MURK_RESULTS_REPEAT_H

#include "cases/repeat.h"
#include "results/results.h"

murk_status murk_json_repeat(cJSON *root, const murk_repeat *repeat,
                             murk_error *err);

/* A row a finished run, in order of seeds. */
murk_status murk_add_repeat_csv(murk_results *results,
                                const murk_repeat *repeat, murk_error *err);

murk_status murk_print_repeat(const murk_repeat *repeat, murk_error *err);

#endif
