/* The fields of all result files, for the manual and for tests. */
#ifndef MURK_RESULTS_CATALOGUE_H
#define MURK_RESULTS_CATALOGUE_H

#include <stdio.h>

/* Prints a section of Markdown for each file: "## FILE" and a table of the
 * file's fields, in order. */
void murk_results_catalogue(FILE *to);

#endif
