/* What a fit has found, as files: fit.json, fit.csv, calibrated.yaml; and on
 * the terminal. */
#ifndef MURK_RESULTS_FIT_H
#define MURK_RESULTS_FIT_H

#include "calibrate/proposals.h"
#include "results/fields.h"

typedef struct murk_fit_facts {
    const murk_scene_desc *scene;
    const murk_free_keys *keys;
    const murk_readings *measured;
    const murk_calibration *found;
    const murk_proposals *next; /* NULL: not asked for */
    bool only_predicts;
} murk_fit_facts;

/* Lists the fields of fit.json and predict.json, except `run`. `of` points to a
 * murk_fit_facts. */
void murk_results_list_fit(murk_results_fields *fields, const void *of);

/* Columns of fit.csv; of: the same. */
void murk_results_list_fit_row(murk_results_fields *fields, const void *of,
                               size_t i);

/* The values, as --set @FILE takes them. */
murk_status murk_add_calibrated(murk_results *results,
                                const murk_fit_facts *facts, murk_error *err);

/* True if the text of a file for --set @FILE is that of a refused fit. */
bool murk_fit_refused_values(const char *text);

/* Warns that the file holds values of a refused fit; like the refusal itself,
 * this is no matter of --quiet. */
void murk_fit_warn_refused(const char *file);

/* Prints the summary. `of` points to a murk_fit_facts. */
void murk_print_fit(const void *of);

#endif
