/* How many candidates there are, and why others are none: as JSON and in
 * words. */
#ifndef MURK_RESULTS_CANDIDATES_H
#define MURK_RESULTS_CANDIDATES_H

#include "results/results.h"
#include "sensing/candidates.h"

/* Adds `candidates`, which is the caller's to go on with. */
cJSON *murk_json_candidates(cJSON *root, const murk_candidates *candidates);

/* "candidates  48 asked, 40 usable: ..." */
void murk_print_candidates(const murk_candidates *candidates);

#endif
