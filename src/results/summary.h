/* The summary of results (base/print.h), as lines that are collected before
 * they are shown. */
#ifndef MURK_RESULTS_SUMMARY_H
#define MURK_RESULTS_SUMMARY_H

#include "base/print.h"
#include "results/json.h"

#include <stddef.h>

/* Calls print(of) and returns the lines as a list of texts, instead of showing
 * them: escaped, and not yet broken at 80 columns. The caller deletes the list,
 * which is NULL when out of memory. */
cJSON *murk_print_collect(murk_print_results *print, const void *of);

/* Prints "time 4.70 s: load 0.07, trace 0.01; memory 0.05 GB", without parts of
 * less than 0.005 s. other: name of a further part, of other_s seconds; NULL:
 * none. */
void murk_print_time(const murk_run_facts *run, const char *other,
                     double other_s);

/* Largest number of rows of a table that are shown. If n is more,
 * murk_print_more() prints how many more rows `file` in the folder has (folder
 * NULL: no file is written). */
#define MURK_PRINTED_ROWS 12
void murk_print_more(size_t n, const char *folder, const char *file);

#endif
