/* Stages the files of a run, refuses a file if the one in its place may not be
 * replaced, and moves the staged files into place after all of them are
 * complete. */
#include "results/results.h"

#include "base/file.h"
#include "base/inputs.h"
#include "base/ranks.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

murk_status murk_results_begin(murk_results *results, const char *folder,
                               bool force, murk_error *err)
{
    struct stat known;
    if (murk_ranks_number() > 0) {
        folder = NULL; /* rank 0 writes */
    }
    *results = (murk_results){.folder = folder,
                              .force = force,
                              .is_new = folder && stat(folder, &known) != 0};
    if (!folder) {
        return MURK_OK;
    }
    const murk_status status = murk_folder_make(folder, err);
    if (!status) {
        murk_staging_clean(folder, false);
    }
    return status;
}

/* ---- what may be replaced ---- */

/* The index in file[] of the file with this path; results->n: there is none. */
static size_t find(const murk_results *results, const char *path)
{
    size_t i = 0;
    while (i < results->n && strcmp(results->file[i].path, path) != 0) {
        ++i;
    }
    return i;
}

/* True if this run has moved a file to this path, or listed a file that was
 * there (murk_results_note()). */
static bool is_shown(const murk_results *results, const char *path)
{
    const size_t i = find(results, path);
    return i < results->n && !results->file[i].staged;
}

/* Checks whether the file at the path, if there is one, may be replaced. Inputs
 * pass here; check_input() judges them when the new content is known. */
static murk_status check_owner(murk_results *results, const char *path,
                               const char *name, murk_error *err)
{
    struct stat known;
    if (lstat(path, &known) != 0) {
        return MURK_OK;
    }
    if (stat(path, &known) == 0 && !S_ISREG(known.st_mode)) {
        return murk_fail(err, MURK_RUN_FAILED, path,
                         "cannot write: not a regular file");
    }
    if (results->force || murk_inputs_has(path) || is_shown(results, path) ||
        murk_owned_has(&results->owned, results->folder, name)) {
        return MURK_OK;
    }
    (void)murk_file_not_ours(path, &results->refused);
    return murk_file_not_ours(path, err);
}

/* True if the file has this SHA-256. An input that has it stays as it is. */
static bool is_same(const char *path, const char *sum)
{
    char there[65];
    return !murk_file_sha256(path, there, NULL) && strcmp(there, sum) == 0;
}

static murk_status check_input(murk_results *results, size_t i, murk_error *err)
{
    const char *path = results->file[i].path;
    if (!murk_inputs_has(path) || is_same(path, results->file[i].sum)) {
        return MURK_OK;
    }
    (void)murk_file_check_input(path, &results->refused);
    return murk_file_check_input(path, err);
}

murk_status murk_results_expect(murk_results *results, const char *name,
                                const char *text, murk_error *err)
{
    if (!results->folder) {
        return MURK_OK;
    }
    char *path = murk_path_join(results->folder, name);
    if (!path) {
        return murk_no_memory(err, name, "to write it");
    }
    murk_status status = check_owner(results, path, name, err);
    if (!status && murk_inputs_has(path) && strcmp(name, MURK_MAP_FILE_NAME)) {
        char sum[65];
        murk_sha256_hex(text ? text : "", text ? strlen(text) : 0, sum);
        status =
            is_same(path, sum) ? MURK_OK : murk_file_check_input(path, err);
    }
    free(path);
    return status;
}

/* ---- adding ---- */

/* Fails if the file at the path may not be replaced (check_owner()), or if a
 * staged file of this run has the same path. If this run has already moved a
 * file of that path into place, removes the entry of that file from the list,
 * because the file will be written again. */
static murk_status check_name(murk_results *results, const char *path,
                              const char *name, murk_error *err)
{
    const murk_status status = check_owner(results, path, name, err);
    const size_t i = find(results, path);
    if (status || i == results->n) {
        return status;
    }
    if (!is_shown(results, path)) {
        return murk_fail(err, MURK_RUN_FAILED, path,
                         "cannot write: two results have this name");
    }
    free(results->file[i].path);
    memmove(&results->file[i], &results->file[i + 1],
            (--results->n - i) * sizeof *results->file);
    return MURK_OK;
}

/* Makes space in the list of files for one more. */
static bool grow(murk_results *results)
{
    murk_result *grown =
        realloc(results->file, (results->n + 1) * sizeof *grown);
    if (!grown) {
        return false;
    }
    results->file = grown;
    return true;
}

/* Appends an entry for a file, with its path and its path in the hidden
 * folder. */
static murk_status stage_name(murk_results *results, const char *name,
                              murk_error *err)
{
    murk_status status = MURK_OK;
    /* The first file makes the folder for staged files. */
    if (!results->staging.folder) {
        status = murk_staging_begin(&results->staging, results->folder, err);
    }
    murk_result file = {0};
    if (!status) {
        file.path = murk_path_join(results->folder, name);
        file.staged = murk_path_join(results->staging.folder, name);
    }
    if (!status && (!file.path || !file.staged || !grow(results))) {
        status = murk_no_memory(err, name, "to write it");
    }
    if (!status) {
        status = check_name(results, file.path, name, err);
    }
    if (status) {
        free(file.path);
        free(file.staged);
        return status;
    }
    results->file[results->n++] = file;
    return MURK_OK;
}

