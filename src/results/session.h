/* A run whose results are written: the scene, the world, the light, the files
 * and the settings that decide about files and lines. */
#ifndef MURK_RESULTS_SESSION_H
#define MURK_RESULTS_SESSION_H

#include "plan/plan.h"
#include "results/json.h"
#include "results/ledger.h"
#include "results/results.h"
#include "results/summary.h"

/* What --export writes. */
typedef enum murk_export {
    MURK_EXPORT_MATRIX = 1,
    MURK_EXPORT_OR_LIBRARY = 2,
    MURK_EXPORT_LP = 4,
    MURK_EXPORT_FIELDS = 8,
    MURK_EXPORT_PHOTONS = 16,
    MURK_EXPORT_SURFACES = 32
} murk_export;

typedef struct murk_session_settings {
    const char *folder; /* of the results; NULL: nothing is written */
    bool force;         /* replaces files that are not murk's */
    unsigned threads;
    unsigned exports; /* murk_export bits */
    const char
        *voxel; /* edge of exported voxels and pieces as typed, or NULL */
    const char *light; /* the file that the light is read from, or NULL */
    bool prints_json, is_quiet;
} murk_session_settings;

typedef struct murk_session {
    murk_session_settings settings;
    murk_scene_desc *scene;
    murk_stage *stage;
    murk_traced *traced; /* NULL before the light is there */
    murk_results results;
    murk_run_facts run;
    char identity[65]; /* of the results; "" before the scene is read */
    double begun_s;
} murk_session;

void murk_session_end(murk_session *session);

/* Refuse at once what would be refused when it is added: the names of a list
 * that NULL ends, the resolved scene and what is exported; and the light with
 * its ledger and tallies. Call them once all input is read. */
murk_status murk_session_expect(murk_session *session, const char *const *names,
                                murk_error *err);
murk_status murk_session_expect_light(murk_session *session, murk_error *err);

/* Adds scene.resolved.yaml, the scene as resolved, if there is one; and with it
 * light.murk. */
murk_status murk_session_add_scene(murk_session *session, murk_error *err);
murk_status murk_session_add_light(murk_session *session, murk_error *err);

/* Adds a ledger with the session's `run`, but not as the main JSON. */
murk_status murk_session_add_ledger(murk_session *session, const char *name,
                                    const murk_ledger_results *ledger,
                                    murk_error *err);

/* Ends the JSON with `run`, adds it under `name` as the main one, and shows all
 * files. Then prints the JSON with --format json, else the summary of the
 * results, which `print` prints of `of` and which `run` holds as well; print
 * NULL: there is none. Deletes root. */
murk_status murk_session_finish(murk_session *session, const char *name,
                                cJSON *root, murk_print_results *print,
                                const void *of, murk_error *err);

/* Shows all files with this as the main JSON, as finishing would, and prints
 * nothing: for what is not to be lost while more is worked on. Deletes root. */
murk_status murk_session_keep(murk_session *session, const char *name,
                              cJSON *root, murk_print_results *print,
                              const void *of, murk_error *err);

/* True where the summary is to be printed. */
bool murk_session_speaks(const murk_session *session);

/* The lines of the light, which several summaries have. */
void murk_print_light(const murk_session *session);

/* Prints the lines that follow a summary and are no part of the results: times,
 * memory and files; of times also a part of the command's own, or NULL. Nothing
 * where no summary is printed. */
void murk_print_run(const murk_session *session, const char *other,
                    double other_s);

#endif
