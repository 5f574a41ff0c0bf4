/* The rows of a study as a table on standard output: all axes, as many values
 * as fit 80 columns, and the first 24 rows. Values of single bands are left
 * out. table.csv has everything. */
#ifndef MURK_RESULTS_STUDY_PRINT_H
#define MURK_RESULTS_STUDY_PRINT_H

#include "cases/sweep.h"

/* Prints the table, and a line about what is left out. folder: that of
 * table.csv; NULL: none is written. */
void murk_print_study_rows(const murk_sweep *sweep, const char *folder);

#endif
