/* The JSON of a command: what every one begins and ends with, and values that
 * many of them hold. Out of memory ends in a NULL text. */
#ifndef MURK_RESULTS_JSON_H
#define MURK_RESULTS_JSON_H

#include "scene/scene.h"

#include <cjson/cJSON.h>

/* {"murk": .., "scene": .., "scene_sha256": .., "seed": ..} */
cJSON *murk_json_begin(const murk_scene_desc *scene);

/* {"murk": ..} alone. */
cJSON *murk_json_begin_murk(void);

typedef struct murk_run_facts {
    const char *command; /* as options->typed; NULL: not known */
    unsigned threads;
    double load_s, trace_s, map_s, sense_s, place_s, total_s;
} murk_run_facts;

/* SHA-256 of a printed JSON up to its line of `run`: run.checksum. */
void murk_json_sum(char out[65], const char *text);

/* Adds "run", which alone may differ between two runs (to what is there under
 * that name), and returns the text:
 * indented, ending with a newline; the caller frees it with cJSON_free().
 * Deletes root. */
char *murk_json_end(cJSON *root, const murk_run_facts *run);

void murk_json_number(cJSON *object, const char *key, double value);
void murk_json_vector(cJSON *object, const char *key, murk_vec3 v);
/* {min_m, max_m}; null for an empty box. */
void murk_json_box(cJSON *object, const char *key, const murk_box *box);
/* A list, band by band. */
void murk_json_spectrum(cJSON *object, const char *key,
                        const murk_spectrum *spectrum, int bands);

#endif
