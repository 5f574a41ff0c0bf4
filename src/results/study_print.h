/* The rows of a study as a table on standard output: as many rows and columns
 * as fit a screen; table.csv has all, and values by band. */
#ifndef MURK_RESULTS_STUDY_PRINT_H
#define MURK_RESULTS_STUDY_PRINT_H

#include "cases/sweep.h"

/* folder NULL: nothing is written. */
void murk_print_study_rows(const murk_sweep *sweep, const char *folder);

#endif
