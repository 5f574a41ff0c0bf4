/* The JSON of a command: its first and last keys, and values that the JSON of
 * many commands has. Without memory, values may be missing, and murk_json_end()
 * returns NULL. */
#ifndef MURK_RESULTS_JSON_H
#define MURK_RESULTS_JSON_H

#include "results/results.h"

#include <cjson/cJSON.h>

/* Returns {"murk": .., "scene": .., "scene_sha256": .., "seed": ..}, which the
 * caller deletes, or hands to murk_json_end(). */
cJSON *murk_json_begin(const murk_scene_desc *scene);

/* Returns {"murk": ..} alone. */
cJSON *murk_json_begin_murk(void);

typedef struct murk_run_facts {
    const char *command; /* the command line as typed; NULL: not known */
    unsigned threads;
    double load_s, trace_s, map_s, sense_s, place_s, total_s;
    uint64_t reused_photons, reused_sightlines; /* taken over from the step
                                                 * before (murk follow) */
    bool has_watched;
    murk_box watched; /* box whose cells on the paths of photons are noted */
    cJSON *summary; /* lines of the summary (results/summary.h), borrowed; NULL:
                       none */
} murk_run_facts;

/* Adds the facts to "run", which is created if it is not there: the only part
 * that may differ between two runs with the same identity. Returns the JSON as
 * text, indented and ending with a newline, which the caller frees with
 * cJSON_free(); NULL when out of memory. Deletes root in any case. */
char *murk_json_end(cJSON *root, const murk_run_facts *run);

/* Replaces the 64 digits of run.checksum in the text of a JSON by the checksum
 * of that text. */
void murk_json_put_sum(char *text);

/* Adds "identity". Unless results is NULL or "files" is there, adds "files":
 * the files added so far with their SHA-256, except JSON files, whose `run`
 * differs from run to run. If `name` is given, the name of the main JSON
 * (results/ownership.h), also adds under run.earlier those files of earlier
 * runs that are in the folder and that no JSON there would list any more when
 * `name` is replaced. */
void murk_json_identify(cJSON *root, const char *identity,
                        murk_results *results, const char *name);

/* Adds the file at `path` to "files" with its SHA-256, under its name without
 * folder; nothing if it cannot be read. Creates "files" if it is not there,
 * also if path is NULL. */
void murk_json_file(cJSON *root, const char *path);

void murk_json_number(cJSON *object, const char *key, double value);
void murk_json_vector(cJSON *object, const char *key, murk_vec3 v);
/* Adds {min_m, max_m}; null for an empty box (min.x above max.x). */
void murk_json_box(cJSON *object, const char *key, const murk_box *box);
void murk_json_numbers(cJSON *object, const char *key, const double *value,
                       int n);
/* Appends an empty object to a list and returns it. */
cJSON *murk_json_item(cJSON *list);

#endif
