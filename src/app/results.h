/* Result files: staged, then shown all together.
 *
 * Everything is written and flushed in a hidden folder first (base/staging.h);
 * only when all of it is on the disk are the files renamed, the main JSON last.
 * So a full disk leaves the old results. A run that is killed between two
 * renames leaves files of two runs; `files` in the main JSON tells which.
 *
 * Nothing is written where a file is in the way that this run reads
 * (base/inputs.h), unless it has the very bytes that would be written, or one
 * that is not murk's (app/ownership.h), unless --force. */
#ifndef MURK_APP_RESULTS_H
#define MURK_APP_RESULTS_H

#include "app/options.h"
#include "app/ownership.h"
#include "base/file.h"
#include "base/staging.h"
#include "base/stats.h"
#include "study/plan.h"

#include <cjson/cJSON.h>

#define MURK_LIGHT_NAME "light.murk"
#define MURK_SCENE_NAME "scene.resolved.yaml"

typedef struct murk_result {
    char *path;
    char *staged; /* NULL once it is in its place */
    char sum[65]; /* SHA-256 */
} murk_result;

typedef struct murk_results {
    const char *folder; /* NULL: nothing is written */
    murk_result *file;  /* [n] in the order added */
    size_t n;
    bool is_new; /* the folder: made by murk_results_begin() */
    bool force;  /* replaces files that are not murk's */
    murk_staging staging;
    murk_owned owned;
    murk_error refused; /* the first file that may not be replaced */
} murk_results;

/* Makes the folder options->out, removes what killed runs left in it and sees
 * that it can be written, before any long work; murk_results_end() takes a new
 * one away again where nothing came into it. Without -o all calls below do
 * nothing. */
murk_status murk_results_begin(murk_results *results,
                               const murk_options *options, murk_error *err);

/* A file that will be added: refused now, before any long work, where it would
 * be refused then. text: what it will hold, NULL where that is not known yet.
 * Call it once all input is read. */
murk_status murk_results_expect(murk_results *results, const char *name,
                                const char *text, murk_error *err);

/* Writes one file whole, or fails with nothing there. */
typedef murk_status (*murk_results_writer)(const char *path,
                                           const void *context,
                                           murk_error *err);

/* One more file of the folder, staged; where that fails, as if it had not been
 * asked for. A file that is shown already may be added anew. */
murk_status murk_results_add(murk_results *results, const char *name,
                             murk_results_writer write, const void *context,
                             murk_error *err);
murk_status murk_results_add_text(murk_results *results, const char *name,
                                  const char *text, murk_error *err);
murk_status murk_results_add_light(murk_results *results, const char *name,
                                   const murk_traced *traced,
                                   const murk_stage *stage, murk_error *err);

/* A file that is in its place without having been added: listed in `files`. */
murk_status murk_results_note(murk_results *results, const char *name,
                              murk_error *err);

/* Puts all in place, in the order added: add the main JSON last. Where one
 * could not be added because it may not be replaced, nothing is put in place.
 * More may be added and shown afterwards. */
murk_status murk_results_show(murk_results *results, murk_error *err);
void murk_results_end(murk_results *results); /* removes what is not shown */

/* ---- JSON that all commands share; out of memory ends in a NULL text ---- */

/* {"murk": .., "scene": .., "scene_sha256": .., "seed": ..} */
cJSON *murk_json_begin(const murk_scene *scene);

/* {"murk": ..} alone. */
cJSON *murk_json_begin_murk(void);

typedef struct murk_run_facts {
    const char *command; /* as options->typed; NULL: not known */
    unsigned threads;
    double load_s, trace_s, map_s, sense_s, place_s, total_s;
} murk_run_facts;

/* Adds "identity", and "files" (where it is not there) with what was added so
 * far but for JSONs, whose `run` differs from run to run. Under run.earlier
 * come files of earlier runs that lie in the folder and that no other JSON
 * there will list once `name` (the main JSON's) has been replaced. */
void murk_json_identify(cJSON *root, const char *identity,
                        murk_results *results, const char *name);

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

/* ledger.json's own fields. */
void murk_json_ledger(cJSON *object, const murk_traced *traced,
                      const murk_stage *stage);

/* Watts of one ledger column, over all channels. */
double murk_ledger_watts(const murk_traced *traced, const murk_tally *column);

#endif
