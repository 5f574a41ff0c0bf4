/* How many places were asked for as candidates, how many are usable, and why
 * the others are not: as JSON and as a line of the summary. */
#ifndef MURK_RESULTS_CANDIDATES_H
#define MURK_RESULTS_CANDIDATES_H

#include "results/fields.h"
#include "sensing/candidates.h"

/* Lists the fields "asked" to "duplicates" of the object "candidates". `of`
 * points to a murk_candidates; NULL: the fields are only described
 * (results/fields.h). */
void murk_results_list_candidates(murk_results_fields *f, const void *of);

/* Prints one line: "candidates 48 asked, 40 usable: ...". */
void murk_print_candidates(const murk_candidates *candidates);

#endif
