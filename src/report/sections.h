/* Parts of the page that `murk report` makes of a result folder: HTML, which is
 * written to a stream, and data, which the script of the page draws. */
#ifndef MURK_REPORT_SECTIONS_H
#define MURK_REPORT_SECTIONS_H

#include "report/data.h"
#include "report/results_in.h"

#include <stdio.h>

/* Largest number of files of the folder, of packages, and of ledgers of
 * conditions in the page. CSV files are cut by bytes instead (report/csv.c). */
#define MURK_REPORT_ROWS_MAX 200

/* Writes the summaries of the runs, and the meanings of words. */
void murk_report_summary(FILE *to, const murk_results_in *results);

/* Writes the CSV files as tables, which a browser shows only without scripts;
 * the script reads them there. Fails if a file that the script needs cannot be
 * read, or with MURK_NO_MEMORY. */
murk_status murk_report_csv(FILE *to, const murk_results_in *results,
                            murk_error *err);

/* Adds tallies.csv as `tallies`; nothing if there is no such file. Tallies
 * whose rows are not a full grid are left out, and those beyond a limit. Fails
 * if the file cannot be read, or with MURK_NO_MEMORY. */
murk_status murk_report_tallies(murk_data *data, const murk_results_in *results,
                                murk_error *err);

/* Writes how the results were made: the commands that make them again, versions
 * and packages, and the files of the folder except report.html and the page,
 * whose path is `page`. */
void murk_report_made(FILE *to, const murk_results_in *results,
                      const char *page);

#endif
