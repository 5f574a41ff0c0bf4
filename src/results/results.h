/* Result files: staged, then shown all together. All files are first written
 * and flushed in a hidden folder (base/staging.h). Only when all of them are on
 * the disk are they renamed, the main JSON last, so a full disk leaves the old
 * results. A run that is killed between two renames leaves files of two runs;
 * `files` in the main JSON tells them apart. Two kinds of files are not
 * replaced: those that this run has read as input (base/inputs.h); and, without
 * --force, those that are not murk's (results/ownership.h). A result that would
 * replace one of these is refused, except that an input which already has the
 * bytes of the result stays in place as that result. */
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
    char *staged; /* path in the hidden folder; NULL once the file is in its
                     place */
    char sum[65]; /* SHA-256 of the content, in hex */
} murk_result;

typedef struct murk_results {
    const char *folder; /* NULL: nothing is written */
    murk_result *file;  /* [n]; in the order added */
    size_t n;
    bool is_new; /* the folder did not exist before murk_results_begin() */
    bool force;  /* files that are not murk's are replaced, too */
    murk_staging staging;
    murk_owned owned;
    murk_error refused; /* why the first file that may not be replaced was
                           refused; no code: none was */
} murk_results;

/* Makes the folder, checks that it can be written to, and removes the staged
 * files that killed runs left in it, except those of a run that was killed
 * while it moved its files into place. To be called before any long work.
 * murk_results_end() removes a new folder again if it is empty. folder NULL:
 * all functions below do nothing and return MURK_OK; so they do in other ranks
 * than rank 0 (base/ranks.h). `folder` is borrowed.
 * Fails with MURK_RUN_FAILED or MURK_NO_MEMORY. */
murk_status murk_results_begin(murk_results *results, const char *folder,
                               bool force, murk_error *err);

/* Checks, before any long work, whether a file that will be added later may
 * replace the file of this name in the folder. Fails with MURK_BAD_VALUE if the
 * file there is an input of the run or, without --force, is not murk's, and
 * with MURK_RUN_FAILED if it is not a regular file. text: the content that the
 * new file will have; an input with the same content is accepted. text NULL:
 * the content is not known yet. An input light.murk is always accepted here. To
 * be called after all input is read. */
murk_status murk_results_expect(murk_results *results, const char *name,
                                const char *text, murk_error *err);

/* Writes one whole file to `path`, or fails and leaves none there. */
typedef murk_status (*murk_results_writer)(const char *path,
                                           const void *context,
                                           murk_error *err);

/* Stages a file `name` of the folder, which write() writes. On failure it is as
 * if the file had not been added, except that murk_results_show() fails after a
 * refusal. Fails as write() or murk_results_expect() does, with MURK_RUN_FAILED
 * if a staged file has this name, or with MURK_NO_MEMORY. A file that has been
 * shown may be added again; if write() then fails, the shown file stays in the
 * folder, but no longer in the list. */
murk_status murk_results_add(murk_results *results, const char *name,
                             murk_results_writer write, const void *context,
                             murk_error *err);
/* murk_results_add() for content that write() writes to a stream. write() need
 * not check the stream: failures of the stream are noticed when the file is
 * committed. */
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

/* Adds to the list, and so to `files` of the main JSON, a file that is in the
 * folder already. Fails if it cannot be read, or with MURK_NO_MEMORY. */
murk_status murk_results_note(murk_results *results, const char *name,
                              murk_error *err);

/* Moves all staged files into place, in the order added, so the main JSON
 * should be added last. If any file was refused because the one that is there
 * may not be replaced, moves none and fails with that error. If moving fails
 * (MURK_RUN_FAILED), earlier files are in place. More files may be added and
 * shown afterwards. */
murk_status murk_results_show(murk_results *results, murk_error *err);
void murk_results_end(murk_results *results); /* removes files not shown, sets
                                                 zeros */

#endif
