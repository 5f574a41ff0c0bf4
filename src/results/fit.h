/* The result of a fit or a prediction: the fields of fit.json or predict.json,
 * the columns of fit.csv, and the summary; for a fit also the file
 * calibrated.yaml. */
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

/* Lists the fields of fit.json and predict.json, except `identity`, `files` and
 * `run`. `of` points to a murk_fit_facts. */
void murk_results_list_fit(murk_results_fields *fields, const void *of);

/* Lists the columns of fit.csv. `of` points to a murk_fit_facts; i: index of
 * the reading among the rows of the data. */
void murk_results_list_fit_row(murk_results_fields *fields, const void *of,
                               size_t i);

/* Adds calibrated.yaml: the found values, in the form that --set @FILE
 * reads. */
murk_status murk_add_calibrated(murk_results *results,
                                const murk_fit_facts *facts, murk_error *err);

/* True if the text is that of a calibrated.yaml whose fit rejected its
 * model. */
bool murk_fit_refused_values(const char *text);

/* The warning about values of a refused fit. */
#define MURK_REFUSED_VALUES \
    "of a fit whose model the data refuse, so its values are not to be used"

/* Prints the summary of a fit. `of` points to a murk_fit_facts. */
void murk_print_fit(const void *of);

#endif
