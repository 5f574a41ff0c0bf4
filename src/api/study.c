/* Studies: reads a study file, runs its rows, each group of rows
 * (cases/sweep.h) in the process that `imports` of the context chooses, and
 * holds the values of all rows. */
#include "api/log_once.h"
#include "api/save.h"

#include "base/log.h"
#include "base/progress.h"
#include "cases/sweep.h"
#include "cases/sweep_store.h"
#include "results/identity.h"
#include "results/study.h"
#include "results/study_print.h"
#include "results/version.h"
#include "scene/override.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct murk_study {
    murk_context *context;
    char *folder; /* of the rows; NULL: none */
    size_t n;
    murk_override *set; /* [n] keys of the caller */
    size_t parts;
    char **part; /* [parts] folders of parts */
    murk_study_file *file;
    murk_sweep *sweep;
    murk_session session; /* its scene is the base scene; NULL if read_base()
                             could not read it */
    char *seen;           /* notes that were given */
    bool is_interrupted;
    murk_fields fields, saved;
};

/* ---- reading ---- */

static void warn_of_failure(const murk_study *study, size_t row)
{
    char where[64];
    snprintf(where, sizeof where, "row %zu of %zu", row + 1, study->file->rows);
    if (study->sweep->row[row].found.failed[0]) {
        murk_warn(where, "failed: %s", study->sweep->row[row].found.failed);
    }
}

/* Passes the failure of a finished row to the log, and those of its notes that
 * no earlier row had (api/log_once.h). */
static void report_row(void *context, size_t row)
{
    murk_study *study = context;
    char news[MURK_ROW_TEXT_SIZE], where[64];
    warn_of_failure(study, row);
    snprintf(where, sizeof where, "row %zu of %zu", row + 1, study->file->rows);
    if (murk_log_once_news(&study->seen, study->sweep->row[row].found.note,
                           news, sizeof news)) {
        murk_note(where, "%s", news);
    }
}

/* Checks the shard and the parts of the caller, and copies the paths of the
 * parts. */
static murk_status take_parts(murk_study *study,
                              const murk_study_options *options,
                              murk_error *err)
{
    const uint32_t number = options->shard_number, count = options->shard_count;
    if (count > MURK_SHARDS_MAX || (count == 0) != (number == 0) ||
        number > count) {
        return murk_fail(err, MURK_BAD_VALUE, "options->shard_number",
                         "%u of %u, must be 1 of 1 to %d of %d", number, count,
                         MURK_SHARDS_MAX, MURK_SHARDS_MAX);
    }
    if (count > 0 && options->parts > 0) {
        return murk_fail(err, MURK_BAD_VALUE, "options->part",
                         "a part is not put together from parts");
    }
    /* Copy the paths. */
    murk_status status = murk_call_check_texts(err, "options->part",
                                               options->part, options->parts);
    if (status) {
        return status;
    }
    study->part = calloc(options->parts + 1, sizeof *study->part);
    if (!study->part) {
        return murk_no_memory(err, "", "for the study");
    }
    for (size_t i = 0; i < options->parts; ++i) {
        study->part[i] = strdup(options->part[i]);
        if (!study->part[i]) {
            return murk_no_memory(err, "", "for the study");
        }
        ++study->parts;
    }
    return MURK_OK;
}

/* Copies the folder, and the keys with their values, of the caller. */
static murk_status take_options(murk_study *study,
                                const murk_study_options *options,
                                murk_error *err)
{
    murk_status status =
        murk_call_check_texts(err, "options->key", options->key, options->n);
    if (!status) {
        status = murk_call_check_texts(err, "options->value", options->value,
                                       options->n);
    }
    if (status) {
        return status;
    }
    study->folder = options->folder ? strdup(options->folder) : NULL;
    study->set = calloc(options->n + 1, sizeof *study->set);
    if (!study->set || (options->folder && !study->folder)) {
        return murk_no_memory(err, "", "for the study");
    }
    for (size_t i = 0; i < options->n && !status; ++i) {
        status = murk_override_make(&study->set[i], options->key[i],
                                    options->value[i], err);
        study->n += !status;
    }
    return status;
}

/* Reads the base scene, in which each row sets keys. study->session.scene stays
 * NULL if the base scene is not valid without the values of a row. Warnings are
 * dropped, because the notes of the rows have them. */
