/* The summary of a study. A table shows the first 24 rows of the study, with
 * all axes and as many values as fit 80 columns. Values of single bands are
 * left out. table.csv has all values of the rows that are done. */
#ifndef MURK_RESULTS_STUDY_PRINT_H
#define MURK_RESULTS_STUDY_PRINT_H

#include "results/study.h"

/* Prints the summary of a study. `of` points to a murk_study_results. */
void murk_print_study(const void *of);

#endif
