/* The fields of the JSON and CSV files of results, for the manual and for
 * tests. table.csv is not listed, because its columns depend on the study. */
#ifndef MURK_RESULTS_CATALOGUE_H
#define MURK_RESULTS_CATALOGUE_H

#include <stdio.h>

/* Prints a section of Markdown for each file: "## FILE" and a table of the
 * fields of the file, in their order. The fields that every JSON begins with
 * have a section of their own, which comes first. */
void murk_results_catalogue(FILE *to);

#endif