murk_status murk_results_add(murk_results *results, const char *name,
                             murk_results_writer write, const void *context,
                             murk_error *err)
{
    if (!results->folder) {
        return MURK_OK;
    }
    murk_error why = {0};
    murk_status status = stage_name(results, name, err);
    if (status) {
        return status;
    }
    const size_t i = results->n - 1;
    status = write(results->file[i].staged, context, &why);
    if (!status) {
        status = murk_file_sha256(results->file[i].staged, results->file[i].sum,
                                  &why);
    }
    if (status) { /* the message names the final path instead of the staged
                     one */
        status = murk_fail(err, status, results->file[i].path, "%s", why.text);
    } else {
        status = check_input(results, i, err);
    }
    if (status) { /* as if the file had not been asked for */
        --results->n;
        unlink(results->file[i].staged);
        free(results->file[i].staged);
        free(results->file[i].path);
    }
    return status;
}

typedef struct stream {
    murk_results_stream write;
    const void *context;
} stream;

static murk_status write_stream(const char *path, const void *context,
                                murk_error *err)
{
    const stream *s = context;
    murk_file *file = NULL;
    murk_status status = murk_file_create(&file, path, err);
    if (!status) {
        status = s->write(murk_file_stream(file), s->context, err);
    }
    if (!status) {
        status = murk_file_commit(&file, err);
    }
    murk_file_discard(file);
    return status;
}

murk_status murk_results_add_stream(murk_results *results, const char *name,
                                    murk_results_stream write,
                                    const void *context, murk_error *err)
{
    const stream s = {write, context};
    return murk_results_add(results, name, write_stream, &s, err);
}

static murk_status write_text(const char *path, const void *text,
                              murk_error *err)
{
    return murk_file_write(path, text, strlen(text), err);
}

murk_status murk_results_add_text(murk_results *results, const char *name,
                                  const char *text, murk_error *err)
{
    if (results->folder && !text) {
        return murk_no_memory(err, name, "to write it");
    }
    return murk_results_add(results, name, write_text, text, err);
}

typedef struct light_parts {
    const murk_traced *traced;
    const murk_stage *stage;
} light_parts;

static murk_status write_light(const char *path, const void *context,
                               murk_error *err)
{
    const light_parts *parts = context;
    return murk_lightmap_save(parts->traced, parts->stage, path, err);
}

murk_status murk_results_add_light(murk_results *results, const char *name,
                                   const murk_traced *traced,
                                   const murk_stage *stage, murk_error *err)
{
    const light_parts parts = {traced, stage};
    return murk_results_add(results, name, write_light, &parts, err);
}

murk_status murk_results_note(murk_results *results, const char *name,
                              murk_error *err)
{
    if (!results->folder) {
        return MURK_OK;
    }
    murk_result file = {.path = murk_path_join(results->folder, name)};
    murk_status status = MURK_OK;
    if (!file.path || !grow(results)) {
        status = murk_no_memory(err, name, "to list it");
    }
    if (!status) {
        status = murk_file_sha256(file.path, file.sum, err);
    }
    if (status) {
        free(file.path);
        return status;
    }
    results->file[results->n++] = file;
    return MURK_OK;
}

/* ---- showing ---- */

/* Fails if a file of this run was refused before, or if a staged file would
 * replace a file that this run has read. The inputs are checked again here,
 * because the run may have read more files since the staged files were added.
 */
static murk_status check_all(murk_results *results, murk_error *err)
{
    for (size_t i = 0; i < results->n && !results->refused.code; ++i) {
        if (results->file[i].staged) {
            (void)check_input(results, i, &results->refused);
        }
    }
    const murk_error *refused = &results->refused;
    return refused->code ? murk_fail(err, refused->code, refused->where, "%s",
                                     refused->text)
                         : MURK_OK;
}

murk_status murk_results_show(murk_results *results, murk_error *err)
{
    if (!results->folder || !results->staging.folder) {
        return MURK_OK;
    }
    const murk_status status = check_all(results, err);
    if (status) {
        return status;
    }
    murk_staging_moving(&results->staging);
    for (size_t i = 0; i < results->n; ++i) {
        if (!results->file[i].staged) {
            continue; /* shown before */
        }
        if (murk_inputs_has(results->file[i].path)) {
            (void)unlink(results->file[i].staged); /* it has the same bytes and
                                                      stays */
        } else if (rename(results->file[i].staged, results->file[i].path) !=
                   0) {
            return murk_fail(err, MURK_RUN_FAILED, results->file[i].path,
                             "cannot write: %s", strerror(errno));
        }
        free(results->file[i].staged);
        results->file[i].staged = NULL;
    }
    murk_folder_sync(results->folder);
    murk_staging_end(&results->staging);
    murk_staging_clean(results->folder, true);
    return MURK_OK;
}

void murk_results_end(murk_results *results)
{
    murk_staging_end(&results->staging);
    for (size_t i = 0; i < results->n; ++i) {
        free(results->file[i].staged);
        free(results->file[i].path);
    }
    if (results->is_new) {
        (void)rmdir(results->folder); /* fails, as it should, if the folder is
                                         not empty */
    }
    free(results->file);
    murk_owned_release(&results->owned);
    *results = (murk_results){0};
}
