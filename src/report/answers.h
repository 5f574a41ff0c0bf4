/* What was asked, and the answer, as lines of the page's summary: names and
 * what is said of them. */
#ifndef MURK_REPORT_ANSWERS_H
#define MURK_REPORT_ANSWERS_H

#include "report/results_in.h"

#include <stdio.h>

/* Writes words, which are markup of the page, with values of the results in
 * place of {path} (a number), {path*} (whole millions), {path$} (a text),
 * {path%} (a share in per cent), {path~} (a share with its standard error,
 * which lies under path_standard_error), {path#one|more} (a number of things)
 * and {path[one|more} (of a list, how many things it has). */
void murk_report_say(FILE *to, const murk_yaml *root, const char *words);

/* plan.json (is_made), or coverage.json of sensors that were given. */
void murk_answer_plan(FILE *to, const murk_yaml *plan, bool is_made);

void murk_answer_study(FILE *to, const murk_yaml *study);
void murk_answer_fit(FILE *to, const murk_yaml *fit);
void murk_answer_light(FILE *to, const murk_yaml *ledger);

#endif
