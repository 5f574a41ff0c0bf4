/* The JSON of a command: what every one begins and ends with, and values that
 * many of them hold. Out of memory ends in a NULL text. */
#ifndef MURK_RESULTS_JSON_H
#define MURK_RESULTS_JSON_H

#include "results/results.h"

#include <cjson/cJSON.h>

/* {"murk": .., "scene": .., "scene_sha256": .., "seed": ..} */
cJSON *murk_json_begin(const murk_scene_desc *scene);

/* {"murk": ..} alone. */
cJSON *murk_json_begin_murk(void);

typedef struct murk_run_facts {
    const char *command; /* as options->typed; NULL: not known */
    unsigned threads;
    double load_s, trace_s, map_s, sense_s, place_s, total_s;
    cJSON *summary; /* its lines (results/summary.h), borrowed, or NULL */
} murk_run_facts;

/* Adds "run", which alone may differ between two runs (to what is there under
 * that name), and returns the text:
 * indented, ending with a newline; the caller frees it with cJSON_free().
 * Deletes root. */
char *murk_json_end(cJSON *root, const murk_run_facts *run);

/* Adds "identity", and "files" (where it is not there) with what was added so
 * far but for JSONs, whose `run` differs from run to run. Under run.earlier
 * come files of earlier runs that lie in the folder and that no other JSON
 * there will list once `name` (the main JSON's) has been replaced. */
void murk_json_identify(cJSON *root, const char *identity,
                        murk_results *results, const char *name);

/* Adds a file that lies under `path` to "files", by its name without folder;
 * the empty "files" where path is NULL. */
void murk_json_file(cJSON *root, const char *path);

void murk_json_number(cJSON *object, const char *key, double value);
void murk_json_vector(cJSON *object, const char *key, murk_vec3 v);
/* {min_m, max_m}; null for an empty box. */
void murk_json_box(cJSON *object, const char *key, const murk_box *box);
void murk_json_numbers(cJSON *object, const char *key, const double *value,
                       int n);
/* Adds an object at the end of a list. */
cJSON *murk_json_item(cJSON *list);

#endif
