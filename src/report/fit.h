/* Parts of the report's section of a calibration: tables of fit.json. Each
 * writes nothing where there is nothing of it. */
#ifndef MURK_REPORT_FIT_H
#define MURK_REPORT_FIT_H

#include "report/results_in.h"

#include <stdio.h>

/* The value of one of fit.json's parameters: with its standard error where the
 * data determine it, else to two digits with its status in words. */
void murk_report_fit_value(FILE *to, const murk_yaml *parameter);

/* The correlation matrix, shaded. */
void murk_report_correlations(FILE *to, const murk_yaml *fit);

/* Which combinations of the values the readings tell, and how well. */
void murk_report_directions(FILE *to, const murk_yaml *fit);

/* Where each search began and ended. */
void murk_report_starts(FILE *to, const murk_yaml *fit);

/* Which readings would tell most. */
void murk_report_next(FILE *to, const murk_yaml *fit);

#endif
