/* The tables of the report's section of a study. */
#ifndef MURK_REPORT_STUDY_H
#define MURK_REPORT_STUDY_H

#include "report/results_in.h"

#include <stdio.h>

/* Whether an output's column of table.csv, with its errors behind it, begins
 * here. */
bool murk_study_is_output(const murk_table *table, size_t column);

/* "density_475nm": of one band only. */
bool murk_study_is_of_band(const char *output);

/* Coverages are shares, which are shown in per cent. */
bool murk_study_is_share(const char *output);

/* The rows with their axes, which are the first columns, and the outputs of
 * bands or the others: some to a table, so that each fits a page. False when
 * out of memory. */
bool murk_report_study_rows(FILE *to, const murk_table *table, size_t axes,
                            bool of_bands);

/* Rows that failed, and plans for all rows. */
void murk_report_study_failed(FILE *to, const murk_yaml *study);
void murk_report_study_plans(FILE *to, const murk_yaml *study);

#endif
