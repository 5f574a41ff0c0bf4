/* The parts of the page that `murk report` makes of a result folder: each
 * writes its sections, or nothing where the folder has no such results. */
#ifndef MURK_REPORT_SECTIONS_H
#define MURK_REPORT_SECTIONS_H

#include "report/fields.h"
#include "report/results_in.h"

#include <stdio.h>

/* What was asked, the answer, what it took, and what the words mean. */
void murk_report_summary(FILE *to, const murk_results_in *results);

/* A sensor placement, made (plan.json) or measured (coverage.json): what it
 * sees, curve and bound, in sample against held out, each sensor. */
murk_status murk_report_plan(FILE *to, const murk_results_in *results,
                             murk_error *err);

/* study.json and table.csv: a plot an output, lines with error bands. */
murk_status murk_report_study(FILE *to, const murk_results_in *results,
                              murk_error *err);

/* fit.json and fit.csv: values with intervals, residuals. */
murk_status murk_report_fit(FILE *to, const murk_results_in *results,
                            murk_error *err);

/* ledger.json: where the light went, by the scene's bands (NULL: not known).
 */
murk_status murk_report_light(FILE *to, const murk_results_in *results,
                              const murk_scene_desc *scene, murk_error *err);

/* tallies.csv, and the fields that were read: what was counted where. */
murk_status murk_report_tallies(FILE *to, const murk_results_in *results,
                                const murk_report_fields *fields,
                                murk_error *err);

/* How it was made: the commands that make it again, version, packages, files
 * but the page, whose path is told. */
void murk_report_made(FILE *to, const murk_results_in *results,
                      const char *page);

#endif
