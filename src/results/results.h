/* Result files: staged, then shown all together.
 *
 * Everything is written and flushed in a hidden folder first (base/staging.h);
 * only when all of it is on the disk are the files renamed, the main JSON last.
 * So a full disk leaves the old results. A run that is killed between two
 * renames leaves files of two runs; `files` in the main JSON tells which.
 *
 * Nothing is written where a file is in the way that this run reads
 * (base/inputs.h), unless it has the very bytes that would be written, or one
 * that is not murk's (results/ownership.h), unless --force. */
#ifndef MURK_RESULTS_RESULTS_H
#define MURK_RESULTS_RESULTS_H

#include "base/file.h"
#include "base/staging.h"
#include "plan/plan.h"
#include "results/ownership.h"

#define MURK_MAP_FILE_NAME "light.murk"
#define MURK_SCENE_NAME    "scene.resolved.yaml"

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

/* Makes the folder, removes what killed runs left in it and sees
 * that it can be written, before any long work; murk_results_end() takes a new
 * one away again where nothing came into it. Without a folder
 * all calls below do nothing. */
murk_status murk_results_begin(murk_results *results, const char *folder,
                               bool force, murk_error *err);

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
/* The same of what write() puts into the stream, whose failures are noticed. */
typedef murk_status (*murk_results_stream)(FILE *to, const void *context,
                                           murk_error *err);
murk_status murk_results_add_stream(murk_results *results, const char *name,
                                    murk_results_stream write,
                                    const void *context, murk_error *err);
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

#endif
