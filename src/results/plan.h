/* The parts of plan.json that need no scene, and the words of methods. */
#ifndef MURK_RESULTS_PLAN_H
#define MURK_RESULTS_PLAN_H

#include "placement/place.h"

#include <cjson/cJSON.h>

extern const char *const murk_method_names[]; /* by murk_place_method */
extern const size_t murk_method_names_count;

/* part / whole; NaN where there is nothing. */
double murk_share(uint64_t part, uint64_t whole);

/* "bound" and "curve". */
void murk_json_bound(cJSON *root, const murk_place_result *place);

/* "cut_by" of "placement". */
void murk_json_cut(cJSON *object, const murk_place_result *place);

/* The summary's line "bound". */
void murk_print_bound(const murk_place_result *place, bool has_budget,
                      const char *sample);

#endif