static void read_base(murk_study *study)
{
    murk_error why = {0};
    const bool was_silent = murk_warn_quiet(true);
    (void)murk_scene_desc_read(&study->session.scene, study->file->base,
                               study->set, study->n, &why);
    murk_warn_quiet(was_silent);
}

static murk_status read_study(murk_study *study, const char *path,
                              const murk_study_options *given, murk_error *err)
{
    murk_study_options options = {0};
    murk_status status = murk_options_copy(
        &options, sizeof options, given, "options", "murk_study_options", err);
    if (status) {
        return status;
    }
    const unsigned threads = study->context->threads;
    study->session = (murk_session){.settings.threads = threads,
                                    .run.threads = threads,
                                    .begun_s = murk_clock_s()};
    status = take_options(study, &options, err);
    if (!status) {
        status = take_parts(study, &options, err);
    }
    if (!status) {
        status = murk_study_file_read(&study->file, path, err);
    }
    const murk_sweep_desc desc = {
        .study = study->file,
        .overrides = study->set,
        .n_overrides = study->n,
        .folder = study->folder,
        .force = options.replaces,
        .version = murk_version_with_commit(),
        .threads = threads,
        .shard = {options.shard_number, options.shard_count},
        .part = (const char *const *)study->part,
        .parts = study->parts,
        .row_done = report_row,
        .context = study};
    if (!status) {
        status = murk_sweep_create(&study->sweep, &desc, err);
    }
    if (status) {
        return status;
    }
    read_base(study);
    /* Warn of the rows that have failed already, because their scenes could not
     * be read or their keys (cases/sweep_keys.h) could not be made. */
    for (size_t i = 0; i < study->file->rows; ++i) {
        if (study->sweep->row[i].is_done) {
            warn_of_failure(study, i);
        }
    }
    return MURK_OK;
}

murk_status murk_study_read(murk_study **out, murk_context *context,
                            const char *path, const murk_study_options *options,
                            murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !context || !path) {
        return murk_call_refuse(error, "out, context or path is NULL");
    }
    /* If the call fails, the new handle is destroyed. */
    murk_call call = murk_call_begin(context, NULL, error);
    murk_study *study = calloc(1, sizeof *study);
    murk_status status = MURK_NO_MEMORY;
    if (study) {
        study->context = context;
        ++context->references;
        status = read_study(study, path, options, &call.failure);
    }
    status = murk_call_end_long(&call, status);
    if (status) {
        murk_study_destroy(study);
        return status;
    }
    *out = study;
    return MURK_OK;
}

void murk_study_destroy(murk_study *study)
{
    if (!study) {
        return;
    }
    murk_session_end(&study->session);
    murk_sweep_destroy(study->sweep);
    murk_study_file_destroy(study->file);
    murk_fields_release(&study->fields);
    murk_fields_release(&study->saved);
    for (size_t i = 0; i < study->n; ++i) {
        murk_override_release(&study->set[i]);
    }
    for (size_t i = 0; i < study->parts; ++i) {
        free(study->part[i]);
    }
    free(study->part);
    free(study->set);
    free(study->seen);
    free(study->folder);
    murk_context_release(study->context);
    free(study);
}

/* ---- running ---- */

murk_status murk_study_run(murk_study *study, murk_error *error)
{
    if (!study) {
        return murk_call_refuse(error, "study is NULL");
    }
    murk_call call = murk_call_begin(study->context, NULL, error);
    murk_fields_release(&study->fields);
    const murk_status status = murk_sweep_run(study->sweep, &call.failure);
    study->is_interrupted = status == MURK_INTERRUPTED;
    return murk_call_end_long(&call, status);
}

murk_status murk_study_fields(murk_study *study, const murk_fields **fields,
                              murk_error *error)
{
    if (!study || !fields) {
        return murk_call_refuse(error, "study or fields is NULL");
    }
    const murk_study_results results = {study->sweep, study->is_interrupted,
                                        NULL};
    murk_call call = murk_call_begin(study->context, NULL, error);
    *fields = &study->fields;
    return murk_call_end(&call, murk_fields_make(&study->fields,
                                                 murk_results_list_study,
                                                 &results, &call.failure));
}

