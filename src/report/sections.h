/* The parts of the page that `murk report` makes of a result folder. What
 * stands in the page as text is written here; what its script draws is added as
 * data. */
#ifndef MURK_REPORT_SECTIONS_H
#define MURK_REPORT_SECTIONS_H

#include "report/data.h"
#include "report/results_in.h"

#include <stdio.h>

/* Rows of a table that the page shows; the rest is in the files. */
#define MURK_REPORT_ROWS_MAX 200

/* The summaries of the runs, and what the words mean. */
void murk_report_summary(FILE *to, const murk_results_in *results);

/* The CSV files as tables. */
murk_status murk_report_csv(FILE *to, const murk_results_in *results,
                            murk_error *err);

/* tallies.csv as `tallies`; nothing if there is none. */
murk_status murk_report_tallies(murk_data *data, const murk_results_in *results,
                                murk_error *err);

/* How it was made: the commands that make it again, version, packages, files
 * but the page, whose path is told. */
void murk_report_made(FILE *to, const murk_results_in *results,
                      const char *page);

#endif
