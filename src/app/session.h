/* What every command does first: scene read, world built, light traced or
 * loaded. */
#ifndef MURK_APP_SESSION_H
#define MURK_APP_SESSION_H

#include "app/options.h"
#include "app/results.h"
#include "plan/plan.h"

typedef struct murk_session {
    const murk_options *options;
    murk_scene_desc *scene;
    murk_stage *stage;
    murk_traced *traced; /* NULL before murk_session_light() */
    murk_results results;
    murk_run_facts run;
    char identity[65]; /* of the results; "" before the scene is read */
    double begun_s;
} murk_session;

/* Reads and builds; makes the result folder. End it also after a failure.
 * read: the same without building, for who has other worlds to build; scene:
 * nor a folder yet, for who has more input to judge. */
murk_status murk_session_begin(murk_session *session,
                               const murk_options *options, murk_error *err);
murk_status murk_session_scene(murk_session *session,
                               const murk_options *options, murk_error *err);
murk_status murk_session_read(murk_session *session,
                              const murk_options *options, murk_error *err);
murk_status murk_session_build(murk_session *session, murk_error *err);
murk_status murk_session_light(murk_session *session, murk_error *err);
void murk_session_end(murk_session *session);

/* Refuse at once what would be refused when it is added: the names of a list
 * that NULL ends, the resolved scene and what is exported; and the light with
 * its ledger and tallies. Call them once all input is read. */
murk_status murk_session_expect(murk_session *session, const char *const *names,
                                murk_error *err);
murk_status murk_session_expect_light(murk_session *session, murk_error *err);

/* Adds light.murk and scene.resolved.yaml, the scene as resolved. */
murk_status murk_session_add_light(murk_session *session, murk_error *err);

/* The ledger as JSON, yet without `run`; and added as ledger.json. */
cJSON *murk_session_ledger(const murk_session *session);
murk_status murk_session_add_ledger(murk_session *session, murk_error *err);

/* Ends the JSON with `run`, adds it under `name` as the main one, shows all
 * files, and prints it with --format json. Deletes root. */
murk_status murk_session_finish(murk_session *session, const char *name,
                                cJSON *root, murk_error *err);

/* Shows all files with this as the main JSON, as finishing would, and prints
 * nothing: for what is not to be lost while more is worked on. Deletes root. */
murk_status murk_session_keep(murk_session *session, const char *name,
                              cJSON *root, murk_error *err);

/* True where the summary is to be printed. */
bool murk_session_speaks(const murk_session *session);

/* Summary lines that several commands print. */
void murk_print_light(const murk_session *session);
void murk_print_files(const murk_session *session);

#endif
