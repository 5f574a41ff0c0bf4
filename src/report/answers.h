/* What was asked, and the answer, as lines of the page's summary: names and
 * what is said of them (murk_page_line_begin). */
#ifndef MURK_REPORT_ANSWERS_H
#define MURK_REPORT_ANSWERS_H

#include "report/results_in.h"

#include <stdio.h>

/* What a plan is over: "light", or "targets" where these stand in place of
 * photons. */
bool murk_answer_has_targets(const murk_yaml *plan);

/* plan.json (is_made), or coverage.json of sensors that were given. */
void murk_answer_plan(FILE *to, const murk_yaml *plan, bool is_made);

void murk_answer_study(FILE *to, const murk_yaml *study);
void murk_answer_fit(FILE *to, const murk_yaml *fit);
void murk_answer_light(FILE *to, const murk_yaml *ledger);

#endif
