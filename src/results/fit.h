/* What a fit has found, as files: fit.json, fit.csv, calibrated.yaml; and on
 * the terminal. */
#ifndef MURK_RESULTS_FIT_H
#define MURK_RESULTS_FIT_H

#include "calibrate/next.h"
#include "results/results.h"

typedef struct murk_fit_facts {
    const murk_scene_desc *scene;
    const murk_free_keys *keys;
    const murk_measurements *measured;
    const murk_calibration *found;
    const murk_next *next; /* NULL: not asked for */
    bool only_predicts;
} murk_fit_facts;

/* fit.json, yet without `run`. */
cJSON *murk_fit_json(const murk_fit_facts *facts);

/* A row of the data each: what was measured, predicted, and what is left. */
murk_status murk_add_fit_csv(murk_results *results, const murk_fit_facts *facts,
                             murk_error *err);

/* The values, as --set @FILE takes them. */
murk_status murk_add_calibrated(murk_results *results,
                                const murk_fit_facts *facts, murk_error *err);

void murk_print_fit(const murk_fit_facts *facts);

#endif