/* ---- files ---- */

/* Sets the identity of the results: a hash of options->asked, the seed, the
 * checksum of the study file and the key of each row (murk_sweep_row.key in
 * cases/sweep.h), which is a hash of all that the row follows from. */
static murk_status identify(const murk_study *study, murk_session *session,
                            const murk_save_options *options, murk_error *err)
{
    const size_t size = sizeof study->sweep->row->key, rows = study->file->rows;
    char *keys = calloc(rows + 2, size);
    if (!keys) {
        return murk_no_memory(err, "", "for the rows");
    }
    size_t n = (size_t)snprintf(keys, size, "%s", study->file->sha256);
    for (size_t i = 0; i < rows; ++i) {
        n += (size_t)snprintf(keys + n, size, "%s", study->sweep->row[i].key);
    }
    const char *asked = murk_save_known(options).asked;
    const murk_status status =
        murk_identity_of(session->identity, "study", asked ? asked : "", NULL,
                         keys, study->sweep->seed, err);
    free(keys);
    return status;
}

static murk_status check(const murk_study *study, murk_session *session,
                         murk_error *err)
{
    static const char *const names[] = {"study.json", "table.csv", NULL};
    if (study->sweep->desc.shard.count) {
        return murk_fail(err, MURK_BAD_VALUE, study->file->path,
                         "a part has no results: a study with all its parts "
                         "has them");
    }
    murk_status status = murk_save_without_exports(session, "a study", err);
    if (!status) {
        status = murk_results_begin(&session->results, session->settings.folder,
                                    session->settings.force, err);
    }
    return status ? status : murk_session_expect(session, names, err);
}

murk_status murk_study_check_save(murk_study *study, const char *folder,
                                  const murk_save_options *options,
                                  murk_error *error)
{
    if (!study) {
        return murk_call_refuse(error, "study is NULL");
    }
    murk_call call = murk_call_begin(study->context, NULL, error);
    murk_session session = study->session;
    murk_status status =
        murk_save_set(&session, folder, options, &call.failure);
    if (!status) {
        status = check(study, &session, &call.failure);
    }
    murk_results_end(&session.results);
    return murk_call_end(&call, status);
}

/* Adds the grids of the rows that are done and have not failed to the list of
 * result files, if the study has the output fluence_vdb. The rows have written
 * these files already. */
static murk_status note_fluence(const murk_study *study, murk_session *session,
                                murk_error *err)
{
    murk_status status = MURK_OK;
    const bool wants = study->sweep->outputs.wants[MURK_OUTPUT_FLUENCE];
    for (size_t i = 0; wants && i < study->file->rows && !status; ++i) {
        char name[MURK_SWEEP_NAME_SIZE];
        murk_sweep_fluence_name(name, i);
        if (study->sweep->row[i].is_done &&
            !study->sweep->row[i].found.failed[0]) {
            status = murk_results_note(&session->results, name, err);
        }
    }
    return status;
}

/* A murk_save_work (api/save.h): adds the table, the base scene if it could be
 * read, the grids, and last study.json. */
static murk_status save(void *of, murk_session *session,
                        const murk_save_options *options, murk_error *late,
                        murk_error *err)
{
    murk_study *study = of;
    (void)late; /* of exports, which check() refuses */
    const murk_study_results results = {study->sweep, study->is_interrupted,
                                        session->settings.folder};
    murk_status status = check(study, session, err);
    if (!status) {
        status = identify(study, session, options, err);
    }
    if (!status) {
        status = murk_add_table(&session->results, study->sweep, err);
    }
    if (!status) {
        status = murk_session_add_scene(session, err);
    }
    if (!status) {
        status = note_fluence(study, session, err);
    }
    return status ? status
                  : murk_session_finish(
                        session, "study.json",
                        murk_results_json(murk_results_list_study, &results),
                        murk_print_study, &results, err);
}

murk_status murk_study_save(murk_study *study, const char *folder,
                            const murk_save_options *options,
                            const murk_fields **fields, murk_error *error)
{
    if (!study) {
        return murk_save_refuse(fields, error, "study is NULL");
    }
    murk_call call = murk_call_begin(study->context, NULL, error);
    return murk_save_results(&call, &study->session, &study->saved, folder,
                             options, fields, save, study);
}
