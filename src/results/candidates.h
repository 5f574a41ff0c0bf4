/* How many candidates there are, and why others are none: as JSON and in
 * words. */
#ifndef MURK_RESULTS_CANDIDATES_H
#define MURK_RESULTS_CANDIDATES_H

#include "results/fields.h"
#include "sensing/candidates.h"

/* Rows of "candidates"; of: a murk_candidates. */
void murk_results_list_candidates(murk_results_fields *f, const void *of);

/* "candidates  48 asked, 40 usable: ..." */
void murk_print_candidates(const murk_candidates *candidates);

#endif
