/* A run of a command: the scene, the world, the light, the result files, and
 * the settings for files and printed lines. */
#ifndef MURK_RESULTS_SESSION_H
#define MURK_RESULTS_SESSION_H

#include "base/export_kind.h"
#include "plan/plan.h"
#include "results/json.h"
#include "results/ledger.h"
#include "results/results.h"
#include "results/summary.h"

typedef struct murk_session_settings {
    const char *folder; /* of the results; NULL: nothing is written */
    bool force;         /* replaces files of the folder that are not murk's,
                           too */
    unsigned threads;
    unsigned exports;      /* murk_export bits */
    bool leaves_out_light; /* light.murk is not written */
    const char *own_input; /* a file of the folder that murk has written before
                            * and read, and that belongs to the results of a
                            * plan; NULL: none */
    const char *voxel; /* edge of exported voxels and pieces, as typed; NULL:
                          not given */
    const char *light; /* file that the light is read from; NULL: it is
                          traced */
} murk_session_settings;

typedef struct murk_session {
    murk_session_settings settings;
    murk_scene_desc *scene;
    murk_stage *stage;
    murk_traced *traced; /* NULL until there is light */
    murk_results results;
    murk_run_facts run;
    char identity[65]; /* of the results; "" before the scene is read */
    double begun_s;
    char *document; /* text of the main JSON, for cJSON_free(); NULL before it
                       is made */
} murk_session;

void murk_session_end(murk_session *session);

/* Reads the light of the stage from the file settings.light. Adds the time to
 * run.load_s. Warns if the file is of another run than the results beside it.
 * Fails as murk_lightmap_load(). */
murk_status murk_session_read_light(murk_session *session, murk_error *err);

/* Fail at once if files could not replace those that are there
 * (murk_results_expect()): the first for the named files (a list that ends with
 * NULL), the resolved scene and the files of --export (of these only if the
 * file there may not be replaced, MURK_BAD_VALUE); the second for the light
 * with its ledger and tallies. Call them after all input is read. */
murk_status murk_session_expect(murk_session *session, const char *const *names,
                                murk_error *err);
murk_status murk_session_expect_light(murk_session *session, murk_error *err);

/* The first adds scene.resolved.yaml, the resolved scene, if there is a scene;
 * the second adds light.murk, then the same. */
murk_status murk_session_add_scene(murk_session *session, murk_error *err);
murk_status murk_session_add_light(murk_session *session, murk_error *err);

/* Adds the JSON of a ledger with identity and `run`, but without `files`. */
murk_status murk_session_add_ledger(murk_session *session, const char *name,
                                    const murk_ledger_results *ledger,
                                    murk_error *err);

/* Completes the JSON with identity, `files` and `run`, adds it as the main JSON
 * `name` (NULL: it is not added), and moves all files into place
 * (murk_results_show()). print(of) prints the summary, whose lines become
 * run.summary and are not shown; print NULL: there is none. session->document
 * becomes the text of the JSON, also after a failure to write it. Deletes root
 * in any case. */
murk_status murk_session_finish(murk_session *session, const char *name,
                                cJSON *root, murk_print_results *print,
                                const void *of, murk_error *err);

/* Prints the lines about the light, which several summaries have. */
void murk_print_light(const murk_session *session);

#endif
